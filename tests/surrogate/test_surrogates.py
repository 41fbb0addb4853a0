"""What every surrogate has in common, member by member."""

import pytest
import torch
from forward_models import jumps

from snapjump.declare.members import make_member, member_class, member_names
from snapjump.surrogate.base import MassScaled, Rows, Standardisation, Surrogate

SMALL = {
    "mlp": {"width": 16, "layers": 2},
    "resnet": {"width": 16, "blocks": 2},
    "ensemble": {"members": 3, "width": 8, "blocks": 2},
    "gradient_mlp": {"width": 16, "layers": 2, "slope_weight": 0.1},
    "rbf": {"neighbours": 30, "kernel": "cubic", "smoothing": 0.0},
}
NAMES = member_names("surrogate")
BY_DESCENT = [name for name in NAMES if name != "rbf"]


def made(name: str, seed: int = 0) -> Surrogate:
    torch.manual_seed(seed)
    found: Surrogate = make_member("surrogate", {"name": name, **SMALL[name]}).network()
    return found


def descended(name: str, rows: Rows, steps: int) -> Surrogate:
    """Trained by plain full-batch descent."""
    network = made(name)
    network.fit(rows)
    if network.by_descent:
        adam = torch.optim.Adam(network.parameters(), lr=0.01)
        for _ in range(steps):
            adam.zero_grad()
            network.loss(rows).backward()
            adam.step()
    return network.requires_grad_(False)


def test_every_member_is_tested_here():
    assert set(SMALL) == set(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_it_learns(name):
    rows, others = jumps(600), jumps(200, 1)
    error = (descended(name, rows, 150)(others.designs) - others.apexes).abs().mean(dim=0)
    assert (error < 0.15 * others.apexes.std(dim=0)).all(), error


@pytest.mark.parametrize("name", NAMES)
def test_designs_do_not_see_each_other(name):
    network = descended(name, jumps(100), 2)
    designs = jumps(7, 2).designs
    together = network(designs)
    assert together.shape == (7, 2) and network(designs[:0]).shape == (0, 2)
    assert torch.allclose(together[3:4], network(designs[3:4]), atol=1e-5)


@pytest.mark.parametrize("name", NAMES)
def test_all_it_has_learned_is_in_its_state(name):
    rows = jumps(300)
    network = descended(name, rows, 3)
    network.calibrate(rows)
    again = made(name, seed=5)
    again.load_state_dict(network.state_dict())
    designs = jumps(20, 3).designs
    assert torch.equal(again(designs), network(designs))
    ours, theirs = network.half_widths(designs), again.half_widths(designs)
    assert ours is None if theirs is None else ours is not None and torch.equal(ours, theirs)


@pytest.mark.parametrize("name", BY_DESCENT)
def test_its_slopes_are_those_of_its_values(name):
    network = descended(name, jumps(100), 2).double()
    designs = jumps(5).designs.double().requires_grad_()
    (slopes,) = torch.autograd.grad(network(designs).sum(), designs)
    step = 1e-6
    with torch.no_grad():
        for axis in range(4):
            move = step * torch.eye(4, dtype=torch.double)[axis]
            change = (network(designs + move) - network(designs - move)).sum(dim=1) / (2.0 * step)
            assert torch.allclose(change, slopes[:, axis], rtol=1e-4, atol=1e-4)


def test_the_paper_s_network_has_the_paper_s_size():
    network = member_class("surrogate", "mlp")().network()
    # 4 -> 372 -> 372 -> 372 -> 2, weights and biases.
    expected = 4 * 372 + 372 + 2 * (372 * 372 + 372) + 2 * 372 + 2
    assert sum(values.numel() for values in network.parameters()) == expected


def test_standardisation_and_its_inverse():
    values = torch.tensor([[1.0, 5.0], [3.0, 5.0], [8.0, 5.0]])
    standard = Standardisation(2)
    standard.fit(values)
    assert torch.allclose(standard(values).mean(dim=0), torch.zeros(2), atol=1e-6)
    assert torch.allclose(standard(values).std(dim=0), torch.tensor([1.0, 0.0]))
    assert torch.allclose(standard.inverse(standard(values)), values)


def test_a_law_of_energy_over_weight_is_constant_in_the_mass():
    class Constant(MassScaled):
        def forward(self, designs: torch.Tensor) -> torch.Tensor:
            return self.apexes(torch.zeros(len(designs), 2), designs)

    designs = jumps(50).designs
    apexes = torch.tensor([[2.0, 30.0]]) / designs[:, 2:3]
    network = Constant()
    network.fit(Rows(designs, apexes, torch.empty(50, 2, 4)))
    assert torch.allclose(network(designs), apexes, rtol=1e-5)
    assert network.loss(Rows(designs, apexes, torch.empty(50, 2, 4))) < 1e-5
