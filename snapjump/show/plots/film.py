"""jump.gif and snap.gif: slow motion of the snap and strike, then the flight to the apex."""

import pathlib
from typing import Any

import numpy as np

from snapjump.files.atomic import atomic_file
from snapjump.show.plots import palette
from snapjump.show.plots.camera import View, views
from snapjump.show.plots.canvas import Canvas
from snapjump.show.plots.instants import settled, snap_interval
from snapjump.show.plots.jump import apex_of, milliseconds
from snapjump.show.plots.motion import Array, Motion, Poses, poses
from snapjump.show.plots.robot_drawing import arrows, clamp_stubs
from snapjump.show.plots.trajectory import flight_end

SIZE = (420, 460)
BAR = 34  # pixels of the caption
FRAME_MS = 40  # a frame's time on the screen
HOLD_MS = 2000  # the last frame's
LEAD, ACTION, FLIGHT = 20, 56, 36  # frames before the snap, of snap and strike, of the flight


def film_times(motion: Motion, apex_ms: float | None) -> tuple[Array, int]:
    """The instants shown (ms), and how many of them come before the flight."""
    first, last = float(motion.time[0]), float(motion.time[-1])
    end = flight_end(motion, apex_ms)
    interval = snap_interval(motion)
    if interval is not None and end <= last:
        last = end = float(motion.time[settled(motion)])
    begin = float(motion.time[interval[0]]) if interval is not None else first
    lead = np.linspace(first, begin, LEAD, endpoint=False) if begin > first else np.array([])
    near = np.concatenate([lead, np.linspace(begin, last, ACTION)])
    if end <= last:
        return near, len(near)
    return np.concatenate([near, np.linspace(last, end, FLIGHT + 1)[1:]]), len(near)


def draw_film(result: Any, motion: Motion, path: pathlib.Path) -> None:
    """Draw and write the film."""
    apex = apex_of(result)
    times, close = film_times(motion, milliseconds(result, "apex_time_s"))
    shown = poses(motion, times)
    cameras = views(motion, shown, close, SIZE, BAR)
    pictures = []
    for k, camera in enumerate(cameras):
        canvas = Canvas(*SIZE)
        _draw_world(canvas, camera, motion, shown, k, apex if k == len(cameras) - 1 else None)
        _draw_robot(canvas, camera, shown, k)
        if times[k] <= motion.time[-1]:
            _draw_push(canvas, camera, motion, times[k])
        _draw_caption(canvas, camera, motion, times, k)
        pictures.append(canvas.picture())
    durations = [FRAME_MS] * (len(pictures) - 1) + [HOLD_MS]
    more = {"append_images": pictures[1:], "duration": durations, "loop": 0, "optimize": False}
    with atomic_file(path, "wb") as file:
        pictures[0].save(file, "GIF", save_all=True, **more)


def _draw_world(
    canvas: Canvas,
    view: View,
    motion: Motion,
    shown: Poses,
    k: int,
    apex: tuple[float, float] | None,
) -> None:
    """Ground, the way of the centre of mass so far, and at the end the apex."""
    if motion.centre is None or shown.centre is None:
        return
    surface = view.origin_y
    canvas.rectangle((0.0, surface, canvas.width, canvas.height), palette.GROUND)
    canvas.line([(0.0, surface), (canvas.width, surface)], palette.INK, 1.0)
    if k > 0:
        canvas.line(view.at(shown.centre[: k + 1]), palette.CENTRE, 1.5)
    if apex is not None:
        x, y = view.at(np.array(apex)).tolist()
        canvas.disc((x, y), 4.0, palette.FORCE)
        side, anchor = (-1.0, "rm") if x > 0.5 * canvas.width else (1.0, "lm")
        mark = f"apex ({apex[0]:.2f}, {apex[1]:.2f}) L"
        canvas.text(x + side * (0.6 * view.scale + 12.0), y, mark, palette.INK, 14, anchor)


def _draw_robot(canvas: Canvas, view: View, shown: Poses, k: int) -> None:
    """Frame, clamps, beam and centre of mass, with lines that thin out as the camera retreats."""
    thin = float(np.clip(view.scale / 200.0, 0.3, 1.0))
    if shown.corners is not None:
        canvas.line(view.at(shown.corners[k]), palette.FRAME, 6.0 * thin)
    beam = view.at(shown.nodes[k])
    if thin > 0.5:
        x, y = shown.nodes[k].T
        bars = view.at(np.column_stack(clamp_stubs(x, y, 0.05)))
        for bar in (bars[:2], bars[3:]):
            canvas.line(bar, palette.CLAMP, 8.0 * thin)
    canvas.line(beam, palette.BEAM, 4.0 * thin)
    if thin > 0.5:
        for end in (0, -1):
            canvas.disc(beam[end], 4.5 * thin, palette.PAPER, palette.INK)
    if shown.centre is not None:
        canvas.disc(view.at(shown.centre[k]), 2.0 + 3.0 * thin, palette.CENTRE)


def _draw_push(canvas: Canvas, view: View, motion: Motion, time: float) -> None:
    """Arrows where the ground pushes, at the sample nearest in time."""
    sample = int(np.argmin(abs(motion.time - time)))
    for x, vector in zip(motion.pad_x[sample], 0.25 * arrows(motion, sample), strict=True):
        tip = np.array([x, 0.0])
        canvas.arrow(view.at(tip - vector), view.at(tip), palette.FORCE)


def _draw_caption(canvas: Canvas, view: View, motion: Motion, times: Array, k: int) -> None:
    """Clock, slow-down, and a bar of a round number of L."""
    canvas.rectangle((0.0, 0.0, canvas.width, BAR), palette.SHADE)
    canvas.text(12, BAR / 2, f"{times[k]:.2f} ms", palette.INK, 16, "lm")
    step = times[min(k + 1, len(times) - 1)] - times[min(k, len(times) - 2)]
    if step > 0.0:
        slow = float(f"{FRAME_MS / step:.2g}")
        canvas.text(0.5 * canvas.width, BAR / 2, f"slowed {slow:.0f} ×", palette.QUIET, 14, "mm")
    sizes = np.array([0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0])
    bar = float(sizes[np.argmin(abs(sizes * view.scale - 60.0))])
    right, left = canvas.width - 60.0, canvas.width - 60.0 - bar * view.scale
    canvas.line([(left, BAR / 2), (right, BAR / 2)], palette.INK, 2.0)
    canvas.text(right + 8, BAR / 2, f"{bar:g} L", palette.INK, 14, "lm")
