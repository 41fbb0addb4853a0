"""Arrays of numbers in kernels: views whose indices are never negative and that own nothing.

numba lets every index count from the end, which costs a comparison and a selection an access; and
it counts references to every array that is passed on. Kernels need neither.
"""

import operator
from typing import Any

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.imputils import lower_builtin
from numba.extending import intrinsic, models, overload, register_model
from numba.np import arrayobj

from snapjump.number.dispatch import INLINED


class NumberArray(types.Array):
    """A C-contiguous array of numbers (doubles or lanes) that is indexed from its beginning."""

    def __init__(self, dtype: types.Type, ndim: int, layout: str = "C"):
        super().__init__(dtype, ndim, layout, name=f"Numbers({dtype}, {ndim}d, {layout})")

    def copy(
        self, dtype: Any = None, ndim: Any = None, layout: Any = None, readonly: Any = None
    ) -> types.Array:
        """The type of a part of this array."""
        return NumberArray(
            self.dtype if dtype is None else dtype,
            self.ndim if ndim is None else ndim,
            self.layout if layout is None else layout,
        )


@register_model(NumberArray)
class NumberArrayModel(models.StructModel):
    """numba's array, with an address in place of the counted reference to its memory."""

    def __init__(self, dmm: Any, fe_type: NumberArray):
        extents = types.UniTuple(types.intp, fe_type.ndim)
        members = [
            ("meminfo", types.voidptr),
            ("parent", types.voidptr),
            ("nitems", types.intp),
            ("itemsize", types.intp),
            ("data", types.CPointer(fe_type.dtype)),
            ("shape", extents),
            ("strides", extents),
        ]
        super().__init__(dmm, fe_type, members)


def unsigned(index: types.Type) -> types.Type:
    """The type of an index, or of a tuple of them, with every integer made unsigned."""
    if isinstance(index, types.BaseTuple):
        return types.Tuple([unsigned(t) for t in index.types])
    return types.uintp if isinstance(index, types.Integer) else index


def _counted_from_the_beginning(function: Any) -> Any:
    """numba's own code for an access, told that the index is unsigned."""

    def lowering(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        array, index, *value = sig.args
        plain = unsigned(index)
        number = context.cast(builder, args[1], index, plain)
        return function(
            context,
            builder,
            sig.replace(args=(array, plain, *value)),
            (args[0], number, *args[2:]),
        )

    return lowering


for _index in (types.Integer, types.SliceType):
    lower_builtin(operator.getitem, NumberArray, _index)(
        _counted_from_the_beginning(arrayobj.getitem_arraynd_intp)
    )
lower_builtin(operator.getitem, NumberArray, types.BaseTuple)(
    _counted_from_the_beginning(arrayobj.getitem_array_tuple)
)


def _store(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    """numba's own code for a store; of lanes, through a fence that costs nothing.

    LLVM would merge ``x[i] = where(mask, y, x[i])`` into a masked store, which AMD's processors
    take a dozen cycles for, against one for the choice and the store by themselves.
    """
    value = args[2]
    if isinstance(value.type, ir.VectorType):
        fence = cgutils.get_or_insert_function(
            builder.module,
            ir.FunctionType(value.type, [value.type]),
            f"llvm.arithmetic.fence.v{value.type.count}f64",
        )
        value = builder.call(fence, [value])
    return arrayobj.setitem_array(context, builder, sig, (*args[:2], value))


lower_builtin(operator.setitem, NumberArray, types.Any, types.Any)(
    _counted_from_the_beginning(_store)
)


def uncounted_type(kind: types.Type) -> types.Type:
    """The type of :func:`uncounted`."""
    if isinstance(kind, types.Array) and not isinstance(kind, NumberArray):
        return NumberArray(kind.dtype, kind.ndim, kind.layout)
    if isinstance(kind, types.BaseTuple) and any(uncounted_type(k) is not k for k in kind.types):
        members = [uncounted_type(k) for k in kind.types]
        return types.BaseTuple.from_types(members, getattr(kind, "instance_class", None))
    return kind


def _without_owner(context: Any, builder: Any, kind: types.Type, value: Any) -> Any:
    """The LLVM value of ``uncounted`` of a value."""
    viewed = uncounted_type(kind)
    if viewed is kind:
        return value
    if isinstance(kind, types.BaseTuple):
        parts = cgutils.unpack_tuple(builder, value, len(kind.types))
        pairs = zip(kind.types, parts, strict=True)
        changed = [_without_owner(context, builder, k, part) for k, part in pairs]
        return context.make_tuple(builder, viewed, changed)
    source = context.make_array(kind)(context, builder, value)
    target = context.make_array(viewed)(context, builder)
    for name in ("nitems", "itemsize", "data", "shape", "strides"):
        setattr(target, name, getattr(source, name))
    target.meminfo = ir.Constant(target.meminfo.type, None)
    target.parent = ir.Constant(target.parent.type, None)
    return target._getvalue()


def uncounted(thing: Any) -> Any:
    """An array, or the arrays of a tuple of tuples, as views that own nothing.

    numba counts references to an array at every call, atomically, which stalls the processor: in
    loops over nodes that is dear. The caller keeps the arrays alive. Plain Python has no such view.
    """
    return thing


@intrinsic
def _uncounted(typingctx: Any, thing: Any) -> Any:
    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return _without_owner(context, builder, sig.args[0], args[0])

    return uncounted_type(thing)(thing), codegen


@overload(uncounted, strict=False, jit_options=INLINED)
def _uncounted_in_numba(thing: Any) -> Any:
    return lambda thing: _uncounted(thing)
