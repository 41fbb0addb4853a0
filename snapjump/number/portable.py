"""Powers and logarithms for Python code whose bits must not depend on the processor.

``**``, ``math.pow`` and ``math.log1p`` are the system library's, which picks among versions by the
processor and rounds differently in each. These are the kernels' own, compiled.
"""

from snapjump.number.dispatch import compiled
from snapjump.number.exponentials import exp, log


@compiled
def power(base: float, exponent: float) -> float:
    """A positive number to any power, good to a few units in the last place."""
    return exp(exponent * log(base))


@compiled
def log1p(x: float) -> float:
    """Logarithm of 1 + x, of small x too (Kahan): what 1 + x loses, the quotient gives back."""
    y = 1.0 + x
    if y == 1.0:
        return x
    return log(y) * (x / (y - 1.0))
