import json
import math

import numpy as np

from snapjump.files.json_file import finite, read_json, write_json


def test_nan_becomes_null_and_is_named(tmp_path):
    values = {"a": math.nan, "b": {"c": [1.0, -math.inf]}, "d": np.float64(math.nan), "e": 2}
    assert write_json(tmp_path / "r.json", values) == ["a", "b.c.1", "d"]
    text = (tmp_path / "r.json").read_text()
    assert "NaN" not in text and "Infinity" not in text
    assert json.loads(text) == {"a": None, "b": {"c": [1.0, None]}, "d": None, "e": 2}


def test_numpy_scalars_become_plain_numbers():
    clean, bad = finite({"a": np.float64(0.5), "b": np.int64(3), "c": np.bool_(True)})
    assert clean == {"a": 0.5, "b": 3, "c": True} and not bad
    assert [type(value) for value in clean.values()] == [float, int, bool]


def test_what_cannot_be_read_is_none(tmp_path):
    (tmp_path / "half.json").write_text('{"status": "o')
    assert read_json(tmp_path / "half.json") is None
    assert read_json(tmp_path / "missing.json") is None
