"""The energy ledger closes at the integrator's order, on a snap up to just before its end."""

import numpy as np
import pytest

from snapjump.robot.design import Design

ORDERS = {"implicit_euler": 1.0, "tr_bdf2": 2.0, "sdirk2": 2.0}


@pytest.mark.parametrize("integrator", ORDERS)
def test_snap(integrator, beam, run):
    losses = []
    for step in (2e-5, 1e-5, 5e-6):
        result = run(beam(step, 32, integrator, design=Design(0.1, 0.1), duration_s=0.0315))
        losses.append(result.arrays["numerical_loss_J"][-1] / result.arrays["elastic_J"][0])
    orders = np.log2(np.abs(losses[:-1]) / np.abs(losses[1:]))
    assert orders[-1] == pytest.approx(ORDERS[integrator], abs=0.15)
    assert abs(losses[-1]) < 1e-4
