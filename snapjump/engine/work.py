"""The memory of a march: one block of numbers, allocated before it starts, whose parts have names.

In Python a part is an array of it, lanes last. In kernels the whole is one value
(:mod:`snapjump.engine.view`), and a part an array of numbers: doubles, lanes or duals.
"""

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.discretization.base import HALF_BANDWIDTH, SKEW
from snapjump.engine.clock import ROWS
from snapjump.engine.model import numbers_in
from snapjump.frame.base import NO_MESH
from snapjump.number.memory import aligned_zeros


class Sizes(NamedTuple):
    """Extents of the parts.

    coordinates: D, of the frame and then of the beam's nodes; stages: slots S of velocity and
    acceleration; points: C, that can touch the ground; numbers: P, of the model; width: W, of the
    mounts' coordinates that the beam is condensed onto. The others are rows of linear systems, with
    HALF_BANDWIDTH rows of zeros on either side, which spare a solver its edge cases: of the beam
    (B + 10), of the frame's right-hand side, and of an elastic frame's matrix.
    """

    lanes: Any
    coordinates: Any
    stages: Any
    points: Any
    numbers: Any
    width: Any
    padded_beam: Any
    padded_frame: Any
    padded_chain: Any


Shape = tuple[str | int, ...]  # names of sizes, and numbers

# What depends on the parameters of a march, and has slopes where derivatives are wanted.
SLOPED: dict[str, Shape] = {
    "state": ("coordinates",),  # the Newton iterate q of the stage at hand
    "start": ("coordinates",),  # state at the step's beginning
    # Of a stage: v = (q - position_predictor) rate, a = (v - velocity_predictor) rate.
    "position_predictor": ("coordinates",),
    "velocity_predictor": ("coordinates",),
    "velocity": ("stages", "coordinates"),  # slot 0 is the step's beginning
    "acceleration": ("stages", "coordinates"),
    "numbers": ("numbers",),  # of the model
    "air": (2,),  # acceleration (x, y) that drag gives all masses in the stage at hand
    "padded_residual": ("padded_beam",),  # of the nodes; then the correction
    "padded_frame_residual": ("padded_frame",),  # of the frame; then the correction
}
FIELDS: dict[str, Shape] = {
    **SLOPED,
    "coefficients": ("stages",),  # of the stage at hand, by which slots are weighted
    "sliding_velocity": ("points",),  # along the ground, at the last iterate
    "correction": ("coordinates",),  # what was last subtracted from the state, before its share
    "active_set": ("points",),  # 1 where a constraint held the point at the last iterate
    "clock": (ROWS,),  # the lane's scalars (snapjump.engine.clock)
    # The nodes' symmetric band, column by column, and its border: the rows of the mounts.
    "padded_band": ("padded_beam", HALF_BANDWIDTH + 1),
    "padded_border": ("padded_beam", "width"),
    "corner_block": ("width", "width"),  # of a rigid frame, or of an elastic one's mounts
    # Of an elastic frame (snapjump.frame.parts.elastic_solve).
    "mount_residual": ("width",),
    "mount_jacobian": (8, 3),
    "padded_frame_band": ("padded_chain", HALF_BANDWIDTH + 1),
    "padded_frame_border": ("padded_chain", 4),
    "last_residual": (4,),
    "last_block": (4, 4),
}
# The linear system of derivatives, whose matrix nothing is left out of: the symmetric one, and what
# that lacks, of the border first in the mounts' three columns, then in their rows.
EXACT: dict[str, Shape] = {
    **{name: FIELDS[name] for name in ("padded_band", "padded_border", "corner_block")},
    "padded_skew": ("padded_beam", SKEW),
    "padded_border_skew": ("padded_beam", 6),
    "padded_factors": ("padded_beam", 17),  # of :mod:`snapjump.linear_solver.banded_unsymmetric`
    "padded_residual": ("padded_beam",),
    "padded_frame_residual": ("padded_frame",),
}
# Padded parts without the padding.
WINDOWS = {
    name.removeprefix("padded_"): name for name in {**FIELDS, **EXACT} if name.startswith("padded_")
}


class Memory(NamedTuple):
    """block (N, W): all parts of W lanes one after the other; mesh: of the frame, of all lanes."""

    block: Any
    sizes: Sizes
    mesh: NDArray[np.int64]

    def __getattr__(self, name: str) -> Any:
        """A part as an array, lanes last."""
        if WINDOWS.get(name) in FIELDS:
            return getattr(self, WINDOWS[name])[HALF_BANDWIDTH:-HALF_BANDWIDTH]
        if name not in FIELDS:
            raise AttributeError(name)
        begin, end, extents = places_of(self.sizes)[name]
        return self.block[begin:end].reshape(*extents, self.block.shape[1])


def extents_of(shape: Shape, sizes: Any) -> list[Any]:
    """The extents of a part."""
    return [getattr(sizes, extent) if isinstance(extent, str) else extent for extent in shape]


@lru_cache
def places_of(sizes: Sizes) -> dict[str, tuple[int, int, list[int]]]:
    """Where each part begins and ends in the block, and its extents."""
    places, begin = {}, 0
    for name, shape in FIELDS.items():
        extents = extents_of(shape, sizes)
        end = begin + math.prod(extents)
        places[name] = begin, end, extents
        begin = end
    return places


def count_of(fields: dict[str, Shape], sizes: Sizes) -> int:
    """Numbers of so many parts together."""
    return sum(math.prod(extents_of(shape, sizes)) for shape in fields.values())


def sizes_of(
    model: Any, nodes: int, stages: int = 2, lanes: int = 1, mesh: NDArray[np.int64] = NO_MESH
) -> Sizes:
    """Sizes for a model whose beam has so many nodes."""
    frame = model.frame.dofs(mesh)
    beam = model.discretization.node_dofs() * nodes
    chain = frame if len(mesh) else 0
    pad = 2 * HALF_BANDWIDTH
    return Sizes(
        lanes=lanes,
        coordinates=int(frame + beam),
        stages=stages,
        points=int(nodes + model.frame.contact_points(mesh)),
        numbers=sum(len(numbers_in(member)) for member in model),
        width=6 if chain else 3,
        padded_beam=beam + pad,
        padded_frame=int(max(frame, 3)) + pad,
        padded_chain=int(chain) + pad,
    )


def make_memory(
    sizes: Sizes,
    mesh: NDArray[np.int64] = NO_MESH,
    allocate: Callable[[tuple[int, int]], Any] = aligned_zeros,
) -> Memory:
    """Zeroed memory."""
    return Memory(allocate((count_of(FIELDS, sizes), sizes.lanes)), sizes, mesh)
