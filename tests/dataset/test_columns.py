"""What determines a dataset; its columns, with units, nulls for what is missing and a hash."""

import numpy as np
import pyarrow as pa
import pytest
from refusals import refused
from small_datasets import CONFIG, WIDE_STICK, made_up_rows, small

from snapjump.batch import Batch
from snapjump.checks import ParameterError
from snapjump.dataset.columns import columns_of, content_sha256, schema, table_of
from snapjump.dataset.specification import first_difference, restored, specify
from snapjump.declare.members import member_names

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
        suffix = {"_s": "s", "_m_s": "m/s", "_rad": "rad", "_percent": "%", "_rad_s": "rad/s"}
        expected = [unit for end, unit in suffix.items() if name.endswith(end)]
        if expected:
            assert units[name] == expected[-1], name
        if name.endswith("_bar") and "_d_" not in name and name != "mass_bar":
            assert units[name] == "L", name
    assert units["dx_bar_d_delta_alpha"] == "L/rad" and units["dy_bar_d_mu"] == "L"


def test_every_output_of_a_jump_is_a_column():
    assert {output.name for output in Batch.declared()} < set(NAMES)


def test_outputs_that_cost_time_are_columns_if_they_are_asked_for():
    asked = {column.name for column in columns_of(SPECIFICATION.axes, ["max_strain"])}
    assert asked == {*NAMES, "max_strain"}


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


PLAN = {"name": "sobol", "count": 8}


def test_a_plain_specification_tells_everything_again():
    for integrator in member_names("integrator"):
        damping = {"name": "none"} if integrator == "central_difference" else {}
        changes = {"integrator": {"name": integrator}, "damping": damping}
        try:
            specification = small(**changes)
        except ParameterError:  # the tableaux are completed by their YAML files
            continue
        again = restored(specification.plain, CONFIG["backend"])
        assert again.plain == specification.plain
        assert again.simulation == specification.simulation


def test_what_changes_numbers_changes_the_specification():
    base = small()
    changed = [
        small(25),
        small(shard_size=9),
        small(stepping={"name": "adaptive", "tolerance": 2e-5}),
        small(robot={"length_m": 0.021}),
        small(plan={"name": "latin_hypercube", "count": 24, "seed": 1}),
    ]
    assert len({one.sha256 for one in [base, *changed]}) == 6
    # Lanes, design and environment do not.
    others = [small(backend=one) for one in ({"name": "scalar"}, {"name": "lanes", "width": 4})]
    others.append(small(design={"epsilon": 0.3}, environment={"mu": 0.5}))
    assert {one.sha256 for one in others} == {base.sha256}
    assert [a.slope for a in base.axes] == ["delta_alpha", "epsilon", "mass_bar", "mu"]


@pytest.mark.parametrize(
    ("changes", "key"),
    [
        ({"sim": {"name": "snap"}}, "sim"),
        ({"plan": {"name": "dice"}}, "plan"),
        ({"plan": {}}, "plan"),
        ({"plan": 3}, "plan"),
        ({"plan": {**PLAN, "points": 3}}, "plan.points"),
        ({"plan": {**PLAN, "mass_bar": [0.001, 2.0]}}, "plan.mass_bar"),
        ({"robot": {"gravity_m_s2": 0.0}}, "robot.gravity_m_s2"),
        ({"stepping": {"name": "fixed", "step_s": -1.0}}, "stepping.step_s"),
    ],
)
def test_bad_input(changes, key):
    with refused(key):
        small(**changes)


def test_outputs_that_cost_time_count_in_the_specification_if_they_are_asked_for():
    plain, asked = small(), small(outputs=["clamp_work_J", "max_strain"])
    assert "outputs" not in plain.plain and plain.outputs == []
    assert asked.sha256 != plain.sha256 == small(outputs=[]).sha256
    assert asked.sha256 == small(outputs=("max_strain", "clamp_work_J")).sha256
    again = restored(asked.plain, CONFIG["backend"])
    assert again.plain == asked.plain and again.outputs == ["max_strain", "clamp_work_J"]


@pytest.mark.parametrize("outputs", ["max_strain", 3, ["x_bar"], ["damping_ratio_1"], ["spam"]])
def test_outputs_that_datasets_do_not_have(outputs):
    with refused("dataset.outputs", "max_strain"):
        small(outputs=outputs)


def test_no_outputs_that_cost_time_with_sensitivities():
    with refused("dataset.outputs", "sensitivities"):
        small(outputs=["max_strain"], sensitivities=True, friction=WIDE_STICK)


@pytest.mark.parametrize("size", [0, -1, 1.5, True, 1_000_001])
def test_shard_sizes(size):
    with pytest.raises(ParameterError, match=r"dataset\.shard_size"):
        specify({**CONFIG, "plan": PLAN}, size)


def test_shards_are_the_whole_plan():
    specification = small(20, 8)
    stretches = [specification.stretch(number) for number in range(specification.shards)]
    assert stretches == [(0, 8), (8, 16), (16, 20)]


def test_the_first_difference_has_its_key_and_both_values():
    assert first_difference({"a": {"b": 1}}, {"a": {"b": 1.0}}) is None
    assert first_difference({"a": {"b": 1}, "c": 2}, {"a": {"b": 3}}) == ("a.b", 1, 3)
    assert first_difference({"a": 1}, {"a": 1, "d": 2}) == ("d", None, 2)
