"""Compiled programs at full size: what becomes of twelve robots, of a snap and of an arch."""

from typing import Any

import numpy as np
import pytest
import robots
import yaml
from golden import FOLDER, Golden, outcome, plain, spelled_out

from snapjump.batch import simulate_designs
from snapjump.composition import Simulation
from snapjump.simulation import build, simulate

pytestmark = [pytest.mark.compiles, pytest.mark.exact]

# delta_alpha (rad), epsilon, mass_bar, mu: spread over the paper's ranges.
TWO_MORE = ((0.07, 0.25, 1.00, 0.35), (0.12, 0.15, 1.80, 0.45))
DESIGNS = np.concatenate([np.array(robots.DESIGNS[:10])[:, [1, 0, 3, 2]], TWO_MORE])
PROGRAMS = yaml.safe_load((FOLDER / "programs.yaml").read_text())
NAMES = tuple(PROGRAMS["jumps"])
# What tolerances make of tier standard for a second-order integrator is dear for the others.
COARSER = {
    "stepping": {"fixed": {"step_s": 2e-5}},
    "frame": {"elastic": {"leg_elements": 9, "top_elements": 16, "bending_ratio": 1e4}},
}
# A stick zone that steps resolve.
SMOOTHER = {"friction": {"implicit": {"velocity_threshold_m_s": 0.01}}}


def jump(name: str, changes: dict[str, Any] = COARSER) -> Simulation:
    return build(spelled_out({"sim": "jump"} | PROGRAMS["jumps"][name], changes))


@pytest.mark.parametrize("name", NAMES)
def test_jumps(name: str, golden: Golden) -> None:
    lanes = simulate_designs(jump(name), DESIGNS, threads=1, lanes=8)
    assert set(lanes.status) <= {"ok", "no_jump"}
    golden.check(name, outcome(lanes))


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=pytest.mark.slow if n != "default" else ()) for n in NAMES]
)
def test_jumps_of_one_robot_at_a_time(name: str, golden: Golden) -> None:
    alone = simulate_designs(jump(name), DESIGNS[:4], threads=1, lanes=1)
    written = golden.known[name]
    assert plain(outcome(alone)) == {key: values[:4] for key, values in written.items()}


def test_sensitivities(golden: Golden) -> None:
    found = simulate_designs(
        jump("default", SMOOTHER), DESIGNS[:8], threads=1, lanes=8, sensitivities=True
    ).sensitivities
    assert found is not None
    # Derivatives may be contracted by the compiler: their last bits are the processor's.
    golden.near("sensitivities", np.hstack([found.dx_bar, found.dy_bar]), 1e-6)


@pytest.mark.parametrize("scene", PROGRAMS["scenes"])
def test_scenes(scene: str, golden: Golden) -> None:
    result = simulate(build(spelled_out({"sim": scene} | PROGRAMS["scenes"][scene], {})))
    # Frequencies are LAPACK's: their last bits are the processor's.
    summary = {
        key: v
        for key, v in result.summary.items()
        if not key.endswith("_seconds") and not key.startswith("damping_ratio")
    }
    golden.check(scene, summary | {"status": result.status})
