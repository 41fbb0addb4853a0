"""Compiled programs at full size: what becomes of twelve robots, of a snap and of an arch."""

from typing import Any

import numpy as np
import pytest
from golden import Golden, outcome, plain, spelled_out

from snapjump.batch import simulate_designs
from snapjump.composition import Simulation
from snapjump.simulation import build, simulate

pytestmark = [pytest.mark.compiles, pytest.mark.exact]

# delta_alpha (rad), epsilon, mass_bar, mu: spread over the paper's ranges.
DESIGNS = np.array(
    [
        (0.02, 0.10, 0.40, 0.10),
        (0.10, 0.20, 0.768, 0.30),
        (0.15, 0.30, 1.50, 0.60),
        (0.05, 0.20, 2.00, 0.20),
        (0.19, 0.10, 0.30, 0.50),
        (0.02, 0.30, 0.90, 0.30),
        (0.15, 0.20, 1.20, 0.40),
        (0.10, 0.10, 0.60, 0.20),
        (0.01, 0.20, 0.50, 0.60),
        (0.19, 0.30, 0.30, 0.10),
        (0.07, 0.25, 1.00, 0.35),
        (0.12, 0.15, 1.80, 0.45),
    ]
)
JUMPS = {
    "default": {
        "integrator": "tr_bdf2",
        "contact": "logbarrier",
        "friction": "implicit",
        "discretization": "der",
        "damping": "kelvin_voigt",
        "frame": "rigid",
        "stepping": "adaptive",
    },
    "spring": {
        "integrator": "bdf2",
        "contact": "penalty",
        "friction": "lagged",
        "discretization": "corotational",
        "damping": "mass_proportional",
        "frame": "rigid",
        "stepping": "adaptive",
    },
    "losses": {
        "integrator": "generalized_alpha",
        "contact": "hunt_crossley",
        "friction": "implicit",
        "discretization": "geometrically_exact",
        "damping": "none",
        "frame": "rigid",
        "stepping": "adaptive",
    },
    "soft": {
        "integrator": "implicit_euler",
        "contact": "signorini",
        "friction": "none",
        "discretization": "der",
        "damping": "kelvin_voigt",
        "frame": "elastic",
        "stepping": "fixed",
    },
}
# What tolerances make of tier standard for a second-order integrator is dear for the others.
COARSER = {
    "stepping": {"fixed": {"step_s": 2e-5}},
    "frame": {"elastic": {"leg_elements": 9, "top_elements": 16, "bending_ratio": 1e4}},
}
HELD = {"frame": "fixed", "contact": "none", "friction": "none"}
SCENES = {
    "snap": HELD | {"damping": "kelvin_voigt", "discretization": "der"},
    "static": HELD | {"damping": "none", "discretization": "der"},
    "cantilever": HELD | {"damping": "none", "discretization": "corotational"},
    "bounce": HELD | {"damping": "none", "contact": "hunt_crossley"},
    "slide": HELD | {"damping": "none", "contact": "logbarrier", "friction": "implicit"},
}


# A stick zone that steps resolve.
SMOOTHER = {"friction": {"implicit": {"velocity_threshold_m_s": 0.01}}}


def jump(name: str, changes: dict[str, Any] = COARSER) -> Simulation:
    return build(spelled_out({"sim": "jump"} | JUMPS[name], changes))


@pytest.mark.parametrize("name", JUMPS)
def test_jumps(name: str, golden: Golden) -> None:
    lanes = simulate_designs(jump(name), DESIGNS, threads=1, lanes=8)
    assert set(lanes.status) <= {"ok", "no_jump"}
    golden.check(name, outcome(lanes))
    scalar = simulate_designs(jump(name), DESIGNS[:4], threads=1, lanes=1)
    few = {key: values[:4] for key, values in plain(outcome(lanes)).items()}
    assert plain(outcome(scalar)) == few


def test_sensitivities(golden: Golden) -> None:
    found = simulate_designs(
        jump("default", SMOOTHER), DESIGNS[:8], threads=1, lanes=8, sensitivities=True
    ).sensitivities
    assert found is not None
    # Derivatives may be contracted by the compiler: their last bits are the processor's.
    golden.near("sensitivities", np.hstack([found.dx_bar, found.dy_bar]), 1e-6)


@pytest.mark.parametrize("scene", SCENES)
def test_scenes(scene: str, golden: Golden) -> None:
    numerics = {"integrator": "tr_bdf2", "stepping": "adaptive"}
    result = simulate(build(spelled_out(numerics | {"sim": scene} | SCENES[scene], {})))
    summary = {key: v for key, v in result.summary.items() if not key.endswith("_seconds")}
    golden.check(scene, summary | {"status": result.status})
