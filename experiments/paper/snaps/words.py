"""What is said about the symmetry of snaps."""

import math
from collections.abc import Mapping, Sequence

from experiments.arches.swings import RATE_RAD_S
from experiments.paper.base import Said
from experiments.paper.limits import LIMITS
from snapjump.run.studies.base import Row

CAPTIONS = {
    "snaps.png": """Shapes between which the midpoint sinks by equal steps, and the midpoint's
        height and tilt; dots with numbers: the instants of the shapes; squares: the independent
        solution, which has no damping""",
    "snap_imperfections.png": """The largest tilt against the mismatch at several rates of the
        clamps; at the left edge equal clamps, which rounding errors alone disturb""",
    "snap_numbers": "The two snaps at all settings",
    "snap_agreement": "Differences from the independent solution, which has no damping (%)",
    "snap_limits": "Mismatch that tilts the midpoint by 1°, and tilt with equal clamps",
}
VISIBLE_DEG = math.degrees(LIMITS["snaps.symmetry.mismatched"].confirmed)


def symmetry(
    pair: Sequence[Row],
    tilts: Mapping[str, float],
    epsilon: float,
    by_rate: Mapping[float, tuple[float, float]],
    accuracy: str,
) -> Said:
    """``pair``: the two snaps; ``tilts``: of the one with a mismatch, by setting; ``by_rate``: the
    mismatch that is seen, and the tilt with equal clamps."""
    one, other = pair
    told = "; ".join(limit_in_words(rate, *by_rate[rate]) for rate in sorted(by_rate))
    return Said(
        "With equal clamps the beam snaps symmetrically, with a mismatch asymmetrically.",
        f"""At {RATE_RAD_S:g} rad/s and ε = {epsilon:g} the midpoint tilts by
        {one["theta_max_rad"]:.1g} rad with equal clamps and by {tilts["standard"]:.3f} rad
        ({math.degrees(tilts["standard"]):.0f}°) at Δα = {other["delta_alpha_rad"]:g} rad
        ({tilts["reference"]:.3f} rad at `reference`, {tilts["paper"]:.3f} rad at the paper's
        settings, {tilts["undamped"]:.3f} rad without damping); it crosses the clamps' line at
        α = {one["alpha_snap_rad"]:.3f} and {other["alpha_snap_rad"]:.3f} rad, and the snap takes
        {one["snap_duration_ms"]:.1f} and {other["snap_duration_ms"]:.1f} ms. How nearly equal the
        clamps have to be depends on how fast they turn: a tilt of {VISIBLE_DEG:g}° takes
        {told}.""",
        accuracy,
    )


def limit_in_words(rate: float, limit: float, equal: float) -> str:
    """At which mismatch the tilt is seen when the clamps turn at this rate (rad/s); ``equal``: the
    tilt with equal clamps."""
    if limit == 0.0:
        return f"no mismatch at all at {rate:g} rad/s ({equal:.2g} rad from rounding)"
    if math.isinf(limit):
        return f"more than was tried at {rate:g} rad/s"
    return f"a mismatch of {limit:.2g} rad at {rate:g} rad/s"


def accuracy(off: float) -> str:
    """How far the tilt at standard is from that at reference (%)."""
    return f"`standard` ({off:.1g} % from `reference`)"


def text(epsilon: float, off: Mapping[str, float]) -> str:
    """What is shown and what is found; ``off``: differences from the independent solution (%)."""
    return f"""The beam alone in a frame that is held still, without gravity or ground,
        at ε = {epsilon:g}; both clamps turn at {RATE_RAD_S:g} rad/s from flat. The tilt is the
        tangent angle at the midpoint; θ_max is the largest one of the snap, which ends where the
        midpoint first comes to rest below the clamps (`theta_later_rad`: with the vibration after
        that, which without damping goes on and whose details are chaotic).

        Without damping, the snaps are those of an independent solution within
        {off["undamped reference"]:.1g} %; that solution's own uncertainty is {off["own"]:.1g} %.

        The arch always becomes unstable asymmetrically first, at equal clamps too, and
        symmetrically a little later. A snap is symmetric if the asymmetric mode has nothing to grow
        from, or no time before the symmetric one has taken over. So it depends on how fast the
        clamps turn: the slower, the smaller the mismatch that suffices. Material damping holds the
        growth back; the paper's time step does not: implicit Euler damps what oscillates, not what
        buckles."""
