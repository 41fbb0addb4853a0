"""The memory of a march in kernels: one value of addresses and sizes, whose parts are arrays.

What a kernel hands to another is the addresses of the parts and the sizes that all of them share,
and not every array with extents of its own.
"""

from collections.abc import Iterator
from typing import Any

from numba.core import cgutils, types
from numba.core.imputils import lower_builtin, lower_getattr_generic
from numba.core.typing.templates import (
    AbstractTemplate,
    AttributeTemplate,
    infer_getattr,
    infer_global,
    signature,
)
from numba.extending import models, overload, register_model

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.engine.work import EXACT, FIELDS, WINDOWS, Memory, Shape, Sizes
from snapjump.number.array import INDEX, NumberArray, View, contiguous, seen_as
from snapjump.number.dispatch import INLINED
from snapjump.number.lane import LaneType
from snapjump.number.nowhere import NOWHERE, Nowhere
from snapjump.number.scopes import SCOPES

SCOPES.extend({**FIELDS, **EXACT})
MESH = NumberArray(types.int64, 1)
MATRIX = ("padded_band", "padded_border", "corner_block")


class WorkType(types.Type):
    """The type of a march's memory in kernels, of one number type.

    lanes: whether its parts are doubles, lanes last; strided: whether neighbours are apart, as one
    thread's numbers are on a card; matrix: whether what is written to the matrix is kept. Of what
    only derivatives ask for nothing is kept.
    """

    fields = FIELDS

    def __init__(self, number: types.Type, lanes: bool, strided: bool, matrix: bool = True):
        self.number = number
        self.lanes = lanes
        self.strided = strided
        self.matrix = matrix
        super().__init__(name=f"Work({number}, {lanes}, {strided}, {matrix})")

    def part(self, name: str) -> types.Type | None:
        """The type of a part, None if there is none of that name."""
        name = WINDOWS.get(name, name)
        if name not in self.fields or (name in MATRIX and not self.matrix):
            return NOWHERE if name in EXACT else MESH if name == "mesh" else None
        ndim = len(self.fields[name]) + self.lanes
        scope = "" if self.strided else name
        return NumberArray(self.number, ndim, "A" if self.strided else "C", scope)


@register_model(WorkType)
class WorkModel(models.StructModel):
    """Addresses of the parts, their sizes, and how many numbers neighbours are apart."""

    def __init__(self, dmm: Any, fe_type: WorkType):
        parts = [(name, types.CPointer(fe_type.number)) for name in fe_type.fields]
        sizes = ("sizes", types.UniTuple(types.intp, len(Sizes._fields)))
        super().__init__(dmm, fe_type, [*parts, sizes, ("apart", types.intp), ("mesh", MESH)])


@infer_getattr
class WorkParts(AttributeTemplate):
    """Typing of the parts."""

    key = WorkType

    def generic_resolve(self, work: WorkType, name: str) -> types.Type | None:
        return work.part(name)


@lower_getattr_generic(WorkType)
def part_of(context: Any, builder: Any, kind: WorkType, value: Any, name: str) -> Any:
    """The LLVM value of a part."""
    work = cgutils.create_struct_proxy(kind)(context, builder, value=value)
    if name == "mesh":
        return work.mesh
    found: Any = kind.part(name)
    if found is NOWHERE:
        return context.get_dummy_value()
    field = WINDOWS.get(name, name)
    sizes = Sizes(*cgutils.unpack_tuple(builder, work.sizes, len(Sizes._fields)))
    shape = shape_of(kind.fields[field], sizes)
    strides = [builder.mul(stride, work.apart) for stride in contiguous(builder, shape)]
    data = getattr(work, field)
    if name in WINDOWS:
        data = builder.gep(data, [builder.mul(INDEX(HALF_BANDWIDTH), strides[0])])
        shape[0] = builder.sub(shape[0], INDEX(2 * HALF_BANDWIDTH))
    if kind.lanes:
        shape, strides = [*shape, sizes.lanes], [*strides, INDEX(1)]
    return View(data, shape, strides).packed(context, builder, found)


def shape_of(shape: Shape, sizes: Sizes) -> list[Any]:
    """The extents of a part in LLVM."""
    return [
        INDEX(extent) if isinstance(extent, int) else getattr(sizes, extent) for extent in shape
    ]


def beginnings(builder: Any, fields: dict[str, Shape], sizes: Sizes) -> Iterator[tuple[str, Any]]:
    """Where each part begins, in numbers."""
    begin = INDEX(0)
    for name, shape in fields.items():
        yield name, begin
        count = INDEX(1)
        for extent in shape_of(shape, sizes):
            count = builder.mul(count, extent)
        begin = builder.add(begin, count)


def taken_apart(
    context: Any, builder: Any, kind: WorkType, block: Any, apart: Any, sizes: Any, mesh: Any
) -> Any:
    """The LLVM value of a memory whose parts lie in a block, from the address of its first
    number."""
    work = cgutils.create_struct_proxy(kind)(context, builder)
    extents = Sizes(*cgutils.unpack_tuple(builder, sizes, len(Sizes._fields)))
    for name, begin in beginnings(builder, kind.fields, extents):
        setattr(work, name, builder.gep(block, [builder.mul(begin, apart)]))
    work.sizes, work.apart, work.mesh = sizes, apart, mesh
    return work._getvalue()


def unpacked(context: Any, builder: Any, kind: Any, value: Any) -> tuple[Any, Any, Any]:
    """Block (address and strides in doubles), sizes and mesh of a :class:`Memory`'s value."""
    block, sizes, mesh = cgutils.unpack_tuple(builder, value, len(kind.types))
    doubles = NumberArray(types.float64, 2, "A")
    view = View.of(builder, doubles, seen_as(context, builder, doubles, kind.types[0], block))
    return view, sizes, seen_as(context, builder, MESH, kind.types[2], mesh)


def view_memory(memory: Any) -> Any:
    """A march's memory as doubles, the lanes last."""
    return memory


@infer_global(view_memory)
class _ViewingMemory(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        return signature(WorkType(types.float64, True, args[0].types[0].layout != "C"), *args)


@lower_builtin(view_memory, types.BaseTuple)
def _view_memory(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    view, sizes, mesh = unpacked(context, builder, sig.args[0], args[0])
    return taken_apart(context, builder, sig.return_type, view.data, view.strides[0], sizes, mesh)


class PlainWork:
    """In plain Python: the parts of a single lane."""

    def __init__(self, memory: Memory):
        self.mesh = memory.mesh
        for name in (*FIELDS, *WINDOWS):
            kept = WINDOWS.get(name, name) in FIELDS
            setattr(self, name, getattr(memory, name)[..., 0] if kept else Nowhere())


def view_work(memory: Any, lanes: Any) -> Any:
    """A march's memory as numbers; ``lanes``: a tuple as long as there are lanes, of which one
    gives doubles."""
    return PlainWork(memory)


@infer_global(view_work)
class _ViewingWork(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        memory, lanes = args
        number = types.float64 if lanes.count == 1 else LaneType(lanes.count)
        strided = memory.types[0].layout != "C"
        if strided and lanes.count > 1:
            raise TypeError("lanes need contiguous memory")
        return signature(WorkType(number, False, strided), *args)


@lower_builtin(view_work, types.BaseTuple, types.BaseTuple)
def _view_work(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    kind = sig.return_type
    view, sizes, mesh = unpacked(context, builder, sig.args[0], args[0])
    block = builder.bitcast(view.data, context.get_value_type(types.CPointer(kind.number)))
    apart = view.strides[0] if kind.strided else INDEX(1)
    return taken_apart(context, builder, kind, block, apart, sizes, mesh)


def alone(work: Any) -> bool:
    """Whether a memory is of one robot whose neighbouring numbers are adjacent, so that the
    processor takes several coordinates at once; a constant while compiling."""
    return True


@overload(alone, strict=False, jit_options=INLINED)
def _alone(work: Any) -> Any:
    one = isinstance(work, WorkType) and work.number == types.float64
    found = one and not (work.lanes or work.strided)
    return lambda work: found


def without_matrix(work: Any) -> Any:
    """The same memory for an assembly of the residual alone."""
    return work


@infer_global(without_matrix)
class _ForgettingMatrix(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        kind = args[0]
        return signature(WorkType(kind.number, kind.lanes, kind.strided, matrix=False), kind)


@lower_builtin(without_matrix, WorkType)
def _without_matrix(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    return args[0]
