"""One clamp turned at a controlled rate, and the limit points with one and with both turned."""

from collections.abc import Mapping
from functools import partial
from typing import Any

from snapjump.run.studies.base import Cell, Done

from ...compositions import changed, groups_at
from ...paper.base import listed
from ...paper.words import Words
from .. import shallow
from ..amplitude import DELAY_EXPONENTS, delay_prefactor
from ..arches import DRAG, EPSILON, snapping_groups, static_groups
from ..base import Compared, Comparison, Source
from ..delay.marches import turned_rows
from ..delay.part import RATES
from ..figure import draw_scalings
from ..scaling import Scaling, scaling_of
from ..symmetries.angles import ALIKE, FOLD, ONE_END, angle_rows

EPSILONS = (0.1, 0.2, 0.3)
ELEMENTS = 224
ANGLES = "angles"


class Rotations(Source):
    """A ladder of rates for each of the two that may resist, and static angles."""

    name = "rotations"
    words = Words(__file__)
    kinds = {"delays": turned_rows, "angles": angle_rows}

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """A cell for each ladder, and one of angles."""
        standard = groups_at(groups, "standard")
        static = static_groups(standard)
        return [
            *(
                Cell(
                    regime,
                    {"kind": "delays", "groups": flat(snapping_groups(standard, regime)),
                     "rates": RATES[regime], "right_share": 0.0, "exponent": law,
                     "prefactor": expected(regime)},
                )
                for regime, law in DELAY_EXPONENTS.items()
            ),
            Cell(
                ANGLES,
                {"kind": "angles", "groups": static, "epsilons": EPSILONS, "elements": ELEMENTS,
                 "thickness_m": static["robot"]["thickness_m"]},
            ),
        ]  # fmt: skip

    def judge(self, done: Mapping[str, Done]) -> Compared:
        """Exponents; angles that nothing can be set beside."""
        scalings = {
            regime: scaling_of(done[regime].rows, "rate", "delay", law, expected(regime))
            for regime, law in DELAY_EXPONENTS.items()
        }
        angles = {
            name: listed((row[name] * row["epsilon"] ** 0.5 for row in done[ANGLES].rows), ".5f")
            for name in (ONE_END, ALIKE, FOLD)
        }
        told: dict[str, Any] = {
            "epsilons": listed(EPSILONS),
            "elements": ELEMENTS,
            "alike": angles[ALIKE],
        }
        comparisons = [
            *(exponent(self, regime, one) for regime, one in scalings.items()),
            self.told("one_end_angle", angles[ONE_END], **told),
            self.told("limit_point", angles[FOLD], **told),
        ]
        draw = partial(
            draw_scalings, scalings, "How far behind the fold the arch snaps, one clamp turned",
            "rate of the clamp over √ε (1/T)", "delay of α / √ε",
        )  # fmt: skip
        rows = [{"resists": name, **row} for name in scalings for row in done[name].rows]
        section = self.section(
            comparisons, {"rotations": draw}, {"rotations_marches": rows},
            {"rotations_marches": {"fold": 7, "snap": 7}}, epsilon=EPSILON,
        )  # fmt: skip
        summary = {f"rotations_{name}_exponent": one.fitted for name, one in scalings.items()}
        return Compared(section, [], summary, comparisons)


def flat(groups: Mapping[str, Any]) -> dict[str, Any]:
    """Without the mismatch: the right clamp is flat."""
    return changed(groups, {"design": {"delta_alpha": 0.0}})


def expected(regime: str) -> float:
    """The amplitude equation's prefactor."""
    return delay_prefactor(regime, shallow.fold(shallow.ONE_END).product)


def exponent(part: Rotations, regime: str, one: Scaling) -> Comparison:
    """The row of an exponent."""
    return part.compared(
        f"exponent {regime}", f"{one.fitted:.4f}", f"{one.fitted - one.exponent:+.4f}",
        part.by_limit("exponent", one.off), regime, low=one.places[-1], high=one.places[-3],
        percent=one.prefactor_percent, whole=one.whole,
        all=part.by_limit("exponent", abs(one.whole - one.exponent)), drag=DRAG,
    )  # fmt: skip
