"""Marches on numba's simulator of a card: as on the processor, refilled and in chunks."""

import json

import numpy as np
import pytest
from before_the_strike import go_on, to_the_strike
from command_line import ROOT, python
from robots import DESIGNS, QUIET, small_march

from snapjump.engine import outcome as c
from snapjump.engine.status import NO_EQUILIBRIUM, OK, TIME_LIMIT

pytestmark = pytest.mark.processes

PROGRAM = ROOT / "tests" / "support" / "card_in_simulator.py"
ROBOTS = (DESIGNS[1], DESIGNS[7])
RATES = ("velocity", "acceleration")
# What the roundings of a whole strike of quiet robots add up to (in T, L or L/T), with room.
APART = 2e-8


@pytest.fixture(scope="module")
def striking():
    """The robots in one queue, each just before its strike, and the states they started from."""
    march = small_march(ROBOTS, 1, **QUIET)
    march.find_starts()
    starts = march.queue.state.copy()
    for robot, design in enumerate(ROBOTS):
        start = [values[[robot]] for values in march.queue[1:4]]
        alone = small_march([design], 1, start, **QUIET)
        way = to_the_strike(alone)
        go_on(alone, way)
        for values, found in zip(march.queue[:4], alone.queue[:4], strict=True):
            values[robot] = found[0]
    return march, starts


@pytest.fixture(scope="module")
def told(striking, tmp_path_factory):
    """What the program on a simulated card printed of the robots that strike."""
    pytest.importorskip("numba_cuda", reason="numba-cuda is not installed")
    file = tmp_path_factory.mktemp("striking") / "queue.npz"
    queue = striking[0].queue._asdict()
    np.savez(file, **{name: queue[name] for name in ("numbers", "state", *RATES)})
    return json.loads(python(str(PROGRAM), str(file), NUMBA_ENABLE_CUDASIM="1").stdout)


def test_jumps_agree_with_compiled_ones(told, striking):
    """In Python products and sums are rounded twice where compiled code does it once: what two
    programs that round differently agree to after a jump. It begins just before the strike."""
    march, starts = striking
    np.testing.assert_allclose(told["starts"], starts, rtol=0.0, atol=1e-9)
    expected = march.run()
    outcome = np.array(told["outcome"])
    assert (outcome[:, c.STATUS] == OK).all()
    for row in (c.STEPS, c.REJECTED, c.ITERATIONS):
        assert np.array_equal(outcome[:, row], expected[:, row])
    for row in (c.TIME, c.SMALLEST_GAP, c.COM_X, c.COM_Y, c.COM_VX, c.COM_VY):
        np.testing.assert_allclose(outcome[:, row], expected[:, row], rtol=0.0, atol=APART)


def test_one_thread_takes_robots_one_after_the_other(told):
    iterations = np.array(told["outcome"])[:, c.ITERATIONS]
    assert told["passes"] == iterations.sum()
    assert told["progress"] == sorted(told["progress"])
    assert told["progress"][0] == 0.0 and told["progress"][-1] == 1.0
    assert told["bytes_sent"] > 0


def test_chunks_are_one_queue(told):
    """To the last bit: there the same Python was marched with and without a card."""
    assert told["differs_in_chunks"] == 0.0
    assert told["status_in_chunks"] == [TIME_LIMIT, NO_EQUILIBRIUM, TIME_LIMIT]
