"""Forward models that have learned nothing, of the small datasets' physical model."""

from typing import Any

import torch
from small_datasets import small

from snapjump.members import make_member
from snapjump.surrogate.base import Rows, Surrogate

RANGES = [[0.01, 0.19], [0.1, 0.3], [0.3, 2.0], [0.1, 0.6]]
RESNET = {"name": "resnet", "width": 16, "blocks": 1}


def jumps(count: int, seed: int = 0) -> Rows:
    """Designs in the paper's ranges, and apexes by a smooth made-up law with exact slopes."""
    unit = torch.rand((count, 4), generator=torch.Generator().manual_seed(seed), dtype=torch.double)
    low, high = torch.tensor(RANGES, dtype=torch.double).T
    designs = low + (high - low) * unit
    lag, epsilon, mass, mu = designs.T
    lean = torch.sin(10.0 * lag) * mu
    apexes = torch.stack([8.0 * epsilon * lean / mass, 50.0 * epsilon / mass - lean], dim=1)
    zero, slope = torch.zeros_like(lag), 10.0 * torch.cos(10.0 * lag) * mu
    x, sine = apexes[:, 0], torch.sin(10.0 * lag)
    slopes = torch.stack(
        [
            torch.stack([8.0 * epsilon * slope / mass, x / epsilon, -x / mass, x / mu], dim=1),
            torch.stack([-slope, 50.0 / mass, -50.0 * epsilon / mass**2 + zero, -sine], dim=1),
        ],
        dim=1,
    )
    return Rows(designs.float(), apexes.float(), slopes.float())


def network(group: dict[str, Any] = RESNET, seed: int = 0) -> Surrogate:
    """One that has its standardisation, and weights by chance."""
    torch.manual_seed(seed)
    made: Surrogate = make_member("surrogate", group).network()
    made.fit(jumps(200, seed))
    return made.eval()


def about(group: dict[str, Any] = RESNET) -> dict[str, Any]:
    """What a checkpoint says of it, as far as the forward model needs it."""
    specification = dict(small().plain)
    return {
        "surrogate": group,
        "ranges": RANGES,
        "dataset": {"sha256": "0" * 64, "specification": specification},
    }
