"""The mismatch: what it raises and lowers, and where it does no more."""

import numpy as np

from experiments.paper.influences.rules import (
    COMMAND,
    Sweeps,
    columns,
    levels_off,
    limit_of_level,
    one_way,
    percent,
)
from experiments.paper.statement import Statement
from experiments.paper.trends import counter_step, plateau

# A swing so many times that of a coarser step was hidden by that step.
HIDDEN = 1.3


def mismatch_statements(sweeps: Sweeps, accuracy: str) -> list[Statement]:
    """Growth of x and fall of y with the mismatch, and the plateau that follows."""
    told, verdicts = {}, {}
    for tier in ("standard", "paper"):
        v, x, y = columns(sweeps[tier], "delta_alpha_rad")
        in_x, in_y = plateau(v, x), plateau(v, y)
        rising, falling = v <= in_x.threshold, v <= in_y.threshold
        back = counter_step(x[rising], True), counter_step(y[falling], False)
        verdicts[tier] = one_way(back), levels_off(in_x, in_y)
        told[tier] = in_x, in_y, back
    (in_x, in_y, back), (paper_x, paper_y, _) = told["standard"], told["paper"]
    v, short_x, _ = columns(sweeps["paper, short step"], "delta_alpha_rad")
    short = np.ptp(short_x[v >= paper_x.threshold]) / paper_x.level
    hidden = short > HIDDEN * paper_x.relative_swing
    places, x, _ = columns(sweeps["standard"], "delta_alpha_rad")
    beyond = x[places >= in_x.threshold]
    low, high = float(beyond.min()), float(beyond.max())
    return [
        Statement(
            "A larger mismatch Δα raises x_c and lowers y_c, up to a threshold.",
            verdicts["standard"][0],
            f"The apex's x_c rises by {in_x.slope_before:.0f} L/rad up to {in_x.threshold:.2g} rad "
            f"and y_c falls by {-in_y.slope_before:.0f} L/rad up to {in_y.threshold:.2g} rad; the "
            f"largest way back is {percent(back[0])} and {percent(back[1])} of the change (the "
            f"paper's settings: up to {paper_x.threshold:.2g} and {paper_y.threshold:.2g} rad).",
            accuracy,
            COMMAND,
        ),
        Statement(
            "Beyond the threshold x_c and y_c are on a plateau.",
            verdicts["standard"][1],
            limit_of_level(verdicts["standard"][1], {"x_c": in_x, "y_c": in_y})
            + f"Up to {v[-1]:g} rad y_c stays within {percent(in_y.relative_swing)} from lowest to "
            f"highest about {in_y.level:.3g} L, x_c within {percent(in_x.relative_swing)} about "
            f"{in_x.level:.2g} L, where it lies between {in_x.level - low:.2g} L below and "
            f"{high - in_x.level:.2g} L above. With the paper's settings the swings are "
            f"{percent(paper_y.relative_swing)} and {percent(paper_x.relative_swing)}; of x_c "
            f"with a step a tenth as long {percent(short)}"
            + (", so that it is the step that levels it." if hidden else "."),
            accuracy,
            COMMAND,
        ),
    ]
