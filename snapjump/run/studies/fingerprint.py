"""The hash of all that determines the cells of a study, which their folder is named by."""

import ast
import json
from collections.abc import Iterable, Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from snapjump.files.json_file import finite
from snapjump.files.provenance import source_hash
from snapjump.files.sources import Source, combined_hash

# What is shown, where, and of which quality says nothing about what is computed.
NOT_PHYSICS = ("tracking", "publish", "figures")
PACKAGE = "experiments"
DIGITS = 16


def fingerprint(config: Mapping[str, Any], roots: Iterable[str]) -> str:
    """A hash of the resolved configuration, of the library and of the modules of a study.
    ``roots``: the modules, as in ``experiments.designs``, that cells are computed by."""
    physics, _ = finite({key: value for key, value in config.items() if key not in NOT_PHYSICS})
    configuration = json.dumps(physics, sort_keys=True)
    return combined_hash(sources(roots), configuration, source_hash())[:DIGITS]


def sources(roots: Iterable[str]) -> list[Source]:
    """The modules and everything of the experiments that these import, by their modules' names."""
    found: dict[str, Path] = {}
    waiting = list(roots)
    while waiting:
        module = waiting.pop()
        origin = _origin(module)
        if module in found or origin is None:
            continue
        found[module] = origin
        waiting += [name for name in _imports(origin) if name.split(".")[0] == PACKAGE]
    return [Source(module, found[module]) for module in sorted(found)]


def _imports(file: Path) -> Iterable[str]:
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            yield node.module
            # ``from package import module`` as well as ``from module import name``.
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def _origin(module: str) -> Path | None:
    try:
        spec = find_spec(module)
    except ModuleNotFoundError:
        return None
    return Path(spec.origin) if spec is not None and spec.origin else None
