"""What is said about errors of the parameters."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from experiments.paper.base import Said
from experiments.paper.settings import BASELINE, NAMES, PLAIN
from snapjump.targets.simulator import RESOLVED_STICK_ZONE_M_S

CAPTIONS = {
    "imperfections.png": """Relative errors of the apex's x and y for errors of each parameter about
        the test design; marks: the ten points of the released program's test; pale dashes: at the
        paper's settings""",
    "imperfections_lines.png": """The same with their signs, for each parameter: simulated at
        `standard` (line) and at the paper's settings (crosses), the exact tangent at `reference`
        (dashed), and the secant of errors of 2 % either way (dotted)""",
    "imperfections": "Errors of up to 20 % at the test design: largest changes of the apex (%)",
    "imperfections_slopes": """Elasticities at the test design (% of change for 1 % of error): a
        line fitted to all errors and the secant, at `reference`, and exact tangents""",
    "imperfections_lines": """How far straight lines are off at an error either way, at `reference`
        (% of x or y)""",
    "imperfections_elsewhere": """Errors of 20 % at 64 designs spread over the ranges: largest
        change (%)""",
}


def ordered(values: Any) -> str:
    """The parameters in the order of (4,) values, each with its own in percent."""
    names = [*PLAIN.values()]
    return ", ".join(f"{names[k]} {100.0 * values[k]:.2g} %" for k in np.argsort(-values))


def worst(largest: Any) -> tuple[str, float]:
    """Of the largest changes (4, 2): which coordinate by which parameter, and how much (%)."""
    k, j = np.unravel_index(int(largest.argmax()), largest.shape)
    return f"{'xy'[j]} by {PLAIN[NAMES[k]]}", 100.0 * float(largest[k, j])


def robust(
    curves: Mapping[str, Any], others: Mapping[str, Any], most: float, inverse: float
) -> Said:
    """``most``: the share of designs that is told; ``inverse``: of an apex in inverse
    proportion."""
    here, (name, percent), (paper, paper_percent) = (
        curves["standard"].largest, *(worst(curves[tier].largest) for tier in ("standard", "paper"))
    )  # fmt: skip
    x, y = others["x"], others["y"]
    beyond = [100.0 * float(np.mean(one.max(axis=0) > inverse)) for one in (x, y)]
    half, limit = (
        [100.0 * float(np.quantile(one.max(axis=0), share)) for one in (x, y)]
        for share in (0.5, most)
    )
    apart = 100.0 * np.abs(curves["standard"].relative - curves["reference"].relative)
    x_off, y_off = np.nanmax(apart, axis=(0, 1))
    return Said(
        """(released program) The jump is robust against manufacturing errors: 20 % in a parameter
        moves the apex in proportion, no more (our reading of its test; the paper's text has
        none).""",
        f"""At the test design, errors of up to 20 % move x by at most {ordered(here[:, 0])}; y by
        {ordered(here[:, 1])}. The largest is that of {name}, {percent:.3g} % (paper's settings:
        {paper}, {paper_percent:.2g} %). An apex in inverse proportion to a parameter moves by
        {100 * inverse:g} %: over the paper's ranges {beyond[0]:.0f} % of the designs move more in
        x, {beyond[1]:.0f} % in y. The medians of x are {ordered(np.median(x, axis=1))}; of y
        {ordered(np.median(y, axis=1))}; by the worst parameter half of the designs move by less
        than {half[0]:.2g} % in x and {half[1]:.2g} % in y, {100 * most:g} % by less than
        {limit[0]:.2g} and {limit[1]:.2g} %.""",
        f"""`standard`; its curves against `reference`: changes of x within {x_off:.1g} %, of y
        within {y_off:.1g} % of x and y; curves at `paper` too""",
    )


def text(
    curves: Mapping[str, Any],
    tangents: Mapping[str, Any],
    others: Mapping[str, Any],
    held: Sequence[float],
    secant: float,
) -> str:
    """What is shown, what is found, what differs and why; ``held``: errors at which straight lines
    are compared, ``secant``: of secants."""
    lag, epsilon, mass_bar, mu = BASELINE
    here, first = 100.0 * curves["standard"].largest, NAMES.index("delta_alpha_rad")
    there = {axis: 100.0 * np.median(others[axis][first]) for axis in "xy"}
    fine, secants = curves["reference"], curves["reference"].secants(secant)
    near, middle, far = (100.0 * error for error in held)
    (near_x, near_y), (x, y), (far_x, far_y) = (
        100.0 * fine.deviations(tangents["reference"], error).max(axis=0) for error in held
    )
    wide = 100.0 * fine.deviations(secants, held[-1]).max(axis=0)
    apart = {tier: float(np.abs(exact - secants).max()) for tier, exact in tangents.items()}
    rough = {tier: 100.0 * one.roughness for tier, one in curves.items()}
    return f"""The test design is Δα = {lag:g} rad, ε = {epsilon:g}, m̄ = {mass_bar:g},
        μ = {mu:g}; one parameter at a time is off by up to 20 %, and the relative errors of x and y
        are drawn as the released program's test of imperfections has them. The paper's text says
        nothing of it; what that test is taken to state, that the jump is robust in the sense of the
        table, is our reading.

        The mismatch moves x by at most {here[first, 0]:.2g} % and y by up to {here[first, 1]:.2g} %
        at this design, but x by {there["x"]:.2g} % and y by {there["y"]:.2g} % at the median of
        designs over the paper's ranges: the test design lies where the map folds, x being near its
        largest value for this pre-compression. In general the mass and the pre-compression, which
        are weight and energy, decide about y, and the mismatch acts on x above all.

        The tangents are the simulator's exact sensitivities (with a stick zone of friction of
        {RESOLVED_STICK_ZONE_M_S:g} m/s, which the steps resolve). They are those of discrete steps:
        elasticities at `reference` agree with the secants of {100 * secant:g} % to
        {apart["reference"]:.1g}, those at `standard` to {apart["standard"]:.1g} only, where the
        steps' own error has slopes of its own. Straight lines at `reference` are off by up to
        {near_x:.1g} % of x and {near_y:.1g} % of y at an error of {near:g} %, by {x:.2g} and
        {y:.2g} % at {middle:g} %, and by {far_x:.2g} and {far_y:.2g} % at {far:g} %; secants by
        {wide[0]:.2g} and {wide[1]:.2g} % there. They tell of errors of a few percent,
        no more.

        At the paper's settings neighbouring points scatter: second differences of the curves are
        {rough["paper"]:.2g} % of x in the mean, against {rough["standard"]:.2g} % at `standard`.
        What moves x there from one point to the next is that scatter, more than the error."""
