"""A cluster of dask for the tests of this folder."""

from collections.abc import Iterator
from typing import Any

import pytest
from dask_processes import a_cluster


@pytest.fixture
def cluster(tmp_path) -> Iterator[tuple[str, list[Any]]]:
    """Address of a real scheduler, its two worker processes, and its own."""
    with a_cluster(tmp_path) as found:
        yield found
