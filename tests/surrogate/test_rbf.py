"""Interpolation: through its points, and exact for what its polynomial holds."""

import pytest
import torch
from forward_models import jumps

from snapjump.checks import ParameterError
from snapjump.surrogate.base import Rows, Surrogate
from snapjump.surrogate.rbf import RbfOptions


def fitted(rows: Rows, **options: int) -> Surrogate:
    network = RbfOptions(**options).network()
    network.fit(rows)
    return network


@pytest.mark.parametrize(("count", "options"), [(300, {"neighbours": 40}), (20, {})])
def test_it_passes_through_the_jumps_it_was_given(count, options):
    """Also where there are fewer of them than neighbours."""
    rows = jumps(count)
    network = fitted(rows, **options)
    assert torch.allclose(network(rows.designs), rows.apexes, atol=1e-4)


def test_what_is_linear_in_its_inputs_is_exact_anywhere():
    def linear(rows: Rows) -> Rows:
        lag, epsilon, mass, mu = rows.designs.T
        x, y = lag + 2.0 * epsilon - mass.log(), 3.0 * mu + mass.log() - lag
        return rows._replace(apexes=torch.stack([x, y], dim=1) / mass[:, None])

    network = fitted(linear(jumps(300)), neighbours=30)
    others = linear(jumps(50, 1))
    assert torch.allclose(network(others.designs), others.apexes, atol=1e-4)


def test_neighbours_in_one_plane_are_told():
    rows = jumps(100)
    rows.designs[:, 3] = 0.3
    network = fitted(rows, neighbours=20)
    with pytest.raises(ParameterError, match=r"surrogate\.neighbours = 20 .* one plane"):
        network(rows.designs)
