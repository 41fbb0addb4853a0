"""Outcomes that were written down, to the last bit: a change that should not move them does not.

``pytest --write-golden`` writes those of the selected tests anew, one process at a time.
"""

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml

FOLDER = Path(__file__).resolve().parents[1] / "golden"
MEMBERS = yaml.safe_load((FOLDER / "members.yaml").read_text())


def spelled_out(choice: dict[str, str], changes: dict[str, Any]) -> dict[str, Any]:
    """The configuration of these members, every number given; ``changes`` by family and member."""
    groups = {family: dict(MEMBERS[family]) for family in ("robot", "design", "environment")}
    for family, name in choice.items():
        numbers = MEMBERS[family].get(name, {}) | changes.get(family, {}).get(name, {})
        groups[family] = {"name": name, **numbers}
    return groups


def plain(value: Any) -> Any:
    """Values as JSON has them, without loss; None for NaN."""
    if isinstance(value, dict):
        return {key: plain(v) for key, v in value.items()}
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        return [plain(v) for v in value]
    if isinstance(value, float) and math.isnan(value):
        return None
    return value


def outcome(batch: Any) -> dict[str, Any]:
    """What a batch of jumps is compared by."""
    names = ("status", "x_bar", "y_bar", "steps", "newton_iterations")
    return {name: getattr(batch, name) for name in names}


class Golden:
    """The outcomes of one test file."""

    def __init__(self, path: Path, config: pytest.Config):
        self.path = path
        self.writing = config.getoption("--write-golden")
        self.shaken = config.getoption("--perturb") is not None
        self.known: dict[str, Any] = json.loads(path.read_text()) if path.exists() else {}

    def check(self, name: str, values: dict[str, Any]) -> None:
        """Compare with what was written down, or write it down; with --perturb neither."""
        found = plain(values)
        assert self.shaken or found == self._written(name, found), f"{name} has moved"

    def near(self, name: str, values: Any, relative: float) -> None:
        """Compare an array so, up to a share of each row's largest number."""
        written = np.array(self._written(name, plain(values)), dtype=float)
        allowed = relative * np.abs(written).max(axis=-1, keepdims=True)
        assert self.shaken or np.all(np.abs(values - written) <= allowed), f"{name} has moved"

    def _written(self, name: str, found: Any) -> Any:
        if self.writing:
            self.known[name] = found
            lines = [f" {json.dumps(k)}: {json.dumps(self.known[k])}" for k in sorted(self.known)]
            self.path.write_text("{\n" + ",\n".join(lines) + "\n}\n")
        return self.known.get(name)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--write-golden", action="store_true", help="write outcomes down anew")


@pytest.fixture(scope="module")
def golden(request: pytest.FixtureRequest) -> Golden:
    name = request.path.stem.removeprefix("test_")
    return Golden(FOLDER / f"{name}.json", request.config)
