"""Hashes kept on disk: of the same bytes by the same rule, or none."""

import json

import pytest

from snapjump.files import kept_hashes as kept
from snapjump.files import tokens
from snapjump.files.kept_hashes import FILE, kept_hashes


@pytest.fixture
def source(tmp_path, monkeypatch):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "cache"))
    path = tmp_path / "a.py"
    path.write_text("a = 1\n")
    return path


def hashed(path):
    with kept_hashes() as file_hash:
        return file_hash(path)


def count_tokenised(monkeypatch):
    calls = []
    whole = tokens.content_hash
    monkeypatch.setattr(tokens, "content_hash", lambda *a: calls.append(a) or whole(*a))
    return calls


def test_the_same_bytes_are_tokenised_once(source, monkeypatch):
    calls = count_tokenised(monkeypatch)
    first = hashed(source)
    assert hashed(source) == first == tokens.token_hash("a = 1") and len(calls) == 1
    source.write_text("a = 2\n")
    assert hashed(source) != first and len(calls) == 2
    yaml = source.rename(source.with_suffix(".yaml"))
    assert hashed(yaml) == tokens.data_hash("a = 2") and len(calls) == 3


@pytest.mark.parametrize("damage", ["", "{", "[]", '{"rule": 1}', '{"rule": "x", "hashes": 3}'])
def test_a_damaged_file_counts_for_nothing(source, damage, monkeypatch):
    first = hashed(source)
    file = kept.cache_root() / FILE
    file.write_text(damage)
    assert hashed(source) == first
    assert list(json.loads(file.read_text())["hashes"].values()) == [first]


def test_hashes_of_another_rule_count_for_nothing(source, monkeypatch):
    first = hashed(source)
    file = kept.cache_root() / FILE
    file.write_text(file.read_text().replace(first, "0" * 64))
    assert hashed(source) == "0" * 64
    content = json.loads(file.read_text())
    file.write_text(json.dumps({**content, "rule": "another"}))
    assert hashed(source) == first


def test_there_are_not_ever_more(source, monkeypatch):
    monkeypatch.setattr(kept, "MOST", 3)
    for k in range(5):
        source.write_text(f"a = {k}\n")
        hashed(source)
    assert len(json.loads((kept.cache_root() / FILE).read_text())["hashes"]) == 2


def test_nothing_needs_to_be_kept(source, monkeypatch):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(source / "below a file"))
    assert hashed(source) == tokens.token_hash("a = 1")
