"""What operations and lines of memory cost this processor at least: cycles, measured on the spot.

Operations go in chains that do not wait for each other; lines are those of an array as large as a
march's memory.
"""

from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numba import njit

from snapjump.number.dispatch import kernel
from snapjump.number.functions import fma, sqrt
from snapjump.number.lane import view_numbers
from snapjump.number.memory import aligned_zeros

from .clock_rate import cycles_of

STEPS = 200_000
PASSES = 100  # over the array
LINE = (0,) * 8  # lanes that fill a line of the caches


class Costs(NamedTuple):
    """Cycles: of an operation on a number, or on lanes of them, among others of its kind, of one
    of sums and products in turns, and of a line that comes into the fastest cache and leaves it as
    it came, or is written back."""

    sums: float
    products: float
    fused: float
    turns: float
    quotients: float
    roots: float
    lines_read: float
    lines_written: float


@kernel
def add(a: Any, b: Any) -> Any:
    """A sum."""
    return a + b


@kernel
def multiply(a: Any, b: Any) -> Any:
    """A product."""
    return a * b


@kernel
def fuse(a: Any, b: Any) -> Any:
    """A fused product and sum, which stays where it is at 1/2."""
    return fma(a, a, b)


@kernel
def divide(a: Any, b: Any) -> Any:
    """A quotient that is never simple."""
    return b / a


@kernel
def root(a: Any, b: Any) -> Any:
    """A root that is never simple, of a product that costs less."""
    return sqrt(a * b)


def chains(one: Any, other: Any) -> dict[int, Any]:
    """Programs of four and of eight chains, of two operations in turns: eight are too many for few
    registers, and four too few where one holds all lanes."""

    @njit(error_model="numpy")
    def four(numbers: Any, lanes: Any, steps: int) -> None:
        x = view_numbers(numbers, lanes)
        a, b, c, d, y = x[0], x[1], x[2], x[3], x[8]
        for _ in range(steps):
            a, b, c, d = one(a, y), other(b, y), one(c, y), other(d, y)
        x[0], x[1], x[2], x[3] = a, b, c, d

    @njit(error_model="numpy")
    def eight(numbers: Any, lanes: Any, steps: int) -> None:
        x = view_numbers(numbers, lanes)
        a, b, c, d, y = x[0], x[1], x[2], x[3], x[8]
        e, f, g, h = x[4], x[5], x[6], x[7]
        for _ in range(steps):
            a, b, c, d = one(a, y), other(b, y), one(c, y), other(d, y)
            e, f, g, h = one(e, y), other(f, y), one(g, y), other(h, y)
        x[0], x[1], x[2], x[3] = a, b, c, d
        x[4], x[5], x[6], x[7] = e, f, g, h

    return {4: four, 8: eight}


@njit(error_model="numpy")
def read(numbers: Any, lanes: Any, passes: int) -> None:
    """Read an array again and again."""
    x = view_numbers(numbers, lanes)
    a, b, c, d = x[0], x[1], x[2], x[3]
    for _ in range(passes):
        for k in range(0, x.shape[0] - 3, 4):
            a, b, c, d = a + x[k], b + x[k + 1], c + x[k + 2], d + x[k + 3]
    x[0] = (a + b) + (c + d)


@njit(error_model="numpy")
def update(numbers: Any, lanes: Any, passes: int) -> None:
    """Read and write an array again and again."""
    x = view_numbers(numbers, lanes)
    y = x[0]
    for _ in range(passes):
        for k in range(x.shape[0]):
            x[k] = x[k] + y


def costs(width: int, memory_bytes: int) -> Costs:
    """Of so many lanes and a memory of that size."""

    def of_operation(one: Any, other: Any, first: float, second: float) -> float:
        numbers = aligned_zeros((9, width))
        numbers[:8], numbers[8] = first, second
        lanes = (0,) * width
        return min(
            cycles_of(partial(program, numbers, lanes, STEPS)) / (count * STEPS)
            for count, program in chains(one, other).items()
        )

    def of_line(program: Any) -> float:
        lines = aligned_zeros((memory_bytes // np.dtype(float).itemsize // len(LINE), len(LINE)))
        return cycles_of(partial(program, lines, LINE, PASSES)) / (PASSES * len(lines))

    return Costs(
        sums=of_operation(add, add, 1.0, 0.0),
        products=of_operation(multiply, multiply, 1.7, 1.0),
        fused=of_operation(fuse, fuse, 0.5, 0.25),
        turns=of_operation(add, multiply, 1.0, 1.0),
        quotients=of_operation(divide, divide, 1.7, 3.1),
        roots=of_operation(root, root, 1.7, 3.1),
        lines_read=of_line(read),
        lines_written=of_line(update),
    )
