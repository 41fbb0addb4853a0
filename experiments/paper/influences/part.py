"""Every parameter's influence on the apex, one at a time about the baseline."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from experiments.compositions import changed
from experiments.paper.base import Found, Part, unfinished
from experiments.paper.influences.compute import (
    ENERGY_MASSES,
    MOUNT_HEIGHT,
    PRESSED_HEIGHTS,
    SLIDING_MU,
    SWEEPS,
    rows_of,
)
from experiments.paper.influences.figure import draw_friction, draw_heights, draw_influences
from experiments.paper.influences.ground import friction_statements, height_statements
from experiments.paper.influences.judge import (
    epsilon_statement,
    mass_statement,
    mismatch_statements,
)
from experiments.paper.jumps import furthest, numbers
from experiments.paper.settings import TIERS, groups_at
from snapjump.run.studies.base import Cell, Done, Figure, Row, Section, Table

STATICS, SLIDING, PRESSED, ENERGIES = "statics", "sliding", "pressed", "energies"
FOLLOWED = ("standard", "paper")  # tiers at which the energy is followed
MISMATCH = "delta_alpha_rad"
# The paper's settings with a shorter step, where that changes what is seen of its plateau.
SHORT, SHORT_CHANGES = "paper, short step", {"stepping": {"step_s": 1e-6}}


class Influences(Part):
    """Five sweeps at three tiers, the statics that they are laid beside, and the contact."""

    name = "influences"
    sources = ("experiments.paper.influences.compute",)

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """Sweeps and statics by tier; the contact at standard; the energy."""
        at = {tier: groups_at(groups, tier) for tier in TIERS}

        def cell(kind: str, tier: str, values: Sequence[float] = ()) -> Cell:
            inputs = {"groups": at[tier], "kind": kind, "values": list(values)}
            return Cell(f"{kind}, {tier}", inputs)

        strides = {tier: tier == "reference" for tier in TIERS}
        sweeps = [
            cell(kind, tier, sweep.values(sweep.stride if strides[tier] else 1))
            for kind, sweep in SWEEPS.items()
            for tier in TIERS
        ]
        return [
            *sweeps,
            Cell(
                f"{MISMATCH}, {SHORT}",
                {
                    "groups": changed(at["paper"], SHORT_CHANGES),
                    "kind": MISMATCH,
                    "values": SWEEPS[MISMATCH].values(),
                },
            ),
            *(cell(STATICS, tier) for tier in TIERS),
            cell(SLIDING, "standard", SLIDING_MU),
            cell(PRESSED, "standard", PRESSED_HEIGHTS),
            *(cell(ENERGIES, tier, ENERGY_MASSES) for tier in FOLLOWED),
        ]

    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """A row for each value of the sweep."""
        return rows_of(inputs)

    def conclude(self, done: Mapping[str, Done]) -> Found:
        """Nine statements, from all cells."""
        missing = unfinished(TITLE, done, jumps=True)
        if missing is not None:
            return missing
        sweeps = {kind: {tier: done[f"{kind}, {tier}"].rows for tier in TIERS} for kind in SWEEPS}
        statics = {tier: done[f"{STATICS}, {tier}"].rows[0] for tier in TIERS}
        energies = {tier: done[f"{ENERGIES}, {tier}"].rows for tier in FOLLOWED}
        sliding, pressed = (done[f"{kind}, standard"].rows for kind in (SLIDING, PRESSED))
        accuracy = {kind: accuracy_of(kind, rows) for kind, rows in sweeps.items()}
        lagging = {**sweeps[MISMATCH], SHORT: done[f"{MISMATCH}, {SHORT}"].rows}
        four = {kind: rows for kind, rows in sweeps.items() if kind != MOUNT_HEIGHT}
        four[MISMATCH] = lagging
        figures = {
            "influences": Figure(
                "Apex against one parameter at a time, all else as the baseline (dotted line); "
                "shaded: the paper's range",
                partial(draw_influences, four),
            ),
            "influences_height": Figure(
                "Apex against the mounts' height, with the arch's depths h1, as it snaps, and h2, "
                "when it has snapped",
                partial(draw_heights, sweeps[MOUNT_HEIGHT], statics["standard"]),
            ),
            "influences_friction": Figure(
                "Why x_c stops growing with the friction coefficient: the direction of lift-off, "
                "and which way the beam slides on the ground",
                partial(draw_friction, sweeps["mu"], sliding),
            ),
        }
        tables = {
            "influences_heights": Table(
                "Depths of the arch under slow loading, and the energy released",
                [{"tier": tier, **row} for tier, row in statics.items()],
            ),
            "influences_energies": Table(
                "Shares of the energy that the baseline's slow snap releases, by mass",
                [{"tier": tier, **row} for tier, rows in energies.items() for row in rows],
            ),
            "influences_pressed": Table("The ground under the beam before it snaps", pressed),
            "influences_sliding": Table("The beam's contact during the strike", sliding),
        }
        statements = [
            *height_statements(sweeps[MOUNT_HEIGHT], statics, pressed, accuracy[MOUNT_HEIGHT]),
            epsilon_statement(sweeps["epsilon"], accuracy["epsilon"]),
            *mismatch_statements(lagging, accuracy[MISMATCH]),
            *friction_statements(sweeps["mu"], sliding, accuracy["mu"]),
            mass_statement(sweeps["mass_bar"], energies, accuracy["mass_bar"]),
        ]
        return Found(Section(TITLE, paragraphs(sweeps), figures, tables), statements)


def accuracy_of(kind: str, sweep: Mapping[str, Sequence[Row]]) -> str:
    """How far standard is from reference in a sweep."""
    own, reference = sweep["standard"], sweep["reference"]
    x, y = (furthest(own, reference, key, kind) for key in ("x_bar", "y_bar"))
    return (
        f"`standard` at {len(own)} values, within {x:.1g} L in x and {y:.1g} L in y of "
        f"`reference` at {len(reference)} of them"
    )


TITLE = "Influences of the parameters on the apex"


def paragraphs(sweeps: Mapping[str, Mapping[str, Sequence[Row]]]) -> list[str]:
    """What is shown, what is found, and how the paper's settings differ."""
    x_off, y_off = [], []
    for tiers in sweeps.values():
        y = numbers(tiers["standard"], "y_bar")
        jumps = y > 1.0
        x_off.append(gap(tiers, "x_bar")[jumps])
        y_off.append((gap(tiers, "y_bar") / y)[jumps])
    x, y = np.concatenate(x_off), 100.0 * np.concatenate(y_off)
    return [
        "Each parameter is swept about the baseline with all others held. The curves of the "
        "converged model are smooth lines with a few bends and dips, which `reference` repeats: "
        "they are the robot's, not the program's.",
        f"With the paper's settings the same jumps are {np.median(y):.1f} % higher in the median "
        f"(between {y.min():.1f} and {y.max():.1f} %), and x_c moves by up to "
        f"{np.abs(x).max():.1f} L (median {np.median(np.abs(x)):.2f} L) either way, with a noise "
        "from place to place that the converged model does not have. *What causes the difference* "
        "takes that apart.",
        "Lagged friction at a fixed step becomes unstable where the step exceeds eps_v m / (μ N): "
        "with the paper's settings the curve against μ breaks up beyond the paper's range.",
    ]


def gap(tiers: Mapping[str, Sequence[Row]], key: str) -> np.ndarray:
    """The paper's settings less the converged model."""
    difference: np.ndarray = numbers(tiers["paper"], key) - numbers(tiers["standard"], key)
    return difference
