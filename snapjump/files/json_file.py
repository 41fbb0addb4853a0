"""JSON without NaN: a number that is not finite becomes null, and the caller hears of it."""

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from snapjump.files.atomic import write_text


def finite(value: Any) -> tuple[Any, list[str]]:
    """A copy in plain Python types with null for NaN and infinity, and where those were."""
    lost: list[str] = []

    def clean(value: Any, place: tuple[str, ...]) -> Any:
        if isinstance(value, Mapping):
            return {str(key): clean(item, (*place, str(key))) for key, item in value.items()}
        if isinstance(value, (list, tuple)):
            return [clean(item, (*place, str(index))) for index, item in enumerate(value)]
        if hasattr(value, "item"):
            value = value.item()
        if isinstance(value, float) and not math.isfinite(value):
            lost.append(".".join(place))
            return None
        return value

    return clean(value, ()), lost


def write_json(path: Path, value: Mapping[str, Any]) -> list[str]:
    """Write a JSON file at once; returns the keys whose numbers were not finite."""
    clean, not_finite = finite(value)
    write_text(path, json.dumps(clean, indent=2, allow_nan=False) + "\n")
    return not_finite


def read_json(path: Path) -> dict[str, Any] | None:
    """The contents of a JSON file, or None if there is none that can be read."""
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return None
    return content if isinstance(content, dict) else None
