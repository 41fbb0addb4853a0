"""A snap without ground, with contact compiled out and compiled in but out of reach."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from experiments.compositions import composed
from experiments.scenes.jumps import timed
from snapjump.declare.members import make_member
from snapjump.engine import clock as c
from snapjump.engine.status import NAMES
from snapjump.scenes.snap_march import snap_march
from snapjump.studies.base import Row

ABOVE = 2.0  # L: mounts so high that nothing comes near the ground


def snap_rows(
    groups: Mapping[str, Any], designs: list[tuple[float, float]], repeats: int
) -> list[Row]:
    """Snaps of designs (delta_alpha, epsilon): where and how fast the midpoint is at the end."""
    return timed(
        lambda: snaps(groups, designs, "logbarrier"),
        lambda: snaps(groups, designs, "none"),
        repeats,
    )


def snaps(groups: Mapping[str, Any], designs: list[tuple[float, float]], contact: str) -> list[Row]:
    """Outcomes of snaps one after the other, with a contact law that never acts or with none."""
    simulation = composed(groups)
    law = make_member("contact", {"name": contact})
    rows = []
    for lag, epsilon in designs:
        one = replace(simulation, design=replace(simulation.design, epsilon=epsilon,
                                                 delta_alpha=lag))  # fmt: skip
        march = snap_march(one, height=ABOVE, contact=law)
        outcome = march.run()[0]
        middle = march.memory.state.shape[0] // 2
        rows.append(
            {
                "status": NAMES[int(outcome[c.STATUS])],
                "x_bar": float(march.memory.state[middle - middle % 2, 0]),
                "y_bar": float(march.memory.state[middle - middle % 2 + 1, 0]) - ABOVE,
                "newton_iterations": float(outcome[c.ITERATIONS]),
            }
        )
    return rows
