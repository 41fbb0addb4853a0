"""Verdicts: errors, observed orders and limit of one observable on one ladder."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from snapjump.arrays import Array
from snapjump.run.studies.base import Done, Row

from ..errors import scale_of_x
from ..order import Limit, fitted_order, richardson
from .ladders import Ladder

# Errors this close to the reference's own uncertainty say nothing about an order.
CLEAR = 3.0


@dataclass(frozen=True)
class Verdict:
    """One observable on one ladder; ``sizes`` and ``errors`` (%) by level, NaN for failures.

    ``doubt``: how far the reference itself is uncertain (%); ``reference_name``: its cell, empty
    where the ladder's own limit serves.
    """

    ladder: Ladder
    observable: str
    sizes: Array
    errors: Array
    fitted: float
    limit: Limit
    reference: float
    reference_name: str
    doubt: float

    def row(self) -> Row:
        return {
            "refined": self.ladder.name,
            "observable": self.observable,
            "error_coarsest_percent": float(self.errors[0]),
            "error_finest_percent": float(self.errors[-1]),
            "order_fitted": self.fitted,
            "order_last_three": self.limit.order,
            "limit": self.limit.value,
            "limit_uncertainty": self.limit.uncertainty,
            "asymptotic": "yes" if self.limit.asymptotic else "no",
            "reference": self.reference,
            "reference_uncertainty_percent": self.doubt,
        }


def judged(ladder: Ladder, done: Mapping[str, Done], key: str) -> Verdict:
    """The verdict on one observable."""
    cells = [done[ladder.cell(value)] for value in ladder.levels]
    values = np.array([value_of(cell, key) for cell in cells])
    sizes = sizes_of(ladder, cells)
    good = np.isfinite(values) & np.isfinite(sizes)
    limit = richardson(list(sizes[good]), list(values[good])) if good.any() else NO_LIMIT
    known = {name: value_of(done[name], key) for name in ladder.references}
    known = {name: value for name, value in known.items() if np.isfinite(value)}
    name = next(iter(known), "")
    reference = known[name] if name else limit.value
    others = [value for other, value in known.items() if other != name]
    finest = int(np.flatnonzero(good)[-1]) if good.any() else -1
    scale = scale_of(done[name] if name else cells[finest], key, reference)
    doubt = 100.0 * abs(others[0] - reference) / scale if others else np.nan
    errors = 100.0 * np.abs(values - reference) / scale
    if not name and not limit.asymptotic:
        errors[finest] = np.nan  # the finest level is the reference itself
    clear = np.where(errors > CLEAR * np.nan_to_num(doubt), errors, np.nan)
    fitted = fitted_order(list(sizes), list(clear))
    return Verdict(ladder, key, sizes, errors, fitted, limit, reference, name, doubt)


NO_LIMIT = Limit(np.nan, np.nan, np.nan, False)


def sizes_of(ladder: Ladder, cells: list[Done]) -> Array:
    """Sizes of the levels, which tend to zero."""
    if ladder.size == "steps":
        return 1.0 / np.array([value_of(cell, "steps") for cell in cells])
    values = np.array(list(ladder.levels))
    return 1.0 / values if ladder.size == "inverse" else values


def value_of(cell: Done, key: str) -> float:
    """A number of a jump that ended well, else NaN."""
    if not cell.rows or cell.rows[0]["status"] != "ok" or cell.rows[0][key] is None:
        return float("nan")
    return float(cell.rows[0][key])


def scale_of(cell: Done, key: str, reference: float) -> float:
    """The scale that errors of an observable are relative to."""
    if key == "x_bar":
        return float(scale_of_x(reference, value_of(cell, "y_bar")))
    return abs(reference)
