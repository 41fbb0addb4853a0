"""Apexes of designs that are off by some percent, and the exact sensitivities of the apex."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from scipy.stats.qmc import Sobol

from experiments.compositions import composed
from experiments.paper.settings import BASELINE, NAMES, RANGES
from snapjump.batch import simulate_designs
from snapjump.plan.base import stretched
from snapjump.run.studies.base import Row
from snapjump.targets.simulator import JumpSimulator, differentiable


def imperfection_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """The rows of a cell, by the ``kind`` of its inputs."""
    kinds = {"curves": curves, "slopes": slopes, "elsewhere": elsewhere}
    return kinds[inputs["kind"]](inputs)


def apexes_of(groups: Mapping[str, Any], designs: Any) -> Any:
    """Apexes (R, 2), NaN where the robot does not jump."""
    return simulate_designs(composed(groups), designs, threads=2, lanes=8).apexes


def curves(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each parameter and factor of it, about the test design."""
    cases = [(k, factor) for k in range(len(NAMES)) for factor in inputs["factors"]]
    designs = np.tile(BASELINE, (len(cases), 1))
    for design, (k, factor) in zip(designs, cases, strict=True):
        design[k] *= factor
    apexes = apexes_of(inputs["groups"], designs)
    return [
        {"parameter": NAMES[k], "factor": factor, "x_bar": float(x), "y_bar": float(y)}
        for (k, factor), (x, y) in zip(cases, apexes, strict=True)
    ]


def slopes(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each parameter: exact elasticities of x and y, of the jump with a stick zone that
    the steps resolve."""
    design = np.array([BASELINE])
    simulator = JumpSimulator(composed(inputs["groups"]))
    exact = simulator.slopes(design)[0]
    (apex,) = JumpSimulator(differentiable(simulator.base)).apexes(design)
    elasticities = exact * design / apex[:, None]
    return [
        {"parameter": name, "x_elasticity": float(x), "y_elasticity": float(y)}
        for name, (x, y) in zip(NAMES, elasticities.T, strict=True)
    ]


def elsewhere(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each of ``designs`` designs over the paper's ranges, each parameter and factor."""
    unit = Sobol(4, rng=inputs["seed"]).random(inputs["designs"])
    nominal = stretched(unit, tuple(RANGES[name] for name in NAMES))
    cases = [
        (n, k, factor)
        for n in range(len(nominal))
        for k in range(len(NAMES))
        for factor in inputs["factors"]
    ]
    designs = np.array([nominal[n] for n, _, _ in cases])
    for design, (_, k, factor) in zip(designs, cases, strict=True):
        design[k] *= factor
    right = apexes_of(inputs["groups"], nominal)
    wrong = apexes_of(inputs["groups"], designs)
    return [
        {
            "design": n,
            **dict(zip(NAMES, nominal[n].tolist(), strict=True)),
            "parameter": NAMES[k],
            "factor": factor,
            "x_change": float(wrong[row, 0] / right[n, 0] - 1.0),
            "y_change": float(wrong[row, 1] / right[n, 1] - 1.0),
            "moved": float(np.hypot(*(wrong[row] - right[n])) / np.hypot(*right[n])),
        }
        for row, (n, k, factor) in enumerate(cases)
    ]
