"""What is said about the released energy, and about the depths h1 and h2."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from experiments.arches import exact
from experiments.paper.base import Said, listed
from experiments.paper.settings import RANGES
from snapjump.run.studies.base import Row, column

CAPTIONS = {
    "released_energy.png": """Energy released by the snap; how far it is from a straight line; and
        over ε, where an exact proportion would be level. Circles: exact""",
    "released_heights.png": """Depth h1 of the lowest point of the critical arch and depth h2 of the
        snapped arch's middle, with the released program's polynomials; and how far these are
        off""",
    "released_energy_lines": "Straight lines",
    "released_heights_errors": "The released program's polynomials against arches (%)",
}
LOW, HIGH = RANGES["epsilon"]


def accuracy(standard: float, reference: float) -> str:
    """The tiers, and how far they are from the exact elastica over the paper's range (%)."""
    return f"`standard` ({standard:.2g} %), `reference` ({reference:.2g} %)"


def law(line: Any) -> str:
    """A line in words."""
    sign = "-" if line.intercept < 0.0 else "+"
    return f"{line.slope:.3g} ε {sign} {abs(line.intercept):.2g}"


def linear(alike: Sequence[Row], line: Any, whole: Any, meshed: Any, told: str) -> Said:
    """Lines over the paper's range, over all, and on the paper's mesh."""
    slope = exact.shallow()["E_over_eps_released"]
    epsilon, energy = column(alike, "epsilon"), column(alike, "energy_released_bar")
    more = 100.0 * (energy / (slope * epsilon) - 1.0)
    first = int(np.argmin(np.abs(epsilon - LOW)))
    return Said(
        "The energy that the snap releases grows linearly with ε.",
        f"""Over the paper's range the best line, {law(line)} in EI/L, is off by up to
        {line.deviation_percent:.2g} % of the value (at ε = {line.worst_place:g}; on the paper's
        mesh {meshed.deviation_percent:.2g} %); down to ε = {epsilon[0]:g}, with {law(whole)}, by up
        to {whole.deviation_percent:.2g} % (at ε = {whole.worst_place:g}). A shallow arch releases
        {slope:.3g} ε exactly in proportion; what is released differs from that by
        {more[first]:+.2g} % at ε = {LOW:g} and by {more[-1]:+.2g} % at ε = {HIGH:g}.""",
        told,
    )


def span(values: Any) -> str:
    """From the least to the largest, with signs."""
    return f"{values.min():+.2g} to {values.max():+.2g}"


def polynomials(
    rows: Sequence[Row],
    fits: Mapping[str, Sequence[Any]],
    left: float,
    mismatch_rad: float,
    told: str,
) -> Said:
    """``fits``: errors of h1 and h2 for the converged arch, on the program's mesh, and there with a
    mismatch; ``left``: by the best quadratic through h2."""
    (h1, own_h1, tilted_h1), (h2, own_h2, tilted_h2) = fits.values()
    factor = exact.released_factor()
    gaps = factor * exact.released_height("h1", column(rows, "epsilon")) - column(rows, "h1_bar")
    return Said(
        """(released program) Its polynomials give the depth h1(ε) of the critical arch's lowest
        point and the depth h2(ε) of the snapped arch's middle.""",
        f"""Against the converged arch h1 is off by {span(h1)} % (with the factor of
        {factor:g} that the program adds, the clamps stand up to {gaps.max():.2g} L too high) and h2
        by {span(h2)} %. On the program's own mesh, whose clamps are two fixed nodes, h1 is off by
        {span(own_h1)} % and h2 by {span(own_h2)} % (the best quadratic through h2 by
        {left:.2g} %); there, with a mismatch of {mismatch_rad:g} rad, h1 by {span(tilted_h1)} % and
        h2 by {span(tilted_h2)} %. The cause of what h2 is off by is open.""",
        told,
    )


def text(
    curves: Mapping[float, Sequence[Row]],
    small: Sequence[Row],
    unit_mJ: float,
    off: Sequence[float],
) -> str:
    """What is shown and what is found; ``small``: arches with a small mismatch; ``off``: energies
    from the exact ones (%), over the paper's range and everywhere."""
    alike, (*_, far) = curves[0.0], curves
    energies = dict(
        zip(column(alike, "epsilon"), column(alike, "energy_released_bar"), strict=True)
    )
    first, last = energies[LOW], energies[HIGH]
    lags = [lag for lag in curves if lag > 0.0]
    less = [100.0 * (1.0 - curves[lag][-1]["energy_released_bar"] / last) for lag in lags]
    shares = " and ".join(f"{share:.2g} %" for share in less)
    deeper = [
        100.0 * (rows[-1]["h1_bar"] / alike[-1]["h1_bar"] - 1.0) for rows in (small, curves[far])
    ]
    return f"""The elastic energy at the critical angle less that of the snapped arch at
        the same angle: from {first:.3g} EI/L at ε = {LOW:g} to {last:.3g} EI/L at ε = {HIGH:g},
        which is {first * unit_mJ:.2g} to {last * unit_mJ:.2g} mJ for the paper's beam. A mismatch
        of {listed(lags).replace(", ", " and ")} rad takes {shares} of it at ε = {HIGH:g}, since the
        arch snaps earlier. The exact elastica, inextensible, has the same energies to
        {off[0]:.2g} %, and to {off[1]:.2g} % in shallower arches, where the beam's own shortening
        counts.

        In the limit of shallow arches all energies are proportional to ε; the next term, of order
        ε², bends the curve upwards. A line with a free intercept takes up most of that over the
        paper's range, but it crosses zero before the arch is flat, so that the smaller ε is, the
        farther it is off in percent.

        The depth h1 of the critical arch is sensitive to a mismatch, whose first
        {small[0]["delta_alpha_rad"]:g} rad make it {deeper[0]:.2g} % deeper at ε = {HIGH:g}, and
        {far:g} rad {deeper[1]:.2g} %: close to a subcritical pitchfork the least disturbance moves
        the critical state."""
