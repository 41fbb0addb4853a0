"""Names of folders and records: of a run, of a sweep and of one cell of it."""

import hashlib
import os
import re
import shlex
import uuid
from collections.abc import Sequence

from omegaconf import DictConfig, OmegaConf

from snapjump.files.layout import PROGRAM

LONGEST = 100
# The same cells recorded elsewhere are the same cells.
NOT_PHYSICS = re.compile(r"\+*(tracking[.=]|objective=|hydra[./])")
# How the cells of a sweep, in whatever process, hear of the keys that vary, and of what else the
# sweep's folder does not tell.
SWEPT_KEYS = "SNAPJUMP_SWEPT_KEYS"
FIXED = "SNAPJUMP_FIXED"


def sweep_name(overrides: Sequence[str], swept: Sequence[str]) -> str:
    """A stable name for a sweep: the keys that vary, whatever their values, and all else that was
    said. So a sweep over one more value is the same, in which one cell is new."""
    fixed = fixed_of(overrides, swept)
    exact = "\0".join([*sorted(swept), *fixed])
    readable = ",".join([*_short_keys(swept).values(), *fixed])
    return f"{_spelled(readable)[:LONGEST]}-{_digest(exact)}"


def fixed_of(overrides: Sequence[str], swept: Sequence[str]) -> list[str]:
    """The overrides that are the same in every cell."""
    return sorted(
        text for text in overrides if key_of(text) not in swept and not NOT_PHYSICS.match(text)
    )


def cell_name(overrides: Sequence[str]) -> str:
    """A stable, readable name for one cell of a sweep: what varies, ``epsilon=0.1,mu=0.3``."""
    swept = swept_keys()
    if not swept:
        told = ",".join(text for text in overrides if not NOT_PHYSICS.match(text))
        return readable_name(told) or "defaults"
    short = _short_keys(swept)
    values = {key_of(text): text.partition("=")[2] for text in overrides}
    told = ",".join(f"{short[key]}={_number(values[key])}" for key in swept if key in values)
    fixed = os.environ.get(FIXED, "")
    return readable_name(told + (f"-{fixed}" if fixed else "")) or "defaults"


def swept_keys() -> list[str]:
    """The keys that vary in the sweep that this process does, or does a cell of."""
    return [key for key in os.environ.get(SWEPT_KEYS, "").split(",") if key]


def command(overrides: Sequence[str]) -> str:
    """The command that repeats a job."""
    return shlex.join([*PROGRAM.split(), *overrides])


def key_of(override: str) -> str:
    """The key of an override."""
    return override.lstrip("+~").partition("=")[0]


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


def readable_name(exact: str) -> str:
    """A name for a file or folder: as it is if it can be one, else shortened, with a hash."""
    readable = _spelled(exact)
    if readable != exact or len(readable) > LONGEST:
        readable = f"{readable[:LONGEST]}-{_digest(exact)}"
    return readable


def _spelled(text: str) -> str:
    return re.sub(r"[^\w.=,+-]", "_", text)


def _digest(exact: str) -> str:
    return hashlib.sha256(exact.encode()).hexdigest()[:8]


def _short_keys(keys: Sequence[str]) -> dict[str, str]:
    """The last word of each key where that tells it from the others."""
    last = [key.rpartition(".")[2] for key in keys]
    return {
        key: word if last.count(word) == 1 else key for key, word in zip(keys, last, strict=True)
    }


def _number(value: str) -> str:
    """A number without what rounding adds to it: 0.12 for 0.12000000000000001."""
    try:
        return value if len(value) < 12 else f"{float(value):.15g}"
    except ValueError:
        return value
