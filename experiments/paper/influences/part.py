"""``figure=influences``: every parameter's influence on the apex, one at a time."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.run.studies.base import Cell, Done, Row, column

from ...arches.critical import critical_rows
from ...compositions import changed, groups_at
from ...trends import Plateau, counter_step, plateau, power, relative_range
from ..base import Found, Part, Statement, percent, span, verdict, weakest
from ..cells import apart, each, energy_row, jumps, sliding_row, varied
from ..limits import LIMITS, judged
from ..settings import BASELINE, RANGES, TIERS
from . import figure, words
from .heights import (
    FOLLOWED,
    MOUNT_HEIGHT,
    UPRIGHT,
    VERTICAL,
    Sweeps,
    height_rows,
    height_statements,
    pressed_rows,
)
from .words import WORDS, limit_of_level, percents

Array = NDArray[np.float64]
MISMATCH = "delta_alpha_rad"


@dataclass(frozen=True)
class Sweep:
    """``count`` values of ``place`` from ``first`` to ``last`` of a design; every ``stride``-th of
    them at reference."""

    place: str
    first: float
    last: float
    count: int
    stride: int
    design: tuple[float, ...] = BASELINE

    def inputs(self, tier: str) -> dict[str, Any]:
        """Of the cell, clean of rounding, so that a coarse sweep has places of the fine one."""
        places = np.linspace(self.first, self.last, self.count).round(9)
        values = places[:: self.stride if tier == "reference" else 1].tolist()
        if self.place == MOUNT_HEIGHT:
            return {"kind": "heights", "design": self.design, "heights": values}
        return {"kind": "jumps", "designs": varied(self.place, values, self.design)}


SWEEPS = {
    VERTICAL: Sweep(MOUNT_HEIGHT, 0.01, 0.34, 133, 4, UPRIGHT),
    MOUNT_HEIGHT: Sweep(MOUNT_HEIGHT, 0.01, 0.34, 133, 4),
    "epsilon": Sweep("epsilon", 0.1, 0.3, 81, 4),
    MISMATCH: Sweep(MISMATCH, 0.0, 0.3, 101, 4),
    "mu": Sweep("mu", 0.0, 1.0, 101, 4),
    "mass_bar": Sweep("mass_bar", 0.3, 2.0, 86, 5),
}
# The paper's settings with a shorter step, where that changes what is seen of its plateau.
SHORT, SHORT_CHANGES = "paper, short step", {"stepping": {"step_s": 1e-6}}
# Of these the contact is looked into: friction against which way the beam slides, and how the
# ground bears the beam before it snaps.
SLIDING_MU = (0.1, 0.2, 0.25, 0.3, 0.45, 0.6)
PRESSED_HEIGHTS = (0.03, 0.05, 0.07, 0.15)
HIDDEN = 1.3  # a swing so many times that of a coarser step was hidden by that step
# Of these the energy is followed: the ends of the paper's range, and the baseline.
ENERGY_MASSES = (0.3, 0.768, 2.0)


def columns(rows: Sequence[Row], key: str, last: float = np.inf) -> tuple[Array, Array, Array]:
    """Places, x and y of a sweep up to ``last``."""
    v, x, y = (column(rows, name) for name in (key, "x_bar", "y_bar"))
    kept = v <= last + 1e-12
    return v[kept], x[kept], y[kept]


def ways_back(rows: Sequence[Row], key: str, rising: bool) -> tuple[float, float]:
    """The largest ways back of x and of y, which both rise or both fall."""
    _, x, y = columns(rows, key)
    return counter_step(x, rising), counter_step(y, rising)


def run(name: str, sweeps: Sweeps, key: str, rising: bool, **values: Any) -> Statement:
    """That x and y both rise or both fall."""
    own, papers = (ways_back(sweeps[tier], key, rising) for tier in FOLLOWED)
    ends = [one[[0, -1]] for one in columns(sweeps["standard"], key)]
    values |= dict(zip("vxy", ends, strict=True))
    values |= {"own": percents(own), "papers": percents(papers)}
    return WORDS.statement(name, judged("influences.monotone", *own), **values)


def mass_statement(sweeps: Sweeps, energies: Mapping[str, Sequence[Row]], near: Any) -> Statement:
    """Fall with the mass; energies: at standard and with the paper's settings, by mass."""
    curves = [columns(sweeps[tier], "mass_bar") for tier in FOLLOWED]
    powers = [power(v, one) for v, *apex in curves for one in apex]
    shares = [words.shares(energies[tier]) for tier in FOLLOWED]
    values = {"powers": powers, "released": energies["standard"][0], "shares": shares, "near": near}
    return run("mass", sweeps, "mass_bar", False, **values)


def levels_off(*found: Plateau) -> str:
    """All level off to a constant; or to a much smaller slope, and one to about a constant."""
    limit, swings = LIMITS["influences.plateau"], [one.relative_swing for one in found]
    return weakest(
        judged("influences.levelling", *(one.levelling for one in found)),
        verdict(max(swings) <= limit.confirmed, min(swings) <= limit.within),
    )


@dataclass(frozen=True)
class Mismatched:
    """A sweep of the mismatch: the ramps of x and y, their ways back until they level off, and
    what of x lies beyond."""

    x: Plateau
    y: Plateau
    back: tuple[float, float]
    beyond: Array


def mismatched(rows: Sequence[Row]) -> Mismatched:
    """The sweep's."""
    v, x, y = columns(rows, MISMATCH)
    in_x, in_y = plateau(v, x), plateau(v, y)
    rising, falling = v <= in_x.threshold, v <= in_y.threshold
    back = counter_step(x[rising], True), counter_step(y[falling], False)
    return Mismatched(in_x, in_y, back, x[v >= in_x.threshold])


def mismatch_statements(sweeps: Sweeps, near: Any) -> list[Statement]:
    """Growth of x and fall of y with the mismatch, and the plateau that follows."""
    own, papers = (mismatched(sweeps[tier]) for tier in FOLLOWED)
    v, short_x, _ = columns(sweeps[SHORT], MISMATCH)
    short = float(np.ptp(short_x[v >= papers.x.threshold]) / papers.x.level)
    came, hidden = levels_off(own.x, own.y), short > HIDDEN * papers.x.relative_swing
    both = {"own": own, "papers": papers, "back": percents(own.back), "near": near}
    tuning = judged("influences.monotone", *own.back)
    level = WORDS.statement(
        "plateau", came, limit=limit_of_level(came, {"x_c": own.x, "y_c": own.y}), last=v[-1],
        swings=percents(one.relative_swing for one in (own.x, own.y, papers.x, papers.y)),
        below=own.x.level - own.beyond.min(), above=own.beyond.max() - own.x.level,
        short=percent(short), hidden=", so that it is the step that levels it" if hidden else "",
        **both,
    )  # fmt: skip
    return [WORDS.statement("mismatch", tuning, fall=-own.y.slope_before, **both), level]


def friction_statements(sweeps: Sweeps, sliding: Sequence[Row], near: Any) -> list[Statement]:
    """What friction does not change, and where it changes no more."""
    last, wide = RANGES["mu"][1], columns(sweeps["standard"], "mu")[2]
    (v, x, y), (_, paper_x, paper_y) = (columns(sweeps[tier], "mu", last) for tier in FOLLOWED)
    own, papers = plateau(v, x), plateau(v, paper_x)
    spreads = [relative_range(one) for one in (y, paper_y, wide)]
    came, alone = levels_off(own), judged("influences.friction_height", spreads[0])
    both = {"last": last, "near": near}
    told = {"y": span(y), "spreads": percents(spreads), **both}
    grown = WORDS.statement(
        "friction_threshold", came, limit=limit_of_level(came, {"x_c": own}), own=own,
        papers=papers, swings=percents([own.relative_swing, papers.relative_swing]),
        why=words.why(sliding, own.threshold), **both,
    )  # fmt: skip
    return [WORDS.statement("friction_height", alone, **told), grown]


class Influences(Part):
    """Sweeps at three tiers, the statics that they are laid beside, and the contact."""

    name = "influences"
    title = "Influences of the parameters on the apex"
    every_jump = True
    kinds = {
        "jumps": jumps,
        "heights": height_rows,
        "statics": critical_rows,
        "sliding": each(sliding_row, "mu"),
        "pressed": pressed_rows,
        "energies": each(energy_row, "mass_bar"),
    }

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """Sweeps and statics by tier; the contact at standard; the energy."""
        at = {tier: groups_at(groups, tier) for tier in TIERS}

        def cell(name: str, tier: str, **inputs: Any) -> Cell:
            return Cell(f"{name}, {tier}", {"kind": name, "groups": at[tier], **inputs})

        arch = {"epsilons": [BASELINE[1]], "delta_alphas_rad": [0.0]}
        short = {"groups": changed(at["paper"], SHORT_CHANGES), **SWEEPS[MISMATCH].inputs("paper")}
        masses = varied("mass_bar", ENERGY_MASSES)
        return [
            *(cell(n, tier, **one.inputs(tier)) for n, one in SWEEPS.items() for tier in TIERS),
            Cell(f"{MISMATCH}, {SHORT}", short),
            *(cell("statics", tier, **arch) for tier in TIERS),
            cell("sliding", "standard", designs=varied("mu", SLIDING_MU)),
            cell("pressed", "standard", design=BASELINE, heights=PRESSED_HEIGHTS),
            *(cell("energies", tier, designs=masses) for tier in FOLLOWED),
        ]

    def judge(self, done: Mapping[str, Done]) -> Found:
        """The statements in the paper's order; figures of sweeps, heights and friction."""
        rows = {name: one.rows for name, one in done.items()}
        sweeps = {name: {tier: rows[f"{name}, {tier}"] for tier in TIERS} for name in SWEEPS}
        near = {
            name: {"off": apart(one, SWEEPS[name].place), "counts": {t: len(one[t]) for t in TIERS}}
            for name, one in sweeps.items()
        }
        sweeps[MISMATCH] |= {SHORT: rows[f"{MISMATCH}, {SHORT}"]}
        statics = {tier: rows[f"statics, {tier}"][0] for tier in TIERS}
        energies = {tier: rows[f"energies, {tier}"] for tier in FOLLOWED}
        sliding, pressed = rows["sliding, standard"], rows["pressed, standard"]
        heights = {name: sweeps[name] for name in (VERTICAL, MOUNT_HEIGHT)}
        four = {name: sweep for name, sweep in sweeps.items() if name not in heights}
        figures = {
            "influences": partial(figure.draw_influences, four),
            "influences_height": partial(figure.draw_heights, heights, statics["standard"]),
            "influences_friction": partial(figure.draw_friction, sweeps["mu"], sliding),
        }
        kept = ("h1_bar", "h2_bar", "alpha_critical_rad", "energy_released_bar")
        tables = {
            "influences_heights": [
                {"tier": tier, **{key: row[key] for key in kept}} for tier, row in statics.items()
            ],
            "influences_energies": [
                {"tier": tier, **row} for tier, found in energies.items() for row in found
            ],
            "influences_pressed": pressed,
            "influences_sliding": sliding,
        }
        told = words.differences([*four.values(), sweeps[MOUNT_HEIGHT]])
        return Found(
            WORDS.section(self.title, figures, tables, **told),
            [
                *height_statements(heights, statics, pressed, near),
                run("growth", sweeps["epsilon"], "epsilon", True, near=near["epsilon"]),
                *mismatch_statements(sweeps[MISMATCH], near[MISMATCH]),
                *friction_statements(sweeps["mu"], sliding, near["mu"]),
                mass_statement(sweeps["mass_bar"], energies, near["mass_bar"]),
            ],
        )
