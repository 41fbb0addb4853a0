"""Commands that measure: their options are the arguments of a function, whose report is printed."""

import json
import sys
from argparse import ArgumentParser
from collections.abc import Callable
from inspect import Parameter, signature
from typing import Any

from snapjump.checks import ParameterError


def measured(report: Callable[..., Any]) -> None:
    """Call a function as the command line asks, and print what it returns as one JSON object.

    A keyword argument is an option of its default's type, of several words where that is a tuple,
    and a flag where it is a truth value; ``*words`` are all other words. What is refused is told
    in one line, with exit code 2.
    """
    parser = ArgumentParser(description=sys.modules[report.__module__].__doc__)
    words = ""
    for name, argument in signature(report).parameters.items():
        option, default = f"--{name.replace('_', '-')}", argument.default
        if argument.kind is Parameter.VAR_POSITIONAL:
            parser.add_argument(words := name, nargs="*")
        elif isinstance(default, bool):
            parser.add_argument(option, action="store_true")
        elif isinstance(default, tuple):
            parser.add_argument(option, nargs="*", default=default)
        else:
            parser.add_argument(option, type=type(default), default=default)
    given = vars(parser.parse_args())
    try:
        print(json.dumps(report(*given.pop(words, ()), **given), indent=2))
    except ParameterError as error:
        print(error)
        sys.exit(2)
