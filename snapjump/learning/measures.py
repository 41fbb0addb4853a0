"""Errors of a forward model on jumps that it has not seen."""

from typing import Any

import numpy as np
import torch
from torch import Tensor

from snapjump.arrays import Array
from snapjump.dataset.columns import APEX
from snapjump.learning.data import WHOLE
from snapjump.surrogate.base import Rows, Surrogate


def errors(network: Surrogate, rows: Rows) -> Array:
    """Predicted less simulated apexes (N, 2), in L."""
    with torch.inference_mode():
        found = torch.cat([network(part) for part in rows.designs.split(WHOLE)])
        return (found.double() - rows.apexes).numpy()


def measures(network: Surrogate, rows: Rows) -> dict[str, float]:
    """Flat numbers, in L: MAE as the paper measures it (both outputs averaged), root mean squares,
    medians and 95th percentiles of the absolute errors; of networks that have intervals, the share
    of apexes inside and the mean half width."""
    error = errors(network, rows)
    off = np.abs(error)
    found: dict[str, Any] = {"mae_bar": off.mean()}
    for i, name in enumerate(APEX):
        found[f"mae_{name}"] = off[:, i].mean()
        found[f"rms_{name}"] = np.sqrt((error[:, i] ** 2).mean())
        found[f"median_{name}"] = np.median(off[:, i])
        found[f"p95_{name}"] = np.quantile(off[:, i], 0.95)
    found["p95_bar"] = np.quantile(off, 0.95)
    half_widths = intervals(network, rows.designs)
    if half_widths is not None:
        inside = off <= half_widths.double().numpy()
        found |= {
            "coverage": inside.mean(),
            "coverage_x": inside[:, 0].mean(),
            "coverage_y": inside[:, 1].mean(),
            "half_width_bar": float(half_widths.mean()),
        }
    return {key: float(value) for key, value in found.items()}


def intervals(network: Surrogate, designs: Tensor) -> Tensor | None:
    """Half widths (N, 2) of 90 % intervals, or None."""
    with torch.inference_mode():
        found = [network.half_widths(part) for part in designs.split(WHOLE)]
    known = [part for part in found if part is not None]
    return torch.cat(known) if known else None
