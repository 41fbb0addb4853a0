"""What is said about achievable regions."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from experiments.paper.base import Said, listed
from experiments.paper.limits import LIMITS
from experiments.paper.settings import RANGES

CAPTIONS = {
    "regions.png": """Achievable regions of the simulated robots (filled) and by the forward model
        (dashed). Left: five masses; middle: the same, both axes times m̄; right: five frictions,
        with the lines x = 2μy of the cone of friction (dotted). Marks: the four corners of the
        controls""",
    "regions_settings.png": """The extremes at `standard` (filled, with lines of constant mismatch,
        which rise, and of constant pre-compression, which cross them) and at the paper's settings
        (black outline)""",
    "regions": "Achievable regions: areas in L², the rest in L",
}
# The paper's text states neither of the two: its figure of the regions comes without a claim.


def shrinks(masses: Sequence[Any], paper: Sequence[Any], exponent: float, told: str) -> Said:
    """Regions in the order of their masses, ``paper`` at the paper's settings."""
    first, last = masses[0], masses[-1]
    own, others = ([region.outline.area for region in one] for one in (masses, paper))
    shares = [100 * after.held(one) for one, after in zip(masses, masses[1:], strict=False)]
    falls = own == sorted(own, reverse=True)
    return Said(
        "The achievable region shrinks as the robot gets heavier (our reading of the figure).",
        f"""From m̄ = {first.mass_bar:g} to {last.mass_bar:g} the area
        {"falls at every step" if falls else "goes"} from {own[0]:.3g} to {own[-1]:.2g} L², as m̄ to
        the power {exponent:.2f} (paper's settings: {others[0]:.3g} to {others[-1]:.2g} L²). Of its
        area a heavier robot's region has {min(shares):.0f} to {max(shares):.0f} % within the next
        lighter one's; the least y goes from {first.least_y:.2g} to
        {last.least_y:.2g} L.""",
        told,
    )


def widens(
    frictions: Sequence[Any],
    paper: Sequence[Any],
    ended: Mapping[float, bool],
    moved: Sequence[tuple[float, float]],
    accuracy: str,
) -> Said:
    """Regions in the order of their frictions; ``ended``: whether widths saturate, by height;
    ``moved``: changes of the least and of the largest y, ours and at the paper's settings."""
    right = [region.largest_x for region in frictions]
    three = [frictions[k] for k in (0, len(frictions) // 2, -1)]
    first, middle, last = (region.mu for region in three)
    told = "; ".join(
        f"at y = {y:.3g} L {listed([region.width_bar(y) for region in three], '.2g')} L "
        f"({'' if done else 'not '}saturated)"
        for y, done in ended.items()
    )
    (low, high), (_, paper_high) = moved
    alone = LIMITS["regions.friction.heights"].confirmed
    saturated = LIMITS["regions.friction.share"].confirmed
    return Said(
        """A larger friction coefficient widens the achievable region in x, until it saturates, and
        leaves its heights alone (our reading of the figure).""",
        f"""From μ = {first:g} to {last:g} the largest x
        {"grows" if right == sorted(right) else "goes"} from {right[0]:.2g} to {right[-1]:.2g} L
        (paper's settings: {paper[0].largest_x:.2g} to {paper[-1].largest_x:.2g} L). The widths, at
        μ = {first:g}, {middle:g} and {last:g}: {told}. Meanwhile the largest y changes by
        {100 * high:.0f} % ({100 * paper_high:.0f} % at the paper's settings) and the least by
        {100 * low:.0f} %, {"within" if max(low, high) <= alone else "beyond"} the {100 * alone:g} %
        that count as left alone. Saturated: {100 * saturated:g} % of the widening done by
        μ = {middle:g}.""",
        accuracy,
    )


def accuracy(count: int, x: float, y: float) -> str:
    """The designs that both tiers have simulated, and differences (%)."""
    return (
        f"`standard`, {count} of the designs against `reference`: 95 % of x within {x:.2g} %, of y "
        f"within {y:.2g} %; the extremes at `paper` too"
    )


def text(
    masses: Sequence[Any],
    frictions: Sequence[Any],
    pairs: Sequence[tuple[Any, Any]],
    exponent: float,
) -> str:
    """What is shown, what is found, what differs and why; ``pairs``: regions at standard and with
    the paper's settings."""
    points = len(masses[0].apexes)
    (low_lag, high_lag), (low, high) = RANGES["delta_alpha_rad"], RANGES["epsilon"]
    areas = np.array([region.outline.area for region in masses])
    scaled = areas * np.array([region.mass_bar for region in masses]) ** 2
    shares = [region.cone_share for region in frictions]
    changes = [100.0 * (paper.outline.area / own.outline.area - 1.0) for own, paper in pairs]
    return f"""The region of a robot and a ground is the image of the rectangle of Δα in
        [{low_lag:g}, {high_lag:g}] rad and ε in [{low:g}, {high:g}], here by {points} × {points}
        simulated jumps, mapped linearly in between.

        The energy that a snap releases does not depend on the mass, so that a heavier robot rises
        less. Places would go as 1/m̄, and areas as m̄⁻², if all of the energy were height; the areas
        go as m̄ to the power {exponent:.2f}. With both axes times m̄ they differ by a factor of
        {scaled.max() / scaled.min():.2g} instead of {areas.max() / areas.min():.2g}. Where the rest
        of the energy goes is followed at three masses among the influences of the parameters.

        Friction limits how oblique a jump can be: the ground pushes sideways at most μ times as
        hard as upwards, so that apexes stay this side of x = 2μy. The largest x/(2μy) is
        {shares[0]:.2f} at μ = {frictions[0].mu:g}, where friction alone draws the boundary, and
        {min(shares):.2f} to {shares[-1]:.2f} for the largest μ. There high jumps are limited by the
        mismatch, and more friction widens the region no further; low ones of a large mismatch reach
        ever farther, in a flap of the map that unfolds to the right.

        At the paper's settings the areas differ from these by {min(changes):+.0f} to
        {max(changes):+.0f} %, and the edges are uneven: at its time step neighbouring designs
        scatter."""
