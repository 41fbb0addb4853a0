"""The pictures of a result: filmstrip, trajectory, film, energies, branches.

Nothing here is computed that a number is read from; matplotlib and Pillow are imported only
when a picture is drawn.
"""

import pathlib
from collections.abc import Callable
from typing import Any

from snapjump.plots.books import Books, read_books
from snapjump.plots.motion import Motion, read_motion


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
    scene = str(result.simulation.sim.name)
    written: list[pathlib.Path] = []
    pictures = _pictures(result, scene, film)
    for name, draw in pictures:
        if progress is not None:
            progress(len(written) / len(pictures), f"drawing {name}")
        written.append(draw(folder / name))
    return written


Draw = Callable[[pathlib.Path], pathlib.Path]


def _pictures(result: Any, scene: str, film: bool) -> list[tuple[str, Draw]]:
    """The names of the files to write, and what draws them."""
    from snapjump.plots.branches import branches_picture
    from snapjump.plots.energy import energy_picture
    from snapjump.plots.film import draw_film
    from snapjump.plots.jump import apex_of, headline, jump_picture, number, since_start
    from snapjump.plots.point import point_picture
    from snapjump.plots.snap import snap_picture

    chosen: list[tuple[str, Draw]] = []
    title = headline(result)
    if any(name.startswith(("branch_", "shapes_")) for name in result.arrays):
        critical = number(result.summary, "alpha_critical_rad")
        chosen.append(
            (f"{scene}.png", lambda path: branches_picture(result.arrays, title, critical, path))
        )
        return chosen
    motion, books = read_motion(result), read_books(result)
    if motion is not None and motion.node_x.shape[1] < 3:
        chosen.append(
            (f"{scene}.png", lambda path: point_picture(result.arrays, motion, title, path))
        )
    elif motion is not None:
        apex_ms = since_start(result, "apex_time_s")
        if motion.centre is not None:
            chosen.append((f"{scene}.png", lambda path: jump_picture(result, motion, path)))
        else:
            chosen.append((f"{scene}.png", lambda path: snap_picture(motion, title, path)))
        if film and motion.count > 1:
            chosen.append(
                (f"{scene}.gif", lambda path: draw_film(motion, apex_ms, apex_of(result), path))
            )
    if books is not None:
        window = _busy(motion, books)
        chosen.append(("energy.png", lambda path: energy_picture(books, title, window, path)))
    return chosen


def _busy(motion: Motion | None, books: Books) -> tuple[float, float] | None:
    """From the snap to the end of the strike (ms), if that is a part of the run worth a panel."""
    from snapjump.plots.moments import settled, snap_interval

    if motion is None or motion.node_x.shape[1] < 3:
        return None
    snap = snap_interval(motion)
    begin = float(motion.time[snap[0]]) if snap is not None else 0.0
    pushed = motion.time[motion.push > 2.0]
    end = float(pushed[-1]) if len(pushed) else float(motion.time[settled(motion)])
    room = 0.08 * max(end - begin, 0.0)
    begin, end = max(begin - room, 0.0), min(end + room, float(books.time[-1]))
    whole = float(books.time[-1] - books.time[0])
    return (begin, end) if 0.0 < end - begin < 0.8 * whole else None
