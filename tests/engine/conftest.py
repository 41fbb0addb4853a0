"""Where the robots of small marches begin."""

import pytest
from robots import DESIGNS, small_march


@pytest.fixture(scope="session")
def starts():
    """State, velocity and acceleration of every design at the start, found one by one."""
    march = small_march(DESIGNS, 1)
    march.find_starts()
    assert not march.queue.status.any()
    return march.queue[1:4]
