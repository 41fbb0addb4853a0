"""Columns: units in the schema, nulls for what is missing, and a hash of the content alone."""

import numpy as np
import pyarrow as pa
import pytest
from small_datasets import made_up_rows, small

from snapjump.batch import Batch
from snapjump.dataset.columns import columns_of, content_sha256, schema, table_of

SPECIFICATION = small()
COLUMNS = columns_of(SPECIFICATION.axes)
NAMES = [column.name for column in COLUMNS]


def rows():
    return dict(made_up_rows(SPECIFICATION, 0))


def test_every_column_has_its_unit_and_meaning_in_the_schema():
    for field in schema(COLUMNS):
        assert field.metadata[b"meaning"]
        assert b"unit" in field.metadata
    units = {field.name: field.metadata[b"unit"].decode() for field in schema(COLUMNS)}
    for name in NAMES:
        suffix = {"_s": "s", "_m_s": "m/s", "_rad": "rad", "_percent": "%"}
        expected = [unit for end, unit in suffix.items() if name.endswith(end)]
        if expected:
            assert units[name] == expected[-1], name
        if name.endswith("_bar") and "_d_" not in name and name != "mass_bar":
            assert units[name] == "L", name
    assert units["dx_bar_d_delta_alpha"] == "L/rad" and units["dy_bar_d_mu"] == "L"


def test_every_output_of_a_jump_is_a_column():
    assert {output.name for output in Batch.declared()} < set(NAMES)


def test_what_is_not_finite_or_left_out_is_null():
    given = rows()
    given["x_bar"] = np.array([np.nan, np.inf, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0])
    del given["differentiable"], given["dx_bar_d_mu"]
    table = table_of(COLUMNS, given)
    assert table.schema.equals(schema(COLUMNS))
    assert table["x_bar"].null_count == 2
    assert table["differentiable"].null_count == table["dx_bar_d_mu"].null_count == 8
    assert pa.types.is_dictionary(table["status"].type)


@pytest.mark.parametrize("column", COLUMNS, ids=lambda column: column.name)
def test_the_hash_tells_any_change_but_that_of_a_time(column):
    given = rows()
    before = content_sha256(table_of(COLUMNS, given))
    values = given[column.name].copy()
    values[2] = {"word": "no_jump", "flag": not values[2]}.get(column.kind, 12345)
    after = content_sha256(table_of(COLUMNS, given | {column.name: values}))
    assert (after == before) is column.timing
    if column.kind != "word":
        others = {k: v for k, v in given.items() if k != column.name}
        without = content_sha256(table_of(COLUMNS, others)) if column != COLUMNS[0] else ""
        assert (without == before) is column.timing


def test_the_hash_does_not_depend_on_how_words_are_encoded():
    table = table_of(COLUMNS, rows())
    words = pa.array(table["status"].to_pylist()[::-1]).dictionary_encode()
    other = table.set_column(
        NAMES.index("status"), "status", words.take(pa.array(range(len(table))[::-1]))
    )
    assert content_sha256(other) == content_sha256(table)
