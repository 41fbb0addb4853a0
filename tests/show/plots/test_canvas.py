"""The film's drawing surface: colours come out as they were drawn, edges as their mean."""

import numpy as np

from snapjump.show.plots import palette
from snapjump.show.plots.canvas import COLOURS, Canvas, film_palette


def test_full_colours_are_exact():
    for colour in COLOURS:
        canvas = Canvas(8, 6)
        canvas.rectangle((-1.0, -1.0, 9.0, 7.0), colour)
        pixels = np.asarray(canvas.picture().convert("RGB"))
        assert pixels.shape == (6, 8, 3)
        assert (pixels == palette.rgb(colour)).all()


def test_half_covered_pixels_are_the_mean():
    canvas = Canvas(8, 6)
    canvas.rectangle((0.0, 0.0, 2.0, 6.0), palette.INK)  # covers columns 0, 1 and half of 2
    pixels = np.asarray(canvas.picture().convert("RGB")).astype(float)
    mean = 0.5 * (np.array(palette.rgb(palette.INK)) + palette.rgb(palette.PAPER))
    assert np.abs(pixels[:, 2] - mean).max() <= 0.5
    assert (pixels[:, 3] == 255.0).all()


def test_palette_fits_in_256_entries():
    table, colours = film_palette()
    assert len(COLOURS) + 3 * len(COLOURS) * (len(COLOURS) - 1) // 2 <= 256
    assert table.shape == (1 << 16,) and len(colours) == 768


def test_lines_far_outside_do_no_harm():
    canvas = Canvas(20, 20)
    canvas.line(np.array([[-1e9, 10.0], [1e9, 10.0]]), palette.BEAM, 3.0)
    canvas.arrow((5.0, 5.0), (5.0, 5.5), palette.FORCE)
    canvas.disc((-50.0, 3.0), 4.0, palette.CENTRE)
    canvas.rectangle((0.0, 30.0, 20.0, 20.0), palette.GROUND)
    assert (np.asarray(canvas.picture().convert("RGB"))[10, 10] == palette.rgb(palette.BEAM)).all()
