"""Pre-compression and mass: which way the apex moves."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from experiments.paper.jumps import numbers
from experiments.paper.statement import LIMITED, Statement, verdict
from experiments.trends import Plateau, counter_step, plateau
from snapjump.run.studies.base import Row

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


TOLD = 0.01  # of the energy: shares below it are not worth a word


def epsilon_statement(sweeps: Sweeps, accuracy: str) -> Statement:
    """Growth with the pre-compression."""
    own, papers = (ways_back(sweeps[t], "epsilon", True, True) for t in ("standard", "paper"))
    v, x, y = columns(sweeps["standard"], "epsilon")
    return Statement(
        "x_c and y_c grow monotonically with the pre-compression ε.",
        one_way(own),
        f"From ε = {v[0]:g} to {v[-1]:g} x_c grows from {x[0]:.2g} to {x[-1]:.2g} L and y_c from "
        f"{y[0]:.2g} to {y[-1]:.2g} L; the largest way back is {percent(own[0])} and "
        f"{percent(own[1])} of the growth (the paper's settings: {percent(papers[0])} and "
        f"{percent(papers[1])}).",
        accuracy,
        COMMAND,
    )


def mass_statement(
    sweeps: Sweeps, energies: Mapping[str, Sequence[Row]], accuracy: str
) -> Statement:
    """Fall with the mass; energies: at standard and with the paper's settings, by mass."""
    own, papers = (ways_back(sweeps[t], "mass_bar", False, False) for t in ("standard", "paper"))
    v, x, y = columns(sweeps["standard"], "mass_bar")
    _, paper_x, paper_y = columns(sweeps["paper"], "mass_bar")
    released = energies["standard"][0]["energy_released_bar"]
    return Statement(
        "x_c and y_c fall as the mass m̄ grows.",
        one_way(own),
        f"From m̄ = {v[0]:g} to {v[-1]:g} x_c falls from {x[0]:.2g} to {x[-1]:.2g} L and y_c from "
        f"{y[0]:.2g} to {y[-1]:.2g} L, with ways back of {percent(own[0])} and "
        f"{percent(own[1])} (the paper's settings: {percent(papers[0])} and "
        f"{percent(papers[1])}). They fall like m̄^{power(v, x):.2f} and m̄^{power(v, y):.2f} (the "
        f"paper's settings: {power(v, paper_x):.2f} and {power(v, paper_y):.2f}), where height "
        f"in proportion to energy would be m̄^-1. Of what the slow snap of the mismatched arch "
        f"releases, {released:.2g} EI/L, {shares(energies['standard'])}. With the paper's "
        f"settings {shares(energies['paper'])}.",
        accuracy,
        COMMAND,
    )


def shares(rows: Sequence[Row]) -> str:
    """Where the energy goes, of the lightest and of the heaviest robot."""
    names = {
        "rise": "becomes height above where the robot stands",
        "friction": "goes to friction",
        "damping": "to the material's damping",
        "numerical": "to the integrator",
        "turning": "to turning and vibration",
    }
    told = ", ".join(
        f"{percent(rows[0][f'{name}_share'])} and {percent(rows[-1][f'{name}_share'])} {what}"
        for name, what in names.items()
        if max(abs(row[f"{name}_share"]) for row in rows) >= TOLD
    )
    return f"at m̄ = {rows[0]['mass_bar']:g} and at {rows[-1]['mass_bar']:g}, in this order, {told}"


# A swing so many times that of a coarser step was hidden by that step.
HIDDEN = 1.3


def mismatch_statements(sweeps: Sweeps, accuracy: str) -> list[Statement]:
    """Growth of x and fall of y with the mismatch, and the plateau that follows."""
    told, verdicts = {}, {}
    for tier in ("standard", "paper"):
        v, x, y = columns(sweeps[tier], "delta_alpha_rad")
        in_x, in_y = plateau(v, x), plateau(v, y)
        rising, falling = v <= in_x.threshold, v <= in_y.threshold
        back = counter_step(x[rising], True), counter_step(y[falling], False)
        verdicts[tier] = one_way(back), levels_off(in_x, in_y)
        told[tier] = in_x, in_y, back
    (in_x, in_y, back), (paper_x, paper_y, _) = told["standard"], told["paper"]
    v, short_x, _ = columns(sweeps["paper, short step"], "delta_alpha_rad")
    short = np.ptp(short_x[v >= paper_x.threshold]) / paper_x.level
    hidden = short > HIDDEN * paper_x.relative_swing
    places, x, _ = columns(sweeps["standard"], "delta_alpha_rad")
    beyond = x[places >= in_x.threshold]
    low, high = float(beyond.min()), float(beyond.max())
    return [
        Statement(
            "A larger mismatch Δα raises x_c and lowers y_c, up to a threshold.",
            verdicts["standard"][0],
            f"The apex's x_c rises by {in_x.slope_before:.0f} L/rad up to {in_x.threshold:.2g} rad "
            f"and y_c falls by {-in_y.slope_before:.0f} L/rad up to {in_y.threshold:.2g} rad; the "
            f"largest way back is {percent(back[0])} and {percent(back[1])} of the change (the "
            f"paper's settings: up to {paper_x.threshold:.2g} and {paper_y.threshold:.2g} rad).",
            accuracy,
            COMMAND,
        ),
        Statement(
            "Beyond the threshold x_c and y_c are on a plateau.",
            verdicts["standard"][1],
            limit_of_level(verdicts["standard"][1], {"x_c": in_x, "y_c": in_y})
            + f"Up to {v[-1]:g} rad y_c stays within {percent(in_y.relative_swing)} from lowest to "
            f"highest about {in_y.level:.3g} L, x_c within {percent(in_x.relative_swing)} about "
            f"{in_x.level:.2g} L, where it lies between {in_x.level - low:.2g} L below and "
            f"{high - in_x.level:.2g} L above. With the paper's settings the swings are "
            f"{percent(paper_y.relative_swing)} and {percent(paper_x.relative_swing)}; of x_c "
            f"with a step a tenth as long {percent(short)}"
            + (", so that it is the step that levels it." if hidden else "."),
            accuracy,
            COMMAND,
        ),
    ]
