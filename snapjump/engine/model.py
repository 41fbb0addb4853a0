"""The parts of a simulation as the kernels see them: members of families, filled with numbers."""

import operator
from typing import Any, NamedTuple

import numpy as np
from numba.core import types
from numba.core.imputils import lower_builtin
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numpy.typing import NDArray

from snapjump.contact.base import Ground
from snapjump.contact.none import NoContact
from snapjump.damping.none import NoDamping
from snapjump.drag.none import NoDrag
from snapjump.engine.load.none import NoLoad
from snapjump.friction.none import NoFriction
from snapjump.number.array import INDEX


class TimeLimit(NamedTuple):
    """The last moment (T) of a robot's march."""

    duration: Any


NO_GROUND = Ground(1.0, 1.0, 0.0)
NO_LIMIT = TimeLimit(1e300)


class Model(NamedTuple):
    """One member of each family; every number is dimensionless (EI = rho A = L = 1).

    ``ground``: what points have of the contact law (:class:`snapjump.contact.base.Ground`).
    ``time_limit``: of a jump, in its own unit of time.
    """

    discretization: Any
    frame: Any
    clamp: Any
    contact: Any = NoContact.Law()
    friction: Any = NoFriction.Law()
    damping: Any = NoDamping.Law()
    drag: Any = NoDrag.Law()
    load: Any = NoLoad()
    ground: Any = NO_GROUND
    time_limit: Any = NO_LIMIT


def numbers_of(model: Model) -> NDArray[np.float64]:
    """All numbers of a model in order, shape (P,)."""
    return np.array([float(v) for member in model for v in member])


def with_numbers(model: Any, numbers: Any) -> Any:
    """The same composition with the numbers of an array of shape (P,), of whatever number type."""
    members, position = [], 0
    for member in model:
        members.append(type(member)(*[numbers[position + k] for k in range(len(member))]))
        position += len(member)
    return Model(*members)


@infer_global(with_numbers)
class _WithNumbers(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        model, numbers = args
        members = [
            types.NamedUniTuple(numbers.dtype, len(member), member.instance_class)
            if len(member)
            else types.NamedTuple((), member.instance_class)
            for member in model.types
        ]
        return signature(types.NamedTuple(tuple(members), model.instance_class), *args)


@lower_builtin(with_numbers, types.BaseTuple, types.Array)
def _with_numbers(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    array = sig.args[1]
    entry = signature(array.dtype, array, types.intp)
    load = context.get_function(operator.getitem, entry)
    position = 0
    built = []
    for member in sig.return_type.types:
        values = []
        for _ in range(len(member)):
            values.append(load(builder, (args[1], INDEX(position))))
            position += 1
        built.append(context.make_tuple(builder, member, values))
    return context.make_tuple(builder, sig.return_type, built)
