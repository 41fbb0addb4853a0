"""The elastic frame becomes the rigid one as it is made stiffer: whole jumps, coarse meshes."""

from dataclasses import replace

import numpy as np
import pytest

from experiments.errors import relative_errors
from snapjump.batch import simulate_batch, variants
from snapjump.composition import Simulation, with_tier
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.frame.elastic import ElasticFrame
from snapjump.stepping.adaptive import AdaptiveStep

pytestmark = pytest.mark.slow
# delta_alpha, epsilon, mass_bar, mu
DESIGNS = [
    (0.1, 0.2, 0.768, 0.3),
    (0.15, 0.15, 1.2, 0.4),
    (0.05, 0.25, 0.5, 0.2),
    (0.1, 0.2, 2.0, 0.3),
]
RATIOS = (1e3, 1e4, 1e5)


def coarse() -> Simulation:
    return with_tier(
        "draft", discretization=DiscreteElasticRod(32), stepping=AdaptiveStep(1e-7, 1.0)
    )


def elastic(ratio: float, **changes: object) -> Simulation:
    frame = ElasticFrame(ratio, ratio, 12, 16, contact="corners")
    return replace(coarse(), frame=frame, **changes)


@pytest.fixture(scope="module")
def rigid():
    """Jumps of the designs on the rigid frame."""
    return simulate_batch(variants(coarse(), DESIGNS))


def apart(simulation: Simulation, other) -> np.ndarray:
    """Largest relative difference of x and y."""
    batch = simulate_batch(variants(simulation, DESIGNS))
    assert set(batch.status) == {"ok"}
    errors = relative_errors(batch.x_bar, batch.y_bar, other.x_bar, other.y_bar)
    return 0.01 * np.max(errors, axis=1)


def test_differences_vanish_with_the_frame_s_compliance(rigid):
    x, y = np.array([apart(elastic(ratio), rigid) for ratio in RATIOS]).T
    assert y[0] > 4.0 * y[1] > 16.0 * y[2]
    assert x[0] > 2.0 * x[1]
    assert x[2] < 0.01
    assert y[2] < 0.002


def test_another_integrator_gives_the_same_jumps(rigid):
    sdirk2 = elastic(1e5, integrator="sdirk2")
    x, y = apart(sdirk2, rigid)
    assert x < 0.02
    assert y < 0.005
