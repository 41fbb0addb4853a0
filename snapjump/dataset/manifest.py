"""The manifest: what a dataset contains, told by content alone.

Two runs of one specification leave the same manifest to the last byte, whatever was killed on the
way: checksums of files, which hold times too, are in the entries of the shards.
"""

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from snapjump.dataset.folder import DatasetFolder
from snapjump.dataset.shard import Entry, read_entry
from snapjump.dataset.specification import Specification
from snapjump.files.lock import FileLock
from snapjump.files.sealed import sha256_of, write_sealed

Manifest = dict[str, Any]


def dataset_sha256(plain: Mapping[str, Any], contents: Sequence[str]) -> str:
    """The hash of a dataset: of its plan and configuration, and of its shards' contents.
    Not of the sources: those that give the same numbers give the same dataset."""
    determined = {key: value for key, value in plain.items() if key != "source_sha256"}
    return sha256_of({"specification": determined, "contents": list(contents)})


def manifest_of(specification: Specification, entries: Sequence[Entry | None]) -> Manifest:
    """The manifest of what has been done; the hash is null until all is."""
    done = [entry for entry in entries if entry is not None]
    statuses: Counter[str] = sum((Counter(entry["statuses"]) for entry in done), Counter())
    complete = len(done) == specification.shards
    contents = [entry["content_sha256"] for entry in done]
    return {
        "complete": complete,
        "dataset_sha256": dataset_sha256(specification.plain, contents) if complete else None,
        "designs": specification.plan.count,
        "rows": sum(entry["rows"] for entry in done),
        "statuses": dict(sorted(statuses.items())),
        "specification": dict(specification.plain),
        "shards": [
            {key: entry[key] for key in ("shard", "rows", "content_sha256", "statuses")}
            for entry in done
        ],
    }


def write_manifest(folder: DatasetFolder, specification: Specification) -> Manifest:
    """List what is there and whole; the last of several processes that finish lists it all."""
    with FileLock(folder.path / ".manifest.lock"):
        entries = [
            read_entry(folder, number, specification.sha256)[0]
            for number in range(specification.shards)
        ]
        manifest = manifest_of(specification, entries)
        write_sealed(folder.manifest, manifest)
    return manifest
