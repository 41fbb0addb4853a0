"""imperfections.png: errors of the apex; imperfections_lines.png: straight lines beside them."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from snapjump.show.plots import palette
from snapjump.show.plots.saving import panels

from ...styles import SERIES, boxes, legend_above
from ..settings import PLAIN

ERRORS, LINES = (13.0, 6.2), (14.0, 7.4)
PALE: Any = (0, (3, 2))


def draw_errors(curves: Mapping[str, Any], marks: Any, path: Path) -> None:
    """|x - x0|/x0 and |y - y0|/y0 against the parameters' errors."""
    title, places = "Errors of the apex by errors of the parameters", boxes(ERRORS, 1, 2, top=1.0)
    paper, ours = curves["paper"], curves["standard"]
    marked = [int(np.abs(ours.errors - mark).argmin()) for mark in marks]
    with panels(path, ERRORS, title, *places) as drawn:
        for j, (label, axes) in enumerate(zip("xy", drawn, strict=True)):
            for k, name in enumerate(PLAIN.values()):
                colour, mark, line = SERIES[k]
                pale, own = (100 * np.abs(one.relative[k, :, j]) for one in (paper, ours))
                axes.plot(100 * paper.errors, pale, color=colour, lw=0.8, ls=PALE, alpha=0.55)
                axes.plot(100 * ours.errors, own, color=colour, lw=1.8, ls=line, marker=mark, ms=6,
                          mec=palette.PAPER, markevery=marked, label=name)  # fmt: skip
            axes.set(xlabel="error of the parameter (%)", xlim=(-20.5, 20.5), ylim=(0.0, 30.0))
            axes.set_ylabel(f"|{label} − {label}₀| / {label}₀ (%)")
        drawn[0].plot([], [], color=palette.QUIET, lw=0.8, ls=PALE, label="paper's settings")
        legend_above(drawn[0], 5, handlelength=3.2)


def draw_lines(curves: Mapping[str, Any], tangents: Any, secant: float, path: Path) -> None:
    """Signed changes with tangent and secant (of so many percent), a row for x and one for y."""
    ours, paper = curves["standard"], curves["paper"]
    title = "Changes of the apex, and straight lines through the test design"
    secants = ours.secants(0.01 * secant)
    places, ends = boxes(LINES, 2, 4, top=1.0, up=0.35), np.array([-20.0, 20.0])
    with panels(path, LINES, title, *places) as drawn:
        for (j, label), row in zip(enumerate("xy"), (drawn[:4], drawn[4:]), strict=True):
            for (k, name), axes in zip(enumerate(PLAIN.values()), row, strict=True):
                axes.plot(100 * paper.errors, 100 * paper.relative[k, :, j], "x", ms=4,
                          color=palette.QUIET, label="paper's settings")  # fmt: skip
                axes.plot(100 * ours.errors, 100 * ours.relative[k, :, j], color=palette.BEAM,
                          lw=2.0, label="standard")  # fmt: skip
                axes.plot(ends, tangents[k, j] * ends, "--", color=palette.FORCE, lw=1.4,
                          label="exact tangent")  # fmt: skip
                axes.plot(ends, secants[k, j] * ends, ":", color=palette.INK, lw=1.8,
                          label=f"secant of ±{secant:g} %")  # fmt: skip
                axes.set(xlim=(-20.5, 20.5), ylim=(-32.0, 32.0))
                if j == 1:
                    axes.set_xlabel(f"error of {name} (%)")
            row[0].set_ylabel(f"change of {label} (%)")
        legend_above(drawn[0], 4)
