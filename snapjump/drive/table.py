"""Measured clamp angles: a table of times and angles, smoothly through every row."""

from dataclasses import field
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from scipy.interpolate import PchipInterpolator

from snapjump.arrays import Array
from snapjump.checks import ParameterError
from snapjump.drive.base import ClampAngles, DriveOptions, Programme
from snapjump.drive.parts.table_file import checked_rows, read_rows
from snapjump.number.dispatch import kernel
from snapjump.number.functions import where

CLOSE_RAD = 1e-6  # of delta_alpha and the mismatch of the first row
PIECE = 9  # numbers of a piece: its beginning, then both clamps' cubics from the constant on


@kernel
def piece_at(pieces: Any, time: Any, column: Any) -> Any:
    """A number of the piece that a time is in; lanes are in pieces of their own."""
    found = pieces[0, column] + 0.0 * time
    for k in range(1, pieces.shape[0]):
        found = where(time >= pieces[k, 0], pieces[k, column], found)
    return found


@kernel
def cubic_at(pieces: Any, time: Any, begun: Any, first: Any) -> Any:
    """An angle and its rate, by the coefficients from column ``first`` on; ``begun``: how long ago
    its piece began."""
    constant = piece_at(pieces, time, first)
    linear = piece_at(pieces, time, first + 1)
    square = piece_at(pieces, time, first + 2)
    cube = piece_at(pieces, time, first + 3)
    angle = ((cube * begun + square) * begun + linear) * begun + constant
    return angle, (3.0 * cube * begun + 2.0 * square) * begun + linear


class Table(DriveOptions):
    """Clamps that turn as a table says, which begins at rest and ends held.

    Between rows an angle goes by the monotone cubic of Fritsch and Carlson (PCHIP), which never
    overshoots. ``file``: a CSV file with the columns time_s, left_rad and right_rad; ``rows``: what
    is in it, which then counts, in hashes and checkpoints too, wherever the file may be.
    """

    file: str | None = field(default=None, metadata={"doc": "CSV: time_s, left_rad, right_rad"})
    rows: Any = field(default=None, metadata={"doc": "instead of the file"})

    @Programme.member
    class Law(NamedTuple):
        """Left angle at time 0 and at the end (rad), the largest rate (rad/T), mismatch at time 0,
        and the pieces (K, 9) by their beginnings (T)."""

        start: float
        end: float
        rate: float
        delta_alpha: float
        pieces: Any

        def angles(self, time: Any) -> Any:
            begun = time - piece_at(self.pieces, time, 0)
            left, left_rate = cubic_at(self.pieces, time, begun, 1)
            right, right_rate = cubic_at(self.pieces, time, begun, 5)
            return ClampAngles(left, right, left_rate, right_rate, 0.0, 0.0)

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.rows is not None:
            object.__setattr__(self, "rows", checked_rows("drive.rows", self.rows))
        elif self.file is not None:
            object.__setattr__(self, "rows", read_rows(self.file))

    def check_with(self, simulation: Any) -> None:
        if self.rows is None:
            read_rows(self.file)
        _, left, right = self.rows[0]
        lag = simulation.design.delta_alpha
        if np.any(np.abs(left - right - lag) > CLOSE_RAD):
            allowed = f"{left - right:.9g} rad, by which the clamps of this table differ at first"
            raise ParameterError("design.delta_alpha", lag, allowed)
        if getattr(simulation.sim, "start_fraction", 0.0) > 0.0:
            allowed = "0 with drive=table, which begins where its first row is"
            raise ParameterError("sim.start_fraction", simulation.sim.start_fraction, allowed)
        if simulation.backend.name == "cuda":
            raise ParameterError("backend", "cuda", "scalar or lanes with drive=table")

    @property
    def in_common(self) -> tuple[str, Any]:
        return "the table", self.rows

    @cached_property
    def pieces(self) -> Array:
        """Pieces (K, 9), in s and rad: one before and one after the table, in which clamps rest."""
        time_s, *angles = np.array(self.rows).T
        time_s = time_s - time_s[0]
        pieces = np.zeros((len(time_s), PIECE))
        pieces[:, 0] = time_s
        for first, values in zip((1, 5), angles, strict=True):
            cubic = PchipInterpolator(time_s, values).c[::-1]
            pieces[:-1, first : first + 4] = cubic.T
            pieces[-1, first] = values[-1]
        return pieces

    @property
    def rate_rad_s(self) -> float:
        """The largest, of both clamps and all rows."""
        return float(np.max(np.abs(self.pieces[:, [2, 6]])))

    @property
    def end_rad(self) -> float:
        return self.rows[-1][1]

    @property
    def delay_s(self) -> float:
        return float(self.pieces[-1, 0])

    def start_rad(self, usual: Any) -> float:
        return self.rows[0][1]

    def programme(self, simulation: Any, start: Any) -> Law:
        """The dimensionless programme."""
        time_s = simulation.robot.scales.time_s
        cubic = np.cumprod([1.0, time_s, time_s, time_s])
        pieces = self.pieces * np.concatenate([[1.0 / time_s], cubic, cubic])
        rate = self.rate_rad_s * time_s
        return self.Law(start, self.end_rad, rate, simulation.design.delta_alpha, pieces)

    def rest(self, simulation: Any, arch: Any) -> Any:
        lag, (_, left, right) = simulation.design.delta_alpha, self.rows[0]
        return arch.turn(arch.flat(lag), (0.0, -lag), (left, right))
