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
from snapjump.number.array import INDEX, uncounted_type, without_owner


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


def numbers_in(member: Any) -> list[Any]:
    """The numbers of a member, without the tables (2-d arrays) that all robots of a march share."""
    return [value for value in member if not shared(value)]


def shared(value: Any) -> bool:
    """Whether a member's value is a table."""
    return isinstance(value, np.ndarray) and value.ndim == 2


def numbers_of(model: Model) -> NDArray[np.float64]:
    """All numbers of a model in order, shape (P,)."""
    return np.array([float(v) for member in model for v in numbers_in(member)])


def with_numbers(model: Any, numbers: Any) -> Any:
    """The same composition, and tables, with the numbers of an array of shape (P,), of whatever
    number type."""
    members, given = [], iter(numbers)
    for member in model:
        members.append(type(member)(*[v if shared(v) else next(given) for v in member]))
    return Model(*members)


def is_table(kind: types.Type) -> bool:
    """Whether a member's field is a table."""
    return isinstance(kind, types.Array)


@infer_global(with_numbers)
class _WithNumbers(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        model, numbers = args
        members = []
        for member in model.types:
            kinds = [uncounted_type(k) if is_table(k) else numbers.dtype for k in member.types]
            members.append(types.BaseTuple.from_types(kinds, member.instance_class))
        return signature(types.NamedTuple(tuple(members), model.instance_class), *args)


@lower_builtin(with_numbers, types.BaseTuple, types.Array)
def _with_numbers(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    template, array = sig.args
    entry = signature(array.dtype, array, types.intp)
    load = context.get_function(operator.getitem, entry)
    position = 0
    built = []
    for k, member in enumerate(sig.return_type.types):
        values = []
        for n, kind in enumerate(member.types):
            if is_table(kind):
                table = builder.extract_value(args[0], [k, n])
                own = template.types[k].types[n]
                values.append(without_owner(context, builder, own, table))
            else:
                values.append(load(builder, (args[1], INDEX(position))))
                position += 1
        built.append(context.make_tuple(builder, member, values))
    return context.make_tuple(builder, sig.return_type, built)
