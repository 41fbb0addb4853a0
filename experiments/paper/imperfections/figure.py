"""imperfections.png: errors of the apex; imperfections_lines.png: straight lines beside them."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from experiments.paper.imperfections.judge import SECANT, Array, Changes
from experiments.paper.settings import NAMES, SYMBOLS
from snapjump.show.plots import palette
from snapjump.show.plots.saving import picture

STYLES = (
    (palette.BEAM, "o", "-"),
    (palette.FORCE, "s", (0, (6, 1.5))),
    (palette.CENTRE, "^", (0, (6, 1.5, 1, 1.5))),
    (palette.PLUM, "D", (0, (1.5, 1.5))),
)
LABELS = ("x", "y")
PALE = (0, (3, 2))


def draw_errors(curves: Mapping[str, Changes], marks: Array, path: Path) -> None:
    """|x - x0|/x0 and |y - y0|/y0 against the parameters' errors."""
    with picture(path, (13.0, 6.2), "Errors of the apex by errors of the parameters") as figure:
        for j, label in enumerate(LABELS):
            axes = figure.add_axes((0.06 + 0.49 * j, 0.1, 0.43, 0.72))
            for k, name in enumerate(NAMES):
                draw_error(axes, curves, marks, k, j, name)
            axes.set(xlabel="error of the parameter (%)", xlim=(-20.5, 20.5), ylim=(0.0, 30.0))
            axes.set_ylabel(f"|{label} − {label}₀| / {label}₀ (%)")
            axes.grid(True)
            if j == 0:
                axes.plot([], [], color=palette.QUIET, lw=0.8, ls=PALE, label="paper's settings")
                axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.01), ncols=5, handlelength=3.2)


def draw_error(
    axes: Any, curves: Mapping[str, Changes], marks: Array, k: int, j: int, name: str
) -> None:
    """The curves of one parameter and coordinate."""
    colour, marker, line = STYLES[k]
    paper, ours = curves["paper"], curves["standard"]
    axes.plot(100 * paper.errors, 100 * np.abs(paper.relative[k, :, j]), color=colour, lw=0.8,
              ls=PALE, alpha=0.55)  # fmt: skip
    axes.plot(
        100 * ours.errors, 100 * np.abs(ours.relative[k, :, j]), color=colour, lw=1.8, ls=line
    )
    places = [int(np.abs(ours.errors - mark).argmin()) for mark in marks]
    axes.plot(100 * ours.errors[places], 100 * np.abs(ours.relative[k, places, j]), marker,
              color=colour, ms=6, mec=palette.PAPER)  # fmt: skip
    axes.plot([], [], color=colour, ls=line, lw=1.8, marker=marker, ms=6, mec=palette.PAPER,
              label=SYMBOLS[name].removesuffix(" (rad)"))  # fmt: skip


def draw_lines(curves: Mapping[str, Changes], tangents: Array, path: Path) -> None:
    """Signed changes with tangent and secant, a row for x and one for y."""
    ours, paper = curves["standard"], curves["paper"]
    title = "Changes of the apex, and straight lines through the test design"
    with picture(path, (14.0, 7.4), title) as figure:
        for k, name in enumerate(NAMES):
            for j, label in enumerate(LABELS):
                axes = figure.add_axes((0.06 + 0.24 * k, 0.475 - 0.39 * j, 0.2, 0.35))
                axes.plot(100 * paper.errors, 100 * paper.relative[k, :, j], "x", ms=4,
                          color=palette.QUIET, label="paper's settings")  # fmt: skip
                axes.plot(100 * ours.errors, 100 * ours.relative[k, :, j], color=palette.BEAM,
                          lw=2.0, label="standard")  # fmt: skip
                ends = np.array([-20.0, 20.0])
                axes.plot(ends, tangents[k, j] * ends, "--", color=palette.FORCE, lw=1.4,
                          label="exact tangent")  # fmt: skip
                axes.plot(ends, ours.secants[k, j] * ends, ":", color=palette.INK, lw=1.8,
                          label=f"secant of ±{100 * SECANT:g} %")  # fmt: skip
                axes.set(xlim=(-20.5, 20.5), ylim=(-32.0, 32.0))
                axes.grid(True)
                if k == 0:
                    axes.set_ylabel(f"change of {label} (%)")
                if j == 0:
                    axes.set_xticklabels([])
                else:
                    axes.set_xlabel(f"error of {SYMBOLS[name].removesuffix(' (rad)')} (%)")
                if (k, j) == (0, 0):
                    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.02), ncols=4)
