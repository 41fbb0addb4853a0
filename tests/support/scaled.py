"""Simulations and outputs at other scales: every number with a dimension, by its declared unit."""

from dataclasses import fields, replace
from typing import Any, NamedTuple

from snapjump.composition import Simulation
from snapjump.declare.families import FAMILIES
from snapjump.declare.fields import Number
from snapjump.declare.outputs import NUMBER, Outputs
from snapjump.simulation import PLAIN

# Powers of length, time and mass; a unit that is missing is to be added.
DIMENSIONLESS = ("", "1", "%", "rad", "L", "EI/L", "EI/L^2", "GiB")
POWERS = dict.fromkeys(DIMENSIONLESS, (0, 0, 0)) | {
    "m": (1, 0, 0), "s": (0, 1, 0), "kg": (0, 0, 1), "m/s": (1, -1, 0), "m/s^2": (1, -2, 0),
    "1/s": (0, -1, 0), "rad/s": (0, -1, 0), "N": (1, -2, 1), "N/m": (0, -2, 1),
    "Pa": (-1, -2, 1), "kg/m^3": (-3, 0, 1), "kg m^2": (2, 0, 1), "N m": (2, -2, 1),
    "m^2": (2, 0, 0), "J": (2, -2, 1), "W": (2, -3, 1), "N s": (1, -1, 1),
}  # fmt: skip


class Factors(NamedTuple):
    """What units of length, time and mass are multiplied by."""

    length: float
    time: float
    mass: float

    def of(self, unit: str) -> float:
        """What a number of a unit is multiplied by. Raises KeyError for a unit without powers."""
        length, time, mass = POWERS[unit]
        return float(self.length**length * self.time**time * self.mass**mass)


def dimensional(part: Any) -> dict[str, str]:
    """Units of a part's numbers that have a dimension, by field."""
    allowed = {declared.name: declared.metadata.get("allowed") for declared in fields(part)}
    units = {name: one.unit for name, one in allowed.items() if isinstance(one, Number)}
    return {name: unit for name, unit in units.items() if any(POWERS[unit])}


def scaled_part(part: Any, factors: Factors) -> Any:
    """A part whose numbers are those of a world of other scales; words, and what is not given,
    stay."""
    return part.changed(
        **{
            name: getattr(part, name) * factors.of(unit)
            for name, unit in dimensional(part).items()
            if isinstance(getattr(part, name), float)
        }
    )


def scaled(simulation: Simulation, factors: Factors) -> Simulation:
    """The simulation with all its dimensionless groups as they are, at other scales."""
    names = (*PLAIN, *FAMILIES)
    parts = {name: scaled_part(getattr(simulation, name), factors) for name in names}
    return replace(simulation, **parts)


def scaled_row(kind: type[Outputs], row: dict[str, Any], factors: Factors) -> dict[str, Any]:
    """All outputs but times of the computation, scaled as numbers of their units are."""
    return {
        each.name: row[each.name] * factors.of(each.unit) if each.kind == NUMBER else row[each.name]
        for each in kind.declared()
        if not each.timing
    }
