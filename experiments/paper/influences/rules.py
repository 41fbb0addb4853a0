"""When a curve runs one way, levels off, or is a constant: the rules of the verdicts."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from experiments.paper.jumps import numbers
from experiments.paper.statement import LIMITED, verdict
from experiments.paper.trends import Plateau, counter_step
from snapjump.studies.base import Row

Array = NDArray[np.float64]
Sweeps = Mapping[str, Sequence[Row]]

# Largest way back of a curve that runs one way, as a share of its change; and of one that does
# with waves.
MONOTONE, WAVY = 0.02, 0.1
# A plateau: its swing as a share of its level; or at least its slope as a share of the ramp's.
FLAT, LEVELLING = 0.05, 0.2
# And of one that is about flat: a twentieth of its level either way.
ROUGHLY_FLAT = 0.1
# Of a value that does not depend on something: its range as a share of its mean; and about so.
CONSTANT, ROUGHLY_CONSTANT = 0.02, 0.1
COMMAND = "task=paper figure=influences"


def columns(rows: Sequence[Row], key: str, last: float = np.inf) -> tuple[Array, Array, Array]:
    """Places, x and y of a sweep up to ``last``."""
    v, x, y = (numbers(rows, name) for name in (key, "x_bar", "y_bar"))
    kept = v <= last + 1e-12
    return v[kept], x[kept], y[kept]


def ways_back(rows: Sequence[Row], key: str, x_rises: bool, y_rises: bool) -> tuple[float, float]:
    """The largest ways back of x and of y."""
    _, x, y = columns(rows, key)
    return counter_step(x, x_rises), counter_step(y, y_rises)


def one_way(back: tuple[float, float]) -> str:
    """Both coordinates run one way throughout; or with waves."""
    worst = float(np.max(back))  # NaN whatever the order, where max() is not
    return verdict(worst <= MONOTONE, worst <= WAVY)


def levels_off(*found: Plateau) -> str:
    """All level off to a constant; or to a much smaller slope, and one to about a constant."""
    levelling = all(one.levelling <= LEVELLING for one in found)
    swings = np.array([one.relative_swing for one in found])
    return verdict(
        levelling and bool((swings <= FLAT).all()),
        levelling and bool((swings <= ROUGHLY_FLAT).any()),
    )


def limit_of_level(came: str, found: Mapping[str, Plateau]) -> str:
    """What a limited verdict of :func:`levels_off` is limited to, in front of what is found.

    found: the curves by their symbols."""
    if came != LIMITED:
        return ""
    kept = [name for name, one in found.items() if one.relative_swing <= ROUGHLY_FLAT]
    if len(kept) < len(found):
        return f"In {' and '.join(kept)} only. "
    return f"To within {percent(max(found[name].relative_swing for name in kept))}. "


def independent(values: Array) -> str:
    """Whether a value is a constant, or about so."""
    spread = relative_range(values)
    return verdict(spread <= CONSTANT, spread <= ROUGHLY_CONSTANT)


def relative_range(values: Array) -> float:
    """From the lowest to the highest, as a share of the mean."""
    return float(np.ptp(values) / np.mean(values))


def power(places: Array, values: Array) -> float:
    """The exponent of the power law through positive values."""
    return float(np.polyfit(np.log(places), np.log(values), 1)[0])


def percent(share: float) -> str:
    """A share for reading."""
    return f"{100.0 * share:.2g} %"
