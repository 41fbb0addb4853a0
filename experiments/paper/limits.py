"""Every verdict's limit: what decides on a statement, up to where, and whose limit that is.

A key is that of a statement, or that and the aspect of it that is measured. Limits of ours say
what still counts as linear, flat or alike; they may be tightened, and never loosened.
"""

import math
from typing import NamedTuple

from experiments.paper.base import Row, verdict


class Limit(NamedTuple):
    """``confirmed``: the most (with ``at_least`` the least) that what is measured may be if the
    statement is confirmed, ``within``: if it is confirmed within a limit; ``of``: what is measured,
    and its unit; ``source``: the paper's words, or why it is ours."""

    confirmed: float
    within: float
    of: str
    source: str
    at_least: bool = False

    def holds(self, value: float, limit: float) -> bool:
        """Whether a value keeps one of the two; NaN keeps none."""
        return value >= limit if self.at_least else value <= limit


ANY = math.inf  # what a statement may still be confirmed within a limit with
NONE = -math.inf  # the same of what has to be at least something
LEAST = True

# fmt: off
LIMITS: dict[str, Limit] = {
    "bifurcation.snap.arches": Limit(1, 1 / 3,
        "share of the arches that snap to a stable state of less energy, and stay there",
        'paper: "quickly transitions to the opposite stable state"; ours: at every ε tried, or '
        "at one of three", LEAST),
    "bifurcation.snap.loop": Limit(0.5, 0.5, "width of the loop (% of the critical angle)",
        "ours: the error that `standard` promises of a jump; a narrower loop is none", LEAST),
    "bifurcation.snap.angle": Limit(0.5, ANY,
        "difference of the critical angle from the exact elastica's (%)",
        "ours: the error that `standard` promises of a jump"),
    "bifurcation.growth": Limit(0, ANY, "steps of ε at which the angle does not grow",
        "ours: from ε = 0.01 on"),
    "bifurcation.growth.range": Limit(0, 0, "the same over the paper's range of ε",
        "paper: ε in [0.1, 0.3]"),
    "bifurcation.fold": Limit(1, 1 / 16, "share of the pre-compressions at which the fold is first",
        "ours: at all, or at one of 16", LEAST),
    "bifurcation.fold.error": Limit(3, 3,
        "times the error of the angle, up to which the fold is no later",
        "ours: a larger difference is the arch's, and not the mesh's"),
    "bifurcation.nodes": Limit(0.5, 5.0,
        "error of what the paper's 100 nodes give, against the exact elastica (%)",
        'paper: "to ensure numerical convergence and accuracy"; ours: the error that `standard` '
        "promises of a jump, and what still serves for estimates"),
    "bifurcation.nodes.step": Limit(0.5, 5.0,
        "shift of the snap's angle by the paper's step of 1 ms, at 20 rad/s (%)", "the same"),
    "released_energy.linear": Limit(1.0, 5.0,
        "deviation from a straight line over the paper's range (% of the value)",
        'paper: "such relation is linear"; ours: not to be seen in a figure, and of use for '
        "estimates"),
    "released_energy.heights.converged": Limit(1.0, ANY,
        "error of the polynomials against the converged arch (%)",
        "ours: the 1 % that the released program adds to its h1"),
    "released_energy.heights.own_mesh": Limit(ANY, 2.0,
        "the same against the arch on the program's own mesh (%)",
        "ours: twice as much, its fit to single runs included"),
    "snaps.symmetry.equal": Limit(1e-06, 1e-06,
        "tilt with equal clamps, as a share of that with the mismatch",
        'paper: "symmetrical when θ_max = 0"; ours: what rounding leaves'),
    "snaps.symmetry.mismatched": Limit(math.radians(1.0), math.radians(1.0),
        "tilt with the mismatch (rad)",
        'paper: "asymmetrical when θ_max ≠ 0"; ours: 1°, which one sees', LEAST),
    "snaps.symmetry.mismatch": Limit(math.radians(0.1), NONE,
        "least mismatch that tilts a snap visibly, over all rates (rad)",
        "ours: a tenth of a degree, about the best that clamps are set equal by hand", LEAST),
    "asymmetry.linear.exponent": Limit(0.02, 0.02,
        "the tilt's exponent in the smallest mismatch, less one",
        'paper: "a linear increase for smaller δα"; ours: to the digits that are told'),
    "asymmetry.linear.deviation": Limit(0.05, 0.05,
        "share by which a tilt falls behind the line where the line ends",
        "ours: as in released_energy.linear, within a limit"),
    "asymmetry.linear.range": Limit(10.0, 10.0, "length of the line, in smallest mismatches",
        "ours: a line that is seen over less than a decade is none", LEAST),
    "asymmetry.linear.designs": Limit(0.01, NONE, "mismatch up to which the tilt is linear (rad)",
        "paper: δα in [0.01, 0.19], so that a design is on the line", LEAST),
    "asymmetry.saturation": Limit(0.05, 0.3, "growth from ten thresholds to 0.2 rad, as a share",
        'paper: "minimal influence"; ours: flat, and broken off, where the mismatch grows '
        "twentyfold"),
    "trajectories.types.vertical": Limit(0.01, 0.01,
        "distance of the apex from the vertical without a mismatch (share of its height)",
        'paper: "perpendicular to the rigid substrate"; ours: to a hundredth'),
    "trajectories.tuned.back": Limit(0.02, ANY,
        "largest way back of x_c/y_c, as a share of its growth",
        "ours: the curves' own numerical error is below it"),
    "trajectories.tuned.horizontal": Limit(45.0, NONE,
        "largest lean at lift-off over the paper's ranges (degrees)",
        'paper: "e.g., horizontal or vertical"; ours: half-way between the two', LEAST),
    "trajectories.tuned.oblique": Limit(5.0, 5.0,
        "largest lean at lift-off of the baseline (degrees)",
        'paper: "oblique to the rigid substrate"; ours: a slant that is seen, and carries the '
        "robot over half its length and more", LEAST),
    "trajectories.types.inclined": Limit(0.01, 0.01,
        "least distance of an apex with a mismatch from the vertical (share of its height)",
        'paper: "oblique to the rigid substrate"; ours: what is not vertical', LEAST),
    "influences.below_h1": Limit(0.03, 0.1,
        "deviation of the apex below h1 from that at h1 (share; within a limit: of y_c alone)",
        'paper: "relatively constant"; ours: constant, and about so'),
    "influences.best": Limit(0.01, 0.03,
        "how much higher the robot jumps with its mounts at another height than h1 (share)",
        'paper: "the best height", "an optimal height design, h = h₁"; ours: a hundredth, and '
        "what is still constant below h1"),
    "influences.decline": Limit(0.02, 0.2,
        "largest way back of x_c and y_c, as a share of their decline",
        'paper: "starts to decrease"; ours: none, and with waves that `reference` has too'),
    "influences.beyond_h2.rise": Limit(0.05, ANY, "rise of the centre of mass from h2 on (L)",
        'paper: "the robot fails to jump"; ours: ten times the recoil of a snap that strikes '
        "nothing"),
    "influences.beyond_h2.last": Limit(ANY, 0.025, "height of the last jump beyond h2 (L)",
        "paper: the barrier's d̃ = 0.5 mm, by which it blurs the ground"),
    "influences.monotone": Limit(0.02, 0.1,
        "largest way back of a curve that runs one way, as a share of its change",
        'paper: "monotonically"; ours: none, and with waves'),
    "influences.levelling": Limit(0.2, 0.2, "slope beyond a threshold, as a share of that before",
        'paper: "until they plateau"; ours: a bend that is seen'),
    "influences.plateau": Limit(0.05, 0.1, "swing of a plateau, as a share of its level",
        'paper: "until they plateau"; ours: flat, and a twentieth of its level either way for '
        "one coordinate at least"),
    "influences.friction_height": Limit(0.02, 0.1, "range of y_c, as a share of its mean",
        'paper: "does not affect"; ours: constant, and about so'),
    "causes.negligible": Limit(1.0, ANY,
        "shift of 95 % of the apexes (%), by which a choice does not matter",
        "ours: below the errors of the physical model, which are 1 to 20 %"),
    "causes.small": Limit(ANY, 5.0,
        "median shift of the apexes (%), by which a choice does not matter much",
        "ours: beyond it conclusions from the jumps may change"),
    "causes.smooth": Limit(0.0, 0.0, "leap of the friction at ε_v, over μ N",
        'paper: "making the transition from static to sliding friction differentiable"'),
    "causes.stability": Limit(0.0, 0.01, "jumps that fail (share)",
        'paper: "simplicity and robustness"; ours: none, and one in a hundred'),
    "regions.mass.area": Limit(0, 0, "steps of the mass at which the area does not fall",
        "ours: at every step"),
    "regions.mass.extent": Limit(0, ANY, "steps of the mass at which width or height do not fall",
        "ours: at every step"),
    "regions.friction.wider": Limit(0, 0,
        "steps of the friction at which the largest x does not grow",
        "ours: at every step"),
    "regions.friction.saturated": Limit(3, 1, "heights of three at which the width saturates",
        "ours: at all, or at one", LEAST),
    "regions.friction.share": Limit(0.8, 0.8,
        "share of the widening that the lower half of the frictions has done if it saturates",
        "ours: more than a curve without a bend has done by then", LEAST),
    "regions.friction.heights": Limit(0.05, 0.2,
        "change of the least and the largest y over all frictions (share)",
        'paper: "does not affect" y_c; ours: alone, and little beside the widths'),
    "designs.millimetres.mean": Limit(2.9, 2.9, "mean miss of a method at a tier (mm)",
        'paper: "an average error of 0.0029 m"'),
    "designs.millimetres.largest": Limit(10.0, ANY, "largest miss of a method at a tier (mm)",
        'paper: "millimeter-scale error"; ours: none of a centimetre'),
    "imperfections.robust.design": Limit(0.2, 0.25,
        "change of x or y of the test design by an error of 20 % (share)",
        "ours: in proportion, and in inverse proportion, as heights go with the mass"),
    "imperfections.robust.most": Limit(0.25, ANY, "the same of 95 % of the designs",
        "ours: in inverse proportion"),
    "imperfections.robust.half": Limit(0.4, 0.4, "the same of half of the designs",
        "ours: magnified twofold, beyond which the test design tells nothing of others"),
    "forward_model.real_time": Limit(1.0, 1.0,
        "most that one core takes for a jump, over how long it lasts to its apex",
        'paper: "can perform real-time simulations"'),
    "forward_model.real_time.liftoff": Limit(1.0, ANY,
        "the same over how long it lasts to lift-off",
        "ours: only that far it is simulated, and then a parabola"),
    "forward_model.dataset.jumps": Limit(50_625, NONE, "jumps that succeed",
        'paper: "a total of 50,625 training samples"', LEAST),
    "forward_model.dataset.time": Limit(1.0, 2.0,
        "core seconds of the dataset, in the paper's thread seconds",
        'paper: "approximately 4 hours of computing time on an Intel i9-12900H processor", which '
        "has 20 threads"),
    "forward_model.error": Limit(0.07, 0.14, "mean absolute error (L)",
        'paper: "an MAE of less than 7×10⁻²"; ours: twice'),
    "forward_model.accuracy": Limit(2.9, 5.8, "mean miss of random targets (mm)",
        'paper: "an average error of 0.0029 m and a standard deviation of 0.0025 m"; ours: twice'),
    "forward_model.time": Limit(0.33, 0.66, "mean time of a design by the forward model (s)",
        'paper: "the average computation time for our proposed strategy is 0.33 s"; ours: twice'),
    "forward_model.plan.time": Limit(0.5, 1.0, "the same (s)",
        'paper: "in less than 0.5 s"; ours: twice'),
    "forward_model.plan.miss": Limit(10.0, 10.0, "mean miss of random targets (mm)",
        'paper: "millimeter-scale error"; ours: less than a centimetre'),
    "forward_model.speed": Limit(1.0, 0.5,
        "ratio of a search on the simulator to a design, as a share of the paper's ratio",
        "paper: 513 s and 1,129 s to 0.33 s, in a table of another version; ours: half", LEAST),
}
# fmt: on


def judged(key: str, *values: float) -> str:
    """The verdict by one limit, on the worst of the values: what is not within it is not confirmed,
    also where any value would do for the rest."""
    limit = LIMITS[key]
    within = all(limit.holds(value, limit.within) for value in values)
    return verdict(within and all(limit.holds(value, limit.confirmed) for value in values), within)


def limit_rows() -> list[Row]:
    """The table of limits."""

    def told(limit: Limit, value: float) -> str:
        words = "at least" if limit.at_least else "at most"
        return f"{words} {value:.4g}" if math.isfinite(value) else "any"

    return [
        {
            "of": f"`{key}`",
            "what is measured": limit.of,
            "confirmed": told(limit, limit.confirmed),
            "within a limit": told(limit, limit.within),
            "source": limit.source,
        }
        for key, limit in LIMITS.items()
    ]
