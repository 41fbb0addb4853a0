"""Methods of members on a card, whose compiler keeps a list of its own of what types have."""

from typing import Any

from numba.core import types
from numba.cuda.cudadecl import registry as typing
from numba.cuda.cudaimpl import registry as lowering

from snapjump.engine.view import WorkParts, WorkType, part_of
from snapjump.number.methods import CALLS, METHODS_KEY, MethodsOfTuples, MethodsOfUniformTuples

typing.register_attr(WorkParts)
lowering.lower_getattr_generic(WorkType)(part_of)
typing.register_attr(MethodsOfTuples)
typing.register_attr(MethodsOfUniformTuples)
known: set[Any] = set()


def register_methods() -> None:
    """Tell the card's compiler all methods that there are by now."""
    for function, call in CALLS.items():
        if function not in known:
            lowering.lower((METHODS_KEY, function), types.BaseTuple, types.VarArg(types.Any))(call)
            known.add(function)
