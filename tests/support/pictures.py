"""Pictures, and how much of a colour is in them."""

from pathlib import Path

import numpy as np
from PIL import Image

from snapjump.show.plots import palette


def picture(path: Path) -> np.ndarray:
    return np.asarray(Image.open(path).convert("RGB"))


def count(pixels: np.ndarray, colour: str) -> int:
    """Number of the pixels of exactly this colour."""
    return int((pixels == palette.rgb(colour)).all(axis=2).sum())


def has(pixels: np.ndarray, colour: str, more_than: int = 200) -> bool:
    """Whether enough of a colour is there for a bar or a line."""
    return count(pixels, colour) > more_than
