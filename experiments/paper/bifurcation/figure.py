"""bifurcation_loop.png, bifurcation.png, bifurcation_angles.png: equilibria and exact ones."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.run.studies.base import Row, column
from snapjump.show.plots import palette
from snapjump.show.plots.branches import stable_runs
from snapjump.show.plots.saving import panels, picture

from ...arches import exact
from ...arches import landmarks as exact_arch

STABLE = {"color": palette.BEAM, "lw": 2.4, "ls": "-", "zorder": 3}
UNSTABLE = {"color": palette.FORCE, "lw": 1.7, "ls": (0, (4, 2))}
LEANING = {"color": palette.PLUM, "lw": 1.7, "ls": (0, (1.2, 1.6))}
EXACT = {"marker": "o", "ls": "", "ms": 6, "mfc": "none", "mec": palette.INK, "zorder": 5}
ARROW = {"arrowstyle": "-|>", "color": palette.QUIET, "lw": 1.2, "shrinkA": 3, "shrinkB": 3}
HIGHEST = 1.35  # energy shown, in that of the critical arch
# Name: what it is, colour, line.
SHAPES = {
    "flat clamps": ("before: clamps flat", palette.SKY, "-"),
    "critical": ("at the critical angle", palette.BEAM, "-"),
    "snapped": ("after the snap, same angle", palette.CENTRE, "-"),
    "at the fold": ("at the fold (unstable)", palette.FORCE, (0, (4, 2))),
    "leaning": ("leaning, half the angle (unstable)", palette.PLUM, (0, (1.2, 1.6))),
}


def draw_loop(shapes: Sequence[Row], branches: Sequence[Row], mark: Row, path: Path) -> None:
    """The shapes at one pre-compression; its loop; and the pitchfork and the fold close by."""
    title = f"The arch whose clamps turn alike, ε = {mark['epsilon']:g}"
    boxes = (0.065, 0.12, 0.28, 0.74), (0.415, 0.12, 0.27, 0.74), (0.765, 0.12, 0.225, 0.74)
    with panels(path, (12.5, 5.4), title, *boxes) as (beside, loop, close):
        for name, (label, colour, line) in SHAPES.items():
            x, y = (
                [row[key] for row in shapes if row["shape"] == name] for key in ("x_bar", "y_bar")
            )
            beside.plot(x, y, color=colour, lw=2.2, ls=line, label=label)
        beside.plot([x[0], x[-1]], [y[0], y[-1]], "o", ms=4, mfc=palette.PAPER, mec=palette.INK)
        beside.set(aspect="equal", xlabel="x / L", ylabel="y / L", ylim=(-0.72, 0.32))
        beside.set_xlim(-0.47, 0.47)
        beside.legend(loc="lower center", handlelength=2.6)
        for axes in (loop, close):
            _branches(axes, branches, "midpoint_bar")
            axes.set(xlabel="clamp angle α (rad)", ylabel="height of the middle, y / L")
        there, back = _arrows(loop, mark)
        words = {"color": palette.QUIET, "va": "center", "rotation": 90}
        loop.text(there + 0.05, -0.09, "snaps down", ha="left", **words)
        loop.text(back - 0.05, 0.09, "snaps up", ha="right", **words)
        _close_up(close, mark)


def _branches(axes: Any, rows: Sequence[Row], key: str) -> None:
    """A value against the angle, each stretch of a branch in the style of its stability."""
    for kind in ("up", "down", "leaning"):
        branch = [row for row in rows if row["branch"] == kind]
        alpha, values, negative = (
            column(branch, name) for name in ("alpha_rad", key, "negative_eigenvalues")
        )
        for piece, stable in stable_runs(np.zeros(len(alpha)), negative):
            style = STABLE if stable else LEANING if kind == "leaning" else UNSTABLE
            axes.plot(alpha[piece], values[piece], **style)


def _arrows(axes: Any, mark: Row) -> tuple[float, float]:
    """Down and up, where the arch snaps there and back; at which angles."""
    there, back = mark["alpha_critical_rad"], mark["alpha_back_rad"]
    before, after = mark["midpoint_before_bar"], mark["midpoint_after_bar"]
    axes.annotate("", (there, after), (there, before), arrowprops=ARROW)
    axes.annotate("", (back, -after), (back, -before), arrowprops=ARROW)
    return there, back


def _close_up(axes: Any, mark: Row) -> None:
    """About the pitchfork and the fold, with the exact ones."""
    entry = exact.symmetric(mark["epsilon"])
    stretched = exact.stretching(mark["epsilon"])
    places = {
        "pitchfork": (stretched["alpha_pitchfork"], entry["ymid_before_asym"], (7, 3)),
        "fold": (stretched["alpha_fold"], entry["ymid_before_fold"], (6, -4)),
    }
    for name, (alpha, height, shift) in places.items():
        axes.plot(alpha, height, **EXACT)
        axes.annotate(name, (alpha, height), shift, textcoords="offset points")
    alpha, height = mark["alpha_critical_rad"], mark["midpoint_before_bar"]
    axes.set(xlim=(0.955 * alpha, 1.03 * alpha), ylim=(0.55 * height, 1.5 * height))


def draw_branches(
    branches: Mapping[float, Sequence[Row]], marks: Sequence[Row], path: Path
) -> None:
    """Height of the middle and energy against the angle at each pre-compression."""
    title = "Equilibria along the clamp angle, and the exact elastica (circles)"
    with picture(path, (12.5, 8.2), title) as figure:
        grid = figure.add_gridspec(
            2, len(marks), left=0.065, right=0.99, top=0.87, bottom=0.07, wspace=0.22, hspace=0.16
        )
        for across, mark in enumerate(marks):
            rows = branches[mark["epsilon"]]
            for line, (key, kind) in enumerate((("midpoint_bar", "ymid"), ("energy_bar", "E"))):
                axes = figure.add_subplot(grid[line, across])
                axes.grid(True)
                _branches(axes, rows, key)
                for alpha, value in exact_arch.exact_points(mark["epsilon"], kind):
                    axes.plot(alpha, value, **EXACT)
                if line == 0:
                    _arrows(axes, mark)
                    axes.set_title(f"ε = {mark['epsilon']:g}", loc="left")
                else:
                    axes.set_ylim(0.0, HIGHEST * mark["energy_before_bar"])
                    axes.set_xlabel("clamp angle α (rad)")
            if across == 0:
                figure.axes[0].set_ylabel("height of the middle, y / L")
                figure.axes[1].set_ylabel("elastic energy (EI/L)")
        handles = [
            figure.axes[0].plot([], [], **style, label=label)[0]
            for style, label in (
                (STABLE, "stable"),
                (UNSTABLE, "symmetric, unstable"),
                (LEANING, "leaning (asymmetric), unstable"),
                (EXACT, "exact"),
            )
        ]
        figure.legend(handles=handles, loc="upper right", ncols=4, bbox_to_anchor=(0.995, 0.955))


def draw_angles(
    angles: Sequence[Row],
    gaps: Sequence[float],
    ladder: Sequence[tuple[str, int, float]],
    paper: tuple[str, int, float],
    path: Path,
) -> None:
    """Angle, how much later the fold comes (%), and convergence to the exact elastica: tiers with
    their elements and largest differences (%)."""
    title = "Critical angle of the arch whose clamps turn alike"
    boxes = [(0.06 + 0.33 * k, 0.15, 0.265, 0.68) for k in range(3)]
    epsilon, alpha = (column(angles, key) for key in ("epsilon", "alpha_critical_rad"))
    known = [exact.symmetric(e) for e in exact.SYMMETRIC]
    hollow = {"mfc": "none", "mec": palette.INK, "label": "exact"}
    with panels(path, (12.5, 4.6), title, *boxes) as (left, middle, right):
        left.plot(epsilon, alpha, color=palette.BEAM, lw=2.4, label="first instability")
        shallow = np.linspace(0.0, 0.3, 121)
        left.plot(shallow, 2.0 * np.sqrt(shallow), color=palette.QUIET, lw=1.2, ls=":",
                  label="2 √ε")  # fmt: skip
        left.plot(exact.SYMMETRIC, [one["alpha_asym"] for one in known], "o", ms=6, **hollow)
        left.set(ylabel="critical angle (rad)", ylim=(0.0, 1.25))
        middle.plot(epsilon, gaps, color=palette.FORCE, lw=2.4, label="simulated")
        later = [100.0 * (one["alpha_fold"] / one["alpha_asym"] - 1.0) for one in known]
        middle.plot(exact.SYMMETRIC, later, "o", ms=6, **hollow)
        middle.set(ylabel="the fold comes later by (% of α)", ylim=(0.0, 1.3))
        for axes in (left, middle):
            axes.set(xlabel="pre-compression ε", xlim=(0.0, 0.31))
            axes.legend(loc="lower right")
        _, elements, errors = (np.array(one) for one in zip(*ladder, strict=True))
        right.plot(elements, errors, "o-", color=palette.BEAM, lw=2.0, ms=7,
                   label="half-element clamps")  # fmt: skip
        second = 1.5 * errors[0] * (elements[0] / elements) ** 2
        right.plot(elements, second, color=palette.QUIET, lw=1.2, ls=":", label="order 2")
        right.plot(*paper[1:], "s", ms=7, color=palette.FORCE, label="the paper's clamps")
        for tier, count, error in ladder:
            right.annotate(tier, (count, error), (-6, -14), textcoords="offset points", ha="right")
        right.set(xscale="log", yscale="log", xlabel="elements", xlim=(32, 300), ylim=(6e-3, 12.0))
        right.set_ylabel("largest difference from exact (%)")
        right.set_xticks([50, 100, 200], ["50", "100", "200"])
        right.set_xticks([], minor=True)
        right.legend(loc="upper right")
