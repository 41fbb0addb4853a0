import numpy as np
import pytest

from snapjump.discretization.corotational import Corotational
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.drive.base import ClampAngles
from snapjump.engine.load.none import NoLoad
from snapjump.engine.load.tip import TipLoad
from snapjump.frame.base import NO_MESH, STILL
from snapjump.frame.fixed import FixedFrame
from snapjump.frame.parts.cantilever import CantileverFrame

ROD = DiscreteElasticRod.Beam(0.05, 1e4, 0.05, clamp_offset=0.05)
ANGLES = ClampAngles(0.3, 0.2, 5.0, 4.0)


def test_fixed_frame_holds_both_ends_and_turns_them_down():
    frame = FixedFrame.Body(0.4, 0.7)
    assert frame.dofs(NO_MESH) == 0
    state = np.full(8, 9.0)
    frame.place_ends(NO_MESH, ROD, ANGLES, state)
    left = np.array([-0.4, 0.7]) + 0.05 * np.array([np.cos(0.3), -np.sin(0.3)])
    right = np.array([0.4, 0.7]) - 0.05 * np.array([np.cos(0.2), np.sin(0.2)])
    np.testing.assert_allclose(state[:2], left, rtol=1e-15)
    np.testing.assert_allclose(state[-2:], right, rtol=1e-15)
    assert (state[2:-2] == 9.0).all()
    tangents = frame.end_tangents(NO_MESH, NoLoad(), ANGLES, state, STILL)
    assert np.arctan2(tangents.left_y, tangents.left_x) == pytest.approx(-0.3)
    assert np.arctan2(tangents.right_y, tangents.right_x) == pytest.approx(0.2)
    assert (tangents.left_rate, tangents.right_rate) == (-5.0, 4.0)
    assert tangents.right_free == 0.0


def test_cantilever_holds_the_left_end_only():
    frame = CantileverFrame()
    state = np.full(8, 9.0)
    frame.place_ends(NO_MESH, ROD, ANGLES, state)
    np.testing.assert_allclose(state[:2], [0.05 * np.cos(0.3), -0.05 * np.sin(0.3)])
    assert (state[2:] == 9.0).all()
    tangents = frame.end_tangents(NO_MESH, TipLoad(1.0, 2.0, 3.0), ANGLES, state, STILL)
    assert (tangents.right_free, tangents.right_moment) == (1.0, 3.0)


def test_clamps_hold_the_rotation_of_nodes_that_turn():
    """The third coordinate is the rotation times the element's length."""
    state = np.full(12, 9.0)
    FixedFrame.Body(0.4, 0.7).place_ends(NO_MESH, Corotational.Beam(0.05, 1e4), ANGLES, state)
    np.testing.assert_allclose(state[:3], [-0.4, 0.7, -0.05 * 0.3])
    np.testing.assert_allclose(state[-3:], [0.4, 0.7, 0.05 * 0.2])
    assert (state[3:-3] == 9.0).all()
    state[:] = 9.0
    CantileverFrame().place_ends(NO_MESH, Corotational.Beam(0.05, 1e4), ANGLES, state)
    np.testing.assert_allclose(state[:3], [0.0, 0.0, -0.05 * 0.3])
    assert (state[3:] == 9.0).all()
