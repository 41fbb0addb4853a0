"""A whole dataset at once: made, or found where ``task=dataset`` keeps it."""

from collections.abc import Mapping
from typing import Any

from snapjump.dataset.folder import DatasetFolder, default_path
from snapjump.dataset.generate import Generation, generate
from snapjump.dataset.read import Dataset, load_dataset
from snapjump.dataset.specification import Specification
from snapjump.executor.local import LocalExecutor


def whole_dataset(
    specification: Specification, backend: Mapping[str, Any]
) -> tuple[Dataset, Generation]:
    """The dataset, and how its making went, on this machine. Raises ParameterError if another
    process is at it."""
    folder = DatasetFolder(default_path(specification))
    folder.check(specification)
    locks = folder.claim(1, 1)
    try:
        went = generate(folder, specification, LocalExecutor(), backend, lambda share, text: None)
    finally:
        for lock in locks:
            lock.release()
    return load_dataset(folder.path), went
