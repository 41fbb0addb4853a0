"""Sensitivities against differences: of the program with frozen steps, and of the adaptive one."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from snapjump.batch import model_derivatives, prepare_designs, simulate_designs
from snapjump.batch.derivatives import places, threshold_slopes
from snapjump.batch.sensitivities import Slopes, apex_sensitivities
from snapjump.batch.thresholds import thresholds
from snapjump.batch.variants import variant
from snapjump.composition import Simulation
from snapjump.declare.inputs import DEFAULT_INPUTS
from snapjump.engine.termination.timed import TimedTermination
from snapjump.scenes.jump_march import jump_march
from snapjump.scenes.jump_start import critical, leading_start, loading_time, start_angle_rad
from snapjump.scenes.march_outputs import side_by_side
from snapjump.scenes.runner import March
from snapjump.scenes.sensitivities import record_sensitivities
from snapjump.statics.threshold import Threshold
from snapjump.statics.threshold_curve import ThresholdCurve

from . import frozen_steps as frozen

# Of the differences: rounding spoils the small one, a kink of the map within reach the large one.
STEPS = (1e-5, 3e-6)
FOURTH_ORDER = ((8.0, 1), (-8.0, -1), (-1.0, 2), (1.0, -2))


def threshold_of(simulation: Simulation, curve: ThresholdCurve) -> Threshold:
    """Its threshold, from the curve where that reaches."""
    return thresholds([simulation], curve)[0] or critical(simulation)


def jump_of(
    base: Simulation,
    design: Any,
    curve: ThresholdCurve,
    inputs: Sequence[str] = DEFAULT_INPUTS,
    snap: tuple[Threshold, float] | None = None,
) -> March:
    """The march of one robot, whose inputs have the values of ``design``; its start is found, so
    long (T) before its threshold if these are given."""
    ready = prepare_designs(base, np.array([design]), curve, inputs)
    (simulation,), (model,) = ready.simulations, ready.models
    if snap is not None:
        start = leading_start(simulation, *snap)
        model = model._replace(clamp=model.clamp._replace(start=start))
    march = jump_march([simulation], [model])
    march.find_starts()
    return march


def differences(jump_at: Any, design: Any, steps: Any, solutions: Any, h: float) -> Any:
    """Derivatives (I, 2) of the apex with frozen steps, by central differences of fourth order.

    ``jump_at``: the march of a design; inputs change by ``h`` of themselves, and so are derivatives
    those by the input over its value.
    """
    rows = []
    for k in range(len(design)):
        total = np.zeros(2)
        for weight, count in FOURTH_ORDER:
            other = np.array(design, dtype=float)
            other[k] += count * h * other[k]
            jump = jump_at(other)
            frozen.exact_jump(jump, steps, solutions)
            total += weight * frozen.apex(jump)
        rows.append(total / (12.0 * h))
    return np.array(rows)


def derivatives(jump: March, numbers: Any, steps: Any, solutions: Any, corrections: int) -> Any:
    """Derivatives (I, 2) that are recorded along the same solutions; ``numbers`` (1, P, I)."""
    flights, grazes = record_sensitivities(jump, numbers, corrections)
    jump.stepping = jump.stepping._replace(
        tolerance=1e9, contact_steps=1e9, newton_share=1e-9, largest=1e9, stick_share=1e30
    )
    jump.termination = TimedTermination(float(np.sum(steps)) * (1.0 - 1e-12))
    frozen.march_along(jump, steps, solutions)
    model = side_by_side(jump.models)
    load, drag = (numbers[:, places(model, family)] for family in ("load", "drag"))
    slopes = Slopes(flights[:, :, : numbers.shape[2]], load, drag, grazes)
    found = apex_sensitivities(frozen.outcome_of(jump), model.load, model.drag, slopes, np.inf)
    return np.vstack([found.dx_bar, found.dy_bar]).T


def frozen_errors(
    base: Simulation,
    design: Any,
    curve: ThresholdCurve,
    corrections: tuple[int, ...],
    inputs: Sequence[str] = DEFAULT_INPUTS,
) -> Any:
    """Largest error of a design's derivatives (C, I), over the largest of x or y, for each number
    of corrections and each input."""

    here = variant(base, design, inputs)
    threshold = threshold_of(here, curve)
    loading = loading_time(here, start_angle_rad(here, threshold), threshold)

    # Along their tangent: computed thresholds are known less well than these differences ask for.
    turned = np.array([threshold_slopes(here, path, curve)[0] for path in inputs])

    def jump_at(values: Any) -> March:
        angle = threshold.alpha_rad + float(turned @ (np.asarray(values) - np.asarray(design)))
        return jump_of(base, values, curve, inputs, (replace(threshold, alpha_rad=angle), loading))

    steps = frozen.adaptive_steps(jump_at(design))
    solutions = frozen.exact_jump(jump_at(design), steps)
    expected = [differences(jump_at, design, steps, solutions, h) for h in STEPS]
    scale = np.abs(expected[0]).max(axis=0)
    numbers = model_derivatives(base, np.array([design]), curve, inputs)
    errors = []
    for count in corrections:
        found = derivatives(jump_at(design), numbers, steps, solutions, count)
        found *= np.asarray(design)[:, None]
        both = [np.abs(found - one) / scale for one in expected]
        errors.append(np.min(both, axis=0).max(axis=1))
    return np.array(errors)


def plain_errors(base: Simulation, designs: Any, h: float) -> dict[str, Any]:
    """Sensitivities against central differences of whole adaptive jumps, h either way."""
    table = np.asarray(designs, dtype=float)
    curve = ThresholdCurve.over(base.robot, base.discretization, table[:, 1])
    batch = simulate_designs(base, table, curve=curve, sensitivities=True)
    found = batch.sensitivities
    assert found is not None
    errors = []
    for k in range(4):
        moved = []
        for sign in (1.0, -1.0):
            other = table.copy()
            other[:, k] += sign * h
            there = simulate_designs(base, other, curve=curve)
            moved.append(np.array([there.x_bar, there.y_bar]))
        difference = (moved[0] - moved[1]) / (2.0 * h)
        errors.append(np.abs(difference - np.array([found.dx_bar[:, k], found.dy_bar[:, k]])))
    sizes = np.array([np.abs(found.dx_bar).max(axis=1), np.abs(found.dy_bar).max(axis=1)])
    relative = np.max(np.array(errors) / sizes, axis=0)  # (2, R)
    return {
        f"{name}_relative_error": {
            "median": round(float(np.nanmedian(values)), 4),
            "quartile": round(float(np.nanquantile(values, 0.25)), 4),
            "three_quarters": round(float(np.nanquantile(values, 0.75)), 4),
        }
        for name, values in zip(("x", "y"), relative, strict=True)
    } | {"designs": len(table), "h": h, "not_differentiable": int((~found.differentiable).sum())}
