"""Instants, interpolation and the ballistic flight that the pictures show."""

import numpy as np
import pytest

from snapjump.show.plots.instants import instants, middle_height, snap_interval
from snapjump.show.plots.jump import apex_of
from snapjump.show.plots.motion import poses, read_motion
from snapjump.show.plots.trajectory import flight_end

from .conftest import of


def test_samples_are_met_and_halfway_is_the_mean(jump):
    motion = read_motion(jump)
    assert motion is not None
    at = poses(motion, motion.time)
    assert at.nodes[..., 1] == pytest.approx(motion.nodes[..., 1], abs=1e-12)
    half = poses(motion, 0.5 * (motion.time[1:] + motion.time[:-1]))
    assert half.nodes[..., 0] == pytest.approx(
        0.5 * (motion.nodes[1:, :, 0] + motion.nodes[:-1, :, 0]), abs=1e-9
    )


def test_flight_ends_at_the_apex_and_keeps_shape_and_turning(jump):
    motion = read_motion(jump)
    assert motion is not None
    assert motion.turning == pytest.approx(-0.06, rel=1e-6)
    end = flight_end(motion, None)
    assert end == pytest.approx(1e3 * jump.summary["apex_time_s"])
    flown = poses(motion, np.array([motion.time[-1], end]))
    assert flown.centre is not None and flown.corners is not None
    assert flown.centre[1] == pytest.approx([jump.summary["x_bar"], jump.summary["y_bar"]])
    along, above = (flown.corners[:, 2] - flown.corners[:, 1]).T
    width = np.hypot(along, above)
    assert width == pytest.approx(0.8)
    angle = np.arctan2(above, along)
    turned = (angle[1] - angle[0] - motion.turning * (end - motion.time[-1])) / (2 * np.pi)
    assert turned == pytest.approx(round(turned), abs=1e-9)


def test_middle_height_is_measured_in_the_frame(jump):
    """Turning and moving everything changes nothing."""
    motion = read_motion(jump)
    assert motion is not None
    height = middle_height(motion)
    assert height[0] == pytest.approx(motion.nodes[0, 32, 1] - motion.nodes[0, 0, 1])
    flown = poses(motion, np.array([motion.time[-1], motion.time[-1] + 50.0]))
    both = read_motion(jump)
    assert both is not None
    object.__setattr__(both, "nodes", flown.nodes)
    assert np.ptp(middle_height(both)) < 1e-12


def test_moments_are_named_in_order_and_eight(jump):
    motion = read_motion(jump)
    assert motion is not None
    snap = snap_interval(motion)
    assert snap is not None and snap[0] < snap[1]
    chosen = instants(motion, 6.0)
    assert len(chosen) == 8
    assert [index for index, _ in chosen] == sorted({index for index, _ in chosen})
    wanted = ["start", "snap begins", "beam touches", "hardest push", "lift-off"]
    assert [name for _, name in chosen if name] == [*wanted, "in flight"]
    assert len(instants(motion, None, wanted=3)) >= 3


def test_only_what_jumped_flies(jump):
    fallen = of(jump, status="no_jump")
    motion = read_motion(fallen)
    assert motion is not None
    assert flight_end(motion, None) == motion.time[-1]
    assert apex_of(fallen) is None and apex_of(jump) is not None
    late = poses(motion, motion.time[-1] + np.array([0.0, 5.0]))
    assert late.nodes[1, :, 1] == pytest.approx(late.nodes[0, :, 1])
