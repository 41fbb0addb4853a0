"""Forward models that have learned nothing, of the small datasets' physical model."""

from typing import Any

import numpy as np
import torch
from small_datasets import small

from snapjump.declare.members import make_member
from snapjump.surrogate.base import Rows, Surrogate

RANGES = [[0.01, 0.19], [0.1, 0.3], [0.3, 2.0], [0.1, 0.6]]
RESNET = {"name": "resnet", "width": 16, "blocks": 1}
RBF = {"name": "rbf", "neighbours": 20, "kernel": "cubic", "smoothing": 0.0}


def law(designs: Any) -> tuple[Any, Any]:
    """Apexes (N, 2) by a smooth made-up law, and their exact slopes (N, 2, 4)."""
    lag, epsilon, mass, mu = designs.T
    sine, cosine = np.sin(10.0 * lag), 10.0 * np.cos(10.0 * lag)
    x = 8.0 * epsilon * sine * mu / mass
    y = 50.0 * epsilon / mass - sine * mu
    slopes_x = [8.0 * epsilon * cosine * mu / mass, x / epsilon, -x / mass, x / mu]
    slopes_y = [-cosine * mu, 50.0 / mass, -50.0 * epsilon / mass**2, -sine]
    slopes = np.stack([np.stack(slopes_x, axis=1), np.stack(slopes_y, axis=1)], axis=1)
    return np.stack([x, y], axis=1), slopes


def jumps(count: int, seed: int = 0) -> Rows:
    """Designs in the paper's ranges that jump by the law."""
    low, high = np.array(RANGES).T
    designs = low + (high - low) * np.random.default_rng(seed).random((count, 4))
    return Rows(*(torch.tensor(part, dtype=torch.float32) for part in (designs, *law(designs))))


def network(group: dict[str, Any] = RESNET, seed: int = 0) -> Surrogate:
    """A network that has its standardisation, and weights by chance."""
    torch.manual_seed(seed)
    made: Surrogate = make_member("surrogate", group).network()
    made.fit(jumps(200, seed))
    return made.eval()


def about(group: dict[str, Any] = RESNET) -> dict[str, Any]:
    """What a checkpoint says of it, as far as the forward model needs it."""
    dataset = {"sha256": "0" * 64, "specification": dict(small().plain)}
    return {"surrogate": group, "ranges": RANGES, "dataset": dataset}
