"""Pre-compression, mismatch, friction and mass: which way the apex moves, and where no more."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from experiments.paper.baseline import RANGES
from experiments.paper.jumps import numbers
from experiments.paper.statement import Statement, verdict
from experiments.paper.trends import Plateau, counter_step, plateau
from snapjump.studies.base import Row

Array = NDArray[np.float64]
Sweeps = Mapping[str, Sequence[Row]]

# Largest way back of a curve that runs one way, as a share of its change; and of one that does
# with waves.
MONOTONE, WAVY = 0.02, 0.1
# A plateau: its swing as a share of its level; or at least its slope as a share of the ramp's.
FLAT, LEVELLING = 0.05, 0.2
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
    return verdict(max(back) <= MONOTONE, max(back) <= WAVY)


def levels_off(*found: Plateau) -> str:
    """All level off to a constant; or at least to a much smaller slope."""
    levelling = all(one.levelling <= LEVELLING for one in found)
    return verdict(
        levelling and all(one.relative_swing <= FLAT for one in found),
        levelling,
    )


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


def epsilon_statement(sweeps: Sweeps, accuracy: str) -> Statement:
    """Growth with the pre-compression."""
    own, papers = (ways_back(sweeps[t], "epsilon", True, True) for t in ("standard", "paper"))
    v, x, y = columns(sweeps["standard"], "epsilon")
    return Statement(
        "x_c and y_c grow monotonically with the pre-compression ε.",
        one_way(own),
        f"From ε = {v[0]:g} to {v[-1]:g} x_c grows from {x[0]:.2g} to {x[-1]:.2g} L and y_c from "
        f"{y[0]:.2g} to {y[-1]:.2g} L; the largest way back is {_percent(own[0])} and "
        f"{_percent(own[1])} of the growth (the paper's settings: {_percent(papers[0])} and "
        f"{_percent(papers[1])}, the roughness of their time step).",
        accuracy,
        COMMAND,
    )


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
    return [
        Statement(
            "A larger mismatch Δα raises x_c and lowers y_c, up to a threshold.",
            verdicts["standard"][0],
            f"x_c rises by {in_x.slope_before:.0f} L/rad up to {in_x.threshold:.2g} rad and y_c "
            f"falls by {-in_y.slope_before:.0f} L/rad up to {in_y.threshold:.2g} rad; the "
            f"largest way back is {_percent(back[0])} and {_percent(back[1])} of the change (the "
            f"paper's settings: up to {paper_x.threshold:.2g} and {paper_y.threshold:.2g} rad).",
            accuracy,
            COMMAND,
        ),
        Statement(
            "Beyond the threshold x_c and y_c are on a plateau.",
            verdicts["standard"][1],
            f"Up to {v[-1]:g} rad y_c stays within {_percent(in_y.relative_swing)} from lowest to "
            f"highest about {in_y.level:.3g} L, x_c within {_percent(in_x.relative_swing)} about "
            f"{in_x.level:.2g} L: it dips before it is level. With the paper's settings the swings "
            f"are {_percent(paper_y.relative_swing)} and {_percent(paper_x.relative_swing)}, but "
            f"with a step a tenth as long x_c swings by {_percent(short)}: its step hides the dip.",
            accuracy,
            COMMAND,
        ),
    ]


def friction_statements(sweeps: Sweeps, sliding: Sequence[Row], accuracy: str) -> list[Statement]:
    """What friction does not change, and where it changes no more."""
    last = RANGES["mu"][1]
    v, x, y = columns(sweeps["standard"], "mu", last)
    _, paper_x, paper_y = columns(sweeps["paper"], "mu", last)
    own, papers = plateau(v, x), plateau(v, paper_x)
    _, _, all_y = columns(sweeps["standard"], "mu")
    low, high = sliding[0], sliding[-1]
    ratio = numbers(sliding, "friction_over_normal")
    return [
        Statement(
            "y_c does not depend on the friction coefficient μ.",
            independent(y),
            f"Over μ in [0, {last:g}] y_c lies between {y.min():.1f} and {y.max():.1f} L, a range "
            f"of {_percent(relative_range(y))} of its mean (the paper's settings: "
            f"{_percent(relative_range(paper_y))}); up to μ = 1 of "
            f"{_percent(relative_range(all_y))}.",
            accuracy,
            COMMAND,
        ),
        Statement(
            "x_c grows with μ up to a threshold, and no more beyond.",
            levels_off(own),
            f"x_c grows in proportion to μ, by {own.slope_before:.0f} L, up to μ = "
            f"{own.threshold:.2g}, then stays within {_percent(own.relative_swing)} from lowest "
            f"to highest about {own.level:.2g} L up to {last:g} (the paper's settings: "
            f"{papers.threshold:.2g}, {_percent(papers.relative_swing)}). Not because the contact "
            f"sticks: at most {_percent(max(row['sticking_share'] for row in sliding))} of the "
            "beam's normal impulse acts where it does. Beyond the threshold the beam slides to "
            f"and fro: the share that brakes grows from {_percent(low['braking_share'])} at μ = "
            f"{low['mu']:g} to {_percent(high['braking_share'])} at {high['mu']:g}, so that the "
            f"net friction stays at {ratio[2:].min():.2f} to {ratio[2:].max():.2f} of the normal "
            "impulse.",
            accuracy,
            COMMAND,
        ),
    ]


def mass_statement(sweeps: Sweeps, statics: Row, accuracy: str) -> Statement:
    """Fall with the mass."""
    own, papers = (ways_back(sweeps[t], "mass_bar", False, False) for t in ("standard", "paper"))
    v, x, y = columns(sweeps["standard"], "mass_bar")
    _, paper_x, paper_y = columns(sweeps["paper"], "mass_bar")
    gained = v * (y - numbers(sweeps["standard"], "liftoff_y_bar"))
    share = gained / statics["energy_released_bar"]
    return Statement(
        "x_c and y_c fall as the mass m̄ grows.",
        one_way(own),
        f"From m̄ = {v[0]:g} to {v[-1]:g} x_c falls from {x[0]:.2g} to {x[-1]:.2g} L and y_c from "
        f"{y[0]:.2g} to {y[-1]:.2g} L, with ways back of {_percent(own[0])} and "
        f"{_percent(own[1])} (the paper's settings: {_percent(papers[0])} and "
        f"{_percent(papers[1])}). They fall like m̄^{power(v, x):.2f} and m̄^{power(v, y):.2f} (the "
        f"paper's settings: {power(v, paper_x):.2f} and {power(v, paper_y):.2f}), not like 1/m̄: "
        f"of the {statics['energy_released_bar']:.2g} EI/L that the snap releases a light robot "
        f"turns {_percent(share[0])} into height, a heavy one {_percent(share[-1])}.",
        accuracy,
        COMMAND,
    )


def _percent(share: Any) -> str:
    return f"{100.0 * share:.2g} %"
