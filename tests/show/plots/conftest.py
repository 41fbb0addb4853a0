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


def of(result: Any, scene: str | None = None, **changes: Any) -> Any:
    """The same result with other arrays, summary or status, perhaps of another scene."""
    parts = {**vars(result), **changes}
    if scene is not None:
        simulation = {**vars(result.simulation), "sim": SimpleNamespace(name=scene)}
        parts["simulation"] = SimpleNamespace(**simulation)
    return SimpleNamespace(**parts)
