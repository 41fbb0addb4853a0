"""Critical angles of shallow arches: one clamp turned, both alike, and the symmetric fold."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

from snapjump.run.studies.base import Cell, Done, Row

from ...compositions import groups_at
from ...order import Limit, richardson
from ...paper.base import listed
from ...paper.words import Words
from .. import shallow
from ..arches import static_groups
from ..base import Compared, Comparison, Source, percent_off
from .angles import ALIKE, FOLD, ONE_END, angle_rows, at_zero
from .figure import draw_angles

EPSILONS = (0.01, 0.02, 0.04, 0.08)
ELEMENTS = (56, 80, 112, 160, 224)
THIN_M, THICK_M = 5e-6, 1e-5
NAMES = {"one_end": ONE_END, "alike": ALIKE, "fold": FOLD}


def cell_name(elements: int, thickness_m: float) -> str:
    """Of a mesh and a beam."""
    return f"{elements} elements, {1e6 * thickness_m:g} um"


class Symmetries(Source):
    """Three angles, on several meshes, of two thicknesses."""

    name = "symmetries"
    words = Words(__file__)
    kinds = {"angles": angle_rows}

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """A cell for each mesh and thickness."""
        static = static_groups(groups_at(groups, "standard"))
        self.length_m = float(static["robot"]["length_m"])
        return [
            Cell(
                cell_name(n, b),
                {"kind": "angles", "groups": static, "epsilons": EPSILONS,
                 "elements": n, "thickness_m": b},
            )
            for n in ELEMENTS
            for b in (THIN_M, THICK_M)
        ]  # fmt: skip

    def judge(self, done: Mapping[str, Done]) -> Compared:
        """A comparison for each angle."""
        meshes = [
            {"elements": n, **slender(*(done[cell_name(n, b)].rows for b in (THIN_M, THICK_M)))}
            for n in ELEMENTS
        ]
        sizes = [1.0 / n for n in ELEMENTS]
        limits = {
            name: richardson(sizes, [float(row[key]) for row in meshes])
            for name, key in NAMES.items()
        }
        comparisons = [self.comparison(name, limit) for name, limit in limits.items()]
        finest = done[cell_name(ELEMENTS[-1], THIN_M)].rows
        theirs = {key: self.number(name) for name, key in NAMES.items()}
        values = {NAMES[name]: limit.value for name, limit in limits.items()}
        draw = partial(draw_angles, finest, meshes, theirs, values)
        section = self.section(
            comparisons, {"symmetries": draw}, {"symmetries_meshes": meshes},
            {"symmetries_meshes": dict.fromkeys(NAMES.values(), 8)},
            epsilons=listed(EPSILONS), elements=listed(ELEMENTS), thin=1e3 * THIN_M,
            thick=1e3 * THICK_M, length=1e3 * self.length_m,
        )  # fmt: skip
        summary = {f"symmetries_{name}": limit.value for name, limit in limits.items()}
        return Compared(section, [], summary, comparisons)

    def comparison(self, name: str, limit: Limit) -> Comparison:
        """One angle; its order of convergence is part of the verdict."""
        theirs, theory = self.number(name), shallow_angle(name)
        off, theory_off = percent_off(limit.value, theirs), percent_off(theory, theirs)
        verdict = self.weakest_of(
            ("limit", off), ("order", abs(limit.order - 2.0)), ("theory", theory_off)
        )
        return self.compared(
            name, f"{limit.value:.6f}", f"{off:.1g} %", verdict, order=limit.order,
            doubt=limit.uncertainty, theory=theory, off=theory_off,
            agrees=self.by_limit("theory", theory_off),
        )  # fmt: skip


def slender(thin: Sequence[Row], thick: Sequence[Row]) -> dict[str, float]:
    """Each angle at epsilon = 0, of a beam that does not stretch."""

    def of(rows: Sequence[Row], name: str) -> float:
        return at_zero([row["epsilon"] for row in rows], [row[name] for row in rows])

    stretches = [rows[0]["stretch"] for rows in (thin, thick)]
    return {name: at_zero(stretches, [of(thin, name), of(thick, name)]) for name in NAMES.values()}


def shallow_angle(name: str) -> float:
    """The same in closed form."""
    if name == "alike":
        return shallow.pitchfork().mu
    return shallow.fold(shallow.ONE_END if name == "one_end" else shallow.ALIKE).mu
