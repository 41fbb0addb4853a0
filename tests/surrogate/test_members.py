"""What each surrogate has by itself: independent members, slopes in the loss, exact values."""

import pytest
import torch
from forward_models import jumps

from snapjump.checks import ParameterError
from snapjump.surrogate.base import Rows, Surrogate
from snapjump.surrogate.ensemble import Ensemble
from snapjump.surrogate.gradient_mlp import GradientMlp
from snapjump.surrogate.rbf import RbfOptions


def network(slope_weight: float) -> GradientMlp:
    torch.manual_seed(0)
    made = GradientMlp(width=8, layers=2, slope_weight=slope_weight)
    made.fit(jumps(100))
    return made


def test_its_loss_is_the_error_of_values_and_of_slopes():
    rows, made = jumps(20), network(0.5)
    designs = rows.designs.clone().requires_grad_()
    apexes = made(designs)
    values = ((apexes - rows.apexes) / rows_std(100)).abs().mean()
    jacobian = torch.func.vmap(torch.func.jacrev(lambda one: made(one[None])[0]))(rows.designs)
    known = jumps(100).designs
    known[:, 2] = known[:, 2].log()
    strides = known.std(dim=0).repeat(20, 1)
    strides[:, 2] *= rows.designs[:, 2]
    slopes = ((jacobian - rows.slopes) * strides[:, None] / rows_std(100)[:, None]).abs().mean()
    assert torch.allclose(made.loss(rows), values + 0.5 * slopes, rtol=1e-4)


def rows_std(count: int) -> torch.Tensor:
    return jumps(count).apexes.std(dim=0)


def test_slopes_that_are_not_known_do_not_count():
    rows, made = jumps(20), network(0.5)
    some = rows.slopes.clone()
    some[::2] = torch.nan
    half = rows._replace(slopes=some)
    odd = type(rows)(*(values[1::2] for values in rows))
    loss = made.loss(half)
    loss.backward()
    assert all(torch.isfinite(values.grad).all() for values in made.parameters())
    of_values = network(0.0).loss
    expected = of_values(rows) + made.loss(odd) - of_values(odd)
    assert torch.allclose(loss, expected, rtol=1e-4)
    none = rows._replace(slopes=torch.full_like(some, torch.nan))
    assert torch.allclose(made.loss(none), of_values(rows))


def test_where_the_law_is_smooth_slopes_are_worth_many_jumps():
    rows, others = jumps(40), jumps(500, 1)
    errors = []
    for weight in (0.0, 1.0):
        torch.manual_seed(0)
        made = GradientMlp(width=32, layers=2, slope_weight=weight)
        made.fit(rows)
        adam = torch.optim.Adam(made.parameters(), lr=0.01)
        for _ in range(300):
            adam.zero_grad()
            made.loss(rows).backward()
            adam.step()
        with torch.no_grad():
            errors.append(float((made(others.designs) - others.apexes).abs().mean()))
    assert errors[1] < 0.6 * errors[0], errors


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


def fitted(rows: Rows, **options: int) -> Surrogate:
    network = RbfOptions(**options).network()
    network.fit(rows)
    return network


@pytest.mark.parametrize(("count", "options"), [(300, {"neighbours": 40}), (20, {})])
def test_it_passes_through_the_jumps_it_was_given(count, options):
    """So it does where there are fewer of them than neighbours."""
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
