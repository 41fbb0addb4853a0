"""bifurcation_loop.png, bifurcation.png, bifurcation_angles.png: equilibria and exact ones."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from experiments.paper import exact
from experiments.paper.bifurcation.judge import LADDER, STRETCHES, gap_percent, overall
from snapjump.run.studies.base import Row
from snapjump.show.plots import palette
from snapjump.show.plots.branches import stable_runs
from snapjump.show.plots.saving import picture

STABLE = {"color": palette.BEAM, "lw": 2.4, "ls": "-", "zorder": 3}
UNSTABLE = {"color": palette.FORCE, "lw": 1.7, "ls": (0, (4, 2))}
LEANING = {"color": palette.PLUM, "lw": 1.7, "ls": (0, (1.2, 1.6))}
EXACT = {"marker": "o", "ls": "", "ms": 6, "mfc": "none", "mec": palette.INK, "zorder": 5}
ARROW = {"arrowstyle": "-|>", "color": palette.QUIET, "lw": 1.2, "shrinkA": 3, "shrinkB": 3}
HIGHEST = 1.35  # energy shown, in that of the critical arch
SHAPES = (
    ("flat clamps", palette.SKY, "-"),
    ("critical", palette.BEAM, "-"),
    ("snapped", palette.CENTRE, "-"),
    ("at the fold", palette.FORCE, (0, (4, 2))),
    ("leaning", palette.PLUM, (0, (1.2, 1.6))),
)
WORDS = {
    "flat clamps": "before: clamps flat",
    "critical": "at the critical angle",
    "snapped": "after the snap, same angle",
    "at the fold": "at the fold (unstable)",
    "leaning": "leaning, half the angle (unstable)",
}


def pieces(rows: Sequence[Row], key: str) -> Iterator[tuple[Any, Any, dict[str, Any]]]:
    """Angles, values and style of each stretch of a branch with the same stability."""
    for name in ("up", "down", "leaning"):
        branch = [row for row in rows if row["branch"] == name]
        alpha = np.array([row["alpha_rad"] for row in branch])
        values = np.array([row[key] for row in branch])
        negative = np.array([row["negative_eigenvalues"] for row in branch])
        for piece, stable in stable_runs(np.zeros(len(alpha)), negative):
            style = STABLE if stable else LEANING if name == "leaning" else UNSTABLE
            yield alpha[piece], values[piece], style


def draw_loop(shapes: Sequence[Row], branches: Sequence[Row], mark: Row, path: Path) -> None:
    """The shapes at one pre-compression; its loop; and the pitchfork and the fold close by."""
    title = f"The arch whose clamps turn alike, ε = {mark['epsilon']:g}"
    with picture(path, (12.5, 5.4), title) as figure:
        _shapes(figure.add_axes((0.065, 0.12, 0.28, 0.74)), shapes)
        loop = figure.add_axes((0.415, 0.12, 0.27, 0.74))
        _branches(loop, branches, "midpoint_bar")
        _loop(loop, mark)
        close = figure.add_axes((0.765, 0.12, 0.225, 0.74))
        _branches(close, branches, "midpoint_bar")
        _close_up(close, mark)
        for axes in (loop, close):
            axes.set_xlabel("clamp angle α (rad)")
            axes.set_ylabel("height of the middle, y / L")


def _shapes(axes: Any, rows: Sequence[Row]) -> None:
    for name, colour, line in SHAPES:
        nodes = [row for row in rows if row["shape"] == name]
        x, y = ([row[key] for row in nodes] for key in ("x_bar", "y_bar"))
        axes.plot(x, y, color=colour, lw=2.2, ls=line, label=WORDS[name])
    axes.plot([x[0], x[-1]], [y[0], y[-1]], "o", ms=4, mfc=palette.PAPER, mec=palette.INK)
    axes.set(aspect="equal", xlabel="x / L", ylabel="y / L", ylim=(-0.72, 0.32))
    axes.set_xlim(-0.47, 0.47)
    axes.grid(True)
    axes.legend(loc="lower center", handlelength=2.6)


def _branches(axes: Any, rows: Sequence[Row], key: str) -> None:
    for alpha, values, style in pieces(rows, key):
        axes.plot(alpha, values, **style)
    axes.grid(True)


def _arrows(axes: Any, mark: Row) -> tuple[float, float]:
    """Down and up, where the arch snaps there and back; at which angles."""
    there, back = mark["alpha_critical_rad"], mark["alpha_back_rad"]
    before, after = mark["midpoint_before_bar"], mark["midpoint_after_bar"]
    axes.annotate("", (there, after), (there, before), arrowprops=ARROW)
    axes.annotate("", (back, -after), (back, -before), arrowprops=ARROW)
    return there, back


def _loop(axes: Any, mark: Row) -> None:
    there, back = _arrows(axes, mark)
    words = {"color": palette.QUIET, "va": "center", "rotation": 90}
    axes.text(there + 0.05, -0.09, "snaps down", ha="left", **words)
    axes.text(back - 0.05, 0.09, "snaps up", ha="right", **words)


def _close_up(axes: Any, mark: Row) -> None:
    """About the pitchfork and the fold, with the exact ones."""
    entry = exact.symmetric(mark["epsilon"])
    stretched = exact.stretching(mark["epsilon"])
    places = (
        (stretched["alpha_pitchfork"], entry["ymid_before_asym"], "pitchfork", (7, 3), "left"),
        (stretched["alpha_fold"], entry["ymid_before_fold"], "fold", (6, -4), "left"),
    )
    for alpha, height, name, shift, side in places:
        axes.plot(alpha, height, **EXACT)
        axes.annotate(name, (alpha, height), shift, textcoords="offset points", ha=side)
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
        for column, mark in enumerate(marks):
            rows = branches[mark["epsilon"]]
            for line, (key, kind) in enumerate((("midpoint_bar", "ymid"), ("energy_bar", "E"))):
                axes = figure.add_subplot(grid[line, column])
                _branches(axes, rows, key)
                for alpha, value in exact_points(mark["epsilon"], kind):
                    axes.plot(alpha, value, **EXACT)
                if line == 0:
                    _arrows(axes, mark)
                    axes.set_title(f"ε = {mark['epsilon']:g}", loc="left")
                else:
                    axes.set_ylim(0.0, HIGHEST * mark["energy_before_bar"])
                    axes.set_xlabel("clamp angle α (rad)")
            if column == 0:
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


def exact_points(epsilon: float, kind: str) -> Iterator[tuple[float, float]]:
    """Angle and middle (``ymid``) or energy (``E``) of the exact equilibria: flat clamps up and
    down, the pitchfork, the state behind it, the fold, and the mirror images of these."""
    mirror = -1.0 if kind == "ymid" else 1.0
    flat, entry, angles = exact.flat(epsilon), exact.symmetric(epsilon), exact.stretching(epsilon)
    points = [
        (0.0, flat[kind]),
        (angles["alpha_pitchfork"], entry[f"{kind}_before_asym"]),
        (angles["alpha_pitchfork"], entry[f"{kind}_after_asym"]),
        (angles["alpha_fold"], entry[f"{kind}_before_fold"]),
    ]
    for alpha, value in points:
        yield alpha, value
        yield -alpha, mirror * value


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
