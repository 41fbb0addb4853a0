"""Hashes of sources, kept between processes: to tokenise a file takes longer than to read it."""

import hashlib
import json
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from snapjump.files import tokens
from snapjump.files.atomic import write_text

FILE = "source_hashes.json"
MOST = 5000  # more are begun anew, with those in use


def cache_root() -> Path:
    """The folder of what can be made again, under the user's cache directory."""
    own = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
    return Path(os.environ.get("NUMBA_CACHE_DIR") or Path(own, "snapjump"))


@contextmanager
def kept_hashes() -> Iterator[Callable[[Path], str]]:
    """A function that hashes a file, or finds the hash that was kept of the same bytes.
    What is new is kept at the end of the block. Hashes of another rule do not count."""
    rule = hashlib.sha256(Path(tokens.__file__).read_bytes()).hexdigest()
    kept = _read(rule)
    used: dict[str, str] = {}

    def file_hash(path: Path) -> str:
        content = path.read_bytes()
        key = f"{path.suffix} {hashlib.sha256(content).hexdigest()}"
        used[key] = kept.get(key) or tokens.content_hash(content, path.suffix)
        return used[key]

    yield file_hash
    if not used.keys() <= kept.keys():
        both = {**kept, **used}
        content = {"rule": rule, "hashes": both if len(both) <= MOST else used}
        with suppress(OSError):  # where it cannot be written, the next process hashes again
            cache_root().mkdir(parents=True, exist_ok=True)
            write_text(cache_root() / FILE, json.dumps(content))


def _read(rule: str) -> dict[str, str]:
    try:
        found = json.loads((cache_root() / FILE).read_text(encoding="utf-8"))
        return dict(found["hashes"]) if found["rule"] == rule else {}
    except (OSError, ValueError, TypeError, KeyError):
        return {}
