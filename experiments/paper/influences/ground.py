"""Friction and the mounts' height: what the ground does to the apex."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from experiments.paper.influences.compute import MOUNT_HEIGHT
from experiments.paper.influences.judge import (
    COMMAND,
    Sweeps,
    columns,
    independent,
    levels_off,
    limit_of_level,
    percent,
    relative_range,
)
from experiments.paper.jumps import numbers
from experiments.paper.settings import RANGES
from experiments.paper.statement import LIMITED, Statement, verdict
from experiments.trends import counter_step, plateau
from snapjump.run.studies.base import Row

# Of the normal impulse: where no more of it acts on a contact that sticks, sticking explains
# nothing.
STICKS = 0.05


def friction_statements(sweeps: Sweeps, sliding: Sequence[Row], accuracy: str) -> list[Statement]:
    """What friction does not change, and where it changes no more."""
    last = RANGES["mu"][1]
    v, x, y = columns(sweeps["standard"], "mu", last)
    _, paper_x, paper_y = columns(sweeps["paper"], "mu", last)
    own, papers = plateau(v, x), plateau(v, paper_x)
    _, _, all_y = columns(sweeps["standard"], "mu")
    return [
        Statement(
            "y_c does not depend on the friction coefficient μ.",
            independent(y),
            f"Over μ in [0, {last:g}] y_c lies between {y.min():.1f} and {y.max():.1f} L, a range "
            f"of {percent(relative_range(y))} of its mean (the paper's settings: "
            f"{percent(relative_range(paper_y))}); up to μ = 1 of "
            f"{percent(relative_range(all_y))}.",
            accuracy,
            COMMAND,
        ),
        Statement(
            "x_c grows with μ up to a threshold, and no more beyond.",
            levels_off(own),
            limit_of_level(levels_off(own), {"x_c": own})
            + f"x_c grows in proportion to μ, by {own.slope_before:.0f} L, up to μ = "
            f"{own.threshold:.2g}, then stays within {percent(own.relative_swing)} from lowest "
            f"to highest about {own.level:.2g} L up to {last:g} (the paper's settings: "
            f"{papers.threshold:.2g}, {percent(papers.relative_swing)}). "
            f"{why(sliding, own.threshold)}",
            accuracy,
            COMMAND,
        ),
    ]


def why(sliding: Sequence[Row], threshold: float) -> str:
    """What becomes of the contact beyond the threshold, from the shares of its normal impulse."""
    stuck = float(numbers(sliding, "sticking_share").max())
    if stuck > STICKS:
        return f"The contact sticks under up to {percent(stuck)} of the beam's normal impulse."
    low, high = sliding[0], sliding[-1]
    from_there = numbers(sliding, "mu") >= min(threshold, high["mu"])
    beyond = numbers(sliding, "friction_over_normal")[from_there]
    return (
        f"Not because the contact sticks: at most {percent(stuck)} of the beam's normal impulse "
        "acts where it does. The beam slides to and fro: the share that brakes goes from "
        f"{percent(low['braking_share'])} at μ = {low['mu']:g} to "
        f"{percent(high['braking_share'])} at {high['mu']:g}, so that beyond the threshold the "
        f"net friction is {beyond.min():.2f} to {beyond.max():.2f} of the normal impulse."
    )


# Shares of the value at h1 within which an apex is constant, and within which it is about so.
CONSTANT, ROUGHLY_CONSTANT = 0.03, 0.1
# Largest way back of a curve that declines, as a share of its decline; and of one that does with
# waves, which are resolved (standard and reference agree on them).
MONOTONE, WAVY = 0.02, 0.2
# What counts as a jump: the centre of mass rises by this much (L) above where it stands. The
# recoil of a snap that strikes nothing lifts it by a tenth of that.
JUMP = 0.05
# The barrier acts so far (L) above the ground: a limit that it blurs by as much is still h2.
BARRIER = 0.025


@dataclass(frozen=True)
class Height:
    """The figures of one tier's sweep between h1 and h2 (L).

    x_range, y_range: largest deviation below h1 from the apex at h1 (share); close_from: the
    lowest h from which on both stay within ROUGHLY_CONSTANT up to h1; x_back, y_back: ways back
    between h1 and h2; last_jump: the highest h with a jump, NaN without any; rise_beyond: the
    largest rise (L) of the centre of mass from h2 on.
    """

    x_range: float
    y_range: float
    close_from: float
    x_back: float
    y_back: float
    last_jump: float
    rise_beyond: float


def height(rows: Sequence[Row], h1: float, h2: float) -> Height:
    """The figures; the centre of mass stands where the lowest of the sweep is, which has not
    jumped."""
    h, x, y = (numbers(rows, key) for key in (MOUNT_HEIGHT, "x_bar", "y_bar"))
    below, between, beyond = h <= h1, (h >= h1) & (h <= h2), h >= h2
    x1, y1 = np.interp(h1, h, x), np.interp(h1, h, y)
    x_off, y_off = np.abs(x / x1 - 1.0), np.abs(y / y1 - 1.0)
    far = np.flatnonzero(below & (np.maximum(x_off, y_off) > ROUGHLY_CONSTANT))
    rise = y - y.min()
    jumps = h[rise > JUMP]
    return Height(
        float(x_off[below].max()),
        float(y_off[below].max()),
        float(h[far[-1] + 1] if len(far) else h[0]),
        counter_step(x[between], rising=False),
        counter_step(y[between], rising=False),
        float(jumps.max()) if len(jumps) else float("nan"),
        float(rise[beyond].max()),
    )


def plateau_verdict(found: Height) -> str:
    """Constant below h1 in both coordinates; or the height at least, about."""
    worst = max(found.x_range, found.y_range)
    return verdict(worst <= CONSTANT, found.y_range <= ROUGHLY_CONSTANT)


def decline_verdict(found: Height) -> str:
    """A decline between h1 and h2 in both coordinates; or one with waves."""
    worst = max(found.x_back, found.y_back)
    return verdict(worst <= MONOTONE, worst <= WAVY)


def stop_verdict(found: Height, h2: float) -> str:
    """Jumps, but none from h2 on; or none from within the barrier's reach beyond it."""
    jumps = not np.isnan(found.last_jump)
    return verdict(jumps and found.rise_beyond <= JUMP, jumps and found.last_jump <= h2 + BARRIER)


def plateau_limit(found: Height) -> str:
    """What a limited verdict on the plateau is limited to, in front of what is found."""
    if plateau_verdict(found) != LIMITED:
        return ""
    whole = found.x_range <= ROUGHLY_CONSTANT
    return f"{'About so' if whole else 'In y_c only'}, to within {percent(ROUGHLY_CONSTANT)}. "


def kept(found: Height) -> str:
    """What remains below h1 and what does not."""
    if found.x_range > ROUGHLY_CONSTANT >= found.y_range:
        return ": the height remains, the direction changes"
    return ""


def height_statements(
    sweeps: Mapping[str, Sequence[Row]],
    statics: Mapping[str, Row],
    pressed: Sequence[Row],
    accuracy: str,
) -> list[Statement]:
    """Three statements; statics: of each tier's own mesh."""
    found = {
        tier: height(rows, statics[tier]["h1_bar"], statics[tier]["h2_bar"])
        for tier, rows in sweeps.items()
    }
    own, papers, still = found["standard"], found["paper"], statics["standard"]
    h1, h2, middle = (still[key] for key in ("h1_bar", "h2_bar", "h2_middle_bar"))
    low = [row for row in pressed if row[MOUNT_HEIGHT] <= h1]
    loads = [row["load_over_weight"] for row in low]
    angles = [row["alpha_snap_rad"] for row in low]
    return [
        Statement(
            "For mounts no higher than h1 the apex does not depend on their height h.",
            plateau_verdict(own),
            f"{plateau_limit(own)}h1 = {h1:.3f} L. From h = "
            f"{sweeps['standard'][0][MOUNT_HEIGHT]:g} L to h1, y_c stays within "
            f"{percent(own.y_range)} of its value at h1, x_c within {percent(own.x_range)}; both "
            f"within {percent(ROUGHLY_CONSTANT)} from {own.close_from:.3f} L on (the paper's "
            f"settings: {percent(papers.y_range)}, {percent(papers.x_range)}, from "
            f"{papers.close_from:.3f} L). The beam then touches "
            "the ground before it snaps, the clamps press it down until it bears "
            f"{min(loads):.0f} to {max(loads):.0f} times the robot's weight and lifts the feet, "
            f"and it snaps at {min(angles):.2f} to {max(angles):.2f} rad instead of "
            f"{still['alpha_critical_rad']:.2f}{kept(own)}.",
            accuracy,
            COMMAND,
        ),
        Statement(
            "Between h1 and h2 the apex declines.",
            decline_verdict(own),
            f"From h1 = {h1:.3f} L to h2 = {h2:.3f} L y_c falls with steps back of at most "
            f"{percent(own.y_back)} of its decline, x_c of {percent(own.x_back)} (the paper's "
            f"settings: {percent(papers.y_back)}, {percent(papers.x_back)}).",
            accuracy,
            COMMAND,
        ),
        Statement(
            "From h2 on, the depth of the snapped arch, the robot does not jump.",
            stop_verdict(own, h2),
            f"Here h2 = {h2:.4f} L, the lowest point; the middle of the arch is {middle:.4f} L "
            f"deep. The last jump of more than {JUMP:g} L is at h = {own.last_jump:.4f} L (the "
            f"paper's settings: {papers.last_jump:.4f} L); from h2 on the centre of mass rises by "
            f"at most {own.rise_beyond:.1g} L, though the barrier begins {BARRIER:g} L above "
            "the ground.",
            accuracy,
            COMMAND,
        ),
    ]
