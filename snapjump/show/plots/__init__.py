"""The pictures of a result: filmstrip, trajectory, film, energies, branches.

Nothing here is computed that a number is read from; matplotlib and Pillow are imported only
when a picture is drawn.
"""

import pathlib
from collections.abc import Callable
from functools import partial
from typing import Any

from snapjump.show.plots.ledger import Ledger, read_ledger
from snapjump.show.plots.motion import Motion, read_motion


def figures(
    result: Any,
    folder: pathlib.Path,
    progress: Callable[[float, str], None] | None = None,
    *,
    film: bool = True,
) -> list[pathlib.Path]:
    """Write the figures that a result has data for, and return their paths.

    ``progress`` is called with the share done and what is drawn next; ``film=False`` leaves out
    the film. A result that ended early gets pictures of what there is, one without arrays none.
    """
    folder.mkdir(parents=True, exist_ok=True)
    written: list[pathlib.Path] = []
    pictures = pictures_of(result, film)
    for name, draw in pictures:
        if progress is not None:
            progress(len(written) / len(pictures), f"drawing {name}")
        draw(folder / name)
        written.append(folder / name)
    return written


Draw = Callable[[pathlib.Path], Any]


def pictures_of(result: Any, film: bool) -> list[tuple[str, Draw]]:
    """The names of the files of a result, and what draws them; the first is the picture of it."""
    from snapjump.show.plots.branches import branches_picture
    from snapjump.show.plots.energy import energy_picture
    from snapjump.show.plots.film import draw_film
    from snapjump.show.plots.jump import finite_number, headline, jump_picture
    from snapjump.show.plots.point import point_picture
    from snapjump.show.plots.snap import snap_picture

    title, scene = headline(result), result.simulation.sim.name
    if any(name.startswith(("branch_", "shapes_")) for name in result.arrays):
        critical = finite_number(result.summary, "alpha_critical_rad")
        return [(f"{scene}.png", partial(branches_picture, result.arrays, title, critical))]
    chosen: list[tuple[str, Draw]] = []
    motion, ledger = read_motion(result), read_ledger(result)
    if motion is not None:
        picture = jump_picture if motion.centre is not None else snap_picture
        picture = picture if motion.is_beam else point_picture
        chosen.append((f"{scene}.png", partial(picture, result, motion)))
        if film and motion.is_beam and motion.count > 1:
            chosen.append((f"{scene}.gif", partial(draw_film, result, motion)))
    if ledger is not None:
        chosen.append(("energy.png", partial(energy_picture, ledger, title, _busy(motion, ledger))))
    return chosen


def _busy(motion: Motion | None, ledger: Ledger) -> tuple[float, float] | None:
    """From the snap to the end of the strike (ms), if that is a part of the run worth a panel."""
    from snapjump.show.plots.instants import settled, snap_interval

    if motion is None or not motion.is_beam:
        return None
    snap = snap_interval(motion)
    first, last = float(ledger.time[0]), float(ledger.time[-1])
    begin = float(motion.time[snap[0]]) if snap is not None else first
    pushed = motion.time[motion.push > 2.0]
    end = float(pushed[-1]) if len(pushed) else float(motion.time[settled(motion)])
    room = 0.08 * max(end - begin, 0.0)
    begin, end = max(begin - room, first), min(end + room, last)
    return (begin, end) if 0.0 < end - begin < 0.8 * (last - first) else None
