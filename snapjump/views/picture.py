"""A picture or a film in memory: shown by notebooks, written to a file on demand."""

import base64
from dataclasses import dataclass
from pathlib import Path

from snapjump.files.atomic import write_bytes


@dataclass(frozen=True, repr=False)
class Picture:
    """``name``: of a file, ``jump.png`` or ``jump.gif``; ``data``: what would be in it."""

    name: str
    data: bytes

    def save(self, path: str | Path | None = None) -> Path:
        """Write it, by default under its own name in the working folder; returns the path."""
        place = Path(path or self.name)
        write_bytes(place, self.data)
        return place

    def html(self) -> str:
        """An image for a page, with all that it needs."""
        kind = Path(self.name).suffix.removeprefix(".")
        data = base64.b64encode(self.data).decode()
        return f'<img src="data:image/{kind};base64,{data}" alt="{self.name}">'

    def __repr__(self) -> str:
        return f"<{self.name}, {len(self.data) / 1e3:.0f} kB; .save(path) writes it>"

    def _repr_png_(self) -> bytes | None:
        return self.data if self.name.endswith(".png") else None

    def _repr_html_(self) -> str | None:
        return None if self.name.endswith(".png") else self.html()
