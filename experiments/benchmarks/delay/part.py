"""Delay of the snap behind the fold by the rate of its drive: with inertia alone, overdamped."""

from collections.abc import Mapping
from functools import partial
from typing import Any, NamedTuple

from snapjump.run.studies.base import Cell, Done, Row

from ...compositions import composed, groups_at
from ...paper.words import Words
from .. import shallow
from ..amplitude import DELAY_EXPONENTS, delay_prefactor
from ..arches import DAMPING, DRAG, ELEMENTS, EPSILON, INERTIA, MISMATCH, snapping_groups
from ..base import Compared, Comparison, Source
from ..figure import draw_scalings
from ..scaling import Scaling, scaling_of
from .marches import BEGIN, opened_rows, turned_rows

RATES = {  # over sqrt(epsilon) of clamps, over epsilon of a span, 1/T
    INERTIA: tuple(10.0 ** (-0.5 * k) for k in range(2, 8)),
    DAMPING: tuple(10.0 ** (-0.5 * k) for k in range(3, 9)),
}


class Driven(NamedTuple):
    """A drive: what is drawn of it, and its rate in the marches' rows and its unit."""

    title: str
    places: str
    values: str
    rate: str
    unit: str


OPENED, TURNED = "opened", "turned"
DRIVES = {
    OPENED: Driven(
        "How far behind the fold the arch snaps, its span opened",
        "rate of the span over ε (1/T)", "delay of ε, over the fold's", "rate_m_s", "m/s",
    ),
    TURNED: Driven(
        "How far behind the fold the arch snaps, its clamps turned",
        "rate of the clamps over √ε (1/T)", "delay of α / √ε", "rate_rad_s", "rad/s",
    ),
}  # fmt: skip


def label(drive: str, regime: str) -> str:
    """Of a cell, and of its comparison."""
    return f"{drive} {regime}"


class Delay(Source):
    """A ladder of rates for each drive, and for each of the two that may resist."""

    name = "delay"
    words = Words(__file__)
    kinds = {OPENED: opened_rows, TURNED: turned_rows}

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """A cell for each."""
        standard = groups_at(groups, "standard")
        made = {regime: snapping_groups(standard, regime) for regime in RATES}
        self.unit_s = composed(made[INERTIA]).robot.scales.time_s
        return [
            Cell(
                label(drive, regime),
                {"kind": drive, "groups": made[regime], "rates": rates, "right_share": 1.0,
                 "exponent": DELAY_EXPONENTS[regime], "prefactor": expected(drive, regime)},
            )
            for drive in DRIVES
            for regime, rates in RATES.items()
        ]  # fmt: skip

    def judge(self, done: Mapping[str, Done]) -> Compared:
        """Exponents and prefactors."""
        scalings = {
            drive: {
                regime: scaling_of(
                    done[label(drive, regime)].rows, "rate", "delay", law, expected(drive, regime)
                )
                for regime, law in DELAY_EXPONENTS.items()
            }
            for drive in DRIVES
        }
        every = [(d, regime, one) for d in DRIVES for regime, one in scalings[d].items()]
        comparisons = [
            compare(self, drive, regime, one, done[label(drive, regime)].rows)
            for compare in (exponent, prefactor)
            for drive, regime, one in every
        ]
        names = {drive: f"delay_{drive}" for drive in DRIVES}
        section = self.section(
            comparisons,
            {names[d]: partial(draw_scalings, scalings[d], *DRIVES[d][:3]) for d in DRIVES},
            {
                names[drive]: [
                    {"resists": regime, **row}
                    for regime in RATES
                    for row in done[label(drive, regime)].rows
                ]
                for drive in DRIVES
            },
            {name: {"fold": 7, "snap": 7} for name in names.values()},
            mismatch=MISMATCH, epsilon=EPSILON, elements=ELEMENTS, unit=1e3 * self.unit_s,
            begin=BEGIN,
        )  # fmt: skip
        summary = {
            f"delay_{drive}_{regime}_{key}": value
            for drive, regime, one in every
            for key, value in (("exponent", one.fitted),
                               ("prefactor_percent", one.prefactor_percent))
        }  # fmt: skip
        return Compared(section, [], summary, comparisons)


def expected(drive: str, regime: str) -> float:
    """The amplitude equation's prefactor."""
    fold = shallow.fold(shallow.lagging(MISMATCH))
    return delay_prefactor(regime, fold.opening if drive == OPENED else fold.product)


def exponent(part: Delay, drive: str, regime: str, one: Scaling, rows: list[Row]) -> Comparison:
    """The row of an exponent."""
    driven = DRIVES[drive]
    return part.compared(
        label(drive, regime), f"{one.fitted:.4f}", f"{one.fitted - one.exponent:+.4f}",
        part.by_limit("exponent", one.off), regime, low=one.places[-1], high=one.places[-3],
        slow=rows[-1][driven.rate], fast=rows[-3][driven.rate], unit=driven.unit,
        whole=one.whole, all=part.by_limit("exponent", abs(one.whole - one.exponent)), drag=DRAG,
    )  # fmt: skip


def prefactor(part: Delay, drive: str, regime: str, one: Scaling, rows: list[Row]) -> Comparison:
    """The row of a prefactor, which has no number of the source beside it."""
    return part.told(
        f"prefactor {label(drive, regime)}", f"{one.ratios[-1] * one.prefactor:.4f}",
        theirs="prefactor", expected=one.prefactor,
        agrees=part.by_limit("prefactor", abs(one.prefactor_percent)),
    )  # fmt: skip
