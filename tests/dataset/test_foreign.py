"""Files of a dataset that somebody else sealed: one line, whatever they hold."""

import pytest
from refusals import refused
from small_datasets import made_up, small

from snapjump.checks import ParameterError
from snapjump.dataset.read import load_dataset
from snapjump.dataset.shard import read_entry
from snapjump.files.sealed import read_sealed, write_sealed

SPECIFICATION = small()


def test_a_sealed_file_of_something_else(tmp_path):
    for text in ("[" * 100_000, '{"a": NaN}', "{}", "3", "\0"):
        (tmp_path / "a.json").write_text(text)
        assert read_sealed(tmp_path / "a.json") is None


FOREIGN = [{}, {"shard": 1}, {"shard": 1, "rows": "8"}, {"statuses": [1]}, {"statuses": {"ok": []}}]


@pytest.mark.parametrize("change", FOREIGN)
def test_an_entry_that_somebody_sealed_is_damaged(tmp_path, change):
    folder = made_up(tmp_path, SPECIFICATION)
    entry = read_sealed(folder.entry(1)) if "statuses" in change else {}
    write_sealed(folder.entry(1), {**entry, **change})
    assert read_entry(folder, 1, SPECIFICATION.sha256) == (None, "_shard-00001.json is damaged")
    with refused("dataset.path"):
        load_dataset(tmp_path)


def without(key):
    return lambda content: content.pop(key)


def with_value(key, value):
    return lambda content: content.update({key: value})


CHANGES = [
    *(without(key) for key in ("complete", "specification", "shards", "rows", "statuses")),
    *(with_value("specification", value) for value in (None, [], {}, {"configuration": []})),
    *(with_value("shards", value) for value in (None, 3, [1], [{}], [{"content_sha256": []}])),
    with_value("rows", 10**9), with_value("statuses", {"ok": "many"}), with_value("statuses", []),
]  # fmt: skip


@pytest.mark.parametrize("change", CHANGES)
def test_a_manifest_that_somebody_sealed_is_refused(tmp_path, change):
    folder = made_up(tmp_path, SPECIFICATION)
    manifest = read_sealed(folder.manifest)
    change(manifest)
    write_sealed(folder.manifest, manifest)
    with refused("dataset.path") as caught:
        load_dataset(tmp_path)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("content", [{}, {"inputs": 3}, {"plan": None, "configuration": []}])
def test_a_specification_that_somebody_sealed_is_refused(tmp_path, content):
    folder = made_up(tmp_path, SPECIFICATION)
    write_sealed(folder.specification, content)
    with pytest.raises(ParameterError) as caught:
        folder.check(SPECIFICATION)
    assert "\n" not in str(caught.value)
