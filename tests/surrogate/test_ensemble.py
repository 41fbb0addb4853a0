"""Members that are independent of each other, and intervals that hold what they promise."""

import torch
from forward_models import jumps

from snapjump.surrogate.base import Rows
from snapjump.surrogate.ensemble import Ensemble


def ensemble() -> Ensemble:
    torch.manual_seed(0)
    network = Ensemble(networks=4, width=8, blocks=1)
    network.fit(jumps(200))
    return network


def test_its_prediction_is_the_mean_of_members_that_differ():
    network, designs = ensemble(), jumps(30).designs
    each = network.each(designs)
    assert each.shape == (4, 30, 2)
    assert torch.equal(each.mean(dim=0), network(designs))
    assert (each.std(dim=0) > 0.0).all()


def test_a_member_learns_as_if_it_were_alone():
    network, rows = ensemble(), jumps(64)
    network.loss(rows).backward()
    together = network.body[0].weight.grad[1].clone()
    network.zero_grad()
    error = (network.each(rows.designs)[1] - rows.apexes) / network.spread
    error.abs().mean().backward()
    assert torch.allclose(together, network.body[0].weight.grad[1] / 4, atol=1e-7)


def test_intervals_hold_ninety_percent_of_jumps_like_those_of_the_calibration():
    network = ensemble()
    noise = torch.Generator().manual_seed(1)

    def noisy(count: int, seed: int) -> Rows:
        rows = jumps(count, seed)
        apexes = network(rows.designs) + torch.randn((count, 2), generator=noise)
        return rows._replace(apexes=apexes)

    with torch.no_grad():
        network.calibrate(noisy(4000, 2))
        rows = noisy(10000, 3)
        inside = (network(rows.designs) - rows.apexes).abs() <= network.half_widths(rows.designs)
    assert ((inside.float().mean(dim=0) - 0.9).abs() < 0.02).all()


def test_few_jumps_of_calibration_give_the_widest_intervals():
    network = ensemble()
    with torch.no_grad():
        rows = jumps(5)
        network.calibrate(rows)
        off = (network(rows.designs) - rows.apexes).abs()
        assert (off <= network.half_widths(rows.designs) * (1.0 + 1e-5)).all()
