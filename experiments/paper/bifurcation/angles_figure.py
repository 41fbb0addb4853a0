"""bifurcation_angles.png: the critical angle against the pre-compression, and its error."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from experiments.paper import exact
from experiments.paper.bifurcation.compare import LADDER, STRETCHES, overall
from experiments.paper.bifurcation.judge import gap_percent
from snapjump.plots import palette
from snapjump.plots.saving import picture
from snapjump.studies.base import Row


def draw_angles(angles: Sequence[Row], tiers: Mapping[str, Sequence[Row]], path: Path) -> None:
    """Angle, distance of the fold, and convergence to the exact elastica."""
    title = "Critical angle of the arch whose clamps turn alike"
    with picture(path, (12.5, 4.6), title) as figure:
        boxes = [(0.06 + 0.33 * k, 0.15, 0.265, 0.68) for k in range(3)]
        _angle(figure.add_axes(boxes[0]), angles)
        _gap(figure.add_axes(boxes[1]), angles)
        _error(figure.add_axes(boxes[2]), tiers)
        for axes in figure.axes[:2]:
            axes.set_xlabel("pre-compression ε")
            axes.set_xlim(0.0, 0.31)


def _angle(axes: Any, angles: Sequence[Row]) -> None:
    epsilon = np.array([row["epsilon"] for row in angles])
    axes.plot(epsilon, [row["alpha_critical_rad"] for row in angles], color=palette.BEAM, lw=2.4,
              label="first instability")  # fmt: skip
    shallow = np.linspace(0.0, 0.3, 121)
    axes.plot(shallow, 2.0 * np.sqrt(shallow), color=palette.QUIET, lw=1.2, ls=":", label="2 √ε")
    alpha = [exact.symmetric(e)["alpha_asym"] for e in exact.SYMMETRIC]
    axes.plot(exact.SYMMETRIC, alpha, "o", ms=6, mfc="none", mec=palette.INK, label="exact")
    axes.set_ylabel("critical angle (rad)")
    axes.set_ylim(0.0, 1.25)
    axes.grid(True)
    axes.legend(loc="lower right")


def _gap(axes: Any, angles: Sequence[Row]) -> None:
    epsilon = [row["epsilon"] for row in angles]
    axes.plot(epsilon, [gap_percent(row) for row in angles], color=palette.FORCE, lw=2.4,
              label="simulated")  # fmt: skip
    gaps = []
    for e in exact.SYMMETRIC:
        entry = exact.symmetric(e)
        gaps.append(100.0 * (entry["alpha_fold"] / entry["alpha_asym"] - 1.0))
    axes.plot(exact.SYMMETRIC, gaps, "o", ms=6, mfc="none", mec=palette.INK, label="exact")
    axes.set_ylabel("the fold comes later by (% of α)")
    axes.set_ylim(0.0, 1.3)
    axes.grid(True)
    axes.legend(loc="lower right")


def _error(axes: Any, tiers: Mapping[str, Sequence[Row]]) -> None:
    """The largest difference from the exact beam against the mesh."""
    elements = np.array([tiers[tier][0]["elements"] for tier in LADDER])
    errors = np.array([overall(tiers[tier], STRETCHES)[0] for tier in LADDER])
    axes.plot(elements, errors, "o-", color=palette.BEAM, lw=2.0, ms=7,
              label="half-element clamps")  # fmt: skip
    axes.plot(elements, 1.5 * errors[0] * (elements[0] / elements) ** 2, color=palette.QUIET,
              lw=1.2, ls=":", label="order 2")  # fmt: skip
    paper = tiers["paper"]
    axes.plot(paper[0]["elements"], overall(paper, STRETCHES)[0], "s", ms=7, color=palette.FORCE,
              label="the paper's clamps")  # fmt: skip
    for tier, count, error in zip(LADDER, elements, errors, strict=True):
        axes.annotate(tier, (count, error), (-6, -14), textcoords="offset points", ha="right")
    axes.set(xscale="log", yscale="log", xlabel="elements", xlim=(32, 300), ylim=(6e-3, 12.0))
    axes.set_ylabel("largest difference from exact (%)")
    axes.set_xticks([50, 100, 200], ["50", "100", "200"])
    axes.set_xticks([], minor=True)
    axes.grid(True)
    axes.legend(loc="upper right")
