"""The hash of all that determines the cells of a study, which their folder is named by."""

import ast
import json
from collections.abc import Iterable, Mapping
from importlib.util import find_spec, resolve_name
from pathlib import Path
from typing import Any

from snapjump.files.json_file import finite
from snapjump.files.layout import EXPERIMENTS, STUDIES, in_a_clone
from snapjump.files.provenance import source_hash
from snapjump.files.sources import Source, combined_hash

# What is shown, where, and of which quality says nothing about what is computed.
NOT_PHYSICS = ("tracking", "publish", "figures", "objective")
INIT = "__init__.py"
DIGITS = 16


def fingerprint(config: Mapping[str, Any], roots: Iterable[str]) -> str:
    """A hash of the resolved configuration, of the library and of the modules of a study.
    ``roots``: the modules, as in ``experiments.designs``, that cells are computed by."""
    physics, _ = finite({key: value for key, value in config.items() if key not in NOT_PHYSICS})
    configuration = json.dumps(physics, sort_keys=True)
    return combined_hash(sources(roots), configuration, source_hash())[:DIGITS]


def sources(roots: Iterable[str]) -> list[Source]:
    """The modules and everything of the experiments that these import, named as in a clone."""
    found: dict[str, Path] = {}
    waiting = list(map(in_a_clone, roots))
    while waiting:
        module = waiting.pop()
        file = _file(module)
        if module in found or file is None:
            continue
        found[module] = file
        package = module if file.name == INIT else module.rpartition(".")[0]
        waiting += _imports(file, package)
    return [Source(module, found[module]) for module in sorted(found)]


def _imports(file: Path, package: str) -> Iterable[str]:
    """What a module of a package imports of the experiments, relatively as they do or not."""
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if not isinstance(node, ast.ImportFrom):
            continue
        name = node.module or ""
        module = resolve_name("." * node.level + name, package) if node.level else name
        if f"{module}.".startswith(STUDIES):
            yield module
            # ``from package import module`` as well as ``from module import name``.
            yield from (f"{module}.{alias.name}" for alias in node.names)


def _file(module: str) -> Path | None:
    """Of a module or package; None for what is a name within one."""
    if not f"{module}.".startswith(STUDIES):
        spec = find_spec(module)
        return Path(spec.origin) if spec is not None and spec.origin else None
    place = EXPERIMENTS.joinpath(*module.split(".")[1:])
    files = (place.with_suffix(".py"), place / INIT)
    return next((file for file in files if file.is_file()), None)
