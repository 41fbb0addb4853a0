"""Names of folders: of a run, of a sweep and of one cell of it."""

import hashlib
import re
import uuid
from collections.abc import Sequence

from omegaconf import DictConfig, OmegaConf

LONGEST = 100
# The same cells recorded elsewhere are the same cells.
NOT_PHYSICS = re.compile(r"\+*tracking[.=]")


def sweep_name(overrides: Sequence[str]) -> str:
    """A stable name for a sweep: the same overrides in any order give the same name."""
    return readable_name(_physics(sorted(overrides)), always_hash=True) or "defaults"


def cell_name(overrides: Sequence[str]) -> str:
    """A stable, readable name for one cell of a sweep."""
    return readable_name(_physics(overrides)) or "defaults"


def task_overrides(hydra: DictConfig) -> list[str]:
    """Overrides of the command line or the sweep; text such as ``${...}`` is left as it is."""
    overrides = OmegaConf.to_container(hydra.overrides.task, resolve=False)
    assert isinstance(overrides, list)
    return overrides


def given_overrides() -> list[str]:
    """Those of the command that this process does; none where there is none."""
    from hydra.core.hydra_config import HydraConfig

    return task_overrides(HydraConfig.get()) if HydraConfig.initialized() else []


def register_resolvers() -> None:
    """Let configurations use ``${unique_id:}`` and ``${cell_name:}``."""

    def of_cell(*, _root_: DictConfig) -> str:
        return cell_name(task_overrides(_root_.hydra))

    register = OmegaConf.register_new_resolver
    register("unique_id", lambda: uuid.uuid4().hex[:8], use_cache=True, replace=True)
    register("cell_name", of_cell, replace=True)


def readable_name(exact: str, always_hash: bool = False) -> str:
    """A name for a file or folder: as it is if it can be one, else shortened, with a hash."""
    readable = re.sub(r"[^\w.=,+-]", "_", exact)
    if readable and (readable != exact or len(readable) > LONGEST or always_hash):
        digest = hashlib.sha256(exact.encode()).hexdigest()[:8]
        readable = f"{readable[:LONGEST]}-{digest}"
    return readable


def _physics(overrides: Sequence[str]) -> str:
    return ",".join(text for text in overrides if not NOT_PHYSICS.match(text))
