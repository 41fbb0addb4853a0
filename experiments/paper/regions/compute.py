"""The rectangle of controls, simulated in one environment and asked of the forward model."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from experiments.compositions import composed
from experiments.paper.learned import shipped_forward
from experiments.paper.settings import RANGES
from snapjump.batch import simulate_designs
from snapjump.run.studies.base import Row


def region_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each of ``points``^2 designs, delta_alpha along the slow axis: simulated apex, null
    where the robot does not jump, and predicted apex."""
    controls = [
        np.linspace(*RANGES[name], inputs["points"]) for name in ("delta_alpha_rad", "epsilon")
    ]
    grid = np.stack(np.meshgrid(*controls, indexing="ij"), axis=-1).reshape(-1, 2)
    rest = np.broadcast_to([inputs["mass_bar"], inputs["mu"]], (len(grid), 2))
    designs = np.hstack([grid, rest])
    batch = simulate_designs(composed(inputs["groups"]), designs, threads=2, lanes=8)
    predicted = shipped_forward().predict(designs)
    return [
        {
            "delta_alpha_rad": float(design[0]),
            "epsilon": float(design[1]),
            "x_bar": float(x) if np.isfinite(x) else None,
            "y_bar": float(y) if np.isfinite(y) else None,
            "predicted_x_bar": float(apex[0]),
            "predicted_y_bar": float(apex[1]),
        }
        for design, (x, y), apex in zip(designs, batch.apexes, predicted, strict=True)
    ]
