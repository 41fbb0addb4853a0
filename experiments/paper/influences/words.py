"""What is said about the parameters' influences.

Thirteen statements take more than 250 lines.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from experiments.paper.base import LIMITED, Said, percent
from experiments.paper.limits import LIMITS
from experiments.paper.settings import RANGES
from snapjump.run.studies.base import Row, column

CAPTIONS = {
    "influences.png": """Apex against one parameter at a time, all else as the baseline (dotted
        line); shaded: the paper's range""",
    "influences_height.png": """Apex against the mounts' height, of the paper's vertical jump
        (Δα = 0, μ = 0) and of the baseline, with the arch's depths h1, as it snaps, and h2, when it
        has snapped""",
    "influences_friction.png": """Why x_c stops growing with the friction coefficient: the direction
        of lift-off, and which way the beam slides on the ground""",
    "influences_heights": "Depths of the arch under slow loading, and the energy released",
    "influences_energies": "Shares of the energy that the baseline's slow snap releases, by mass",
    "influences_pressed": "The ground under the beam before it snaps",
    "influences_sliding": "The beam's contact during the strike",
}
ABOUT = LIMITS["influences.below_h1"].within
JUMP = LIMITS["influences.beyond_h2.rise"].confirmed
BARRIER = LIMITS["influences.beyond_h2.last"].within
ROUGHLY_FLAT = LIMITS["influences.plateau"].within
# Of the normal impulse: where no more of it acts on a contact that sticks, sticking explains
# nothing. Of the energy: shares below it are not worth a word.
STICKS, TOLD = 0.05, 0.01
HIDDEN = 1.3  # a swing so many times that of a coarser step was hidden by that step


def accuracy(sweep: Mapping[str, Sequence[Row]], off: Sequence[float]) -> str:
    """How far standard is from reference in a sweep, in x and in y."""
    return (
        f"`standard` at {len(sweep['standard'])} values, within {off[0]:.1g} L in x and "
        f"{off[1]:.1g} L in y of `reference` at {len(sweep['reference'])} of them"
    )


def each(shares: Mapping[str, float]) -> str:
    """Shares of coordinates, by their names."""
    return ", ".join(f"{name} {percent(share)}" for name, share in shares.items())


def heights(
    came: Mapping[str, str], own: Any, papers: Any, first: float, told: str
) -> dict[str, Said]:
    """Of a sweep, from its ``first`` height on, with what limited verdicts are limited to."""
    level = "About so" if max(own.off.values()) <= ABOUT else "In y_c only"
    limits = {
        "below_h1": f"{level}, to within {percent(ABOUT)}. ",
        "decline": "With waves. ",
        "beyond_h2": f"From {own.last_jump - own.h2:.3f} L beyond it on. ",
    }
    limited = {key: text if came[key] == LIMITED else "" for key, text in limits.items()}
    return {
        "below_h1": Said(
            "For mounts no higher than h1 the robot jumps as high as for h1.",
            f"""{limited["below_h1"]}Here h1 = {own.h1:.3f} L. From h = {first:g} L to
            h1 the largest deviations from the apex at h1 are {each(own.off)}; within
            {percent(ABOUT)} from {own.close_from:.3f} L on (the paper's settings:
            {each(papers.off)}, from {papers.close_from:.3f} L).""",
            told,
        ),
        "best": Said(
            "Mounts at h1 are the best: no others make the robot jump higher.",
            f"""The highest jump of all is at h = {own.best_height:.4f} L, and {percent(own.best)}
            higher than that at h1 = {own.h1:.4f} L (the paper's settings: {papers.best_height:.4f}
            L, {percent(papers.best)}).""",
            told,
        ),
        "decline": Said(
            "Between h1 and h2 the height of the jump declines.",
            f"""{limited["decline"]}From h1 = {own.h1:.3f} L to h2 = {own.h2:.3f} L the steps back
            are at most, as shares of the decline, {each(own.back)} (the paper's settings:
            {each(papers.back)}).""",
            told,
        ),
        "beyond_h2": Said(
            "From h2 on, the depth of the snapped arch, the robot does not jump.",
            f"""{limited["beyond_h2"]}Here h2 = {own.h2:.4f} L, the depth of the arch's middle,
            which is its lowest point. The last jump of more than {JUMP:g} L is at
            h = {own.last_jump:.4f} L (the paper's settings: {papers.last_jump:.4f} L); from h2 on
            the centre of mass rises by at most {own.rise_beyond:.1g} L, and the barrier begins
            {BARRIER:g} L above the ground.""",
            told,
        ),
    }


def oblique(said: dict[str, Said], own: Any, rows: Sequence[Row], still: Row) -> dict[str, Said]:
    """The same of the baseline, whose apex has two coordinates, and what the ground does to a beam
    that touches it before it snaps."""
    low = [row for row in rows if row["mount_height_bar"] <= own.h1]
    loads, angles = column(low, "load_over_weight"), column(low, "alpha_snap_rad")
    turned = own.off["x_c"] > ABOUT >= own.off["y_c"]
    says = {
        "below_h1": """For mounts no higher than h1 the apex of an oblique jump does not depend on
        their height h (our reading).""",
        "decline": "Between h1 and h2 the apex of an oblique jump declines (our reading).",
        "beyond_h2": "From h2 on the baseline, with a mismatch, does not jump (our reading).",
    }
    found = {key: said[key].found for key in says}
    found["below_h1"] += f""" The beam then touches the ground before it snaps, the clamps press it
        down until it bears {loads.min():.0f} to {loads.max():.0f} times the robot's weight and
        lifts the feet, and it snaps at {angles.min():.2f} to {angles.max():.2f} rad instead of
        {still["alpha_critical_rad"]:.2f}{
        ": the height remains, the direction changes" if turned else ""
    }."""
    return {key: Said(one, found[key], said[key].accuracy) for key, one in says.items()}


def growth(v: Any, x: Any, y: Any, backs: Any, told: str) -> Said:
    """``backs``: ways back of x and y, and of those at the paper's settings."""
    own, papers = backs
    return Said(
        "x_c and y_c grow monotonically with the pre-compression ε.",
        f"""From ε = {v[0]:g} to {v[-1]:g} x_c grows from {x[0]:.2g} to {x[-1]:.2g} L and y_c from
        {y[0]:.2g} to {y[-1]:.2g} L; the largest way back is {percent(own[0])} and {percent(own[1])}
        of the growth (the paper's settings: {percent(papers[0])} and {percent(papers[1])}).""",
        told,
    )


def fall(
    v: Any, x: Any, y: Any, backs: Any, powers: Any, energies: Mapping[str, Any], told: str
) -> Said:
    """The same with the mass; ``powers``: exponents in the same order."""
    (back_x, back_y), (paper_x, paper_y) = backs
    released = energies["standard"][0]["energy_released_bar"]
    return Said(
        "x_c and y_c fall as the mass m̄ grows.",
        f"""From m̄ = {v[0]:g} to {v[-1]:g} x_c falls from {x[0]:.2g} to {x[-1]:.2g} L and y_c from
        {y[0]:.2g} to {y[-1]:.2g} L, with ways back of {percent(back_x)} and {percent(back_y)} (the
        paper's settings: {percent(paper_x)} and {percent(paper_y)}). They fall like
        m̄^{powers[0]:.2f} and m̄^{powers[1]:.2f} (the paper's settings: {powers[2]:.2f} and
        {powers[3]:.2f}), where height in proportion to energy would be m̄^-1. Of what the slow snap
        of the mismatched arch releases, {released:.2g} EI/L, {shares(energies["standard"])}. With
        the paper's settings {shares(energies["paper"])}.""",
        told,
    )


def shares(rows: Sequence[Row]) -> str:
    """Where the energy goes, of the lightest and of the heaviest robot."""
    names = {
        "rise": "becomes height above where the robot stands",
        "friction": "goes to friction",
        "damping": "to the material's damping",
        "numerical": "to the integrator",
        "turning": "to turning and vibration",
    }
    told = ", ".join(
        f"{percent(rows[0][f'{name}_share'])} and {percent(rows[-1][f'{name}_share'])} {what}"
        for name, what in names.items()
        if max(abs(row[f"{name}_share"]) for row in rows) >= TOLD
    )
    return f"at m̄ = {rows[0]['mass_bar']:g} and at {rows[-1]['mass_bar']:g}, in this order, {told}"


def mismatch(own: Any, papers: Any, told: str) -> Said:
    """Up to the thresholds."""
    return Said(
        "A larger mismatch Δα raises x_c and lowers y_c, up to a threshold.",
        f"""The apex's x_c rises by {own.x.slope_before:.0f} L/rad up to {own.x.threshold:.2g} rad
        and y_c falls by {-own.y.slope_before:.0f} L/rad up to {own.y.threshold:.2g} rad; the
        largest way back is {percent(own.back[0])} and {percent(own.back[1])} of the change (the
        paper's settings: up to {papers.x.threshold:.2g} and {papers.y.threshold:.2g} rad).""",
        told,
    )


def limit_of_level(came: str, found: Mapping[str, Any]) -> str:
    """What a limited verdict on plateaus is limited to, in front of what is found."""
    if came != LIMITED:
        return ""
    kept = [name for name, one in found.items() if one.relative_swing <= ROUGHLY_FLAT]
    if len(kept) < len(found):
        return f"In {' and '.join(kept)} only. "
    return f"To within {percent(max(found[name].relative_swing for name in kept))}. "


def plateau(came: str, own: Any, papers: Any, last: float, short: float, told: str) -> Said:
    """Beyond the thresholds; ``short``: the swing of x with a short step."""
    in_x, in_y = own.x, own.y
    hidden = short > HIDDEN * papers.x.relative_swing
    return Said(
        "Beyond the threshold x_c and y_c are on a plateau.",
        f"""{limit_of_level(came, {"x_c": in_x, "y_c": in_y})}Up to {last:g} rad y_c stays within
        {percent(in_y.relative_swing)} from lowest to highest about {in_y.level:.3g} L, x_c within
        {percent(in_x.relative_swing)} about {in_x.level:.2g} L, where it lies between
        {in_x.level - own.beyond.min():.2g} L below and {own.beyond.max() - in_x.level:.2g} L above.
        With the paper's settings the swings are {percent(papers.y.relative_swing)} and
        {percent(papers.x.relative_swing)}; of x_c with a step a tenth as long {percent(short)}{
            ", so that it is the step that levels it" if hidden else ""
        }.""",
        told,
    )


def friction_height(y: Any, spreads: Sequence[float], told: str) -> Said:
    """``spreads``: over the paper's range, the same at the paper's settings, over all."""
    return Said(
        "y_c does not depend on the friction coefficient μ.",
        f"""Over μ in [0, {RANGES["mu"][1]:g}] y_c lies between {y.min():.1f} and {y.max():.1f} L, a
        range of {percent(spreads[0])} of its mean (the paper's settings: {percent(spreads[1])}); up
        to μ = 1 of {percent(spreads[2])}.""",
        told,
    )


def threshold(came: str, own: Any, papers: Any, sliding: Sequence[Row], told: str) -> Said:
    """The ramp of x against the friction coefficient."""
    return Said(
        "x_c grows with μ up to a threshold, and no more beyond.",
        f"""{limit_of_level(came, {"x_c": own})}x_c grows in proportion to μ, by
        {own.slope_before:.0f} L, up to μ = {own.threshold:.2g}, then stays within
        {percent(own.relative_swing)} from lowest to highest about {own.level:.2g} L up to
        {RANGES["mu"][1]:g} (the paper's settings: {papers.threshold:.2g},
        {percent(papers.relative_swing)}). {why(sliding, own.threshold)}""",
        told,
    )


def why(sliding: Sequence[Row], threshold: float) -> str:
    """What becomes of the contact beyond the threshold, from the shares of its normal impulse."""
    stuck = float(column(sliding, "sticking_share").max())
    if stuck > STICKS:
        return f"The contact sticks under up to {percent(stuck)} of the beam's normal impulse."
    low, high = sliding[0], sliding[-1]
    from_there = column(sliding, "mu") >= min(threshold, high["mu"])
    beyond = column(sliding, "friction_over_normal")[from_there]
    return f"""Not because the contact sticks: at most {percent(stuck)} of the beam's normal impulse
        acts where it does. The beam slides to and fro: the share that brakes goes from
        {percent(low["braking_share"])} at μ = {low["mu"]:g} to {percent(high["braking_share"])} at
        {high["mu"]:g}, so that beyond the threshold the net friction is {beyond.min():.2f} to
        {beyond.max():.2f} of the normal impulse."""


def text(sweeps: Sequence[Mapping[str, Sequence[Row]]]) -> str:
    """What is shown, what is found, and how the paper's settings differ; sweeps of the baseline."""
    x_off, y_off = [], []
    for tiers in sweeps:
        x, y, paper_x, paper_y = (
            column(tiers[tier], key) for tier in ("standard", "paper") for key in ("x_bar", "y_bar")
        )
        jumps = y > 1.0
        x_off.append((paper_x - x)[jumps])
        y_off.append(100.0 * (paper_y / y - 1.0)[jumps])
    aside, higher = np.abs(np.concatenate(x_off)), np.concatenate(y_off)
    return f"""Each parameter is swept about the baseline with all others held; the
        mounts' height also for the paper's vertical jump, which has neither mismatch nor friction.
        The curves of the converged model are smooth lines with a few bends and dips, which
        `reference` repeats: they are the robot's, not the program's.

        With the paper's settings the same jumps are {np.median(higher):.1f} % higher in the median
        (between {higher.min():.1f} and {higher.max():.1f} %), and x_c moves by up to
        {aside.max():.1f} L (median {np.median(aside):.2f} L) either way, with a noise from place to
        place that the converged model does not have. *What causes the difference* takes that apart.

        Lagged friction at a fixed step becomes unstable where the step exceeds eps_v m / (μ N):
        with the paper's settings the curve against μ breaks up beyond the paper's range."""
