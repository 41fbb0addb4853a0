"""Methods of members: written in the body of a NamedTuple, called in Python and in numba alike.

A family of modules has a contract: a class that declares the methods which kernels call, some of
them with a body that members may leave as it is. A member is a ``NamedTuple`` of numbers whose
body has the others. numba resolves a call by the member's class while it compiles, so that a choice
costs nothing at run time.
"""

import inspect
from collections import Counter
from collections.abc import Callable
from functools import cache
from typing import Any

from numba.core import types
from numba.core.imputils import lower_builtin
from numba.core.typing.templates import (
    AbstractTemplate,
    AttributeTemplate,
    infer_getattr,
    signature,
)

from snapjump.declare.fields import required
from snapjump.number.dispatch import kernel

Function = Callable[..., Any]
__all__ = ["Contract", "ContractError", "required"]
METHODS_KEY = "snapjump.methods"
METHODS: dict[tuple[type, str], Function] = {}
NAMES: Counter[str] = Counter()
CALLS: dict[Function, Function] = {}  # how numba writes a call of each
# Of arguments, which plug-ins may still have.
FORMER_NAMES = {"approach": "state", "turning": "rotations", "weights": "coefficients"}
OF_TUPLES = ("_make", "_replace", "_asdict")


class ContractError(TypeError):
    """A member does not fulfil its contract; the message is one line."""


class Contract:
    """A contract: the methods of every member of a family, which kernels call."""

    @classmethod
    def member(cls, member: Any) -> Any:
        """Let a NamedTuple class follow the contract. Raises ContractError."""
        for name, declared in methods_of(cls).items():
            given = vars(member).get(name)
            if given is None and getattr(declared, "is_required", False):
                asked = f"{name}({', '.join(inspect.signature(declared).parameters)})"
                raise ContractError(f"{member.__qualname__} has no method {asked}")
            if given is not None and parameters(given) != parameters(declared):
                raise ContractError(
                    f"{member.__qualname__}.{name} takes {', '.join(parameters(given))}: "
                    f"{', '.join(parameters(declared))} are what it is called with"
                )
            setattr(member, name, given or declared)
        for name, function in methods_of(member).items():
            METHODS[member, name] = compiled_too(function)
        member.__name__ = name_of_its_own(member)
        return member


def name_of_its_own(member: type) -> str:
    """A name that no other member has, one that was defined before in its place included.

    numba's programs tell the tuples that they are called with apart by the names of class and
    fields alone: of two laws that are both called Law, the second would run the first one's code.
    """
    name = f"{member.__module__}.{member.__qualname__}".encode("ascii", "backslashreplace").decode()
    NAMES[name] += 1
    return name if NAMES[name] == 1 else f"{name}#{NAMES[name]}"


def methods_of(cls: type) -> dict[str, Function]:
    """Functions in the body of a class and of contracts that it extends."""
    found: dict[str, Function] = {}
    for base in reversed(cls.__mro__):
        if base is not Contract and base.__module__ not in ("builtins", "typing"):
            found |= {n: f for n, f in vars(base).items() if inspect.isfunction(f)}
    return {n: f for n, f in found.items() if not n.startswith("__") and n not in OF_TUPLES}


def parameters(function: Function) -> list[str]:
    """Names of a method's arguments but for itself."""
    return [FORMER_NAMES.get(name, name) for name in inspect.signature(function).parameters][1:]


@cache
def compiled_too(function: Function) -> Function:
    """The function, known to numba as a kernel and as a method."""
    kernel(function)

    def call_it(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        kind = context.typing_context.resolve_value_type(function)
        plain = kind.get_call_type(context.typing_context, sig.args, {})
        call = context.get_function(kind, plain)
        context.add_linking_libs(getattr(call, "libs", ()))
        if len(args) < len(sig.args):  # numba leaves out a receiver that has no numbers
            args = [context.get_constant_null(sig.args[0]), *args]
        return call(builder, args)

    CALLS[function] = call_it
    lower_builtin((METHODS_KEY, function), types.BaseTuple, types.VarArg(types.Any))(call_it)
    return function


class MemberMethods(AttributeTemplate):
    """Typing of ``member.method``."""

    def generic_resolve(self, member: Any, name: str) -> Any:
        function = METHODS.get((member.instance_class, name))
        if function is None:
            return None
        context = self.context

        class Method(AbstractTemplate):
            key = (METHODS_KEY, function)

            def generic(self, args: Any, kws: Any) -> Any:
                kind = context.resolve_value_type(function)
                found = kind.get_call_type(context, (member, *args), kws)
                return signature(found.return_type, *found.args[1:], recvr=member)

        return types.BoundFunction(Method, member)


@infer_getattr
class MethodsOfTuples(MemberMethods):
    """Of members whose numbers have different types."""

    key = types.NamedTuple


@infer_getattr
class MethodsOfUniformTuples(MemberMethods):
    """Of members whose numbers have one type."""

    key = types.NamedUniTuple
