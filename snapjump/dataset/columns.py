"""The columns of a dataset: names, units, meanings; as numpy arrays, as Arrow, and as a hash."""

import hashlib
from collections.abc import Collection, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from snapjump.batch import Batch
from snapjump.batch.loads import OFFERED
from snapjump.declare.outputs import FLAG, INTEGER, NUMBER, WORD, Output
from snapjump.plan.parts.axes import Axis

# Arrays (R,) by column; a column that is left out has no values.
Rows = Mapping[str, NDArray[Any]]


class Column(NamedTuple):
    """``kind``: NUMBER (float64), INTEGER (int64), FLAG (bool), WORD (text).
    ``timing``: differs from run to run, and is left out of the hash of the content."""

    name: str
    unit: str
    meaning: str
    kind: str = NUMBER
    timing: bool = False


APEX = ("x_bar", "y_bar")
INDEX = Column("index", "", "number of the design in the plan", INTEGER)


def column_of(each: Output[Any]) -> Column:
    """The column of an output."""
    return Column(each.name, each.unit, each.meaning, each.kind, each.timing)


OUTPUTS = tuple(column_of(each) for each in Batch.declared())
TIMINGS = {column.name for column in OUTPUTS if column.timing}
JUDGED = (
    Column("graze_distance", "1", "change of a parameter that makes or breaks a contact"),
    Column("differentiable", "", "whether that is over 1e-5, and steps resolve sticking", FLAG),
)


def columns_of(axes: Sequence[Axis], outputs: Collection[str] = ()) -> tuple[Column, ...]:
    """The columns of a dataset of these axes, with these outputs beside those of all jumps."""
    return (
        INDEX,
        *(Column(axis.column, axis.unit or "1", axis.meaning) for axis in axes),
        *OUTPUTS,
        *(column_of(each) for each in OFFERED if each.name in outputs),
        *(
            Column(
                name,
                f"L/{axis.unit}" if axis.unit else "L",
                f"derivative of {apex} by {axis.slope}",
            )
            for apex in APEX
            for axis, name in zip(axes, slope_columns(apex, axes), strict=True)
        ),
        *JUDGED,
    )


def slope_columns(apex: str, axes: Sequence[Axis]) -> list[str]:
    """Columns of the derivatives of x_bar or y_bar."""
    return [f"d{apex}_d_{axis.slope}" for axis in axes]


def schema(columns: Sequence[Column]) -> pa.Schema:
    """The Arrow schema; unit and meaning are metadata of each field."""
    types = {
        NUMBER: pa.float64(),
        INTEGER: pa.int64(),
        FLAG: pa.bool_(),
        WORD: pa.dictionary(pa.int32(), pa.string()),
    }
    return pa.schema(
        pa.field(c.name, types[c.kind], metadata={"unit": c.unit, "meaning": c.meaning})
        for c in columns
    )


def table_of(columns: Sequence[Column], rows: Rows) -> pa.Table:
    """Rows as an Arrow table; what is missing or not finite is null."""
    count = len(rows["index"])
    arrays = []
    for column, field in zip(columns, schema(columns), strict=True):
        values = rows.get(column.name)
        if values is None:
            arrays.append(pa.nulls(count, field.type))
        elif column.kind == NUMBER:
            arrays.append(pa.array(values, field.type, mask=~np.isfinite(values)))
        elif column.kind == WORD:
            arrays.append(pa.array(values.tolist(), pa.string()).dictionary_encode())
        else:
            arrays.append(pa.array(values.tolist(), field.type))
    return pa.Table.from_arrays(arrays, schema=schema(columns))


def content_sha256(table: pa.Table) -> str:
    """A hash of every value but timings, whatever file and compression they lie in.

    Each column of the table counts with its name there and its values as little-endian bytes:
    numbers as float64, nulls as NaN; integers as int64, nulls as -1; flags as a byte, nulls as 2;
    words in UTF-8, each ended by a newline.
    """
    digest = hashlib.sha256()
    for field in table.schema:
        if field.name in TIMINGS:
            continue
        digest.update(f"{field.name}:{len(table)}\n".encode())
        digest.update(_canonical(table[field.name].combine_chunks()))
    return digest.hexdigest()


def _canonical(values: pa.Array) -> bytes:
    if pa.types.is_dictionary(values.type):
        words = np.array([f"{word}\n" for word in (*values.dictionary.to_pylist(), None)], object)
        return "".join(words[values.indices.fill_null(-1).to_numpy()]).encode()
    if pa.types.is_boolean(values.type):
        return bytes(values.cast(pa.uint8()).fill_null(2).to_numpy().tobytes())
    if pa.types.is_integer(values.type):
        return bytes(values.fill_null(-1).to_numpy().astype("<i8").tobytes())
    numbers = values.to_numpy(zero_copy_only=False).astype("<f8")
    numbers[np.isnan(numbers)] = np.nan
    return bytes(numbers.tobytes())
