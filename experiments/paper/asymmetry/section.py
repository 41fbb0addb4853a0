"""The section on the tilt against the mismatch: text, figure, tables."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from functools import partial

from experiments.paper.asymmetry.figure import draw_asymmetry
from experiments.paper.asymmetry.saturation import (
    FITTED_UPTO_RAD,
    FLAT_FROM,
    LINEAR_WITHIN,
    Saturation,
)
from experiments.paper.baseline import RANGES
from snapjump.studies.base import Figure, Row, Section, Table

TITLE = "How asymmetric a snap becomes"
SHOWN = (0.01, 0.1, 0.2, 0.4)  # rad


def make_section(
    sweeps: Mapping[str, Mapping[float, Sequence[Row]]],
    found: Mapping[str, Mapping[float, Saturation]],
    upto_rad: float,
) -> Section:
    """Text, the figure, the laws and some of the snaps."""
    misfit = max(one.misfit for laws in found.values() for one in laws.values())
    own = found["standard"]
    far = max(one.threshold_rad for one in own.values())
    faster, freely = (
        [found[setting][epsilon].slope / own[epsilon].slope for epsilon in own]
        for setting in ("paper", "undamped")
    )
    lags = sorted(row["delta_alpha_rad"] for row in sweeps["standard"][min(own)])
    first = min(own)
    later, same = with_vibration(sweeps["standard"][first])
    return Section(
        TITLE,
        [
            "The same snaps at three pre-compressions and at mismatches from "
            f"{lags[0]:g} to {lags[-1]:g} rad. θ_max is the largest absolute tangent angle at the "
            "midpoint until the snap ends.",
            "The threshold is found by fitting θ_max = slope · Δα / √(1 + (Δα / threshold)²) to "
            f"all mismatches up to {FITTED_UPTO_RAD:g} rad, by logarithms: that is how the "
            "amplitude of an unstable mode with a cubic limit depends on where it started. No snap "
            f"is farther than {100.0 * misfit:.1f} % from it. For comparison the threshold is also "
            f"taken as θ_max at {FITTED_UPTO_RAD:g} rad over the mean slope of the smallest.",
            "Every design in the paper's range of mismatches, shaded, snaps beyond the threshold, "
            f"by a factor of {RANGES['delta_alpha_rad'][0] / far:.0f} at least. What the mismatch "
            "still changes there is the tilt at rest, and when the snap happens.",
            f"At the paper's settings the slope is {min(faster):.1f} to {max(faster):.1f} times "
            "that of the converged model, without damping "
            f"{min(freely):.1f} to {max(freely):.1f} times. Kelvin-Voigt damping resists bending "
            "as such, and so holds back the asymmetric mode whose net stiffness is lost. The "
            "damping of implicit Euler goes with the net stiffness: it stills vibrations, but does "
            "not slow down what buckles. How the slope depends on the rate of the clamps: the "
            "section on symmetric and asymmetric snaps.",
            "If the vibration after the snap is counted as well (`theta_later_rad`), the slope at "
            f"ε = {first:g} is {later:.0f} instead of {own[first].slope:.0f} and the angles from "
            f"{FITTED_UPTO_RAD:g} rad on {'are the same' if same else 'differ'}. Without damping "
            "the vibration goes on, and its largest angle depends on the finest detail.",
        ],
        figures={
            "asymmetry": Figure(
                "θ_max against the mismatch: left with the paper's range shaded, and dash-dotted "
                "what is left without the tilt at rest; right by logarithms, the law at standard "
                "drawn thin, its threshold marked on it",
                partial(draw_asymmetry, sweeps, found["standard"]),
            )
        },
        tables={
            "saturation": Table(
                "Slope, level and threshold of the law; how far it is linear (within "
                f"{100.0 * LINEAR_WITHIN:g} %); how the level rises from {FLAT_FROM:g} thresholds "
                f"to {upto_rad:g} rad",
                [
                    {"setting": setting, "epsilon": epsilon, **asdict(one)}
                    for setting, laws in found.items()
                    for epsilon, one in laws.items()
                ],
                digits=dict.fromkeys(Saturation.__dataclass_fields__, 3),
            ),
            "snap_sweep": Table(
                "Some of the snaps at standard",
                [
                    {"epsilon": epsilon, **row}
                    for epsilon, rows in sweeps["standard"].items()
                    for row in rows
                    if row["delta_alpha_rad"] in SHOWN
                ],
            ),
        },
    )


def with_vibration(rows: Sequence[Row]) -> tuple[float, bool]:
    """The slope of the smallest mismatch with the vibration after the snap, and whether that adds
    nothing to the angles of larger ones."""
    smallest = min(rows, key=lambda row: row["delta_alpha_rad"])
    large = [row for row in rows if row["delta_alpha_rad"] >= FITTED_UPTO_RAD]
    return (
        float(smallest["theta_later_rad"] / smallest["delta_alpha_rad"]),
        all(row["theta_later_rad"] == row["theta_max_rad"] for row in large),
    )
