"""The tangent state of a march: its memory again in duals, which carry derivatives by four
parameters."""

from typing import Any, NamedTuple

import numpy as np
from numba.core import types
from numba.core.imputils import lower_builtin
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numpy.typing import NDArray

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.engine.view import MESH, WorkType, taken_apart
from snapjump.engine.work import DIFFERENTIATED, Memory, Sizes, count_of
from snapjump.number.array import INDEX, NumberArray, View, seen_as
from snapjump.number.dual import DOUBLES, DUAL, PARAMETERS
from snapjump.number.memory import aligned_zeros

Array = NDArray[np.float64]


class TangentState(NamedTuple):
    """Of W lanes.

    block (W, N, 8): the parts of a memory that depend on parameters, each number a dual; sizes,
    mesh: the memory's; slopes (W, B + 10, 4), padded by five rows of zeros on either side, and
    frame_slopes (W, F, 4): derivatives of the residual, then of the correction.
    """

    block: Array
    sizes: Sizes
    mesh: NDArray[np.int64]
    slopes: Array
    frame_slopes: Array


def make_tangent_state(memory: Memory) -> TangentState:
    """Zeros for every lane of a march's memory."""
    sizes = memory.sizes
    lanes = sizes.lanes
    frame = sizes.padded_frame - 2 * HALF_BANDWIDTH
    return TangentState(
        block=aligned_zeros((lanes, count_of(DIFFERENTIATED, sizes), DOUBLES)),
        sizes=sizes,
        mesh=memory.mesh,
        slopes=aligned_zeros((lanes, sizes.padded_beam, PARAMETERS)),
        frame_slopes=aligned_zeros((lanes, frame, PARAMETERS)),
    )


def view_tangent(tangent: Any, lane: Any) -> Any:
    """One lane's tangent state as the memory of a march in duals, whose matrix is not wanted."""
    raise NotImplementedError("duals are compiled")


@infer_global(view_tangent)
class _ViewingTangent(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        return signature(WorkType(DUAL, False, False), args[0], types.intp)


@lower_builtin(view_tangent, types.BaseTuple, types.Integer)
def _view_tangent(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    kinds = sig.args[0].types
    block, sizes, mesh = (builder.extract_value(args[0], k) for k in range(3))
    doubles = NumberArray(types.float64, 3, "A")
    view = View.of(builder, doubles, seen_as(context, builder, doubles, kinds[0], block))
    first = builder.gep(view.data, [builder.mul(args[1], view.strides[0])])
    pointer = context.get_value_type(types.CPointer(DUAL))
    mesh = seen_as(context, builder, MESH, kinds[2], mesh)
    return taken_apart(
        context, builder, sig.return_type, builder.bitcast(first, pointer), INDEX(1), sizes, mesh
    )
