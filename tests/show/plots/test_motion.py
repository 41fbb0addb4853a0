"""What pictures read of a result: instants, flights between them, and the balance of its books."""

import copy
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from snapjump import Environment
from snapjump.composition import with_tier
from snapjump.show.plots.film import film_times
from snapjump.show.plots.instants import instants, middle_height, snap_interval
from snapjump.show.plots.jump import apex_of, milliseconds
from snapjump.show.plots.ledger import Ledger, read_ledger
from snapjump.show.plots.motion import Motion, poses, read_motion
from snapjump.show.plots.trajectory import flight_end
from snapjump.simulation import simulate

from .conftest import of


def motion_of(result: Any) -> Motion:
    motion = read_motion(result)
    assert motion is not None
    return motion


def books_of(result: Any) -> Ledger:
    books = read_ledger(result)
    assert books is not None
    return books


def test_samples_are_met_and_halfway_is_the_mean(jump):
    motion = motion_of(jump)
    at = poses(motion, motion.time)
    assert at.nodes[..., 1] == pytest.approx(motion.nodes[..., 1], abs=1e-12)
    half = poses(motion, 0.5 * (motion.time[1:] + motion.time[:-1]))
    assert half.nodes[..., 0] == pytest.approx(
        0.5 * (motion.nodes[1:, :, 0] + motion.nodes[:-1, :, 0]), abs=1e-9
    )


def test_flight_ends_at_the_apex_and_keeps_shape_and_turning(jump):
    motion = motion_of(jump)
    late = motion.time >= 0.9 * motion.time[-1]
    turns = np.polyfit(motion.time[late], jump.arrays["frame_angle_rad"][late], 1)
    assert motion.turning == pytest.approx(turns[0], rel=1e-6) and abs(motion.turning) > 0.01
    end = flight_end(motion, None)
    assert end == pytest.approx(milliseconds(jump, "apex_time_s"))
    flown = poses(motion, np.array([motion.time[-1], end]))
    assert flown.centre is not None and flown.corners is not None
    assert flown.centre[1] == pytest.approx([jump.summary["x_bar"], jump.summary["y_bar"]])
    along, above = (flown.corners[:, 2] - flown.corners[:, 1]).T
    width = np.hypot(along, above)
    assert width == pytest.approx(0.8)
    angle = np.arctan2(above, along)
    turned = (angle[1] - angle[0] - motion.turning * (end - motion.time[-1])) / (2 * np.pi)
    assert turned == pytest.approx(round(turned), abs=1e-9)


@pytest.mark.parametrize("slope_rad", [-0.1, 0.1])
def test_on_a_slope_the_flight_ends_at_the_apex_too(slope_rad):
    simulation = with_tier("draft", environment=Environment(slope_rad=slope_rad))
    sloping = simulate(simulation)
    motion = motion_of(sloping)
    end = flight_end(motion, None)
    assert end == pytest.approx(milliseconds(sloping, "apex_time_s"))
    flown = poses(motion, np.array([end]))
    assert flown.centre is not None
    assert flown.centre[0] == pytest.approx([sloping.x_bar, sloping.y_bar])


def test_a_flight_through_air_ends_at_its_apex_too(jump):
    """A drawn arc is of even acceleration; where and when it ends is the result's."""
    simulation = replace(jump.simulation, drag="quadratic")
    apex = {"x_bar": jump.x_bar - 0.5, "y_bar": jump.y_bar - 1.0}
    apex["apex_time_s"] = jump.apex_time_s - 2e-3
    slowed = of(jump, simulation=simulation, summary={**jump.summary, **apex})
    motion = motion_of(slowed)
    end = flight_end(motion, None)
    assert end == pytest.approx(1e3 * apex["apex_time_s"])
    flown = poses(motion, np.array([motion.time[-1], motion.time[-1] + 1e-3, end]))
    assert flown.centre is not None and motion.velocity is not None
    assert flown.centre[2] == pytest.approx([apex["x_bar"], apex["y_bar"]])
    assert flown.centre[1] - flown.centre[0] == pytest.approx(1e-3 * motion.velocity, rel=1e-2)


def test_middle_height_is_measured_in_the_frame(jump):
    """Turning and moving everything changes nothing."""
    motion = motion_of(jump)
    height = middle_height(motion)
    middle = motion.nodes.shape[1] // 2
    assert height[0] == pytest.approx(motion.nodes[0, middle, 1] - motion.nodes[0, 0, 1])
    flown = poses(motion, np.array([motion.time[-1], motion.time[-1] + 50.0]))
    both = motion_of(jump)
    object.__setattr__(both, "nodes", flown.nodes)
    assert np.ptp(middle_height(both)) < 1e-12


def test_moments_are_named_in_order_and_eight(jump):
    motion = motion_of(jump)
    snap = snap_interval(motion)
    assert snap is not None and snap[0] < snap[1]
    chosen = instants(motion, milliseconds(jump, "liftoff_time_s"))
    assert len(chosen) == 8
    assert [index for index, _ in chosen] == sorted({index for index, _ in chosen})
    wanted = ["start", "beam touches", "snap begins", "hardest push", "lift-off"]
    assert [name for _, name in chosen if name] == [*wanted, "in flight"]
    assert len(instants(motion, None, wanted=3)) >= 3


def test_the_largest_strain_is_where_and_when_the_outputs_say(jump):
    motion = motion_of(jump)
    assert motion.bent is not None
    assert motion.bent.strain == jump.max_strain and motion.bent.place == jump.max_strain_at_bar
    assert motion.time[motion.bent.sample] == pytest.approx(1e3 * jump.max_strain_time_s, abs=0.01)
    drawn = np.abs(jump.arrays["node_strain"][motion.bent.sample, motion.bent.node])
    assert drawn == pytest.approx(jump.max_strain, rel=0.02)
    assert motion.bent.sample in dict(instants(motion, milliseconds(jump, "liftoff_time_s")))
    assert motion_of(of(jump, summary={})).bent is None


def test_only_what_jumped_flies(jump):
    fallen = of(jump, status="no_jump")
    motion = motion_of(fallen)
    assert flight_end(motion, None) == motion.time[-1]
    assert apex_of(fallen) is None and apex_of(jump) is not None
    late = poses(motion, motion.time[-1] + np.array([0.0, 5.0]))
    assert late.nodes[1, :, 1] == pytest.approx(late.nodes[0, :, 1])


def test_balance_of_kept_books_is_zero(jump):
    books = books_of(jump)
    assert books.unit_J == pytest.approx(2e11 * 1e-2 * 5e-5**3 / 12 / 0.02)
    assert np.abs(books.balance).max() < 1e-12
    assert books.total[-1] != pytest.approx(books.total[0])


STORED = ("elastic_J", "kinetic_J", "gravitational_J", "contact_J")
LOST = ("friction_loss_J", "damping_loss_J", "numerical_loss_J")


@pytest.mark.parametrize("name", [*STORED, *LOST, "clamp_work_J"])
def test_balance_shows_what_is_missing(jump, name):
    wrong = copy.deepcopy(jump)
    unit = 2e11 * 1e-2 * 5e-5**3 / 12 / 0.02
    wrong.arrays[name][5:] += 0.1 * unit
    books = books_of(wrong)
    assert books.balance[:5] == pytest.approx(0.0, abs=1e-12)
    assert books.balance[5:] == pytest.approx(-0.1 if name == "clamp_work_J" else 0.1)


@pytest.mark.parametrize("name", ["contact_loss_J", "drag_loss_J"])
def test_what_contact_and_air_take_is_in_the_books_if_they_take_any(jump, name):
    assert name[:-2] not in books_of(jump).lost
    taken = copy.deepcopy(jump)
    taken.arrays[name][5:] += 1e-6
    taken.arrays["elastic_J"][5:] -= 1e-6
    assert name[:-2] in books_of(taken).lost
    assert np.abs(books_of(taken).balance).max() < 1e-12


def test_books_without_losses_still_balance(snap):
    arrays = {name: snap.arrays[name] for name in ("time_s", "elastic_J")}
    books = books_of(of(snap, arrays=arrays))
    assert books.balance == pytest.approx(books.total - books.total[0])


def test_pictures_and_film_have_the_clock_of_the_result(jump):
    """A motion that starts later is shown at its own times, with what happens in it."""
    keys = ("liftoff_time_s", "apex_time_s")
    moved = {key: jump.summary[key] + 0.03 for key in (*keys, "max_strain_time_s")}
    late = replace(
        jump,
        arrays={**jump.arrays, "time_s": jump.arrays["time_s"] + 0.03},
        summary={**jump.summary, **moved},
    )
    here, there = motion_of(jump), motion_of(late)
    assert there.time[0] == pytest.approx(here.time[0] + 30.0)
    for key in keys:
        assert milliseconds(late, key) == pytest.approx(1e3 * late.summary[key])
    named = instants(here, milliseconds(jump, "liftoff_time_s"))
    assert instants(there, milliseconds(late, "liftoff_time_s")) == named
    before, after = (film_times(m, milliseconds(r, "apex_time_s"))
                     for m, r in ((here, jump), (there, late)))  # fmt: skip
    assert after[1] == before[1] and after[0] == pytest.approx(before[0] + 30.0)
    assert books_of(late).time == pytest.approx(books_of(jump).time + 30.0)
