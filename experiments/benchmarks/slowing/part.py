"""Time until the snap of arches held a little beyond the fold: with inertia alone, overdamped."""

from collections.abc import Mapping
from functools import partial
from typing import Any

from snapjump.run.studies.base import Cell, Done

from ...compositions import groups_at
from ...paper.words import Words
from .. import shallow
from ..amplitude import TIME_EXPONENTS, time_prefactor
from ..arches import DRAG, EPSILON, MISMATCH, snapping_groups
from ..base import Compared, Comparison, Source
from ..figure import draw_scalings
from ..scaling import Scaling, scaling_of
from .marches import time_rows

DISTANCES = tuple(10.0 ** (-0.5 * k) for k in range(3, 11))  # over sqrt(epsilon)


class Slowing(Source):
    """A ladder of distances for each of the two that may resist."""

    name = "slowing"
    words = Words(__file__)
    kinds = {"times": time_rows}

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """A cell for each."""
        standard = groups_at(groups, "standard")
        return [
            Cell(
                regime,
                {"kind": "times", "groups": snapping_groups(standard, regime),
                 "distances": DISTANCES, "exponent": law, "prefactor": expected(regime)},
            )
            for regime, law in TIME_EXPONENTS.items()
        ]  # fmt: skip

    def judge(self, done: Mapping[str, Done]) -> Compared:
        """Exponents and prefactors."""
        scalings = {
            regime: scaling_of(done[regime].rows, "distance", "time", law, expected(regime))
            for regime, law in TIME_EXPONENTS.items()
        }
        comparisons = [
            compare(self, regime, one)
            for compare in (exponent, prefactor)
            for regime, one in scalings.items()
        ]
        draw = partial(
            draw_scalings, scalings, "How long an arch takes that is held beyond its fold",
            "distance of α / √ε from the fold", "time until the snap (T)",
        )  # fmt: skip
        rows = [{"resists": regime, **row} for regime, one in done.items() for row in one.rows]
        section = self.section(
            comparisons, {"slowing": draw}, {"slowing_marches": rows},
            epsilon=EPSILON, mismatch=MISMATCH,
        )  # fmt: skip
        summary = {
            f"slowing_{regime}_{key}": value
            for regime, one in scalings.items()
            for key, value in (("exponent", one.fitted),
                               ("prefactor_percent", one.prefactor_percent))
        }  # fmt: skip
        return Compared(section, [], summary, comparisons)


def expected(regime: str) -> float:
    """The amplitude equation's prefactor."""
    return time_prefactor(regime, shallow.fold(shallow.lagging(MISMATCH)).product)


def exponent(part: Slowing, regime: str, one: Scaling) -> Comparison:
    """The row of an exponent."""
    return part.compared(
        regime, f"{one.fitted:.4f}", f"{one.fitted - one.exponent:+.4f}",
        part.by_limit("exponent", one.off), low=one.places[-1], high=one.places[-3],
        whole=one.whole,
        all=part.by_limit("exponent", abs(one.whole - one.exponent)), drag=DRAG,
    )  # fmt: skip


def prefactor(part: Slowing, regime: str, one: Scaling) -> Comparison:
    """The row of a prefactor, which has no number of the source beside it."""
    return part.told(
        f"prefactor {regime}", f"{one.ratios[-1] * one.prefactor:.4f}", theirs="prefactor",
        expected=one.prefactor, agrees=part.by_limit("prefactor", abs(one.prefactor_percent)),
    )  # fmt: skip
