"""Names that outputs had in files of before, for whatever reads such a file again."""

from collections.abc import Callable, Mapping
from typing import Any

# Of a dataset's columns, whose unit has stayed.
COLUMNS = {"h_bar": "mount_height_bar"}


def with_present_names(
    result: Mapping[str, Any], config: Callable[[], Mapping[str, Any] | None]
) -> dict[str, Any]:
    """A ``result.json`` under the names and units of today; ``config`` reads the job's own."""
    found = dict(result)
    if "mount_height_m" in found:
        length_m = (config() or {})["robot"]["length_m"]
        found["mount_height_bar"] = found.pop("mount_height_m") / length_m
    return found
