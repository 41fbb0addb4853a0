"""JSON files that tell when they have been damaged: each holds the hash of what it says."""

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from snapjump.files.json_file import read_json, write_json

SEAL = "sha256_of_this"


def canonical(value: Any) -> str:
    """JSON that is the same for equal values."""
    return json.dumps(value, sort_keys=True, separators=(",", ":"), allow_nan=False)


def sha256_of(value: Any) -> str:
    """A hash of a plain value."""
    return hashlib.sha256(canonical(value).encode()).hexdigest()


def file_sha256(path: Path) -> str:
    """A hash of a file's bytes; of one that cannot be read, the reason."""
    try:
        with open(path, "rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError as error:
        return str(error.strerror)


def write_sealed(path: Path, content: Mapping[str, Any]) -> None:
    """Write a JSON file whole, with its hash."""
    write_json(path, {**content, SEAL: sha256_of(content)})


def read_sealed(path: Path) -> dict[str, Any] | None:
    """The content, or None if there is none that is as it was written."""
    content = read_json(path)
    if content is None:
        return None
    seal = content.pop(SEAL, None)
    try:
        return content if seal == sha256_of(content) else None
    except ValueError:  # NaN, which nobody has sealed
        return None
