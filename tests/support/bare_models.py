"""Models of which only what a test is about does anything."""

from typing import Any

from snapjump.discretization.corotational import Corotational
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.discretization.parts.loose_nodes import LooseNodes
from snapjump.drive.constant_rate import ConstantRate
from snapjump.engine.load.tip import TipLoad
from snapjump.engine.model import Model
from snapjump.frame.parts.cantilever import CantileverFrame
from snapjump.frame.parts.no_frame import NoFrame
from snapjump.frame.rigid import RigidFrame

STILL = ConstantRate.Law(0.0, 1.0, 1.0, 0.0)


def bare_model(discretization: Any, frame: Any, **members: Any) -> Model:
    """A model without contact, friction, damping and load, but for members that are given."""
    return Model(discretization, frame, **({"clamp": STILL} | members))


def loose_nodes(**members: Any) -> Model:
    """Nodes that no elements and no frame hold."""
    return bare_model(LooseNodes(), NoFrame(), **members)


def on_rigid_frame(per_node: int) -> Model:
    """A robot whose nodes have so many coordinates, where its numbers do not matter."""
    beams = {2: DiscreteElasticRod.Beam(0.1, 1e4, 0.1, 0.0), 3: Corotational.Beam(0.1, 1e4)}
    return bare_model(
        beams[per_node], RigidFrame.Body(0.4, -0.15, -0.25, 0.25, 15.0, 1.3, 0.06, 0.01)
    )


def cantilever(discretization: Any, force_x: float = 0.0) -> Model:
    """One clamp that stands still, and a force along the beam at its tip."""
    return bare_model(discretization, CantileverFrame(), load=TipLoad(force_x, 0.0, 0.0))
