"""Drag against the closed form of a vertical throw, an independent integration, and a march."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from snapjump.batch import simulate_designs
from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.drag.none import NoDrag
from snapjump.drag.quadratic import MOST_PER_LENGTH, QuadraticDrag
from snapjump.engine import outcome as c
from snapjump.engine.load.gravity import Gravity
from snapjump.engine.status import NO_JUMP, OK
from snapjump.engine.termination.apex import ApexTermination
from snapjump.scenes.flight import flight
from snapjump.scenes.jump_march import jump_march
from snapjump.scenes.jump_start import jump_model
from snapjump.scenes.runner import March
from snapjump.simulation import simulate

LAWS = [QuadraticDrag.Law(share) for share in (1e-3, 1e-2, MOST_PER_LENGTH)]
G = 1.7


def thrown(vx, vy, later=0.0, status=OK):
    outcome = np.zeros(c.COLUMNS)
    outcome[[c.STATUS, c.COM_X, c.COM_Y, c.COM_VX, c.COM_VY]] = status, 0.3, 0.5, vx, vy
    outcome[[c.LAST_CONTACT, c.TIME]] = 4.0, 4.0 + later
    return outcome


@pytest.mark.parametrize("speed", [0.1, 3.0, 14.0, 90.0])
@pytest.mark.parametrize("law", LAWS)
def test_a_vertical_throw_rises_as_the_closed_form_says(law, speed):
    found = flight(0.0, Gravity(G), thrown(0.0, speed), law)
    square = G / law.per_length  # of the terminal velocity
    rise = 0.5 * square / G * np.log1p(speed * speed / square)
    time = np.sqrt(square) / G * np.arctan(speed / np.sqrt(square))
    assert found.apex_y - 0.5 == pytest.approx(rise, rel=1e-7)
    assert found.apex_time - 4.0 == pytest.approx(time, rel=1e-6)
    assert found.apex_x == found.landing_x == 0.3


@pytest.mark.parametrize("slope", [0.0, 0.3])
@pytest.mark.parametrize("law", LAWS)
def test_a_flight_is_that_of_an_independent_integration(law, slope):
    """Of one seen 0.4 after its lift-off: there, at the apex against gravity, and where its height
    of lift-off is reached again."""
    load = Gravity(G, np.cos(slope), -np.sin(slope))
    start = [0.1, 0.2, 2.0, 9.0]

    def motion(_, s):
        speed = np.hypot(s[2], s[3])
        drag = -law.per_length * speed * s[2:]
        return [s[2], s[3], drag[0] + load.pull(), drag[1] - load.gravity()]

    def highest(_, s):
        return load.rise(s[2], s[3])

    def landed(t, s):
        return s[1] - start[1] if t > 1.0 else 1.0

    landed.terminal, highest.direction = True, -1.0
    found = solve_ivp(
        motion, (0.0, 60.0), start, events=(highest, landed), dense_output=True,
        rtol=1e-12, atol=1e-12, method="DOP853",
    )  # fmt: skip
    later = 0.4
    outcome = thrown(0.0, 0.0, later)
    outcome[[c.COM_X, c.COM_Y, c.COM_VX, c.COM_VY]] = found.sol(later)
    ours = flight(0.0, load, outcome, law)
    apex, landing = found.y_events[0][0], found.y_events[1][0]
    assert [ours.apex_x, ours.apex_y] == pytest.approx(apex[:2], rel=1e-6)
    assert ours.apex_time == pytest.approx(4.0 + found.t_events[0][0], rel=1e-6)
    back = [ours.liftoff_x, ours.liftoff_y, ours.liftoff_vx, ours.liftoff_vy]
    assert back == pytest.approx(start, rel=1e-6)
    assert ours.landing_x == pytest.approx(landing[0], rel=1e-6)


def test_without_drag_it_is_a_parabola_and_what_stays_stays():
    none, some = NoDrag.Law(), QuadraticDrag.Law(0.0)
    parabola, integrated = (flight(1.0, Gravity(G), thrown(0.4, 3.0, 0.1), d) for d in (none, some))
    assert integrated == pytest.approx(parabola, rel=1e-12)
    both = np.array([thrown(0.4, 3.0), thrown(0.4, 3.0, status=NO_JUMP)])
    found = flight(1.0, Gravity(G), both, LAWS[0])
    assert found.apex_x[1] == 0.3 and found.apex_y[1] == 0.5


def test_options():
    robot = Simulation().robot
    law = QuadraticDrag(1.1, 2e-4, 1.3).law(robot.scales, 4e-3, 1.0)
    assert law.per_length == pytest.approx(0.5 * 1.3 * 1.1 * 2e-4 / 4e-3 * robot.length_m)
    design = {"epsilon": 0.25}
    simulation = Simulation(drag="quadratic", design=design)
    plate_m2 = 0.75 * robot.length_m * robot.width_m
    whole = Simulation(drag={"name": "quadratic", "area_m2": plate_m2}, design=design)
    assert simulation.drag.law_of(simulation) == whole.drag.law_of(whole)


@pytest.mark.parametrize("scene", ["snap", "static", "bounce", "slide", "cantilever"])
def test_refused_where_nothing_flies(scene):
    with pytest.raises(ParameterError, match=f"drag = 'quadratic' .* none with sim={scene}"):
        Simulation(sim=scene, drag="quadratic")


def test_a_robot_that_the_air_stops_at_once_is_refused():
    with pytest.raises(
        ParameterError, match=r"drag.coefficient = 1.2 is not allowed: at most 0\.\d"
    ):
        Simulation(drag={"name": "quadratic", "area_m2": 0.1})
    base = with_tier("draft", drag={"name": "quadratic", "area_m2": 4e-3})
    found = simulate_designs(base, [[0.1, 0.2, 0.05, 0.3]], threads=1)
    assert found.status == ["bad_design"]
    assert "drag.coefficient" in found.refusals[0]


HARD = {"name": "quadratic", "coefficient": 6.0}


def sunk_to_the_apex(end, model):
    """The flight back to the apex of a march that ended just after it."""
    back = end.copy()
    back[[c.COM_VX, c.COM_VY]] *= -1.0
    return flight(0.0, model.load, back, QuadraticDrag.Law(-model.drag.per_length))


@pytest.mark.compiles
def test_a_march_through_the_air_meets_the_integrated_flight():
    base = with_tier("standard", drag=HARD)
    model = jump_model(base)
    march = jump_march([base], [model])
    march.find_starts()
    end, left = march.run()[0], march.memory
    # The same flight marched on, its clamps as they are.
    turned = model.clamp.angles(end[c.TIME]).left
    onwards = March(
        models=[model._replace(clamp=model.clamp._replace(start=turned))], masses=march.masses,
        states=left.start.T, velocities=left.velocity[0].T, accelerations=left.acceleration[0].T,
        simulation=base, termination=ApexTermination(1.0 / base.robot.scales.time_s, 1.5),
    )  # fmt: skip
    found, marched = flight(0.0, model.load, end, model.drag), onwards.run()[0]
    assert marched[c.STATUS] == OK
    apex = sunk_to_the_apex(marched, model)
    way = [found.apex_x - end[c.COM_X], found.apex_y - end[c.COM_Y]]
    assert [apex.apex_x - end[c.COM_X], apex.apex_y - end[c.COM_Y]] == pytest.approx(way, rel=1e-6)
    vacuum = flight(0.0, model.load, end)
    assert way[1] < 0.97 * (vacuum.apex_y - end[c.COM_Y])


@pytest.mark.slow
def test_what_the_air_takes_is_in_the_ledger_and_the_momentum():
    found = simulate(with_tier("standard", drag=HARD))
    vacuum = simulate(with_tier("standard"))
    ledger, other = found.arrays, vacuum.arrays["numerical_loss_J"][-1]
    lost = ledger["drag_loss_J"][-1]
    assert abs(ledger["numerical_loss_J"][-1] - other) < 0.01 * lost
    # The impulse of the ground is what the momentum gained, and no less for the air's.
    assert found.summary["ground_impulse_N_s"] == pytest.approx(
        vacuum.summary["ground_impulse_N_s"], rel=1e-3
    )
    assert ledger["ground_impulse_y_N_s"][-1] == pytest.approx(
        ledger["ground_impulse_y_N_s"][ledger["time_s"] > found.liftoff_time_s][0], rel=1e-6
    )


@pytest.mark.compiles
@pytest.mark.parametrize("frame", ["rigid", pytest.param("elastic", marks=pytest.mark.slow)])
def test_lanes_jump_as_one_robot_does(frame):
    base = with_tier("draft", drag=HARD, frame=frame)
    rows = [[0.1, 0.2, 0.768, 0.3], [0.05, 0.15, 1.2, 0.4]]
    lanes, one = (simulate_designs(base, rows, threads=1, lanes=k) for k in (8, 1))
    assert np.array_equal(lanes.x_bar, one.x_bar) and np.array_equal(lanes.y_bar, one.y_bar)
    vacuum = simulate_designs(with_tier("draft", frame=frame), rows, threads=1)
    assert np.all(lanes.y_bar < 0.99 * vacuum.y_bar)
