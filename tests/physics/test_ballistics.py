"""B1: the apex from a state of flight, and the bias of implicit Euler in free fall."""

from types import SimpleNamespace

import numpy as np
import pytest

from snapjump.ending.timed import TimedEnding
from snapjump.engine import clock as c
from snapjump.engine.status import OK
from snapjump.recorder.trajectory import make_recorder
from snapjump.scenes.jump import apex_bar
from snapjump.scenes.mass import mass_model
from snapjump.scenes.runner import March

START, VX, VY, G = 0.01, 0.3, 1.0, 10.0


def test_apex(reference):
    exact = reference("B1_ballistic")
    outcome = np.zeros(c.ROWS)
    outcome[c.STATUS] = OK
    outcome[c.COM_Y], outcome[c.COM_VX], outcome[c.COM_VY] = START, VX, VY
    model = SimpleNamespace(load=SimpleNamespace(acceleration=G))
    x, y, time = apex_bar(model, outcome)
    assert x == pytest.approx(exact["xc_minus_x"], rel=1e-12)
    assert y == pytest.approx(exact["yc"], rel=1e-12)
    assert time == pytest.approx(VY / G, rel=1e-12)


@pytest.mark.parametrize("step_s, accuracy", [(1e-3, 1e-12), (1e-5, 2e-8)])
@pytest.mark.parametrize("integrator", ["implicit_euler", "tr_bdf2", "sdirk2"])
def test_free_fall(integrator, step_s, accuracy, single_mass, reference):
    """Height where the speed vanishes: exact, or lower by v h/2 with implicit Euler.

    Velocities are differences of positions over the step, so that 10,000 steps gather rounding
    of 1e-8; 100 steps do not.
    """
    exact = reference("B1_ballistic")
    simulation = single_mass("bounce", step_s, integrator)
    scales = simulation.robot.scales
    model = mass_model(simulation, G, 0.0)
    duration = VY / G / scales.time_s
    march = March(
        models=[model],
        masses=np.array([4e-3 / scales.mass_kg]),
        states=np.array([[0.0, START / scales.length_m]]),
        velocities=np.array([[VX, VY]]) / scales.velocity_m_s,
        simulation=simulation,
        ending=TimedEnding(duration),
        recorder=make_recorder(2, duration, duration),
    )
    march.queue.acceleration[0, 1] = -G / scales.acceleration_m_s2
    march.run()
    x, y = march.memory.start[:, 0] * scales.length_m
    bias = 0.5 * VY * step_s if integrator == "implicit_euler" else 0.0
    if integrator == "implicit_euler" and step_s == 1e-5:
        assert exact["yc"] - bias == pytest.approx(exact["IE_yc_dt1e5"], rel=1e-12)
    assert y == pytest.approx(exact["yc"] - bias, rel=accuracy)
    assert x == pytest.approx(exact["xc_minus_x"], rel=accuracy)
