"""Files written whole: a reader never sees half a picture."""

import contextlib
import pathlib
from collections.abc import Iterator
from typing import Any

from snapjump.files.atomic import atomic_file
from snapjump.show.plots import palette

DPI = 120


def style() -> dict[str, Any]:
    """Ours on matplotlib's own defaults, whatever the user's matplotlibrc asks for."""
    import matplotlib

    defaults = matplotlib.rcParamsDefault.items()
    return {**{key: value for key, value in defaults if "backend" not in key}, **palette.STYLE}


@contextlib.contextmanager
def picture(path: pathlib.Path, size: tuple[float, float], title: str) -> Iterator[Any]:
    """A matplotlib figure (inches) with a title line to draw on; written as a PNG at the end."""
    import matplotlib
    from matplotlib.figure import Figure

    with matplotlib.rc_context(style()):
        figure = Figure(figsize=size, dpi=DPI)
        figure.text(0.18 / size[0], 1.0 - 0.3 / size[1], title, fontsize=14, va="center")
        yield figure
        with atomic_file(path, "wb") as file:
            figure.savefig(file, format="png", dpi=DPI, pil_kwargs={"compress_level": 4})


@contextlib.contextmanager
def panels(
    path: pathlib.Path,
    size: tuple[float, float],
    title: str,
    *boxes: tuple[float, float, float, float],
) -> Iterator[list[Any]]:
    """The same with axes that have grids, at boxes in shares of the figure: left, bottom, width,
    height."""
    with picture(path, size, title) as figure:
        axes = [figure.add_axes(box) for box in boxes]
        for one in axes:
            one.grid(True)
        yield axes


def axes_at(figure: Any, left: float, bottom: float, width: float, height: float) -> Any:
    """Axes of a figure, their box in inches from its lower left corner."""
    across, up = figure.get_size_inches()
    return figure.add_axes((left / across, bottom / up, width / across, height / up))
