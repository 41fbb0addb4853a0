"""Models of which only what a test is about does anything."""

from typing import Any

from snapjump.contact.none import NoContact
from snapjump.damping.none import NoDamping
from snapjump.discretization.parts.loose_nodes import LooseNodes
from snapjump.engine.clamp.constant_rate import ConstantRate
from snapjump.engine.load.none import NoLoad
from snapjump.engine.load.tip import TipLoad
from snapjump.engine.model import Model
from snapjump.frame.parts.cantilever import CantileverFrame
from snapjump.frame.parts.no_frame import NoFrame
from snapjump.friction.none import NoFriction

NOTHING = {
    "clamp": ConstantRate(0.0, 1.0, 1.0, 0.0), "contact": NoContact.Law(),
    "friction": NoFriction.Law(), "damping": NoDamping.Law(), "load": NoLoad(),
}  # fmt: skip


def bare_model(discretization: Any, frame: Any, **members: Any) -> Model:
    """A model without contact, friction, damping and load, but for members that are given."""
    return Model(discretization, frame, **(NOTHING | members))


def loose_nodes(**members: Any) -> Model:
    """Nodes that no elements and no frame hold."""
    return bare_model(LooseNodes(), NoFrame(), **members)


def cantilever(discretization: Any, force_x: float = 0.0) -> Model:
    """One clamp that stands still, and a force along the beam at its tip."""
    return bare_model(discretization, CantileverFrame(), load=TipLoad(force_x, 0.0, 0.0))
