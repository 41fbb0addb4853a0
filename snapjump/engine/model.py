"""The parts of a simulation as the kernels see them: members of families, filled with numbers."""

from typing import Any, NamedTuple

import numpy as np
from numba.core import cgutils, types
from numba.extending import intrinsic
from numpy.typing import NDArray


class Model(NamedTuple):
    """One member of each family; every number is dimensionless (EI = rho A = L = 1).

    ``contact_share`` of the friction and contact members are the weights at nodes and corners.
    """

    discretization: Any
    frame: Any
    clamp: Any
    contact: Any
    friction: Any
    damping: Any
    load: Any


def numbers_of(model: Model) -> NDArray[np.float64]:
    """All numbers of a model in order, shape (P,)."""
    return np.array([float(v) for member in model for v in member])


@intrinsic
def with_numbers(typingctx: Any, model: Any, numbers: Any) -> Any:
    """The same composition with the numbers of an array of shape (P,), of whatever number type."""
    number = numbers.dtype
    members = []
    for member in model.types:
        cls = member.instance_class
        count = len(member)
        members.append(
            types.NamedUniTuple(number, count, cls) if count else types.NamedTuple((), cls)
        )
    filled = types.NamedTuple(tuple(members), model.instance_class)

    def codegen(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        from llvmlite import ir

        array = context.make_array(numbers)(context, builder, args[1])
        position = 0
        built = []
        for member in members:
            values = []
            for _ in range(len(member)):
                index = ir.Constant(ir.IntType(64), position)
                address = cgutils.get_item_pointer(
                    context, builder, numbers, array, [index], wraparound=False
                )
                values.append(builder.load(address))
                position += 1
            built.append(context.make_tuple(builder, member, values))
        return context.make_tuple(builder, filled, built)

    return filled(model, numbers), codegen
