"""The work of an executor: one shard, computed and written wherever this is called."""

import functools
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from snapjump.checks import ParameterError
from snapjump.dataset.folder import DatasetFolder
from snapjump.dataset.shard import Entry, write_shard
from snapjump.dataset.simulate import ShardSimulator
from snapjump.dataset.specification import Specification, restored
from snapjump.declare.plugins import load_plugins
from snapjump.declare.scenes import Progress
from snapjump.files.provenance import BEYOND_DATASETS, source_hash
from snapjump.files.sealed import canonical
from snapjump.files.sources import PLUGINS


def job_of(
    folder: DatasetFolder, specification: Specification, backend: Mapping[str, Any], number: int
) -> dict[str, Any]:
    """A job that makes a shard in another process, in plain JSON."""
    return {
        "folder": str(folder.path),
        "specification": dict(specification.plain),
        "backend": dict(backend),
        "shard": number,
        "plugins": [str(folder) for folder in PLUGINS],
    }


def make_shard(job: Mapping[str, Any], progress: Progress | None) -> Entry:
    """Simulate the designs of a shard and write it; returns its entry.
    Raises ParameterError where the sources are not those of the process that asks."""
    for plugins in job.get("plugins", ()):
        load_plugins(plugins)
    asked = job["specification"]
    own = source_hash(BEYOND_DATASETS)
    if own != asked["source_sha256"]:
        raise ParameterError(
            "source_sha256", own, f"{asked['source_sha256']}, which this worker's snapjump is not"
        )
    simulator = prepared(canonical(asked), canonical(job["backend"]))
    first, last = simulator.specification.stretch(job["shard"])
    rows = simulator.rows(first, last, progress)
    folder = DatasetFolder(Path(job["folder"]))
    return write_shard(folder, simulator.specification, job["shard"], rows)


@functools.lru_cache(maxsize=1)
def prepared(specification: str, backend: str) -> ShardSimulator:
    """The simulator that all shards of a dataset share, kept from one to the next."""
    return ShardSimulator(restored(json.loads(specification), json.loads(backend)))
