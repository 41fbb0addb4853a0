"""Arrays of duals in compiled functions of tests."""

from typing import Any

from numba.core import types
from numba.extending import intrinsic

from snapjump.number.array import NumberArray, seen_as
from snapjump.number.dual_type import DUAL


@intrinsic
def view_duals(typingctx: Any, array: Any) -> Any:
    """View a C-contiguous float64 array of shape (..., 8) as an array of duals of shape (...).

    The data must be aligned to 64 bytes, of eight doubles the first being the value and the last
    four the slopes.
    """
    if array.layout != "C" or array.dtype != types.float64:
        raise TypeError(f"view_duals needs C-contiguous doubles, not {array}")
    viewed = NumberArray(DUAL, array.ndim - 1)

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return seen_as(context, builder, viewed, array, args[0])

    return viewed(array), codegen
