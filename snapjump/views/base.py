"""What shows itself: text for a terminal, pictures for a notebook, a film."""

from importlib import import_module
from typing import Any

from snapjump.views.picture import Picture


class Shown:
    """A result as people see it.

    Drawing is a floor above results: it is looked up when it is asked for, and costs nothing
    before.
    """

    def __repr__(self) -> str:
        return str(_of("line", self))

    def __str__(self) -> str:
        return str(_of("text", self))

    def _repr_html_(self) -> str:
        return str(_of("html", self))

    def plot(self, name: str | None = None) -> Picture:
        """The picture of it, which a notebook shows, and ``.save(path)`` writes; by ``name``
        another one: ``energy``. Raises ParameterError where there is nothing to draw."""
        picture: Picture = _of("plot", self, name)
        return picture

    def film(self) -> Picture:
        """The film of it, a GIF. Raises ParameterError where nothing moves."""
        picture: Picture = _of("film", self)
        return picture


def _of(view: str, shown: Shown, *more: Any) -> Any:
    return getattr(import_module("snapjump.show.views"), view)(shown, *more)
