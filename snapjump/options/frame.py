"""Options of the frames."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from snapjump.checks import ParameterError, check_choice, check_integer, check_number

Mesh = NDArray[np.int64]
MOUNTS = ("exact", "edge_middle")
CONTACTS = ("nodes", "corners")
LOW_SHARE = 0.15  # of a leg's elements, below an exact mount


@dataclass(frozen=True)
class RigidFrameOptions:
    """A rigid body of three coordinates that carries both clamps and can touch the ground."""


@dataclass(frozen=True)
class ElasticFrameOptions:
    """The paper's open chain, leg - top - leg, of nodes that are far stiffer than the beam.

    ``bending_ratio``, ``stretching_ratio``: its EI and EA over the beam's (the released program:
    1000 and 1). ``mount``: the clamps' height as it is (the leg's mesh follows it), or rounded to
    the middle of an edge of an even mesh. ``inset_m``: how far the beam's ends are from the legs.
    ``contact``: all nodes can touch the ground, or only feet and top corners, as of a rigid frame.
    ``beam_on_top``: the beam's mass comes on top of the robot's, which is all the frame's.
    ``right_follow``: share of its leg's bending that the right clamp turns with; below 1 it has no
    energy and serves comparisons with the released program only (its data: about 0.5).
    """

    bending_ratio: float = 1000.0
    stretching_ratio: float = 1000.0
    leg_elements: int = 33
    top_elements: int = 56
    mount: str = "exact"
    inset_m: float = 0.0
    contact: str = "nodes"
    beam_on_top: bool = False
    right_follow: float = 1.0

    def __post_init__(self) -> None:
        check_number("frame.bending_ratio", self.bending_ratio, 0.0, above=True)
        check_number("frame.stretching_ratio", self.stretching_ratio, 0.0, above=True)
        check_integer("frame.leg_elements", self.leg_elements, 3, 10_000)
        check_integer("frame.top_elements", self.top_elements, 2, 10_000)
        check_choice("frame.mount", self.mount, MOUNTS)
        check_number("frame.inset_m", self.inset_m, 0.0, unit="m")
        check_choice("frame.contact", self.contact, CONTACTS)
        if not isinstance(self.beam_on_top, bool):
            raise ParameterError("frame.beam_on_top", self.beam_on_top, "true or false")
        check_number("frame.right_follow", self.right_follow, 0.0, 1.0)

    def elements_below(self, mount_share: float) -> int:
        """Elements of a leg below its mount, which is at a share of the leg's height."""
        share = LOW_SHARE if self.mount == "exact" else mount_share - 0.5 / self.leg_elements
        return min(max(1, round(share * self.leg_elements)), self.leg_elements - 2)

    def mesh(self, mount_share: float) -> Mesh:
        """Coordinates, the left mount's edge, and the nodes of the top's two corners."""
        nodes = 2 * self.leg_elements + self.top_elements + 1
        corners = (self.leg_elements, self.leg_elements + self.top_elements)
        return np.array([2 * nodes, self.elements_below(mount_share), *corners], dtype=np.int64)


@dataclass(frozen=True)
class FixedFrameOptions:
    """Clamps held in space: for scenes without a flight."""
