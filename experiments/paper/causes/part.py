"""Which of the paper's choices moves the apex by how much, and whether its settings converge."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from snapjump.batch import variants as robots
from snapjump.run.studies.base import Cell, Done, Row, column
from snapjump.scenes.jump_march import jump_march
from snapjump.scenes.jump_start import jump_model

from ...compositions import Groups, changed, composed, groups_at
from ...designs import spread_designs
from ...errors import Shift, shift
from ...exchanges import (
    ELASTIC,
    ELEMENTS,
    ENDS,
    FRAME,
    LATER,
    PAPER,
    REFERENCE,
    START,
    Changes,
    choices,
    program,
    variants,
)
from ..base import Found, Part, failed, incomplete, weakest
from ..cells import LANES, jump_rows
from ..limits import judged
from ..settings import BASELINE
from . import words
from .figure import draw_causes
from .words import WORDS

DESIGNS, MANY, LONG = 32, 256, 64
STEPS_S = (1e-5, 3e-6, 1e-6, 3e-7)  # the paper's, and ever finer; the last is the limit
LONG_STEPS_S = (3e-5, 1e-4, 3e-4, 1e-3)
STIFFNESSES = (1e3, 1e4, 1e5)  # of the frame, over the beam's
RIGID, STARTS = "rigid frame, standard", "start in the elastic frame"
# The paper's numbers of the contact, and others that are nearer to a hard ground with dry friction.
HARDER: dict[str, Changes] = {
    "K_c ten times as large": {"contact": {"stiffness_N_m": 1e5}},
    "half of d̃": {"contact": {"distance_m": 0.25e-3}},
    "a tenth of ε_v": {"friction": {"velocity_threshold_m_s": 1e-5}},
}


# Names of cells: with one choice exchanged at an end; a frame so many times stiffer than the beam;
# the paper's settings but the step; and jumps that are looked through for failures and gaps.
exchange = "{}, exchanged: {}".format
frame = "frame of {:g} EI, standard".format
step = "step {:g} s".format
many = "many jumps, step {:g} s".format


def start_row(simulation: Any) -> Row:
    """The equilibrium that the motion starts from: the clear span between the beam's ends (L)."""
    model = jump_model(simulation)
    march = jump_march([simulation], [model])
    march.find_starts()
    nodes = march.queue.state[0, model.frame.dofs(march.mesh) :]
    x, y = nodes[:: model.discretization.node_dofs()], nodes[1 :: model.discretization.node_dofs()]
    span = float(((x[-1] - x[0]) ** 2 + (y[-1] - y[0]) ** 2) ** 0.5)
    return {"clear_span_bar": span, "epsilon_left": 1.0 - span}


class Causes(Part):
    """The same designs from both ends, with one choice exchanged at a time."""

    name = "causes"
    title = "What causes the difference"

    def plan(self, groups: Mapping[str, Any], seed: int) -> list[Cell]:
        """Ends, exchanges, frames, harder contact, steps, and many jumps."""
        at = {end: groups_at(groups, end) for end in ENDS}
        standard = groups_at(groups, "standard")
        programs = {program(one) for one in at.values()}

        def cell(name: str, made: Groups, count: int = DESIGNS) -> Cell:
            lanes = LANES if program(made) in programs else 1
            return Cell(
                name, {"groups": made, "designs": spread_designs(count, seed), "lanes": lanes}
            )

        def stepped(step_s: float) -> Groups:
            return changed(at[PAPER], {"stepping": {"step_s": step_s}})

        def stiff(ratio: float) -> Groups:
            stiffer = {"frame": {"bending_ratio": ratio, "stretching_ratio": ratio}}
            return changed(changed(standard, ELASTIC), stiffer)

        start = {
            "groups": changed(standard, {**ELASTIC, **LATER}),
            "designs": [BASELINE],
            "kind": "starts",
        }
        return [
            *(cell(end, at[end]) for end in ENDS),
            *(cell(exchange(*key), made) for key, made in variants(at).items()),
            cell(RIGID, standard),
            *(cell(frame(ratio), stiff(ratio)) for ratio in STIFFNESSES),
            Cell(STARTS, start),
            *(cell(title, changed(standard, changes)) for title, changes in HARDER.items()),
            *(cell(step(s), stepped(s)) for s in STEPS_S[1:]),
            cell(many(STEPS_S[0]), at[PAPER], MANY),
            *(cell(many(s), stepped(s), LONG) for s in LONG_STEPS_S),
        ]

    def compute(self, inputs: Mapping[str, Any]) -> list[Row]:
        """A row for each design: its jump, or, where that is asked for, its start.

        Results do not depend on ``lanes``; one lane compiles faster, for a program that few jumps
        are made with."""
        base = composed(inputs["groups"])
        if inputs.get("kind") == "starts":
            return [start_row(one) for one in robots(base, inputs["designs"])]
        return jump_rows(base, inputs["designs"], inputs["lanes"])

    def judge(self, done: Mapping[str, Done]) -> Found:
        """Six statements, and the table of choices."""
        rows = {name: one.rows for name, one in done.items()}
        groups = {end: done[end].cell.inputs["groups"] for end in ENDS}
        moved = {
            (end, title): shift(rows[exchange(end, title)], rows[end])
            for end in ENDS
            for title in choices(groups)
        }
        apart = shift(rows[PAPER], rows[REFERENCE])
        ladder = {ratio: shift(rows[frame(ratio)], rows[RIGID]) for ratio in STIFFNESSES}
        harder = {title: shift(rows[title], rows[RIGID]) for title in HARDER}
        changes = "; ".join(f"{title}: {words.moves(one)}" for title, one in harder.items())
        soft = rows[frame(STIFFNESSES[0])]
        off = shift(soft, rows[exchange(REFERENCE, FRAME)])
        limit = rows[step(STEPS_S[-1])]
        by_step = {STEPS_S[0]: shift(rows[PAPER], limit)} | {
            s: shift(rows[step(s)], limit) for s in STEPS_S[1:-1]
        }
        epsilon = BASELINE[1], rows[STARTS][0]["epsilon_left"]
        counted = [gap_row(s, rows[many(s)]) for s in (STEPS_S[0], *LONG_STEPS_S)]
        mesh, finer = (moved[end, ELEMENTS] for end in ENDS)
        lost = [incomplete(name, one) for name, one in done.items() if failed(one.rows)]
        flat = {"paper_to_reference": apart, "frame_1000_ei": ladder[STIFFNESSES[0]],
                "step_1e_5_s": by_step[STEPS_S[0]]}  # fmt: skip
        slip = 1.0 - printed_friction(1.0)
        made = {"designs": DESIGNS, "finest_s": STEPS_S[-1]}
        barrier_mm = 1e3 * groups[PAPER]["contact"]["distance_m"]
        figures = {"causes": partial(draw_causes, moved, apart)}
        values = {**made, "apart": apart, **words.told(moved, lost)}
        return Found(
            WORDS.section(self.title, figures, *tables(moved, by_step, counted), **values),
            [
                words.frame(
                    matters(ladder[STIFFNESSES[0]]),
                    ladder,
                    len(failed(soft)),
                    paper=moved[PAPER, FRAME],
                    off=off,
                    epsilon=epsilon,
                    **made,
                ),
                words.step(matters(by_step[STEPS_S[0]]), by_step, **made),
                WORDS.statement(
                    "nodes",
                    matters(mesh),
                    moves=words.moves(mesh),
                    converged=finer,
                    noise=moved[PAPER, START],
                    **made,
                ),
                WORDS.statement("contact", matters(*harder.values()), changes=changes, **made),
                WORDS.statement(
                    "smooth", judged("causes.smooth", slip), last=printed_friction(1.0)
                ),
                words.stability(stable(rows[many(STEPS_S[0])]), counted, barrier_mm),
            ],
            {
                f"{name}_{key}_median_percent": getattr(found, f"{key}_median")
                for name, found in flat.items()
                for key in ("x", "y")
            },
        )


def printed_friction(speed: float) -> float:
    """The friction's share of μ N at a speed over ε_v of at most one, as the text prints it."""
    return speed - speed**2


def matters(*found: Shift) -> str:
    """The verdict on choices that are said not to matter."""
    return weakest(
        judged("causes.negligible", *(one.p95 for one in found)),
        judged("causes.small", *(one.medians for one in found)),
    )


def stable(rows: Sequence[Row]) -> str:
    """No failures; or few. The gaps do not count: the scheme cannot close them."""
    return judged("causes.stability", len(failed(rows)) / len(rows))


def gap_row(step_s: float, rows: Sequence[Row]) -> Row:
    """Failures and the smallest gap with a step."""
    gap_m = float(np.nanmin(column(rows, "min_gap_m")))
    lost = len(failed(rows))
    return {"step_s": step_s, "jumps": len(rows), "failed": lost, "smallest_gap_mm": 1e3 * gap_m}


def tables(
    moved: Mapping[tuple[str, str], Shift], by_step: Mapping[float, Shift], counted: Sequence[Row]
) -> tuple[dict[str, Sequence[Row]], dict[str, dict[str, int]]]:
    """All three, and their digits."""

    def cut(found: Shift, prefix: str = "") -> Row:
        return {
            f"{prefix}x_median_percent": found.x_median,
            f"{prefix}x_p95_percent": found.x_p95,
            f"{prefix}y_signed_median_percent": found.y_signed,
            f"{prefix}y_p95_percent": found.y_p95,
        }

    exchanged = [
        {
            "the paper's choice": title,
            **cut(moved[PAPER, title], "from_paper_"),
            **cut(moved[REFERENCE, title], "from_reference_"),
        }
        for title in dict.fromkeys(title for _, title in moved)
    ]
    steps = [{"step_s": s, **cut(one)} for s, one in by_step.items()]
    digits = {"causes": dict.fromkeys(list(exchanged[0])[1:], 2)}
    return {"causes": exchanged, "causes_steps": steps, "causes_gaps": counted}, digits
