"""One shard on disk: written whole, then listed; and found out if it is not what was written."""

import hashlib
import json
from collections import Counter
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

from snapjump.dataset.columns import Rows, columns_of, content_sha256, table_of
from snapjump.dataset.folder import DatasetFolder
from snapjump.dataset.specification import Specification
from snapjump.files.atomic import write_bytes
from snapjump.files.provenance import now, origin
from snapjump.files.sealed import file_sha256, read_sealed, sha256_of, write_sealed

METADATA = b"snapjump"
Entry = dict[str, Any]


def write_shard(
    folder: DatasetFolder, specification: Specification, number: int, rows: Rows
) -> Entry:
    """Write the rows of a shard, then its entry; returns the entry."""
    columns = columns_of(specification.axes, specification.outputs)
    table = table_of(columns, rows)
    return write_table(folder, specification, number, table)


def write_table(
    folder: DatasetFolder, specification: Specification, number: int, table: pa.Table
) -> Entry:
    """The same of rows as a table."""
    content = content_sha256(table)
    about = {
        "specification": specification.plain,
        "plan_sha256": sha256_of([specification.plain[key] for key in ("plan", "inputs")]),
        "shard": number,
        "content_sha256": content,
        "written_at": now(),
        **origin(),
    }
    table = table.replace_schema_metadata({METADATA: json.dumps(about)})
    stream = pa.BufferOutputStream()
    pq.write_table(table, stream, compression="zstd", write_page_checksum=True)
    whole = stream.getvalue()
    write_bytes(folder.shard(number), whole)
    entry = {
        "shard": number,
        "rows": len(table),
        "specification_sha256": specification.sha256,
        "content_sha256": content,
        "file_sha256": hashlib.sha256(whole).hexdigest(),
        "bytes": whole.size,
        "statuses": dict(sorted(Counter(table["status"].to_numpy().tolist()).items())),
    }
    write_sealed(folder.entry(number), entry)
    return entry


def read_entry(
    folder: DatasetFolder, number: int, specification_sha256: str
) -> tuple[Entry | None, str]:
    """The entry of a shard that is whole, else None and what is wrong: empty if it is not done."""
    file = folder.entry(number)
    if not file.exists():
        return None, ""
    entry = read_sealed(file)
    if entry is None or not is_entry(entry):
        return None, f"{file.name} is damaged"
    if (entry["shard"], entry["specification_sha256"]) != (number, specification_sha256):
        return None, f"{file.name} is of another dataset or shard"
    reason = damage(folder.shard(number), entry)
    return (None, reason) if reason else (entry, "")


def is_entry(content: Entry) -> bool:
    """Whether it has all that an entry has: somebody may have sealed something else."""
    counts, words = ("shard", "rows", "bytes"), ("content_sha256", "file_sha256")
    statuses = content.get("statuses")
    return (
        all(isinstance(content.get(key), int) for key in counts)
        and all(isinstance(content.get(key), str) for key in words)
        and "specification_sha256" in content
        and isinstance(statuses, dict)
        and all(isinstance(count, int) for count in statuses.values())
    )


def damage(shard: Path, entry: Entry) -> str:
    """The damage of a shard's file in words; empty if it is what was written."""
    if not shard.exists():
        return f"{shard.name} is missing"
    size = shard.stat().st_size
    if size != entry["bytes"]:
        return f"{shard.name} has {size} bytes instead of {entry['bytes']}"
    is_whole = file_sha256(shard) == entry["file_sha256"]
    return "" if is_whole else f"{shard.name} is not what was written"
