"""One palette for all pictures (Okabe and Ito's, safe for colour-blind readers), and the fonts."""

from typing import Any

INK = "#1f2328"
QUIET = "#6b7280"
PALE = "#d5d9df"
PAPER = "#ffffff"
SHADE = "#f7f8fa"
GROUND = "#e9e4da"
BEAM = "#0072b2"
FRAME = "#4b5563"
CLAMP = "#e69f00"
FORCE = "#d55e00"
CENTRE = "#009e73"
PLUM = "#7b3294"
VIOLET = "#cc79a7"
SKY = "#56b4e9"

# Of curves side by side, told apart as far as their number allows.
SERIES = (
    *(BEAM, CENTRE, FORCE, PLUM, CLAMP, SKY, VIOLET, FRAME),
    *("#8c510a", "#01665e", "#b2182b", "#4d9221", "#999999"),
)

STYLE: Any = {
    "font.size": 10.5,
    "axes.titlesize": 10.5,
    "axes.labelsize": 10.5,
    "xtick.labelsize": 10,
    "ytick.labelsize": 10,
    "legend.fontsize": 10,
    "legend.frameon": False,
    "text.color": INK,
    "axes.edgecolor": QUIET,
    "axes.labelcolor": INK,
    "xtick.color": QUIET,
    "ytick.color": QUIET,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "grid.color": "#eceef1",
    "grid.linewidth": 0.8,
    "axes.axisbelow": True,
    "lines.solid_capstyle": "round",
}
"""Matplotlib settings of every figure; 10 points on 12 inches is legible at half size."""


def rgb(colour: str) -> tuple[int, int, int]:
    """The three bytes of "#rrggbb"."""
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)
