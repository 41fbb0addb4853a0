"""Arrays of duals whose values and slopes lie apart, as one memory beside another.

What is written to such an array is slopes, where the values are those of a computation that is
only followed; or values, where nobody asks for their slopes; or both.
"""

import operator
from typing import Any

from numba.core import types
from numba.core.imputils import lower_builtin
from numba.extending import models, register_model

from snapjump.number.array import NumberArray, View, fenced_store
from snapjump.number.dual_type import DualType, Parts, together
from snapjump.number.scopes import SCOPES, apart


def slopes_of_scope(scope: str) -> str:
    """The name of the memory that has the slopes of another."""
    return f"slopes of {scope}"


def name_scopes(names: Any) -> None:
    """Tell the compiler that slopes of memory of these names share none."""
    SCOPES.extend(slopes_of_scope(name) for name in names)


class DualArray(NumberArray):
    """An array of duals over an array of values and one of slopes.

    sloped: whether it has slopes, and keeps them; owned: whether values that are written are kept.
    """

    def __init__(self, dtype: DualType, ndim: int, scope: str, sloped: bool, owned: bool):
        self.sloped = sloped
        self.owned = owned
        super().__init__(dtype, ndim, "C", scope)
        self.name: str = f"Duals({dtype}, {ndim}d, {scope}, {sloped}, {owned})"

    @property
    def key(self) -> Any:
        """What tells types apart."""
        return (*super().key, self.sloped, self.owned)

    def copy(
        self, dtype: Any = None, ndim: Any = None, layout: Any = None, readonly: Any = None
    ) -> types.Array:
        """The type of a part of this array."""
        dimensions = self.ndim if ndim is None else ndim
        return DualArray(self.dtype, dimensions, self.scope, self.sloped, self.owned)


@register_model(DualArray)
class DualArrayModel(models.StructModel):
    """The address of the values, the extents, and the address of the slopes."""

    def __init__(self, dmm: Any, fe_type: DualArray):
        members = [
            ("data", types.CPointer(fe_type.dtype.base)),
            ("shape", types.UniTuple(types.intp, fe_type.ndim)),
            ("slopes", types.CPointer(fe_type.dtype.slopes)),
        ]
        super().__init__(dmm, fe_type, members)


def packed(context: Any, builder: Any, kind: DualArray, values: View, slopes: Any) -> Any:
    """The LLVM value of an array, from its values and the address of its slopes."""
    return builder.insert_value(values.packed(context, builder, kind), slopes, 2)


def parts_at(context: Any, builder: Any, sig: Any, args: Any) -> tuple[View, View]:
    """What an index of an array leads to: values, and slopes."""
    array, index = sig.args[:2]
    values = View.of(builder, array, args[0])
    slopes = values._replace(data=builder.extract_value(args[0], 2))
    return (
        values.part(context, builder, index, args[1]),
        slopes.part(context, builder, index, args[1]),
    )


@lower_builtin(operator.getitem, DualArray, types.BaseTuple)
@lower_builtin(operator.getitem, DualArray, types.SliceType)
@lower_builtin(operator.getitem, DualArray, types.Integer)
def _load(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    array = sig.args[0]
    values, slopes = parts_at(context, builder, sig, args)
    if isinstance(sig.return_type, DualArray):
        return packed(context, builder, sig.return_type, values, slopes.data)
    kind = array.dtype
    value = apart(builder, array.scope, context.unpack_value(builder, kind.base, values.data))
    if not array.sloped:
        return together(context, builder, kind, value, None)
    scope = slopes_of_scope(array.scope)
    found = apart(builder, scope, context.unpack_value(builder, kind.slopes, slopes.data))
    return together(context, builder, kind, value, found)


@lower_builtin(operator.setitem, DualArray, types.Any, types.Any)
def _store(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    array, _, given = sig.args
    values, slopes = parts_at(context, builder, sig, args)
    kind = array.dtype
    number = Parts(context, builder, kind, context.cast(builder, args[2], given, kind), kind)
    if array.sloped:
        store = fenced_store(context, builder, kind.slopes, number.slopes, slopes.data)
        apart(builder, slopes_of_scope(array.scope), store)
    if array.owned:
        store = fenced_store(context, builder, kind.base, number.value, values.data)
        apart(builder, array.scope, store)
