"""The tangent state of a march: its memory again in duals, which carry derivatives by four
parameters.

Values are those of the march, which is not touched. Slopes lie beside them, and so does a matrix
that nothing is left out of.
"""

from typing import Any, NamedTuple

import numpy as np
from llvmlite import ir
from numba.core import cgutils, types
from numba.core.imputils import lower_builtin, lower_getattr_generic
from numba.core.typing.templates import (
    AbstractTemplate,
    AttributeTemplate,
    infer_getattr,
    infer_global,
    signature,
)
from numba.extending import models, register_model
from numpy.typing import NDArray

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.engine.view import WorkType, beginnings, part_of, shape_of
from snapjump.engine.work import EXACT, FIELDS, SLOPED, WINDOWS, Memory, Sizes, count_of
from snapjump.number.array import INDEX, NumberArray, View, contiguous, seen_as
from snapjump.number.dual_array import DualArray, name_scopes, packed, slopes_of_scope
from snapjump.number.dual_type import PARAMETERS, DualType
from snapjump.number.memory import aligned_zeros
from snapjump.number.nowhere import NOWHERE

name_scopes(SLOPED)
Array = NDArray[np.float64]
PLAIN = ("clock", "coefficients", "mesh")  # without derivatives
SLOPES, VALUES = "slopes_of_", "values_of_"  # before the name of a part: their addresses
BARE = "bare_"  # before the name of a part: its slopes alone


class TangentState(NamedTuple):
    """Of W lanes: slopes (N, 4 W) of the sloped parts of a memory, all lanes of one parameter after
    the other, and values (M, W) of a linear system of its own."""

    slopes: Array
    values: Array


def make_tangent_state(memory: Memory) -> TangentState:
    """Zeros for every lane of a march's memory."""
    lanes = memory.sizes.lanes
    return TangentState(
        aligned_zeros((count_of(SLOPED, memory.sizes), PARAMETERS * lanes)),
        aligned_zeros((count_of(EXACT, memory.sizes), lanes)),
    )


class TangentType(types.Type):
    """The type of a march's memory in duals, over one of plain numbers, without a matrix.

    held: whether the state is one that does not depend on parameters.
    """

    def __init__(self, work: WorkType, held: bool = False):
        self.work = work
        self.held = held
        self.number = DualType(work.number)
        super().__init__(name=f"{type(self).__name__}({work}, {held})")

    def part(self, name: str) -> types.Type | None:
        """The type of a part, None if there is none of that name."""
        if name in PLAIN:
            return self.work.part(name)
        bare = name.startswith(BARE)
        field = WINDOWS.get(name.removeprefix(BARE), name.removeprefix(BARE))
        if field not in SLOPED:
            return NOWHERE if field in FIELDS or field in EXACT else None
        ndim = len(SLOPED[field])
        if bare:
            return NumberArray(self.number.slopes, ndim, "C", slopes_of_scope(field))
        sloped = not (self.held and field == "state")
        return DualArray(self.number, ndim, field, sloped, owned=field in EXACT)


@register_model(TangentType)
class TangentModel(models.StructModel):
    """The memory of plain numbers, and addresses of slopes and of values of its own."""

    def __init__(self, dmm: Any, fe_type: TangentType):
        slopes = types.CPointer(fe_type.number.slopes)
        values = types.CPointer(fe_type.number.base)
        parts = [(SLOPES + name, slopes) for name in SLOPED]
        parts += [(VALUES + name, values) for name in EXACT]
        super().__init__(dmm, fe_type, [("work", fe_type.work), *parts])


@infer_getattr
class TangentParts(AttributeTemplate):
    """Typing of the parts."""

    key = TangentType

    def generic_resolve(self, tangent: TangentType, name: str) -> types.Type | None:
        return tangent.part(name)


@lower_getattr_generic(TangentType)
def _part(context: Any, builder: Any, kind: TangentType, value: Any, name: str) -> Any:
    """The LLVM value of a part."""
    twin = cgutils.create_struct_proxy(kind)(context, builder, value=value)
    if name in PLAIN:
        return part_of(context, builder, kind.work, twin.work, name)
    found: Any = kind.part(name)
    if found is NOWHERE:
        return context.get_dummy_value()
    bare = name.startswith(BARE)
    name = name.removeprefix(BARE)
    field = WINDOWS.get(name, name)
    work = cgutils.create_struct_proxy(kind.work)(context, builder, value=twin.work)
    sizes = Sizes(*cgutils.unpack_tuple(builder, work.sizes, len(Sizes._fields)))
    shape = shape_of({**SLOPED, **EXACT}[field], sizes)
    strides = contiguous(builder, shape)
    values = getattr(twin, VALUES + field) if field in EXACT else getattr(work, field)
    nothing = ir.Constant(context.get_value_type(types.CPointer(kind.number.slopes)), None)
    slopes = getattr(twin, SLOPES + field) if field in SLOPED else nothing
    if name in WINDOWS:
        skipped = [builder.mul(INDEX(HALF_BANDWIDTH), strides[0])]
        values, slopes = builder.gep(values, skipped), builder.gep(slopes, skipped)
        shape[0] = builder.sub(shape[0], INDEX(2 * HALF_BANDWIDTH))
    if bare:
        return View(slopes, shape, strides).packed(context, builder, found)
    if not isinstance(found, DualArray):
        return View(values, shape, strides).packed(context, builder, found)
    return packed(context, builder, found, View(values, shape, strides), slopes)


def view_tangent(work: Any, tangent: Any) -> Any:
    """A march's memory in duals: its numbers (:func:`~snapjump.engine.view.view_work`) with the
    slopes of a :class:`TangentState`."""
    raise NotImplementedError("duals are compiled")


@infer_global(view_tangent)
class _ViewingTangent(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        return signature(TangentType(args[0]), *args)


class ExactType(TangentType):
    """The type of a march's memory in plain numbers, with the system of a tangent state."""

    def part(self, name: str) -> types.Type | None:
        """The type of a part, None if there is none of that name."""
        field = WINDOWS.get(name, name)
        if field in EXACT:
            return NumberArray(self.number.base, len(EXACT[field]), "C", field)
        kept = field in PLAIN or field in SLOPED
        return self.work.part(name) if kept else NOWHERE if field in FIELDS else None


register_model(ExactType)(TangentModel)


@infer_getattr
class ExactParts(TangentParts):
    """Typing of the parts."""

    key = ExactType


def with_exact_system(work: Any) -> Any:
    """The memory of a tangent in plain numbers, with a matrix that nothing is left out of."""
    raise NotImplementedError("duals are compiled")


@infer_global(with_exact_system)
class _WithExactSystem(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        return signature(ExactType(args[0].work), *args)


@lower_builtin(with_exact_system, TangentType)
def _with_exact_system(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    return args[0]


def with_state_held(work: Any) -> Any:
    """The same memory with a state that does not depend on parameters."""
    raise NotImplementedError("duals are compiled")


@infer_global(with_state_held)
class _Holding(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        return signature(TangentType(args[0].work, held=True), *args)


@lower_builtin(with_state_held, TangentType)
def _with_state_held(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    return args[0]


def block_of(context: Any, builder: Any, kind: Any, value: Any, place: int) -> Any:
    """The address of the first number of one of the two blocks, in doubles."""
    block = builder.extract_value(value, place)
    doubles = NumberArray(types.float64, 2, "A")
    view = seen_as(context, builder, doubles, kind.types[place], block)
    return View.of(builder, doubles, view).data


@lower_builtin(view_tangent, WorkType, types.BaseTuple)
def _view_tangent(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    kind = sig.return_type
    work = cgutils.create_struct_proxy(kind.work)(context, builder, value=args[0])
    sizes = Sizes(*cgutils.unpack_tuple(builder, work.sizes, len(Sizes._fields)))
    twin = cgutils.create_struct_proxy(kind)(context, builder)
    twin.work = args[0]
    blocks = ((SLOPES, SLOPED, kind.number.slopes), (VALUES, EXACT, kind.number.base))
    for place, (prefix, fields, number) in enumerate(blocks):
        first = block_of(context, builder, sig.args[1], args[1], place)
        first = builder.bitcast(first, context.get_value_type(types.CPointer(number)))
        for name, begin in beginnings(builder, fields, sizes):
            setattr(twin, prefix + name, builder.gep(first, [begin]))
    return twin._getvalue()
