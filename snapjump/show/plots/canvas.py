"""A fast drawing surface for films: twelve colours, drawn at twice the size, smoothed by a table.

Colours are drawn as numbers 0 to 11 on a surface of twice the width and height. Each square of
four pixels becomes one pixel of the picture, whose colour, the mean of the four, comes from a
table of all 16^4 combinations. The palette holds every blend of two colours in quarters, so that
edges are smooth and no colour search is needed.
"""

import functools
import itertools
import os
from typing import Any

import numpy as np

from snapjump.show.plots import palette

COLOURS = (
    *(palette.PAPER, palette.GROUND, palette.INK, palette.QUIET, palette.PALE, palette.FRAME),
    *(palette.BEAM, palette.SKY, palette.CLAMP, palette.FORCE, palette.CENTRE, palette.SHADE),
)

Point = Any  # x and y, pixels


class Canvas:
    """A picture of `width` by `height` pixels; coordinates are pixels from the upper left."""

    def __init__(self, width: int, height: int) -> None:
        from PIL import Image, ImageDraw

        self.width, self.height = width, height
        self._image = Image.new("L", (2 * width, 2 * height), 0)
        self._draw = ImageDraw.Draw(self._image)
        self._draw.fontmode = "1"

    def line(self, points: Any, colour: str, width: float) -> None:
        """A line through points (P, 2), round at its ends."""
        flat: list[float] = np.clip(2.0 * np.asarray(points), -1e4, 1e4).ravel().tolist()
        fill, thick = COLOURS.index(colour), max(1, round(2.0 * width))
        self._draw.line(flat, fill=fill, width=thick, joint="curve" if thick > 3 else None)

    def rectangle(self, box: tuple[float, float, float, float], colour: str) -> None:
        """A filled box: left, top, right, bottom."""
        corners = np.clip(2.0 * np.array(box), -10.0, 2.0 * max(self.width, self.height) + 10.0)
        if corners[2] >= corners[0] and corners[3] >= corners[1]:
            self._draw.rectangle(corners.tolist(), fill=COLOURS.index(colour))

    def disc(self, at: Point, radius: float, colour: str, rim: str | None = None) -> None:
        """A filled circle, with a rim of another colour if wanted."""
        box = [2.0 * (value + side) for side in (-radius, radius) for value in at]
        outline = None if rim is None else COLOURS.index(rim)
        self._draw.ellipse(box, fill=COLOURS.index(colour), outline=outline, width=3)

    def arrow(self, tail: Point, tip: Point, colour: str) -> None:
        """An arrow of the width of a thick line."""
        way = np.subtract(tip, tail)
        size = float(np.hypot(*way))
        if size < 3.0:
            return
        along = way / size
        head = min(9.0, 0.7 * size)
        base = np.asarray(tip) - head * along
        side = 0.45 * head * np.array([-along[1], along[0]])
        self.line([tail, base], colour, 2.5)
        corners = 2.0 * np.array([tip, base + side, base - side])
        self._draw.polygon(corners.ravel().tolist(), fill=COLOURS.index(colour))

    def text(self, x: float, y: float, text: str, colour: str, size: int, anchor: str) -> None:
        """Text, placed by Pillow's two-letter anchor ("la": left, top of letters)."""
        font = _font(2 * size)
        self._draw.text((2 * x, 2 * y), text, COLOURS.index(colour), font=font, anchor=anchor)

    def picture(self) -> Any:
        """The smoothed picture, a Pillow image with the palette of `film_palette`."""
        from PIL import Image

        table, colours = film_palette()
        drawn = np.asarray(self._image)
        pairs = (drawn[:, 0::2] << 4) | drawn[:, 1::2]
        codes = (pairs[0::2].astype(np.uint16) << 8) | pairs[1::2]
        image = Image.frombytes("P", (self.width, self.height), table[codes].tobytes())
        image.putpalette(colours)
        return image


@functools.cache
def film_palette() -> tuple[np.ndarray, bytes]:
    """Table from four colour numbers (16 bits) to a palette entry, and the palette (768 bytes)."""
    base = np.array([palette.rgb(colour) for colour in COLOURS], float)
    quarters = [np.eye(len(base))]
    for i, j in itertools.combinations(range(len(base)), 2):
        blend = np.zeros((3, len(base)))
        blend[:, i], blend[:, j] = (0.75, 0.5, 0.25), (0.25, 0.5, 0.75)
        quarters.append(blend)
    colours = np.vstack(quarters) @ base
    fours = np.array(list(itertools.combinations_with_replacement(range(len(base)), 4)))
    mean = base[fours].mean(axis=1)
    distance = (colours**2).sum(axis=1) - 2.0 * mean @ colours.T
    nearest = distance.argmin(axis=1).astype(np.uint8)
    table = np.zeros(1 << 16, np.uint8)
    for order in itertools.permutations(range(4)):
        a, b, c, d = fours[:, order].T
        table[(a << 12) | (b << 8) | (c << 4) | d] = nearest
    flat = np.zeros((256, 3), np.uint8)
    flat[: len(colours)] = np.rint(colours)
    return table, flat.tobytes()


@functools.cache
def _font(size: int) -> Any:
    """DejaVu Sans, which comes with matplotlib."""
    import matplotlib
    from PIL import ImageFont

    folder = os.path.join(matplotlib.get_data_path(), "fonts", "ttf")
    return ImageFont.truetype(os.path.join(folder, "DejaVuSans.ttf"), size)
