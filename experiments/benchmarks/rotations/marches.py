"""Snaps of arches of which one clamp turns slowly: how far behind the fold the midpoint crosses."""

import math
from collections.abc import Mapping
from typing import Any

from snapjump.drive.smooth_start import SmoothStart
from snapjump.run.studies.base import Row
from snapjump.statics.arch import StaticArch

from ...compositions import composed
from ..delay.marches import AFTER, LATEST, RISE
from ..held_march import crossing_of
from ..symmetries.angles import one_end

END = 1.5
BEGIN = 0.9  # of the fold's angle: from there on the arch, at rest, is turned


def one_end_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each rate (over sqrt(epsilon), 1/T): angles of the fold and of the snap over
    sqrt(epsilon), and the delay between them. ``prefactor``, ``exponent``: of the delay that is
    expected."""
    made = composed(inputs["groups"])
    epsilon = made.design.epsilon
    root = math.sqrt(epsilon)
    fold = one_end(made, epsilon)
    arch = StaticArch(made.robot, made.discretization, epsilon)
    state = arch.turn(arch.flat(), (0.0, 0.0), (BEGIN * fold, 0.0))
    rows = []
    for rate in inputs["rates"]:
        expected = inputs["prefactor"] * rate ** inputs["exponent"]
        # The right clamp is flat when the left one is there, and stays so.
        clamp = SmoothStart.Law(BEGIN * fold, END, rate * root, BEGIN * fold, 0.0, RISE)
        way = (1.0 - BEGIN) * fold / root + LATEST * expected
        status, crossing = crossing_of(made, clamp, state, way / rate + RISE + AFTER)
        snap = float(clamp.angles(crossing).left) / root
        rows.append(
            {
                "status": status,
                "rate": rate,
                "fold": fold / root,
                "snap": snap,
                "delay": snap - fold / root,
            }
        )
    return rows
