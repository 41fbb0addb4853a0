"""The columns of a dataset: names, units, meanings; as numpy arrays, as Arrow, and as a hash."""

import hashlib
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.batch import Batch
from snapjump.declare.outputs import FLAG, INTEGER, NUMBER, WORD

if TYPE_CHECKING:
    import pyarrow as pa

# Arrays (R,) by column; a column that is left out has no values.
Rows = Mapping[str, NDArray[Any]]


class Column(NamedTuple):
    """``kind``: NUMBER (float64), INTEGER (int64), FLAG (bool), WORD (text).

    ``timing``: differs from run to run, and is left out of the hash of the content.
    """

    name: str
    unit: str
    meaning: str
    kind: str = NUMBER
    timing: bool = False


OUTPUTS = Batch.declared()
INPUTS = {"delta_alpha": "rad", "epsilon": "", "mass_bar": "", "mu": ""}
COLUMNS = (
    Column("index", "", "number of the design in the plan", INTEGER),
    Column("delta_alpha_rad", "rad", "lag of the right clamp"),
    Column("epsilon", "1", "pre-compression"),
    Column("mass_bar", "1", "m g L^2/EI of the whole robot"),
    Column("mu", "1", "friction coefficient"),
    *(Column(each.name, each.unit, each.meaning, each.kind, each.timing) for each in OUTPUTS),
    *(
        Column(f"d{apex}_d_{name}", f"L/{unit}" if unit else "L", f"derivative of {apex} by {name}")
        for apex in ("x_bar", "y_bar")
        for name, unit in INPUTS.items()
    ),
    Column("graze_distance", "1", "change of a parameter that makes or breaks a contact"),
    Column("differentiable", "", "whether that is more than 1e-5: no contact is grazed", FLAG),
)
NAMES = tuple(column.name for column in COLUMNS)
TIMINGS = {column.name for column in COLUMNS if column.timing}


def schema() -> "pa.Schema":
    """The Arrow schema; unit and meaning are metadata of each field."""
    import pyarrow as pa

    types = {
        NUMBER: pa.float64(),
        INTEGER: pa.int64(),
        FLAG: pa.bool_(),
        WORD: pa.dictionary(pa.int32(), pa.string()),
    }
    return pa.schema(
        pa.field(c.name, types[c.kind], metadata={"unit": c.unit, "meaning": c.meaning})
        for c in COLUMNS
    )


def table_of(rows: Rows) -> "pa.Table":
    """Rows as an Arrow table; what is missing or not finite is null."""
    import pyarrow as pa

    count = len(rows["index"])
    arrays = []
    for column, field in zip(COLUMNS, schema(), strict=True):
        values = rows.get(column.name)
        if values is None:
            arrays.append(pa.nulls(count, field.type))
        elif column.kind == NUMBER:
            arrays.append(pa.array(values, field.type, mask=~np.isfinite(values)))
        elif column.kind == WORD:
            arrays.append(pa.array(values.tolist(), pa.string()).dictionary_encode())
        else:
            arrays.append(pa.array(values, field.type))
    return pa.Table.from_arrays(arrays, schema=schema())


def content_sha256(table: "pa.Table") -> str:
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


def _canonical(values: "pa.Array") -> bytes:
    import pyarrow as pa

    if pa.types.is_dictionary(values.type):
        return "".join(f"{word}\n" for word in values.to_pylist()).encode()
    if pa.types.is_boolean(values.type):
        return bytes({None: 2}.get(flag, int(bool(flag))) for flag in values.to_pylist())
    if pa.types.is_integer(values.type):
        return bytes(values.fill_null(-1).to_numpy().astype("<i8").tobytes())
    numbers = values.to_numpy(zero_copy_only=False).astype("<f8")
    numbers[np.isnan(numbers)] = np.nan
    return bytes(numbers.tobytes())
