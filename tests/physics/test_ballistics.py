"""B1: the apex from a state of flight, and the bias of implicit Euler in free fall."""

import numpy as np
import pytest
from physical import single_mass
from references import outputs_of as reference

from snapjump.engine import outcome as c
from snapjump.engine.load.gravity import Gravity
from snapjump.engine.recorder.trajectory import make_recorder
from snapjump.engine.status import NO_JUMP, OK
from snapjump.engine.termination.timed import TimedTermination
from snapjump.scenes.flight import flight
from snapjump.scenes.mass import mass_model
from snapjump.scenes.runner import March

START, VX, VY, G = 0.01, 0.3, 1.0, 10.0
EULER = pytest.param("implicit_euler", marks=pytest.mark.slow)


def test_apex():
    exact = reference("B1_ballistic")
    outcome = np.zeros(c.COLUMNS)
    outcome[c.STATUS] = OK
    outcome[c.COM_Y], outcome[c.COM_VX], outcome[c.COM_VY] = START, VX, VY
    found = flight(2.0, Gravity(G), outcome)
    assert found.apex_x == pytest.approx(exact["xc_minus_x"], rel=1e-12)
    assert found.apex_y == pytest.approx(exact["yc"], rel=1e-12)
    assert found.apex_time == pytest.approx(2.0 + VY / G, rel=1e-12)


def test_liftoff():
    """Thrown at t = 0.5 from (0.2, 0.1) at (VX, VY), seen 0.03 later; and one still on the ground,
    of the same flights."""
    later = 0.03
    outcome = np.zeros((2, c.COLUMNS))
    outcome[:, c.STATUS] = OK, NO_JUMP
    outcome[:, c.LAST_CONTACT] = 0.5
    outcome[:, c.TIME] = 0.5 + later
    outcome[:, c.COM_X] = 0.2 + VX * later
    outcome[:, c.COM_Y] = 0.1 + VY * later - 0.5 * G * later**2
    outcome[:, c.COM_VX], outcome[:, c.COM_VY] = VX, VY - G * later
    found = flight(np.array([1.0, 2.0]), Gravity(np.array([G, G])), outcome)
    thrown = [values[0] for values in found]
    reached = [0.2 + VX * VY / G, 0.1 + 0.5 * VY**2 / G, 1.5 + VY / G]
    assert thrown == pytest.approx(
        [*reached, 0.2, 0.1, VX, VY, 1.5, 0.2 + 2.0 * VX * VY / G], rel=1e-12
    )
    assert found.apex_x[1] == outcome[1, c.COM_X]
    assert found.apex_y[1] == outcome[1, c.COM_Y]
    assert found.apex_time[1] == 2.0 + outcome[1, c.TIME]


@pytest.mark.parametrize("step_s, accuracy", [(1e-3, 1e-12), (1e-5, 2e-8)])
@pytest.mark.parametrize("integrator", [EULER, "tr_bdf2", "sdirk2"])
def test_free_fall(integrator, step_s, accuracy):
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
        models=[model], masses=np.array([4e-3 / scales.mass_kg]),
        states=np.array([[0.0, START / scales.length_m]]),
        velocities=np.array([[VX, VY]]) / scales.velocity_m_s, simulation=simulation,
        termination=TimedTermination(duration), recorder=make_recorder(2, duration, duration),
    )  # fmt: skip
    march.queue.acceleration[0, 1] = -G / scales.acceleration_m_s2
    march.run()
    x, y = march.memory.start[:, 0] * scales.length_m
    bias = 0.5 * VY * step_s if integrator == "implicit_euler" else 0.0
    if integrator == "implicit_euler" and step_s == 1e-5:
        assert exact["yc"] - bias == pytest.approx(exact["IE_yc_dt1e5"], rel=1e-12)
    assert y == pytest.approx(exact["yc"] - bias, rel=accuracy)
    assert x == pytest.approx(exact["xc_minus_x"], rel=accuracy)
