"""Tables of the section on causes: choices, steps, and what became of many jumps."""

from collections.abc import Mapping, Sequence

from experiments.paper.causes.cells import LONG_STEPS_S, STEPS_S, many
from experiments.paper.causes.choices import PAPER, REFERENCE
from experiments.paper.causes.shifts import Shift
from experiments.paper.failures import failed
from experiments.paper.jumps import numbers
from snapjump.studies.base import Row, Table


def shift_row(found: Shift, prefix: str = "") -> Row:
    """Columns of a table."""
    return {
        f"{prefix}x_median_percent": found.x_median,
        f"{prefix}x_p95_percent": found.x_p95,
        f"{prefix}y_signed_median_percent": found.y_signed,
        f"{prefix}y_p95_percent": found.y_p95,
    }


def tables(
    moved: Mapping[tuple[str, str], Shift],
    by_step: Mapping[float, Shift],
    rows: Mapping[str, Sequence[Row]],
) -> dict[str, Table]:
    """All three."""
    choices = [
        {
            "the paper's choice": title,
            **shift_row(moved[PAPER, title], "from_paper_"),
            **shift_row(moved[REFERENCE, title], "from_reference_"),
        }
        for title in dict.fromkeys(title for _, title in moved)
    ]
    found = {step_s: rows[many(step_s)] for step_s in (STEPS_S[0], *LONG_STEPS_S)}
    gaps = [
        {
            "step_s": step_s,
            "jumps": len(jumps),
            "failed": len(failed(jumps)),
            "smallest_gap_mm": float(1e3 * numbers(jumps, "min_gap_m").min()),
        }
        for step_s, jumps in found.items()
    ]
    return {
        "causes": Table(
            "Shift of the apex by one exchanged choice; y's medians with their signs",
            choices,
            dict.fromkeys((key for row in choices for key in row if key.endswith("percent")), 2),
        ),
        "causes_steps": Table(
            f"The paper's settings with other steps, against {STEPS_S[-1]:g} s",
            [{"step_s": s, **shift_row(one)} for s, one in by_step.items()],
        ),
        "causes_gaps": Table("The paper's settings with longer steps", gaps),
    }
