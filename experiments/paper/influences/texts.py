"""Sentences of the section on influences."""

from collections.abc import Mapping, Sequence

import numpy as np

from experiments.paper.jumps import numbers
from snapjump.studies.base import Row

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
