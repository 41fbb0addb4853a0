"""The slopes of a tangent state as doubles, lane by lane: for what is read in and out."""

from typing import Any

from numba.core import cgutils, types
from numba.core.imputils import lower_builtin
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import models, register_model

from snapjump.engine.tangent import block_of
from snapjump.engine.view import WorkType, taken_apart
from snapjump.engine.work import SLOPED, Sizes
from snapjump.number.array import INDEX
from snapjump.number.dual_type import PARAMETERS


class SlopesType(WorkType):
    """The type of a tangent state's slopes as doubles, all lanes of one parameter after the other
    in the last dimension."""

    fields = SLOPED

    def __init__(self) -> None:
        super().__init__(types.float64, True, False)
        self.name = "Slopes"


@register_model(SlopesType)
class SlopesModel(models.StructModel):
    """As of a memory."""

    def __init__(self, dmm: Any, fe_type: SlopesType):
        parts = [(name, types.CPointer(types.float64)) for name in fe_type.fields]
        sizes = ("sizes", types.UniTuple(types.intp, len(Sizes._fields)))
        mesh = ("mesh", fe_type.part("mesh"))
        super().__init__(dmm, fe_type, [*parts, sizes, ("apart", types.intp), mesh])


def view_slopes(work: Any, tangent: Any) -> Any:
    """The slopes of a :class:`TangentState` of a memory, as doubles."""
    raise NotImplementedError("duals are compiled")


@infer_global(view_slopes)
class _ViewingSlopes(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        return signature(SlopesType(), *args)


@lower_builtin(view_slopes, WorkType, types.BaseTuple)
def _view_slopes(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    work = cgutils.create_struct_proxy(sig.args[0])(context, builder, value=args[0])
    sizes = cgutils.unpack_tuple(builder, work.sizes, len(Sizes._fields))
    sizes[0] = builder.mul(sizes[0], INDEX(PARAMETERS))
    kind = types.UniTuple(types.intp, len(Sizes._fields))
    block = block_of(context, builder, sig.args[1], args[1], 0)
    several = context.make_tuple(builder, kind, sizes)
    return taken_apart(context, builder, sig.return_type, block, sizes[0], several, work.mesh)
