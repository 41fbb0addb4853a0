"""Multiple right-hand sides of a system that has been eliminated: four of them, lane by lane.

The factors of all lanes lie side by side in memory, so that the lanes are solved together, node by
node: what one lane has fetched, the others find at hand. On the way down a right-hand side is kept
divided by its pivot, which leaves the factors as they are stored.
"""

from typing import Any

from snapjump.discretization.base import HALF_BANDWIDTH
from snapjump.linear_solver.schur import solve_block
from snapjump.number.array import uncounted
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import fma
from snapjump.number.lane import view_numbers

FOUR = (0, 0, 0, 0)


@kernel
def take_from_frame(border: Any, j: Any, lane: Any, over_pivot: Any, frame: Any) -> None:
    """Take a row's share of the frame's right-hand sides from them."""
    frame[0] = fma(-border[j, 0, lane], over_pivot, frame[0])
    frame[1] = fma(-border[j, 1, lane], over_pivot, frame[1])
    frame[2] = fma(-border[j, 2, lane], over_pivot, frame[2])


@kernel
def frame_share(border: Any, j: Any, lane: Any, frame: Any) -> Any:
    """Contribution of the frame's solution to a row."""
    share = border[j, 0, lane] * frame[0]
    share = fma(border[j, 1, lane], frame[1], share)
    return fma(border[j, 2, lane], frame[2], share)


@routine
def reduce_nodes(band: Any, border: Any, every: Any, frames: Any, chosen: Any, count: int) -> None:
    """Bring right-hand sides (W, B + 10, 4) up to date, over pivots; nodes of two coordinates."""
    for i in range(HALF_BANDWIDTH, every.shape[1] - HALF_BANDWIDTH, 2):
        j = i + 1
        for c in range(count):
            lane = chosen[c]
            sides = every[lane]
            far_x = sides[i - 4]
            far_y = sides[i - 3]
            last_x = sides[i - 2]
            last_y = sides[i - 1]
            x = fma(-band[i - 4, 4, lane], far_x, sides[i])
            x = fma(-band[i - 3, 3, lane], far_y, x)
            x = fma(-band[i - 2, 2, lane], last_x, x)
            x = fma(-band[i - 1, 1, lane], last_y, x) * band[i, 0, lane]
            y = fma(-band[i - 4, 5, lane], far_x, sides[j])
            y = fma(-band[i - 3, 4, lane], far_y, y)
            y = fma(-band[i - 2, 3, lane], last_x, y)
            y = fma(-band[i - 1, 2, lane], last_y, y)
            y = fma(-band[i, 1, lane], x, y) * band[j, 0, lane]
            sides[i] = x
            sides[j] = y
            take_from_frame(border, i, lane, x, frames[lane])
            take_from_frame(border, j, lane, y, frames[lane])


@routine
def return_nodes(band: Any, border: Any, every: Any, frames: Any, chosen: Any, count: int) -> None:
    """Turn what :func:`reduce_nodes` left, and the frame's solutions, into those of the nodes."""
    for i in range(every.shape[1] - HALF_BANDWIDTH - 2, HALF_BANDWIDTH - 1, -2):
        j = i + 1
        for c in range(count):
            lane = chosen[c]
            sides = every[lane]
            next_x = sides[i + 2]
            next_y = sides[i + 3]
            far_x = sides[i + 4]
            far_y = sides[i + 5]
            y = fma(band[j, 4, lane], far_y, frame_share(border, j, lane, frames[lane]))
            y = fma(band[j, 3, lane], far_x, y)
            y = fma(band[j, 2, lane], next_y, y)
            y = fma(band[j, 1, lane], next_x, y)
            x = fma(band[i, 5, lane], far_y, frame_share(border, i, lane, frames[lane]))
            x = fma(band[i, 4, lane], far_x, x)
            x = fma(band[i, 3, lane], next_y, x)
            x = fma(band[i, 2, lane], next_x, x)
            y = fma(-band[j, 0, lane], y, sides[j])
            x = fma(band[i, 1, lane], y, x)
            sides[j] = y
            sides[i] = fma(-band[i, 0, lane], x, sides[i])


@routine
def reduce_rows(band: Any, border: Any, every: Any, frames: Any, chosen: Any, count: int) -> None:
    """:func:`reduce_nodes` for nodes of any coordinates, row by row."""
    for j in range(HALF_BANDWIDTH, every.shape[1] - HALF_BANDWIDTH):
        for c in range(count):
            lane = chosen[c]
            sides = every[lane]
            value = sides[j]
            for k in range(HALF_BANDWIDTH, 0, -1):
                value = fma(-band[j - k, k, lane], sides[j - k], value)
            value = value * band[j, 0, lane]
            sides[j] = value
            take_from_frame(border, j, lane, value, frames[lane])


@routine
def return_rows(band: Any, border: Any, every: Any, frames: Any, chosen: Any, count: int) -> None:
    """:func:`return_nodes` for nodes of any coordinates, row by row."""
    for j in range(every.shape[1] - HALF_BANDWIDTH - 1, HALF_BANDWIDTH - 1, -1):
        for c in range(count):
            lane = chosen[c]
            sides = every[lane]
            value = frame_share(border, j, lane, frames[lane])
            for k in range(HALF_BANDWIDTH, 0, -1):
                value = fma(band[j, k, lane], sides[j + k], value)
            sides[j] = fma(-band[j, 0, lane], value, sides[j])


@routine
def solve_right_hand_sides(
    work: Any, padded_sides: Any, frame_sides: Any, chosen: Any, count: int, rotations: bool
) -> None:
    """Replace the right-hand sides of the first ``count`` lanes in ``chosen`` by solutions.

    work: memory (..., W) of an eliminated :class:`~snapjump.engine.work.System` with a border of
    three columns; padded_sides (W, B + 10, 4) of the nodes, whose first and last five rows are
    zero; frame_sides (W, F, 4) of the frame; rotations: whether nodes have three coordinates.
    """
    band = uncounted(work.padded_band)
    border = uncounted(work.padded_border)
    every = view_numbers(padded_sides, FOUR)
    frames = view_numbers(frame_sides, FOUR)
    if rotations:
        reduce_rows(band, border, every, frames, chosen, count)
    else:
        reduce_nodes(band, border, every, frames, chosen, count)
    for c in range(count):
        lane = chosen[c]
        solve_block(work.corner_block[:, :, lane], frames[lane])
    if rotations:
        return_rows(band, border, every, frames, chosen, count)
    else:
        return_nodes(band, border, every, frames, chosen, count)
