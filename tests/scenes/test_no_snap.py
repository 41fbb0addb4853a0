"""What becomes of arches that do not snap: a status and why, and figures that are known or NaN."""

import math
from typing import Any

import numpy as np
import pytest

from snapjump.checks import ParameterError
from snapjump.results import Result
from snapjump.scenes import snap_march
from snapjump.simulation import build, simulate
from snapjump.statics import critical
from snapjump.statics.arch import StaticArch

DEFAULTS = {
    "length_m": 0.02, "width_m": 0.01, "thickness_m": 5e-5, "youngs_modulus_Pa": 2e11,
    "density_kg_m3": 5000.0,
}  # fmt: skip
TIMES = {"duration_s": 0.06, "sample_interval_s": 5e-5}
STRAIGHT = {"epsilon": 1e-5, "delta_alpha": 0.0}
TURNED_FAR = {"epsilon": 0.006, "delta_alpha": -0.4}


def of(scene: str, design: dict[str, float] | None = None, **groups: Any) -> Result:
    """A simulation of a scene and design, its figures as they are declared."""
    groups = {"accuracy": {"name": "draft"}, "design": design or {}} | groups
    result = simulate(build({"sim": {"name": scene} | groups.pop("sim", {}), **groups}))
    assert bool(result.message) == (result.status != "ok")
    for each in result.simulation.sim.outputs.declared():
        value = result.summary[each.name]
        if isinstance(value, float):
            has = not each.of or result.status in each.of
            assert math.isfinite(value) == has or each.unknown, each.name
    return result


@pytest.mark.parametrize("design", [TURNED_FAR, {"epsilon": 1e-5}])
def test_an_arch_that_stays_stable_does_not_snap(design):
    result = of("static", design)
    assert result.status == "no_snap" and "stable up to 3.1" in result.message
    assert not result.succeeded and result.arrays == {}


def test_a_walk_of_too_many_steps_is_given_up(monkeypatch):
    monkeypatch.setattr(critical, "MOST_NODE_STEPS", 5.0 * 65.0)
    result = of("static", TURNED_FAR)
    assert result.status == "branch_lost" and "in 5 steps" in result.message


@pytest.mark.parametrize(
    ("design", "scene"), [({}, {"duration_s": 1e-3}), (TURNED_FAR, {}), (STRAIGHT, {})]
)
def test_a_beam_that_does_not_pass_its_clamps_has_not_snapped(design, scene):
    result = of("snap", design, sim=scene)
    assert result.status == "no_snap" and "did not snap" in result.message
    assert np.isfinite(result.theta_max_rad) and len(result.arrays["time_s"]) > 1


@pytest.mark.parametrize("scene", ["static", "snap"])
def test_without_an_arch_there_is_nothing_to_follow(scene, monkeypatch):
    def lost(*arguments: Any) -> None:
        raise ArithmeticError("no equilibrium found")

    monkeypatch.setattr(StaticArch, "flat", lost)
    result = of(scene)
    assert result.status == "no_equilibrium" and result.arrays == {}


def test_a_march_of_too_many_iterations_is_given_up(monkeypatch):
    monkeypatch.setattr(snap_march, "MOST_NODE_ITERATIONS", 57.0 * 300.0)
    assert of("snap").status == "iteration_limit"


def test_samples_of_a_fine_mesh_that_no_memory_holds_are_refused():
    with pytest.raises(ParameterError, match=r"sim\.sample_interval_s = 1e-06 .* 10000 samples"):
        of(
            "snap",
            sim={"sample_interval_s": 1e-6},
            discretization={"name": "der", "elements": 20_000},
        )


@pytest.mark.parametrize("seed", range(24))
@pytest.mark.parametrize("scene", ["static", "snap"])
def test_wild_inputs_end_in_a_status(scene, seed):
    """Inputs up to a hundred times as large or small as their defaults, all of them together."""
    random = np.random.default_rng(seed)

    def moved(values: dict[str, float]) -> dict[str, float]:
        chosen = [name for name in values if random.random() < 0.5]
        return {name: values[name] * 10.0 ** random.uniform(-2.0, 2.0) for name in chosen}

    design = {
        "epsilon": 0.4 * 10.0 ** random.uniform(-4.5, 0.0),
        "delta_alpha": float(random.choice([0.0, -0.5, 0.5, 1e-6, random.uniform(-0.5, 0.5)])),
    }
    groups: dict[str, Any] = {"robot": moved(DEFAULTS)}
    groups["discretization"] = {"name": "der", "elements": int(random.choice([8, 20, 56, 300]))}
    if scene == "snap":
        groups["sim"] = moved(TIMES)
    try:
        of(scene, design, **groups)
    except ParameterError as error:
        assert "\n" not in str(error)
