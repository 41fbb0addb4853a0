"""Designs that are prepared together: one simulation whose inputs are columns, arrays (R), of which
the same formulas make one model as of a single robot.

What is refused, and whatever takes single numbers only, is left to be prepared alone.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from snapjump.arrays import Array, Flags
from snapjump.batch.thresholds import beam_of, critical_figures
from snapjump.composition import Simulation
from snapjump.declare.inputs import inputs_of, with_columns
from snapjump.engine.models import Models
from snapjump.scenes.frame_body import compression
from snapjump.scenes.jump_start import jump_model, least_end_rad, start_angle_rad
from snapjump.statics.threshold import Threshold
from snapjump.statics.threshold_curve import ThresholdCurve

FEWEST = 2  # an array of one number passes for a number here and there


class Together(NamedTuple):
    """Models of some designs, and the rows of these."""

    rows: NDArray[np.int64]
    models: Models


NONE = Together(np.zeros(0, dtype=np.int64), Models.of([]))


def prepare_together(
    base: Simulation, designs: Array, curve: ThresholdCurve | None, inputs: Sequence[str]
) -> Together:
    """Models of the designs (R, I) that nothing refuses; none where inputs, or members, take single
    numbers only."""
    if not take_arrays(base, inputs):
        return NONE
    rows = np.flatnonzero(in_range(base, designs, inputs))
    try:
        with np.errstate(all="ignore"):  # as of single numbers
            able, figures = beginnings(many(base, designs[rows], inputs), len(rows), curve)
            rows = rows[able]
            together = many(base, designs[rows], inputs)
            if len(rows) < FEWEST or not checked(base, together):
                return NONE
            model = jump_model(together, threshold_of(figures[:, able]))
            return Together(rows, Models.of_columns(model, len(rows)))
    except (TypeError, ValueError):
        return NONE  # says a check, or a plug-in's formula, that is about single numbers


def take_arrays(base: Simulation, inputs: Sequence[str]) -> bool:
    """Whether all that these inputs reach takes arrays; then their robots have the same scales, and
    frames of the same mesh."""
    known = inputs_of(base)
    members = base.frame.takes_arrays and base.friction.takes_arrays
    level, given = base.environment.slope_rad == 0.0, not isinstance(base.robot.mount_height, str)
    return members and level and not given and all(known[path].takes_arrays for path in inputs)


def in_range(base: Simulation, designs: Array, inputs: Sequence[str]) -> Flags:
    """Which designs (R, I) have all inputs in the ranges of their fields."""
    known = inputs_of(base)
    allowed = np.ones(len(designs), dtype=bool)
    for path, column in zip(inputs, designs.T, strict=True):
        allowed &= known[path].allowed.allows(column)
    return allowed


def many(base: Simulation, designs: Array, inputs: Sequence[str]) -> Simulation:
    """The simulations of designs (R, I) in their ranges as one, whose inputs are columns (R)."""
    columns = np.ascontiguousarray(designs.T)
    return with_columns(base, dict(zip(inputs, columns, strict=True)))


def threshold_of(figures: Any) -> Threshold:
    """Thresholds of critical angles and depths (2, R) as one."""
    return Threshold(figures[0], figures[1], np.nan)


def beginnings(
    together: Simulation, robots: int, curve: ThresholdCurve | None
) -> tuple[Flags, Array]:
    """Which of so many robots can begin a jump (R), and their critical figures (2, R)."""
    compressions = np.broadcast_to(compression(together), robots)
    figures = critical_figures(together, compressions, curve)
    start = start_angle_rad(together, threshold_of(figures))
    # Nothing is larger than the angle of an arch without a threshold, which is NaN.
    snaps = least_end_rad(together, threshold_of(figures), start) < together.drive.end_rad
    return snaps & together.environment.has_mass(together.robot), figures


def checked(base: Simulation, together: Simulation) -> bool:
    """Whether parts let each other pass, and beams are those of ``base``. Raises ParameterError, or
    whatever arrays raise in a check that is about single numbers."""
    for part in together.parts:
        part.check_with(together)
    return bool(beam_of(together) == beam_of(base))
