"""What the apex of a jump moves by where its inputs are off, one by one and together."""

import csv
import io
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from snapjump.arrays import Array
from snapjump.checks import is_finite_number

LESS, MORE = "less", "more"
MOST_TOLD = 3
HEADER = (
    *("input", "nominal", "tolerance", "side", "value"),
    *("change_x_bar", "change_y_bar", "change_x_m", "change_y_m", "why_not"),
)


class Side(NamedTuple):
    """An input at one end of its tolerance, or another member: ``side``, less, more or the member's
    name; ``value``; ``change`` (2,) of the apex's x and y, in L, NaN where there is no apex;
    ``why_not``: the status, or the line that refuses it."""

    side: str
    value: float | str
    change: Array
    why_not: str = ""


@dataclass(frozen=True)
class Influence:
    """What an input does, by its path, or the choice of a family's member, by its name."""

    name: str
    nominal: float | str
    tolerance: str
    sides: tuple[Side, ...]

    def __str__(self) -> str:
        x, y = self.largest.tolist()
        return f"{self.name} ({self.tolerance}) x {x:.2g} L, y {y:.2g} L"

    @property
    def largest(self) -> Array:
        """The larger change (2,) of x and of y either way, in L; NaN where no side has an apex."""
        sizes = np.abs([one.change for one in self.sides])
        known = np.where(np.isnan(sizes), -1.0, sizes).max(axis=0)
        return np.where(known < 0.0, np.nan, known)

    @property
    def half_distance(self) -> float:
        """Half the distance (L) between the apexes either way; NaN where one of them is not."""
        first, last = (one.change for one in (self.sides[0], self.sides[-1]))
        return 0.5 * float(np.hypot(*(last - first)))


@dataclass(frozen=True, repr=False)
class ModelUncertainty:
    """How far an apex may be off by its model, beside what it is off by its numbers.

    ``apex`` (2,), in L; ``numerical`` (2,): its estimated numerical error, in L, NaN where that is
    not known; ``influences``: of the inputs, in the order of the table; ``left_out``: rows of the
    table that are none of the robot, and why.
    """

    apex: Array
    numerical: Array
    influences: tuple[Influence, ...]
    left_out: dict[str, str]
    length_m: float

    @property
    def spread(self) -> Array:
        """Of x and y (2,), in L: the root of the summed squares of the larger sides; NaN where no
        input's is known."""
        known = np.array([one.largest for one in self.by_size])
        if not len(known):
            return np.full(2, np.nan)
        return np.sqrt(np.sum(known * known, axis=0))

    @property
    def by_size(self) -> list[Influence]:
        """Influences that are known, the largest first."""
        known = [one for one in self.influences if np.isfinite(one.largest).all()]
        return sorted(known, key=lambda one: -float(np.hypot(*one.largest)))

    @property
    def without_apex(self) -> dict[str, str]:
        """Sides that have no apex, ``<input> <side>``, and why: the spread is without them."""
        return {
            f"{one.name} {side.side}": side.why_not
            for one in self.influences
            for side in one.sides
            if side.why_not
        }

    def rows(self) -> list[dict[str, Any]]:
        """A row for each side of each input, lengths in L and m."""
        return [
            dict(
                zip(
                    HEADER,
                    (one.name, one.nominal, one.tolerance, side.side, side.value,
                     *side.change.tolist(), *(self.length_m * side.change).tolist(), side.why_not),
                    strict=True,
                )
            )
            for one in self.influences
            for side in one.sides
        ]  # fmt: skip

    def csv(self) -> str:
        """The same as CSV; what is not known is empty."""
        text = io.StringIO()
        table = csv.DictWriter(text, HEADER, lineterminator="\n")
        table.writeheader()
        for row in self.rows():
            table.writerow({key: known(value) for key, value in row.items()})
        return text.getvalue()

    def summary(self) -> dict[str, Any]:
        """Flat figures, keys with their unit; None where there is no number."""
        spread, largest = self.spread.tolist(), self.by_size
        found = {
            **pair("model_spread", "bar", spread),
            **pair("model_spread", "m", [self.length_m * each for each in spread]),
            **pair("numerical_error", "bar", self.numerical.tolist()),
            "model_spread_largest": largest[0].name if largest else None,
            "model_spread_most": "; ".join(map(str, largest[:MOST_TOLD])),
        }
        for one in self.influences:
            name = one.name.replace(".", "_")
            for side in one.sides:
                found |= pair(f"model_{name}_{side.side}", "bar", side.change.tolist())
        missing = {**self.left_out, **self.without_apex}
        found["model_left_out"] = "; ".join(f"{name}: {why}" for name, why in missing.items())
        return found

    def __repr__(self) -> str:
        (x, y), (off_x, off_y) = self.apex.tolist(), self.spread.tolist()
        most = f", {self.by_size[0].name} most" if self.by_size else ""
        return f"<apex x {x:.4g} +- {off_x:.2g} L, y {y:.4g} +- {off_y:.2g} L by the model{most}>"


def pair(name: str, unit: str, values: list[float]) -> dict[str, Any]:
    """Numbers of x and y by their keys."""
    named = zip("xy", values, strict=True)
    return {f"{name}_{axis}_{unit}": v if is_finite_number(v) else None for axis, v in named}


def known(value: Any) -> Any:
    """A value of a table; empty for a number that there is not."""
    return "" if isinstance(value, float) and not is_finite_number(value) else value
