"""Options of the frames."""

from dataclasses import dataclass


@dataclass(frozen=True)
class RigidFrameOptions:
    """A rigid body of three coordinates that carries both clamps and can touch the ground."""


@dataclass(frozen=True)
class FixedFrameOptions:
    """Clamps held in space: for scenes without a flight."""
