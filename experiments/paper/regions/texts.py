"""Sentences of the section about achievable regions."""

from collections.abc import Mapping, Sequence

import numpy as np

from experiments.paper.baseline import RANGES
from experiments.paper.regions.judge import mass_exponent
from experiments.paper.regions.outlines import Region

CAPTION = (
    "Achievable regions of the simulated robots (filled) and by the forward model (dashed). Left: "
    "five masses; middle: the same, both axes times m̄; right: five frictions, with the lines "
    "x = 2μy of the cone of friction (dotted). Marks: the four corners of the controls"
)
SETTINGS = (
    "The extremes at `standard` (filled, with lines of constant mismatch, which rise, and of "
    "constant pre-compression, which cross them) and at the paper's settings (black outline)"
)


def paragraphs(
    masses: Sequence[Region],
    frictions: Sequence[Region],
    paper: Mapping[tuple[float, float], Region],
) -> list[str]:
    """What is shown, what is found, what differs and why."""
    points = len(masses[0].apexes)
    (low_lag, high_lag), (low, high) = RANGES["delta_alpha_rad"], RANGES["epsilon"]
    areas = np.array([region.outline.area for region in masses])
    scaled = areas * np.array([region.mass_bar for region in masses]) ** 2
    shares = [region.cone_share for region in frictions]
    ours = {(region.mass_bar, region.mu): region for region in [*masses, *frictions]}
    changes = [100.0 * (p.outline.area / ours[e].outline.area - 1.0) for e, p in paper.items()]
    return [
        f"The region of a robot and a ground is the image of the rectangle of Δα in "
        f"[{low_lag:g}, {high_lag:g}] rad and ε in [{low:g}, {high:g}], here by {points} × "
        f"{points} simulated jumps, mapped linearly in between.",
        "The energy that a snap releases does not depend on the mass, so that a heavier robot "
        "rises less. Places would go as 1/m̄, and areas as m̄⁻², if all of the energy were height; "
        f"the areas go as m̄ to the power {mass_exponent(masses):.2f}. With both axes times m̄ they "
        f"differ by a factor of {scaled.max() / scaled.min():.2g} instead of "
        f"{areas.max() / areas.min():.2g}. Where the rest of the energy "
        "goes is followed at three masses among the influences of the parameters.",
        "Friction limits how oblique a jump can be: the ground pushes sideways at most μ times as "
        "hard as upwards, so that apexes stay this side of x = 2μy. The largest x/(2μy) is "
        f"{shares[0]:.2f} at μ = {frictions[0].mu:g}, where friction alone draws the boundary, and "
        f"{min(shares):.2f} to {shares[-1]:.2f} for the largest μ. There high jumps are limited by "
        "the mismatch, and more friction widens the region no further; low ones of a large "
        "mismatch reach ever farther, in a flap of the map that unfolds to the right.",
        "At the paper's settings the areas differ from these by "
        f"{min(changes):+.0f} to {max(changes):+.0f} %, and the edges are uneven: at its time step "
        "neighbouring designs scatter.",
    ]
