"""A robot that is quick to simulate: coarse, and with little care for its contacts."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))


@pytest.fixture(scope="session")
def base():
    from robots import small_simulation

    return small_simulation(0.2, 0.1, 0.3, 0.768)
