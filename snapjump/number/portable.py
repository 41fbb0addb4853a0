"""Powers and logarithms for Python code whose bits must not depend on the processor.

``**``, ``math.pow`` and ``math.log1p`` are the system library's, which picks among versions by the
processor and rounds differently in each. These are the kernels' own, compiled.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.number.dispatch import compiled
from snapjump.number.exponentials import exp, log

Array = NDArray[np.float64]


@compiled
def power(base: float, exponent: float) -> float:
    """A positive number to any power, good to a few units in the last place."""
    return exp(exponent * log(base))


@compiled
def fill_powers(bases: Array, exponent: float, found: Array) -> None:
    """Powers of positive numbers (R,), into an array of as many."""
    for k in range(bases.shape[0]):
        found[k] = exp(exponent * log(bases[k]))


def powers(bases: Any, exponent: float) -> Array:
    """Positive numbers (R,), or one, to any power (R,)."""
    plain = np.atleast_1d(np.asarray(bases, dtype=float))
    found = np.empty(plain.shape)
    fill_powers(plain, exponent, found)
    return found


@compiled
def log1p(x: float) -> float:
    """Logarithm of 1 + x, of small x too (Kahan): what 1 + x loses, the quotient gives back."""
    y = 1.0 + x
    if y == 1.0:
        return x
    return log(y) * (x / (y - 1.0))
