"""Options of the frames."""

import numpy as np
from numpy.typing import NDArray

from snapjump.declare.fields import Part, choice, flag, integer, number

Mesh = NDArray[np.int64]
MOUNTS = ("exact", "edge_middle")
CONTACTS = ("nodes", "corners")
LOW_SHARE = 0.15  # of a leg's elements, below an exact mount


class FrameOptions(Part):
    """A frame and its numbers."""

    group = "frame"


class RigidFrameOptions(FrameOptions):
    """A rigid body of three coordinates that carries both clamps and can touch the ground."""


class ElasticFrameOptions(FrameOptions):
    """The paper's open chain, leg - top - leg, of nodes that are far stiffer than the beam.

    ``bending_ratio``, ``stretching_ratio``: its EI and EA over the beam's (the released program:
    1000 and 1). ``mount``: the clamps' height as it is (the leg's mesh follows it), or rounded to
    the middle of an edge of an even mesh. ``inset_m``: how far the beam's ends are from the legs.
    ``contact``: all nodes can touch the ground, or only feet and top corners, as of a rigid frame.
    ``beam_on_top``: the beam's mass comes on top of the robot's, which is all the frame's.
    ``right_follow``: share of its leg's bending that the right clamp turns with; below 1 it has no
    energy and serves comparisons with the released program only (its data: about 0.5).
    """

    bending_ratio: float = number(1000.0, above=0.0)
    stretching_ratio: float = number(1000.0, above=0.0)
    leg_elements: int = integer(33, least=3, most=10_000)
    top_elements: int = integer(56, least=2, most=10_000)
    mount: str = choice("exact", MOUNTS)
    inset_m: float = number(0.0, least=0.0, unit="m")
    contact: str = choice("nodes", CONTACTS)
    beam_on_top: bool = flag(False)
    right_follow: float = number(1.0, least=0.0, most=1.0)

    def elements_below(self, mount_share: float) -> int:
        """Elements of a leg below its mount, which is at a share of the leg's height."""
        share = LOW_SHARE if self.mount == "exact" else mount_share - 0.5 / self.leg_elements
        return min(max(1, round(share * self.leg_elements)), self.leg_elements - 2)

    def mesh(self, mount_share: float) -> Mesh:
        """Coordinates, the left mount's edge, and the nodes of the top's two corners."""
        nodes = 2 * self.leg_elements + self.top_elements + 1
        corners = (self.leg_elements, self.leg_elements + self.top_elements)
        return np.array([2 * nodes, self.elements_below(mount_share), *corners], dtype=np.int64)


class FixedFrameOptions(FrameOptions):
    """Clamps held in space: for scenes without a flight."""
