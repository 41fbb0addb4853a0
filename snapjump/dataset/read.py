"""Reading a dataset that is complete: checked, then whole or shard by shard."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pyarrow as pa
import pyarrow.parquet as pq

from snapjump.checks import ParameterError, of_ours
from snapjump.dataset.folder import DatasetFolder
from snapjump.dataset.manifest import dataset_sha256
from snapjump.dataset.shard import read_entry
from snapjump.declare.members import check_known
from snapjump.files import former_names
from snapjump.files.sealed import read_sealed, sha256_of
from snapjump.plan.parts.axes import Axis, recorded_axes

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True)
class Dataset:
    """``sha256``: its name for good; ``specification``: all that determines it, plain."""

    folder: DatasetFolder
    sha256: str
    rows: int
    statuses: dict[str, int]
    specification: dict[str, Any]
    shard_count: int

    @cached_property
    def columns(self) -> dict[str, str]:
        """The columns that its files have: names there, by names of today."""
        names = pq.read_schema(self.folder.shard(0)).names
        return {former_names.COLUMNS.get(name, name): name for name in names}

    @property
    def axes(self) -> tuple[Axis, ...]:
        """The inputs that vary, and their ranges."""
        return recorded_axes(self.specification)

    def shards(self, columns: Sequence[str] | None = None) -> Iterator[pa.Table]:
        """One shard's rows after the other, in the plan's order; memory is that of one."""
        chosen = checked_columns(columns, self.columns)
        held = [self.columns[name] for name in chosen]
        for number in range(self.shard_count):
            yield pq.read_table(
                self.folder.shard(number), columns=held, page_checksum_verification=True
            ).rename_columns(chosen)

    def table(self, columns: Sequence[str] | None = None) -> pa.Table:
        """All rows, null where there is no value; ``columns``: which, None for all."""
        return pa.concat_tables(
            table.replace_schema_metadata(None).unify_dictionaries()
            for table in self.shards(columns)
        )

    def frame(self, columns: Sequence[str] | None = None) -> "pd.DataFrame":
        """All rows for pandas, NaN where there is no value (and a status that tells why)."""
        return self.table(columns).to_pandas()


def checked_columns(columns: Sequence[str] | None, there: Collection[str]) -> list[str]:
    """The columns to read, None for all. Raises ParameterError for one that is not there."""
    chosen = list(there if columns is None else columns)
    for name in chosen:
        if name not in there:
            raise ParameterError("columns", name, "some of " + ", ".join(there))
    return chosen


def load_dataset(path: str | Path) -> Dataset:
    """A dataset whose every shard is as it was written.

    Raises ParameterError, which names what is missing or damaged: running its generation again
    makes that good.
    """
    folder = DatasetFolder(Path(path))
    with of_ours(lambda reason: folder.refused(f"a folder with a dataset: {reason}")):
        found = _read(folder)
        assert found.axes and sum(found.statuses.values()) == found.rows
        return found


def _read(folder: DatasetFolder) -> Dataset:
    manifest = read_sealed(folder.manifest)
    if manifest is None:
        raise folder.refused(f"a folder with a {folder.manifest.name} that is not damaged")
    if not manifest["complete"]:
        have = f"{manifest['rows']} of {manifest['designs']} rows are there"
        raise folder.refused(f"a dataset that is complete ({have})")
    specification = manifest["specification"]
    try:
        check_known(specification["configuration"])
    except ParameterError as error:
        raise folder.refused(f"one of members that are known here ({error})") from error
    for number, listed in enumerate(manifest["shards"]):
        entry, reason = read_entry(folder, number, sha256_of(specification))
        if entry is None:
            name = folder.shard(number).name
            raise folder.refused(f"a dataset without damage ({reason or name + ' is missing'})")
        if entry["content_sha256"] != listed["content_sha256"]:
            raise folder.refused(f"a manifest of these shards (shard {number} is another)")
    contents = [listed["content_sha256"] for listed in manifest["shards"]]
    told = dataset_sha256(specification, contents), manifest["rows"], manifest["statuses"]
    return Dataset(folder, *told, specification, len(contents))
