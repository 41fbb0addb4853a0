"""How results show themselves: a line, a block of text, a page, a picture, a film.

They are what :class:`snapjump.views.base.Shown` looks up, of single results and of batches.
"""

import html as markup
from collections import Counter
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from snapjump.batch import Batch
from snapjump.checks import ParameterError, check_choice
from snapjump.results import Result
from snapjump.show.plots import Draw, pictures_of
from snapjump.show.plots.apexes import draw_apexes
from snapjump.show.terminal.block import block, number
from snapjump.show.terminal.scene_report import scene_report
from snapjump.views.picture import Picture

MOST_OF_A_LINE = ("apex", "lift-off", "snap", "accuracy")


def line(shown: Result | Batch) -> str:
    """One line: what it is, how it ended, and what matters most."""
    if isinstance(shown, Batch):
        return f"<{_title(shown)}; {_span(shown, 'x_bar')}, {_span(shown, 'y_bar')}>"
    (name, title), *rest = scene_report(shown.simulation.configuration, shown.summary)
    told = [f"{heading} {text}" for heading, text in rest if heading in MOST_OF_A_LINE and text]
    return f"<{name} {shown.status}, {title}: {'; '.join(told) or shown.message}>"


def text(shown: Result | Batch) -> str:
    """The closing block of a simulation; of a batch, how many ended how, and where."""
    if isinstance(shown, Batch):
        spans = [(each.name, _range(shown, each.name)) for each in shown.reported() if each.show]
        per_jump = number(1e3 * shown.march_seconds / max(len(shown.status), 1))
        return block([("batch", _title(shown)), *spans, ("cost", f"{per_jump} ms a jump and core")])
    lines = scene_report(shown.simulation.configuration, shown.summary)
    if shown.status != "ok":
        lines.insert(1, ("status", f"{shown.status} {shown.message}".rstrip()))
    return block(lines)


def html(shown: Result | Batch) -> str:
    """The block, and the picture where there is one."""
    words = f"<pre>{markup.escape(text(shown))}</pre>"
    try:
        return words + plot(shown).html()
    except ParameterError:
        return words


def plot(shown: Result | Batch, name: str | None = None) -> Picture:
    """The first of its pictures, or that of a name. Raises ParameterError where there is none."""
    if isinstance(shown, Batch):
        if not np.isfinite(shown.apexes).any():
            raise ParameterError("plot", _title(shown), "a batch with an apex")
        return drawn("apexes.png", lambda path: draw_apexes(shown, _title(shown), path))
    pictures = pictures_of(shown, film=False)
    if not pictures:
        raise ParameterError("plot", shown.status, "a result with a trajectory")
    by_name = {Path(file).stem: (file, draw) for file, draw in pictures}
    if name is not None:
        check_choice("plot", name, tuple(by_name))
    return drawn(*by_name[name or Path(pictures[0][0]).stem])


def film(shown: Result | Batch) -> Picture:
    """Its film. Raises ParameterError where nothing moves."""
    if isinstance(shown, Batch):
        raise ParameterError("film", _title(shown), "a single jump: simulate_jump(...).film()")
    films = [each for each in pictures_of(shown, film=True) if each[0].endswith(".gif")]
    if not films:
        raise ParameterError("film", shown.status, "a result with a beam that moves")
    return drawn(*films[0])


def drawn(name: str, draw: Draw) -> Picture:
    """What a function draws into a file, in memory."""
    with TemporaryDirectory() as folder:
        place = Path(folder, name)
        draw(place)
        return Picture(name, place.read_bytes())


def _title(batch: Batch) -> str:
    counts = ", ".join(f"{count} {status}" for status, count in Counter(batch.status).most_common())
    return f"{len(batch.status)} jumps at {batch.simulation.accuracy}: {counts}"


def _span(batch: Batch, name: str) -> str:
    return f"{name} {_range(batch, name)}".rstrip()


def _range(batch: Batch, name: str) -> str:
    """Least and largest of an output, with its unit."""
    values = np.asarray(getattr(batch, name), dtype=float)
    known = np.broadcast_to(values, np.shape(batch.status))[np.isfinite(values)]
    if not len(known):
        return ""
    unit = next(each.unit for each in batch.reported() if each.name == name)
    return f"{number(float(known.min()))} to {number(float(known.max()))} {unit}".removesuffix(" 1")
