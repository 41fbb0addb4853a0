"""Rows of a linear system that are one node's own, and never stand in memory."""

import math
from typing import Any

import numpy as np
from numba.core import cgutils, types
from numba.core.imputils import lower_builtin
from numba.core.typing.templates import AbstractTemplate, infer_global, signature

from snapjump.number.array import INDEX, NumberArray, View

SHAPES = ((3,), (3, 6), (3, 11))  # residual, band, and what the band lacks


def own_rows(number: Any) -> Any:
    """Residual (3), band (3, 6) and what that lacks (3, 11) of one node, of the type of a number,
    which no memory holds."""
    return tuple(np.zeros(shape, type(number)) for shape in SHAPES)


@infer_global(own_rows)
class _OwnRows(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        kinds = [NumberArray(args[0], len(shape), scope="own") for shape in SHAPES]
        return signature(types.Tuple(kinds), *args)


@lower_builtin(own_rows, types.Any)
def _own_rows(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    arrays = []
    for kind, shape in zip(sig.return_type.types, SHAPES, strict=True):
        extents = [INDEX(extent) for extent in shape]
        number = context.get_data_type(kind.dtype)
        data = cgutils.alloca_once(builder, number, size=INDEX(math.prod(shape)))
        arrays.append(View(data, extents, []).packed(context, builder, kind))
    return context.make_tuple(builder, sig.return_type, arrays)
