"""More right-hand sides for a system that has been eliminated: four of them, lane by lane.

The factors of all lanes lie side by side in memory, so that the lanes are solved together, row by
row: what one lane has fetched, the others find at hand.
"""

from typing import Any

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.linear_solver.banded import solve_square
from snapjump.number.dispatch import routine
from snapjump.number.functions import fma
from snapjump.number.lane import view_numbers

FOUR = (0, 0, 0, 0)


@routine
def solve_more_sides(system: Any, sides: Any, frame_sides: Any, chosen: Any, count: int) -> None:
    """Replace the right-hand sides of the first ``count`` lanes in ``chosen`` by solutions.

    system: memory (..., W) of an eliminated :class:`~snapjump.engine.work.System` with a border of
    three columns; sides (W, B, 4) of the nodes, frame_sides (W, F, 4) of the frame.
    """
    band = system.padded_band
    border = system.padded_border
    rows = sides.shape[1]
    every = view_numbers(sides, FOUR)
    frames = view_numbers(frame_sides, FOUR)
    for row in range(rows):
        j = row + HALF_BANDWIDTH
        reach = min(row, HALF_BANDWIDTH)
        for c in range(count):
            lane = chosen[c]
            value = every[lane, row]
            for k in range(reach, 0, -1):
                factor = band[j - k, k, lane] * band[j - k, 0, lane]
                value = fma(-factor, every[lane, row - k], value)
            every[lane, row] = value
            scaled = band[j, 0, lane] * value
            for m in range(3):
                frames[lane, m] = fma(-border[j, m, lane], scaled, frames[lane, m])
    for c in range(count):
        lane = chosen[c]
        solve_square(system.square[:, :, lane], frames[lane])
    for row in range(rows - 1, -1, -1):
        j = row + HALF_BANDWIDTH
        reach = min(rows - 1 - row, HALF_BANDWIDTH)
        for c in range(count):
            lane = chosen[c]
            value = every[lane, row]
            for m in range(3):
                value = fma(-border[j, m, lane], frames[lane, m], value)
            for k in range(reach, 0, -1):
                value = fma(-band[j, k, lane], every[lane, row + k], value)
            every[lane, row] = value * band[j, 0, lane]
