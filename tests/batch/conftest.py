"""A robot that is quick to simulate: coarse, and with little care for its contacts."""

import pytest
from robots import small_simulation


@pytest.fixture(scope="session")
def base():
    return small_simulation(0.2, 0.1, 0.3, 0.768)
