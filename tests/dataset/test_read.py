"""Reading: the rows that were written, some columns of them, shard by shard; statistics."""

import tracemalloc

import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from small_datasets import made_up_dataset, made_up_rows, small

from snapjump.checks import ParameterError
from snapjump.dataset.columns import columns_of, content_sha256, table_of
from snapjump.dataset.folder import DatasetFolder
from snapjump.dataset.manifest import write_manifest
from snapjump.dataset.read import load_dataset
from snapjump.dataset.shard import write_table
from snapjump.dataset.statistics import gather
from snapjump.plan.parts.axes import default_axes

NAMES = [column.name for column in columns_of(default_axes())]
COLUMNS = [axis.column for axis in default_axes()]


@pytest.fixture(scope="module")
def read_and_written(tmp_path_factory):
    """A dataset of made-up numbers as it is read, and the columns that were written."""
    specification = small(100, 16)
    found = made_up_dataset(tmp_path_factory.mktemp("made_up"), specification)
    rows = [made_up_rows(specification, number) for number in range(specification.shards)]
    return found, {n: np.concatenate([row[n] for row in rows]) for n in NAMES}


def test_what_was_written_is_read(read_and_written):
    found, written = read_and_written
    frame = found.frame()
    assert list(frame.columns) == list(NAMES) and len(frame) == found.rows == 100
    for name in NAMES:
        if written[name].dtype.kind == "f":
            assert np.array_equal(frame[name], written[name], equal_nan=True)
        else:
            assert (frame[name] == written[name]).all()
    assert found.statuses == {"ok": 90, "step_underflow": 10}
    assert (frame["x_bar"].isna() == (frame["status"] != "ok")).all()


def test_some_columns_shard_by_shard(read_and_written):
    found, written = read_and_written
    tables = list(found.shards(["mu", "y_bar"]))
    assert [len(table) for table in tables] == [16] * 6 + [4]
    assert tables[0].column_names == ["mu", "y_bar"]
    assert np.concatenate([t["mu"].to_numpy() for t in tables]).tolist() == written["mu"].tolist()
    assert found.table(["mu"]).num_rows == 100
    with pytest.raises(ParameterError, match="columns = 'z_bar'"):
        found.table(["z_bar"])


def test_a_dataset_of_before_has_its_columns_under_names_of_today(tmp_path):
    specification = small(16, 8)
    folder = DatasetFolder(tmp_path)
    folder.open(specification)
    kept = ["index", "mount_height_bar", "x_bar", "status", "kernel_seconds"]
    former = ["index", "h_bar", "x_bar", "status", "kernel_seconds"]
    hashes = {}
    for number in range(specification.shards):
        rows = dict(made_up_rows(specification, number))
        table = table_of(columns_of(specification.axes), rows).select(kept).rename_columns(former)
        hashes[number] = write_table(folder, specification, number, table)["content_sha256"]
    write_manifest(folder, specification)
    found = load_dataset(tmp_path)
    heights = made_up_rows(specification, 1)["mount_height_bar"]
    table = list(found.shards(["x_bar", "mount_height_bar"]))[1]
    assert np.array_equal(table["mount_height_bar"].to_numpy(), heights)
    assert list(found.frame().columns) == kept
    with pytest.raises(ParameterError, match="columns = 'y_bar'"):
        found.table(["y_bar"])
    # Its hash is of the names in its files.
    assert content_sha256(pq.read_table(folder.shard(1))) == hashes[1]
    assert content_sha256(list(found.shards())[1]) != hashes[1]


def test_a_dataset_that_is_not_complete_is_refused(tmp_path):
    specification = small(100, 16)
    with pytest.raises(ParameterError, match=r"manifest\.json"):
        load_dataset(tmp_path)
    folder = DatasetFolder(tmp_path)
    folder.open(specification)
    write_manifest(folder, specification)
    with pytest.raises(ParameterError, match="0 of 100 rows"):
        load_dataset(tmp_path)


def test_statistics_are_those_of_the_rows(read_and_written):
    found, written = read_and_written
    statistics = gather(found)
    ok = written["status"] == "ok"
    for o, name in enumerate(("x_bar", "y_bar")):
        for pair, (i, j) in enumerate(statistics.pairs):
            place = [
                np.clip(np.digitize(written[COLUMNS[a]], statistics.edges[a]) - 1, 0, 4)
                for a in (i, j)
            ]
            for (a, b), mean in np.ndenumerate(statistics.means(o, pair)):
                values = written[name][ok & (place[0] == a) & (place[1] == b)]
                expected = values.mean() if len(values) else np.nan
                assert mean == pytest.approx(expected, nan_ok=True)
        first = np.digitize(written[COLUMNS[0]], statistics.edges[0]) - 1 == 0
        values = written[name][ok & first]
        width = np.diff(statistics.levels[o])[0]
        (median,) = statistics.quantiles(o, 0, [0.5])
        assert abs(median[0] - np.sort(values)[(len(values) - 1) // 2]) <= width
    marked = ~(ok & written["within_tier"])
    assert statistics.marked[0].sum() == marked.sum()
    assert statistics.rows.sum() == 100 * len(statistics.pairs)


def test_bins_of_a_grid_are_its_values(tmp_path):
    specification = small(plan={"name": "grid", "points": 3}, shard_size=50)
    statistics = gather(made_up_dataset(tmp_path, specification))
    assert statistics.edges.shape == (4, 4)
    assert (statistics.rows == 9).all()


def test_memory_does_not_grow_with_the_dataset(tmp_path):
    """Peak of Python's and Arrow's memory while opening and gathering 12 and 60 shards."""
    peaks = []
    for shards in (12, 60):
        specification = small(512 * shards, 512)
        dataset = made_up_dataset(tmp_path / str(shards), specification)
        gather(dataset)
        pool = pa.proxy_memory_pool(pa.default_memory_pool())
        before = pa.default_memory_pool()
        pa.set_memory_pool(pool)
        tracemalloc.start()
        try:
            gather(load_dataset(tmp_path / str(shards)))
            peaks.append(tracemalloc.get_traced_memory()[1] + pool.max_memory())
        finally:
            tracemalloc.stop()
            pa.set_memory_pool(before)
    assert peaks[1] < 1.1 * peaks[0]


def test_the_folder_of_shards_is_a_table_for_everybody(read_and_written):
    found, _ = read_and_written
    frame = pd.read_parquet(found.folder.path / "shards")
    assert frame["mu"].tolist() == found.frame()["mu"].tolist()


def test_entries_under_their_former_names_are_found(tmp_path):
    before = made_up_dataset(tmp_path, small(40, 16))
    for number in range(before.shard_count):
        path = before.folder.entry(number)
        path.rename(path.with_name(path.name.removeprefix("_")))
    assert not list(tmp_path.glob("shards/_*"))
    assert load_dataset(tmp_path).sha256 == before.sha256
