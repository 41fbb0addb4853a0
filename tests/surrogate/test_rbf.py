"""Interpolation: through its points, and exact for what its polynomial holds."""

import pytest
import torch
from forward_models import jumps

from snapjump.checks import ParameterError
from snapjump.surrogate.base import Rows
from snapjump.surrogate.rbf import RbfOptions


def test_it_passes_through_the_jumps_it_was_given():
    rows = jumps(300)
    network = RbfOptions(neighbours=40).network()
    network.fit(rows)
    assert torch.allclose(network(rows.designs), rows.apexes, atol=1e-4)


def test_what_is_linear_in_its_inputs_is_exact_anywhere():
    def linear(rows: Rows) -> Rows:
        lag, epsilon, mass, mu = rows.designs.T
        x, y = lag + 2.0 * epsilon - mass.log(), 3.0 * mu + mass.log() - lag
        return rows._replace(apexes=torch.stack([x, y], dim=1) / mass[:, None])

    network = RbfOptions(neighbours=30).network()
    network.fit(linear(jumps(300)))
    others = linear(jumps(50, 1))
    assert torch.allclose(network(others.designs), others.apexes, atol=1e-4)


def test_neighbours_in_one_plane_are_told():
    rows = jumps(100)
    rows.designs[:, 3] = 0.3
    network = RbfOptions(neighbours=20).network()
    network.fit(rows)
    with pytest.raises(ParameterError, match=r"surrogate\.neighbours = 20 .* one plane"):
        network(rows.designs)


def test_fewer_points_than_neighbours():
    rows = jumps(20)
    network = RbfOptions().network()
    network.fit(rows)
    assert torch.allclose(network(rows.designs), rows.apexes, atol=1e-4)
