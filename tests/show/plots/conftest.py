"""A jump and a snap at tier draft, of which the pictures are drawn."""

from types import SimpleNamespace
from typing import Any

import pytest

from snapjump import Result
from snapjump.composition import with_tier
from snapjump.simulation import simulate


@pytest.fixture(scope="session")
def jump() -> Result:
    return simulate(with_tier("draft"))


@pytest.fixture(scope="session")
def snap() -> Result:
    return simulate(with_tier("draft", sim="snap"))


def of(result: Any, **changes: Any) -> Any:
    """The same result with other arrays, summary or status."""
    return SimpleNamespace(**{**vars(result), **changes})
