"""Shards, entries and manifest on disk: any damage is told, no other dataset is touched."""

import json
import os
import random

import pyarrow.parquet as pq
import pytest
from refusals import refused
from small_datasets import made_up, made_up_rows, small

from snapjump.checks import ParameterError
from snapjump.dataset.columns import columns_of, content_sha256, schema
from snapjump.dataset.folder import DatasetFolder, default_path
from snapjump.dataset.manifest import write_manifest
from snapjump.dataset.read import load_dataset
from snapjump.dataset.shard import read_entry, write_shard
from snapjump.files.sealed import read_sealed, write_sealed

SPECIFICATION = small()
PLAN = {"name": "latin_hypercube", "count": 24}
COLUMNS = columns_of(SPECIFICATION.axes)


def whole(folder, number=1):
    return read_entry(folder, number, SPECIFICATION.sha256)


def test_a_shard_tells_where_it_comes_from(tmp_path):
    folder = made_up(tmp_path, SPECIFICATION)
    file = pq.ParquetFile(folder.shard(2))
    about = json.loads(file.schema_arrow.metadata[b"snapjump"])
    assert about["specification"] == SPECIFICATION.plain
    assert about["shard"] == 2 and about["plan_sha256"]
    assert {"git_revision", "versions", "machine", "source_sha256", "written_at"} <= set(about)
    table = file.read()
    assert table.schema.remove_metadata().equals(schema(COLUMNS).remove_metadata())
    assert table.schema.field("x_bar").metadata[b"unit"] == b"L"
    entry, reason = whole(folder, 2)
    assert reason == "" and entry["content_sha256"] == content_sha256(table)
    assert about["content_sha256"] == entry["content_sha256"]
    assert table["index"].to_pylist() == list(range(16, 24))


def test_files_are_written_whole_and_nothing_else_is_left(tmp_path):
    folder = made_up(tmp_path, SPECIFICATION)
    names = {path.name for path in tmp_path.rglob("*") if path.is_file()}
    shards = {name for k in range(3) for name in (f"_shard-0000{k}.json", f"shard-0000{k}.parquet")}
    assert names == {"dataset.json", "manifest.json", ".manifest.lock"} | shards
    for left in (folder.shard(1), folder.entry(1)):
        (left.parent / f".{left.name}.half").write_text("half")
    folder.sweep([0, 2])
    assert len(list((tmp_path / "shards").glob(".*"))) == 2
    folder.sweep([1])
    assert not list((tmp_path / "shards").glob(".*"))


def test_an_entry_follows_its_shard(tmp_path, monkeypatch):
    """Whatever stops the writing between the two, the shard does not count."""
    folder = DatasetFolder(tmp_path)
    folder.open(SPECIFICATION)
    replace = os.replace

    def stop_at_entry(source, target):
        if str(target).endswith(".json"):
            raise KeyboardInterrupt
        replace(source, target)

    monkeypatch.setattr(os, "replace", stop_at_entry)
    with pytest.raises(KeyboardInterrupt):
        write_shard(folder, SPECIFICATION, 0, made_up_rows(SPECIFICATION, 0))
    assert folder.shard(0).exists() and whole(folder, 0) == (None, "")


def test_any_flipped_bit_is_found(tmp_path):
    folder = made_up(tmp_path, SPECIFICATION)
    choice = random.Random(0)
    for file in (folder.shard(1), folder.entry(1)):
        content = file.read_bytes()
        for _ in range(60):
            place, bit = choice.randrange(len(content)), 1 << choice.randrange(8)
            flipped = bytes([content[place] ^ bit])
            file.write_bytes(content[:place] + flipped + content[place + 1 :])
            entry, reason = whole(folder)
            # White space between the words of JSON says nothing.
            if entry is not None:
                assert file.suffix == ".json" and chr(content[place]).isspace()
                continue
            assert "shard-00001" in reason
        file.write_bytes(content)
    assert whole(folder)[1] == ""


def test_a_shard_that_is_truncated_gone_or_of_another_place_is_named(tmp_path):
    folder = made_up(tmp_path, SPECIFICATION)
    for kept in (1000, 4, 0):
        os.truncate(folder.shard(1), kept)
        entry, reason = whole(folder)
        assert entry is None
        assert reason.startswith(f"shard-00001.parquet has {kept} bytes instead of")
        with pytest.raises(ParameterError, match=r"shard-00001\.parquet has"):
            load_dataset(tmp_path)
    folder.shard(0).unlink()
    assert whole(folder, 0) == (None, "shard-00000.parquet is missing")
    folder.entry(1).write_bytes(folder.entry(2).read_bytes())
    assert whole(folder, 1) == (None, "_shard-00001.json is of another dataset or shard")


def test_a_sealed_file_knows_its_content(tmp_path):
    write_sealed(tmp_path / "a.json", {"b": [1, 2.5, None, "c"]})
    assert read_sealed(tmp_path / "a.json") == {"b": [1, 2.5, None, "c"]}
    text = (tmp_path / "a.json").read_text()
    (tmp_path / "a.json").write_text(text.replace("2.5", "2.6"))
    assert read_sealed(tmp_path / "a.json") is None
    assert read_sealed(tmp_path / "none.json") is None


def test_left_overs_are_looked_for_once(tmp_path, monkeypatch):
    """A folder of many shards is listed once, not once for each."""
    folder = made_up(tmp_path, SPECIFICATION)
    listed = []
    scandir = os.scandir
    monkeypatch.setattr(os, "scandir", lambda *path: listed.append(path) or scandir(*path))
    folder.sweep(list(range(1000)))
    assert len(listed) <= 1


def test_equal_datasets_have_equal_manifests_and_files_need_not(tmp_path):
    for name in ("a", "b"):
        made_up(tmp_path / name, SPECIFICATION)
    rows = dict(made_up_rows(SPECIFICATION, 1))
    rows["kernel_seconds"] = 2.0 * rows["kernel_seconds"]
    other = DatasetFolder(tmp_path / "b")
    write_shard(other, SPECIFICATION, 1, rows)
    write_manifest(other, SPECIFICATION)
    a, b = (tmp_path / name for name in ("a", "b"))
    assert (a / "manifest.json").read_bytes() == (b / "manifest.json").read_bytes()
    assert load_dataset(a).sha256 == load_dataset(b).sha256
    rows["x_bar"] = rows["x_bar"] + 1e-12
    write_shard(other, SPECIFICATION, 1, rows)
    with pytest.raises(ParameterError, match="shard 1 is another"):
        load_dataset(b)
    write_manifest(other, SPECIFICATION)
    assert load_dataset(a).sha256 != load_dataset(b).sha256


def test_a_folder_of_another_dataset_is_refused_with_the_first_difference(tmp_path):
    folder = made_up(tmp_path, SPECIFICATION)
    folder.check(SPECIFICATION)
    changes = {
        "stepping.tolerance": small(stepping={"name": "adaptive", "tolerance": 2e-5}),
        "plan.count": small(32),
        "dataset.shard_size": small(shard_size=4),
        "accuracy.name": small(accuracy={"name": "standard"}),
        "plan.name": small(plan={"name": "sobol", "count": 24}),
        "plan.inputs.environment.mu": small(plan={**PLAN, "mu": [0.1, 0.5]}),
        "plan.inputs.design.delta_alpha": small(plan={**PLAN, "inputs": {"design.epsilon": None}}),
    }
    for key, other in changes.items():
        with refused(key, str(tmp_path)):
            folder.check(other)
    assert "1e-05 to go on with" in first_error(folder, changes["stepping.tolerance"])
    assert whole(folder)[0] is not None


def test_a_folder_of_other_sources_or_of_something_else_is_refused(tmp_path):
    folder = DatasetFolder(tmp_path / "before")
    folder.path.mkdir()
    other = {**SPECIFICATION.plain, "source_sha256": "of before"}
    write_sealed(folder.specification, other)
    assert first_error(folder, SPECIFICATION).startswith("source_sha256 = ")
    (tmp_path / "thesis.txt").write_text("")
    assert "a new folder" in first_error(DatasetFolder(tmp_path), SPECIFICATION)
    assert "this is a file" in first_error(DatasetFolder(tmp_path / "thesis.txt"), SPECIFICATION)
    made_up(tmp_path / "data", SPECIFICATION)
    (tmp_path / "data" / "dataset.json").write_text("{")
    assert "not damaged" in first_error(DatasetFolder(tmp_path / "data"), SPECIFICATION)


def first_error(folder, specification):
    with pytest.raises(ParameterError) as caught:
        folder.check(specification)
    return str(caught.value)


def test_one_writes_the_whole_or_several_their_parts(tmp_path):
    folder = DatasetFolder(tmp_path)
    for parts in ([(1, 1)], [(1, 2), (2, 2)]):
        locks = [lock for part in parts for lock in folder.claim(*part)]
        for part in ((1, 1), (1, 2)):
            with pytest.raises(ParameterError, match="no other process"):
                folder.claim(*part)
        for lock in locks:
            lock.release()
    folder.claim(1, 1)[0].release()


def test_the_default_folder_is_named_after_what_determines_it():
    assert default_path(SPECIFICATION).name.startswith("latin_hypercube-draft-")
    assert default_path(SPECIFICATION) != default_path(small(25))
