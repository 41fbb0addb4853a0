"""Arrays of numbers in kernels: an address and its extents, that own nothing.

numba's array carries eight values and more, which every call of a function that takes it hands
over; lets every index count from the end, which costs a comparison and a selection an access; and
counts references to its memory. Kernels need none of this, and compile in less time without.
"""

import operator
from typing import Any, NamedTuple

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.imputils import lower_builtin
from numba.core.typing.arraydecl import GetItemBuffer, SetItemBuffer
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import models, register_model

from snapjump.number.scopes import apart

INDEX = ir.IntType(64)


class NumberArray(types.Array):
    """An array of numbers (doubles, lanes, duals) whose indices count from its beginning.

    C-contiguous ("C"), or with strides of its own ("A"). ``scope``: a name of its memory, which no
    array of another name shares; without a name it may be any.
    """

    def __init__(self, dtype: types.Type, ndim: int, layout: str = "C", scope: str = ""):
        self.scope = scope
        super().__init__(dtype, ndim, layout, name=f"Numbers({dtype}, {ndim}d, {layout}, {scope})")

    @property
    def key(self) -> Any:
        """What tells types apart."""
        return (*super().key, self.scope)

    def copy(
        self, dtype: Any = None, ndim: Any = None, layout: Any = None, readonly: Any = None
    ) -> types.Array:
        """The type of a part of this array."""
        return NumberArray(
            self.dtype if dtype is None else dtype,
            self.ndim if ndim is None else ndim,
            self.layout if layout is None else layout,
            self.scope,
        )


@register_model(NumberArray)
class NumberArrayModel(models.StructModel):
    """An address, the extents, and where they do not tell it the strides, in numbers."""

    def __init__(self, dmm: Any, fe_type: NumberArray):
        extents = types.UniTuple(types.intp, fe_type.ndim)
        members = [("data", types.CPointer(fe_type.dtype)), ("shape", extents)]
        if fe_type.layout != "C":
            members.append(("strides", extents))
        super().__init__(dmm, fe_type, members)


class View(NamedTuple):
    """A :class:`NumberArray` taken apart in LLVM: an address, extents and strides in numbers."""

    data: ir.Value
    shape: list[ir.Value]
    strides: list[ir.Value]

    @classmethod
    def of(cls, builder: Any, kind: NumberArray, value: Any) -> "View":
        """The parts of an array's LLVM value."""

        def member(place: int) -> list[ir.Value]:
            return [builder.extract_value(value, (place, k)) for k in range(kind.ndim)]

        shape = member(1)
        strides = contiguous(builder, shape) if kind.layout == "C" else member(2)
        return cls(builder.extract_value(value, 0), shape, strides)

    def part(self, context: Any, builder: Any, kind: types.Type, index: Any) -> "View":
        """What an index of the first dimensions leads to: integers, and slices without a step."""
        if isinstance(kind, types.BaseTuple):
            kinds, indices = kind.types, cgutils.unpack_tuple(builder, index, len(kind))
        else:
            kinds, indices = (kind,), [index]
        offset = INDEX(0)
        shape, strides = [], []
        for k, (one, first) in enumerate(zip(kinds, indices, strict=True)):
            if isinstance(one, types.SliceType) and not one.has_step:
                cut = context.make_helper(builder, one, first)
                first = cut.start
                inside = builder.icmp_unsigned("<", cut.stop, self.shape[k])
                stop = builder.select(inside, cut.stop, self.shape[k])
                shape.append(builder.sub(stop, first))
                strides.append(self.strides[k])
            elif isinstance(one, types.Integer):
                first = context.cast(builder, first, one, types.intp)
            else:
                raise NotImplementedError(f"an index that is {one}")
            offset = builder.add(offset, builder.mul(first, self.strides[k]))
        rest = len(kinds)
        data = builder.gep(self.data, [offset])
        return View(data, shape + self.shape[rest:], strides + self.strides[rest:])

    def packed(self, context: Any, builder: Any, kind: NumberArray) -> Any:
        """The LLVM value of an array of the given type."""
        value = ir.Constant(context.get_value_type(kind), ir.Undefined)
        value = builder.insert_value(value, self.data, 0)
        lists = (self.shape,) if kind.layout == "C" else (self.shape, self.strides)
        for place, numbers in enumerate(lists, 1):
            for k, number in enumerate(numbers):
                value = builder.insert_value(value, number, (place, k))
        return value


def contiguous(builder: Any, shape: list[ir.Value]) -> list[ir.Value]:
    """The strides of a C-contiguous array, in numbers."""
    strides = [INDEX(1)]
    for extent in shape[:0:-1]:
        strides.insert(0, builder.mul(extent, strides[0]))
    return strides


class FirstTemplate(AbstractTemplate):
    """The typing of an operation that is asked before numba's own, of which there are a dozen."""

    metadata = {"target": "cpu"}  # more specific than theirs


@infer_global(operator.getitem)
class _Loading(FirstTemplate, GetItemBuffer):
    pass


@infer_global(operator.setitem)
class _Storing(FirstTemplate, SetItemBuffer):
    pass


@lower_builtin(operator.getitem, NumberArray, types.BaseTuple)
@lower_builtin(operator.getitem, NumberArray, types.SliceType)
@lower_builtin(operator.getitem, NumberArray, types.Integer)
def _load(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    array, index = sig.args
    part = View.of(builder, array, args[0]).part(context, builder, index, args[1])
    if isinstance(sig.return_type, NumberArray):
        return part.packed(context, builder, sig.return_type)
    return apart(builder, array.scope, context.unpack_value(builder, array.dtype, part.data))


def fenced_store(context: Any, builder: Any, kind: types.Type, value: Any, place: Any) -> Any:
    """A store; of lanes, through a fence that costs nothing. Returns it.

    LLVM would merge ``x[i] = where(mask, y, x[i])`` into a masked store, which AMD's processors
    take a dozen cycles for, against one for the choice and the store by themselves.
    """
    if isinstance(value.type, ir.VectorType):
        fence = cgutils.get_or_insert_function(
            builder.module,
            ir.FunctionType(value.type, [value.type]),
            f"llvm.arithmetic.fence.v{value.type.count}f64",
        )
        value = builder.call(fence, [value])
    context.pack_value(builder, kind, value, place)
    return builder.block.instructions[-1]


@lower_builtin(operator.setitem, NumberArray, types.Any, types.Array)
@lower_builtin(operator.setitem, NumberArray, types.Any, types.Any)
def _store(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    array, index, kind = sig.args
    part = View.of(builder, array, args[0]).part(context, builder, index, args[1])
    if part.shape:
        raise NotImplementedError(f"{array}[{index}] is no single number")
    value = context.cast(builder, args[2], kind, array.dtype)
    apart(builder, array.scope, fenced_store(context, builder, array.dtype, value, part.data))


def uncounted_type(kind: types.Type) -> types.Type:
    """The type of :func:`uncounted`."""
    if isinstance(kind, types.Array) and not isinstance(kind, NumberArray):
        return NumberArray(kind.dtype, kind.ndim, kind.layout)
    if isinstance(kind, types.BaseTuple) and any(uncounted_type(k) is not k for k in kind.types):
        members = [uncounted_type(k) for k in kind.types]
        return types.BaseTuple.from_types(members, getattr(kind, "instance_class", None))
    return kind


def seen_as(context: Any, builder: Any, viewed: NumberArray, kind: types.Array, value: Any) -> Any:
    """The LLVM value of an array of numbers, over the memory of another array.

    Of as many dimensions, or of one less: then its numbers are as long as the last dimension.
    """
    if isinstance(kind, NumberArray):
        source = View.of(builder, kind, value)
        data, shape, strides = source.data, source.shape, source.strides
    else:
        array = context.make_array(kind)(context, builder, value)
        data = array.data
        shape = cgutils.unpack_tuple(builder, array.shape, kind.ndim)
        size = INDEX(context.get_abi_sizeof(context.get_data_type(kind.dtype)))
        strides = [
            builder.sdiv(s, size) for s in cgutils.unpack_tuple(builder, array.strides, kind.ndim)
        ]
    data = builder.bitcast(data, context.get_data_type(viewed.dtype).as_pointer())
    ndim = viewed.ndim
    return View(data, shape[:ndim], strides[:ndim]).packed(context, builder, viewed)


def without_owner(context: Any, builder: Any, kind: types.Type, value: Any) -> Any:
    """The LLVM value of ``uncounted`` of a value."""
    viewed = uncounted_type(kind)
    if viewed is kind:
        return value
    if isinstance(kind, types.BaseTuple):
        parts = cgutils.unpack_tuple(builder, value, len(kind.types))
        pairs = zip(kind.types, parts, strict=True)
        changed = [without_owner(context, builder, k, part) for k, part in pairs]
        return context.make_tuple(builder, viewed, changed)
    return seen_as(context, builder, viewed, kind, value)


def uncounted(thing: Any) -> Any:
    """An array, or the arrays of a tuple of tuples, as arrays of numbers that own nothing.

    The caller keeps the arrays alive. Plain Python has no such view.
    """
    return thing


@infer_global(uncounted)
class _Uncounting(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        return signature(uncounted_type(args[0]), args[0])


@lower_builtin(uncounted, types.Any)
def _uncount(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    return without_owner(context, builder, sig.args[0], args[0])
