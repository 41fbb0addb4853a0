"""The film's camera: close to the robot, then ever wider, so that the way back stays seen."""

from dataclasses import dataclass

import numpy as np

from snapjump.show.plots.motion import Array, Motion, Poses

ROOM = 0.2  # round the robot, in L


@dataclass(frozen=True)
class View:
    """Pixels per L, and the pixel at which the world's origin lies."""

    scale: float
    origin_x: float
    origin_y: float

    def at(self, points: Array) -> Array:
        """Pixels (..., 2) of points (..., 2) in L."""
        return np.array([self.origin_x, self.origin_y]) + points * (self.scale, -self.scale)


def views(motion: Motion, film: Poses, close: int, size: tuple[int, int], bar: int) -> list[View]:
    """One view a frame: the first `close` frames near, later ones hold all the way so far."""
    boxes = _boxes(film)
    boxes[:close] = _union(boxes[:close])[-1]
    boxes[close:, 3] += ROOM * np.linspace(0.0, 4.0, len(boxes) - close)
    low = -0.3 if motion.centre is not None else float(boxes[:close, 1].min()) - ROOM
    boxes[:, 1] = np.minimum(boxes[:, 1], np.minimum(low, -0.05 * boxes[:, 3]))
    return [_fit(box, *size, bar) for box in _union(boxes)]


def _boxes(film: Poses) -> Array:
    """Room needed by each pose (M, 4): left, low, right, high; a turning robot needs no less."""
    points = film.outline()
    (left, low), (right, high) = points.min(axis=1).T, points.max(axis=1).T
    return np.stack([left - ROOM, low, right + ROOM, high + 0.5 * ROOM], axis=1)


def _union(boxes: Array) -> Array:
    """The box of all boxes so far (M, 4)."""
    lows = np.minimum.accumulate(boxes[:, :2], axis=0)
    return np.hstack([lows, np.maximum.accumulate(boxes[:, 2:], axis=0)])


def _fit(box: Array, width: int, height: int, bar: int) -> View:
    """The view that shows a box centred below a caption of `bar` pixels, its lower edge lowest."""
    scale = min(width / (box[2] - box[0]), (height - bar) / (box[3] - box[1]))
    return View(
        float(scale),
        float(0.5 * width - 0.5 * scale * (box[0] + box[2])),
        float(height + scale * box[1]),
    )
