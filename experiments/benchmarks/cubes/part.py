"""Restitution and sliding with the parameters that are fitted to tossed cubes."""

import math
from collections.abc import Mapping
from typing import Any

from snapjump.contact.hunt_crossley import damping_number
from snapjump.run.studies.base import Cell, Done

from ...compositions import changed, groups_at
from ...paper.words import Words
from ..arches import AT_REST
from ..base import Compared, Number, Source, percent_off
from .scenes import restitution_of, scene_rows, sliding_groups

MASS_KG, STIFFNESS_N_M = 0.37, 10800.0  # contactnets_cube.urdf
SPEED_M_S = 1.0
GRAVITY_M_S2 = 9.81
PERIODS = 10.0  # of mass and stiffness over 2 pi, in which it has left the ground
GROUND, BOUNCE, SLIDE = "default ground", "bounce", "slide"


class Cubes(Source):
    """Two bounces and a slide."""

    name = "cubes"
    words = Words(__file__)
    kinds = {"scenes": scene_rows}

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """A cell for each."""
        bare = changed(
            groups_at(groups, "standard"),
            {**AT_REST, "contact": {"name": "logbarrier"}, "robot": {"gravity_m_s2": GRAVITY_M_S2}},
        )
        law = {
            "name": "hunt_crossley",
            "restitution": restitution_of(self.number("dissipation"), SPEED_M_S),
            "impact_speed_m_s": SPEED_M_S,
            "stiffness_N_m": STIFFNESS_N_M,
        }
        duration_s = PERIODS * math.sqrt(MASS_KG / STIFFNESS_N_M)
        bounce = {"name": "bounce", "mass_kg": MASS_KG, "speed_m_s": SPEED_M_S,
                  "duration_s": duration_s, "sample_interval_s": duration_s / 500.0}  # fmt: skip
        sliding = changed(bare, {"friction": {"name": "implicit"}})
        made = {
            GROUND: changed(bare, {"sim": {"name": "bounce"}}),
            BOUNCE: changed(bare, {"contact": law, "sim": bounce}),
            SLIDE: sliding_groups(sliding, MASS_KG, SPEED_M_S, self.number("sliding")),
        }
        return [Cell(name, {"kind": "scenes", "groups": one}) for name, one in made.items()]

    def judge(self, done: Mapping[str, Done]) -> Compared:
        """Restitutions and a distance."""
        rows = {name: one.rows[0] for name, one in done.items()}
        ground, bounce = (rows[name]["restitution"] for name in (GROUND, BOUNCE))
        apart = abs(ground - self.number("ground"))
        closed = restitution_of(self.number("dissipation"), SPEED_M_S)
        distance = rows[SLIDE]["distance_m"]
        coulomb = SPEED_M_S**2 / (2.0 * self.number("sliding") * GRAVITY_M_S2)
        needed = damping_number(self.number("ground")) / SPEED_M_S
        off = [percent_off(*pair) for pair in ((bounce, closed), (distance, coulomb))]
        comparisons = [
            self.compared(
                "ground", f"{ground:.4f}", f"{apart:.3f}", self.by_limit("ground", apart)
            ),
            self.compared(
                "dissipation", f"{bounce:.5f}", f"{off[0]:.1g} %",
                self.by_limit("restitution", off[0]), self.derived("dissipation", closed),
                speed=SPEED_M_S, needed=needed,
            ),
            self.compared(
                "sliding", f"{distance:.5f}", f"{off[1]:.1g} %", self.by_limit("sliding", off[1]),
                self.derived("sliding", coulomb), mass=MASS_KG, speed=SPEED_M_S,
                gravity=GRAVITY_M_S2,
            ),
            self.told("tosses", "no such scene"),
        ]  # fmt: skip
        summary = {"cubes_restitution": bounce, "cubes_sliding_m": distance}
        return Compared(self.section(comparisons, mass=MASS_KG), [], summary, comparisons)

    def derived(self, name: str, value: float) -> Number:
        """What a parameter of the source's comes to in closed form."""
        own = self.literature.numbers[name]
        return Number(value, f"in closed form, from {own.value:g} as in {own.place}")
