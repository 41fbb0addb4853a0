"""The tier `reference`, against two integrators that agree with each other."""

import numpy as np
import pytest

from snapjump import Design, Environment, simulate_jump
from snapjump.declare.members import member_class

DESIGNS = [
    (0.2, 0.1, 0.3, 0.768),
    (0.15, 0.05, 0.4, 0.3),
    (0.25, 0.01, 0.2, 0.6),
    (0.3, 0.15, 0.5, 1.5),
]
BOUND = 5e-4


def apex(design: tuple[float, ...], **parts) -> np.ndarray:
    epsilon, lag, mu, mass_bar = design
    result = simulate_jump(
        design=Design(epsilon, lag),
        environment=Environment(mu, mass_bar),
        accuracy="reference",
        **parts,
    )
    assert result.status == "ok"
    return np.array([result.x_bar, result.y_bar])


def distance(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Relative difference of x (to max(|x|, 0.1 y)) and y."""
    scale = np.array([max(abs(other[0]), 0.1 * other[1]), other[1]])
    return np.abs(one - other) / scale


@pytest.mark.slow
@pytest.mark.parametrize("design", DESIGNS)
def test_two_integrators_agree(design):
    tight = member_class("stepping", "adaptive")(tolerance=1e-9, contact_steps=0.15)
    first, second = (
        apex(design, integrator=member_class("integrator", name)(), stepping=tight)
        for name in ("tr_bdf2", "sdirk2")
    )
    assert (distance(second, first) < BOUND).all()
    assert (distance(apex(design), 0.5 * (first + second)) < BOUND).all()
