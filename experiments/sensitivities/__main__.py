"""``python -m experiments.sensitivities`` prints one JSON object.

``frozen``: the recorded derivatives against central differences of the same program with frozen
steps, every stage solved to rounding by a Jacobian that nothing is left out of; on a coarse mesh,
with friction smooth enough that differences have a limit (its kinks at the tiers' 1e-3 m/s lie
nearer than rounding lets differences go). ``corrected``: the same of elements whose matrix lacks
something, by the number of corrections. ``plain``: against differences of adaptive jumps, whose
roughness is no part of derivatives, for stick zones of friction that steps resolve more and less
well. ``cost``: time with sensitivities over time without.
"""

import statistics
import sys
from dataclasses import replace
from typing import Any

import numpy as np

from snapjump.batch import simulate_designs
from snapjump.composition import Simulation, with_tier
from snapjump.discretization.corotational import Corotational
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.friction.implicit import ImplicitFriction
from snapjump.integrator.generalized_alpha import GeneralizedAlpha
from snapjump.statics.threshold_curve import ThresholdCurve
from snapjump.stepping.adaptive import AdaptiveStep

from ..command import measured
from ..designs import spread_designs
from ..errors import relative_errors
from .agreement import frozen_errors, plain_errors

CORRECTIONS = (1, 2, 3)
RESOLVED_M_S = 1e-2
COARSE = with_tier(
    "draft",
    discretization=DiscreteElasticRod(16),
    integrator=GeneralizedAlpha(spectral_radius=0.0),
    stepping=AdaptiveStep(2e-5, 2.0, 16.0),
    friction=ImplicitFriction(velocity_threshold_m_s=1.0),
)


def with_frozen_steps(
    base: Simulation, count: int, corrections: tuple[int, ...] = (1,)
) -> dict[str, Any]:
    """Errors over designs, by the number of corrections."""
    curve = ThresholdCurve.through(base.robot, base.discretization, 0.09, 0.31)
    errors, unsolved = [], 0
    for k, design in enumerate(spread_designs(count)):
        print(f"design {k + 1} of {count} ...", file=sys.stderr)
        try:
            errors.append(frozen_errors(base, design, curve, corrections).max(axis=1))
        except ArithmeticError:  # Newton's method went to and fro: nothing to compare with
            unsolved += 1
    table = np.array(errors)
    return {
        "designs": len(table),
        "unsolved": unsolved,
        "within_1e-5": int((table[:, -1] < 1e-5).sum()),
        **{
            f"corrections_{n}": {
                "median": float(f"{np.median(column):.2g}"),
                "95_percent": float(f"{np.quantile(column, 0.95):.2g}"),
                "largest": float(f"{column.max():.2g}"),
            }
            for n, column in zip(corrections, table.T, strict=True)
        },
    }


def sticking(tier: str, zone: float) -> Simulation:
    """A tier with another velocity threshold of friction (m/s)."""
    return with_tier(tier, friction=ImplicitFriction(velocity_threshold_m_s=zone))


def moved(zone: float, designs: Any) -> dict[str, float]:
    """Change of the apex (percent) by another velocity threshold than the usual one."""
    here = simulate_designs(with_tier("standard"), designs)
    there = simulate_designs(sticking("standard", zone), designs)
    of_x, _ = relative_errors(there.x_bar, there.y_bar, here.x_bar, here.y_bar)
    return {
        "x_median_percent": round(float(np.nanmedian(of_x)), 3),
        "x_95_percent": round(float(np.nanquantile(of_x, 0.95)), 3),
    }


def cost(base: Simulation, count: int, repeats: int) -> dict[str, float]:
    """Kernel time of a batch on one core, with and without, one after the other."""
    designs = np.array(spread_designs(count))
    curve = ThresholdCurve.over(base.robot, base.discretization, designs[:, 1])
    milliseconds: dict[bool, list[float]] = {False: [], True: []}
    for wanted in (False, True):
        simulate_designs(base, designs[:1], curve=curve, threads=1, sensitivities=wanted)
    for _ in range(repeats):
        for wanted, times in milliseconds.items():
            batch = simulate_designs(base, designs, curve=curve, threads=1, sensitivities=wanted)
            times.append(1e3 * batch.march_seconds / count)
    ratios = [b / a for a, b in zip(milliseconds[False], milliseconds[True], strict=True)]
    return {
        "plain_ms": round(statistics.median(milliseconds[False]), 3),
        "with_sensitivities_ms": round(statistics.median(milliseconds[True]), 3),
        "ratio": round(statistics.median(ratios), 3),
    }


def report(frozen: int = 64, designs: int = 64, repeats: int = 3) -> dict[str, Any]:
    """All of it; ``frozen``: so many designs with frozen steps, of the others ``designs``."""
    spread = spread_designs(designs)
    found: dict[str, Any] = {
        "cost": {
            name: cost(sticking(name, RESOLVED_M_S), designs, repeats)
            for name in ("draft", "standard")
        },
        "plain": {
            f"{zone:g}_m_s": plain_errors(sticking("standard", zone), spread, 1e-3)
            for zone in (5e-3, 1e-2, 1e-1)
        },
        "moved": {f"{zone:g}_m_s": moved(zone, spread) for zone in (1e-4, 1e-2, 1e-1)},
    }
    if frozen:
        turning = replace(COARSE, discretization=Corotational(16))
        found["frozen"] = with_frozen_steps(COARSE, frozen)
        found["corrected"] = with_frozen_steps(turning, frozen, CORRECTIONS)
    return found


if __name__ == "__main__":
    measured(report)
