"""Slopes in the loss: what they add, and what is left out."""

import torch
from forward_models import jumps

from snapjump.surrogate.gradient_mlp import GradientMlp


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
