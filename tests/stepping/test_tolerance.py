"""The tolerance of adaptive steps says how large the error is: less of one is less of the other."""

from dataclasses import replace

import numpy as np
import pytest

from experiments.designs import spread_designs
from snapjump.batch import simulate_batch, variants
from snapjump.composition import with_tier
from snapjump.declare.members import member_class

TOLERANCES = (1e-5, 1e-6, 1e-7, 1e-8)


@pytest.mark.parametrize("name", ["tr_bdf2", pytest.param("esdirk3", marks=pytest.mark.slow)])
def test_errors_fall_with_the_tolerance(name):
    """Median over sixteen designs against a far smaller tolerance, on one mesh."""
    base = with_tier("draft", integrator=member_class("integrator", name)())
    designs = spread_designs(16)

    def jumps(tolerance):
        stepping = replace(base.stepping, tolerance=tolerance)
        batch = simulate_batch(variants(replace(base, stepping=stepping), designs))
        assert set(batch.status) == {"ok"}
        return batch

    limit = jumps(1e-10)
    errors = []
    for tolerance in TOLERANCES:
        batch = jumps(tolerance)
        scale = np.maximum(np.abs(limit.x_bar), 0.1 * limit.y_bar)
        x = np.median(np.abs(batch.x_bar - limit.x_bar) / scale)
        y = np.median(np.abs(batch.y_bar - limit.y_bar) / limit.y_bar)
        errors.append((x, y))
    for looser, tighter in zip(errors, errors[1:], strict=False):
        assert tighter[0] < looser[0] and tighter[1] < looser[1], errors
