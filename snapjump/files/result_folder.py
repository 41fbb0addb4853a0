"""The folder of one job: which files it holds, and how each is written and read."""

import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import yaml

from snapjump.files.atomic import atomic_file, flush, write_text
from snapjump.files.former_names import with_present_names
from snapjump.files.json_file import read_json, write_json

# Where a run is recorded says nothing about what it computes.
NOT_PHYSICS = ("tracking",)

LONGEST_REASON = 300  # characters of why a picture was not drawn


class ResultFolder:
    """``config.yaml``, ``provenance.json``, ``trajectory.npz``, figures, and ``result.json``.
    ``result.json`` is written last: where it says that a job is finished, all else is there."""

    def __init__(self, path: Path):
        self.path = Path(path)

    def write_config(self, config: Mapping[str, Any]) -> None:
        """Write the configuration with every reference resolved."""
        write_text(self.path / "config.yaml", yaml.safe_dump(dict(config), sort_keys=False))

    def write_provenance(self, content: Mapping[str, Any]) -> None:
        write_json(self.path / "provenance.json", content)

    def write_result(self, content: Mapping[str, Any]) -> list[str]:
        """Write the flat result; returns the keys whose numbers were not finite."""
        return write_json(self.path / "result.json", content)

    def write_arrays(self, name: str, arrays: Mapping[str, Any]) -> list[str]:
        """Write ``<name>.npz``; arrays that are not finite are left out, and their names returned.
        Writes no file if nothing is left."""
        kept = {
            key: array
            for key, array in arrays.items()
            if array.dtype.kind not in "fc" or bool(np.isfinite(array).all())
        }
        if kept:
            with atomic_file(self.path / f"{name}.npz", "wb") as file:
                np.savez_compressed(file, allow_pickle=False, **kept)
        return [key for key in arrays if key not in kept]

    def write_figures(self, draw: Callable[[Path], Any]) -> bool:
        """Let ``draw`` fill a folder, and take its files over once all of them are complete.

        False for pictures that cannot be drawn (fonts, memory, a full disk): that is told, and
        takes no result along.
        """
        try:
            with TemporaryDirectory(prefix=".figures.", dir=self.path) as folder:
                draw(Path(folder))
                for file in sorted(Path(folder).iterdir()):
                    flush(file)
                    file.replace(self.path / file.name)
        except Exception as error:
            reason = " ".join(f"{type(error).__name__}: {error}".split())
            print(f"figures not drawn: {reason[:LONGEST_REASON]}", file=sys.stderr, flush=True)
            return False
        return True

    def result(self) -> dict[str, Any] | None:
        """The result, if there is one, under the names of today."""
        found = read_json(self.path / "result.json")
        return None if found is None else with_present_names(found, self.config)

    def provenance(self) -> dict[str, Any] | None:
        return read_json(self.path / "provenance.json")

    def config(self) -> dict[str, Any] | None:
        try:
            content = yaml.safe_load((self.path / "config.yaml").read_text(encoding="utf-8"))
        except (OSError, yaml.YAMLError):
            return None
        return content if isinstance(content, dict) else None

    def forget(self) -> None:
        """Remove the result of an earlier attempt, so that it cannot pass for the next one's."""
        for name in ("result.json", "provenance.json", "traceback.txt"):
            (self.path / name).unlink(missing_ok=True)

    def files(self) -> list[Path]:
        """Every complete file of the job, by name."""
        return sorted(
            file for file in self.path.iterdir() if file.is_file() and not file.name.startswith(".")
        )

    def holds(self, config: Mapping[str, Any], source_sha256: str, done: frozenset[str]) -> bool:
        """Whether this very computation, by the same code, has ended in one of ``done`` here."""
        result, origin = self.result(), self.provenance()
        return (
            result is not None
            and result.get("status") in done
            and origin is not None
            and origin.get("source_sha256") == source_sha256
            and _physics(self.config() or {}) == _physics(config)
        )


def _physics(config: Mapping[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in config.items() if key not in NOT_PHYSICS}
