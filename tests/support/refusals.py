"""Bad input: refused in one line, which begins with its key."""

from contextlib import contextmanager

import pytest

from snapjump.checks import ParameterError


def key_in(override):
    """The key that a word of the command line is about."""
    return override.lstrip("+~").partition("=")[0]


@contextmanager
def refused(key, *words):
    """The block is refused, with these words in the line; yields what is caught."""
    with pytest.raises(ParameterError) as caught:
        yield caught
    told = str(caught.value)
    assert caught.value.key == key and told.startswith(f"{key} = ") and "\n" not in told
    for word in words:
        assert word in told
