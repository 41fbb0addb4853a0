"""Delay of the snap behind the fold by the rate of the clamps: with inertia alone, overdamped."""

from collections.abc import Mapping
from functools import partial
from typing import Any

from snapjump.run.studies.base import Cell, Done

from ...compositions import composed, groups_at
from ...paper.words import Words
from .. import shallow
from ..amplitude import DELAY_EXPONENTS, delay_prefactor
from ..arches import DAMPING, DRAG, ELEMENTS, EPSILON, INERTIA, MISMATCH, snapping_groups
from ..base import Compared, Comparison, Source
from ..figure import draw_scalings
from ..scaling import Scaling, scaling_of
from .marches import delay_rows

RATES = {  # over sqrt(epsilon), 1/T
    INERTIA: tuple(10.0 ** (-0.5 * k) for k in range(2, 8)),
    DAMPING: tuple(10.0 ** (-0.5 * k) for k in range(3, 9)),
}


class Delay(Source):
    """A ladder of rates for each of the two that may resist."""

    name = "delay"
    words = Words(__file__)
    kinds = {"delays": delay_rows}

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """A cell for each."""
        standard = groups_at(groups, "standard")
        made = {regime: snapping_groups(standard, regime) for regime in RATES}
        self.unit_s = composed(made[INERTIA]).robot.scales.time_s
        return [
            Cell(
                regime,
                {"kind": "delays", "groups": made[regime], "rates": rates,
                 "exponent": DELAY_EXPONENTS[regime], "prefactor": expected(regime)},
            )
            for regime, rates in RATES.items()
        ]  # fmt: skip

    def judge(self, done: Mapping[str, Done]) -> Compared:
        """Exponents and prefactors."""
        scalings = {
            regime: scaling_of(done[regime].rows, "rate", "delay", law, expected(regime))
            for regime, law in DELAY_EXPONENTS.items()
        }
        comparisons = [
            compare(self, regime, one)
            for compare in (exponent, prefactor)
            for regime, one in scalings.items()
        ]
        draw = partial(
            draw_scalings, scalings, "How far behind the fold the arch snaps",
            "rate of the clamps over √ε (1/T)", "delay of α / √ε",
        )  # fmt: skip
        rows = [{"resists": regime, **row} for regime in RATES for row in done[regime].rows]
        section = self.section(
            comparisons, {"delay": draw}, {"delay_marches": rows},
            {"delay_marches": {"fold": 7, "snap": 7}}, mismatch=MISMATCH, epsilon=EPSILON,
            elements=ELEMENTS, unit=1e3 * self.unit_s,
        )  # fmt: skip
        summary = {
            f"delay_{regime}_{key}": value
            for regime, one in scalings.items()
            for key, value in (("exponent", one.fitted),
                               ("prefactor_percent", one.prefactor_percent))
        }  # fmt: skip
        return Compared(section, [], summary, comparisons)


def expected(regime: str) -> float:
    """The amplitude equation's prefactor."""
    return delay_prefactor(regime, shallow.fold(shallow.lagging(MISMATCH)).product)


def exponent(part: Delay, regime: str, one: Scaling) -> Comparison:
    """The row of an exponent."""
    low, high = one.places[-1], one.places[-3]
    rad_s = EPSILON**0.5 / part.unit_s
    return part.compared(
        regime, f"{one.fitted:.4f}", f"{one.fitted - one.exponent:+.4f}",
        part.by_limit("exponent", one.off), low=low, high=high, slow=low * rad_s,
        fast=high * rad_s, whole=one.whole,
        all=part.by_limit("exponent", abs(one.whole - one.exponent)), drag=DRAG,
    )  # fmt: skip


def prefactor(part: Delay, regime: str, one: Scaling) -> Comparison:
    """The row of a prefactor, which has no number of the source beside it."""
    return part.told(
        f"prefactor {regime}", f"{one.ratios[-1] * one.prefactor:.4f}", theirs="prefactor",
        expected=one.prefactor, agrees=part.by_limit("prefactor", abs(one.prefactor_percent)),
    )  # fmt: skip
