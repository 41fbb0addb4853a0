"""Loads of batches, recorded at every step: those of the trajectories, in any lanes and threads."""

from dataclasses import replace

import numpy as np
import pytest
from refusals import refused
from robots import BASELINE as BASE
from scaled import Factors, scaled, scaled_row

from snapjump.backend.cuda import CudaBackend
from snapjump.batch import Batch, simulate_batch, simulate_designs
from snapjump.batch.loads import OFFERED, LoadedBatch, reads_of
from snapjump.composition import with_tier
from snapjump.scenes.bending import clamped_bar
from snapjump.scenes.jump_loads import mass_kg
from snapjump.scenes.recorded_loads import KINDS
from snapjump.simulation import simulate

NAMES = [one.name for one in OFFERED]
# Steps so long that every one of them is a sample.
COARSE = {
    "stepping": {"name": "adaptive", "tolerance": 1e-4},
    "discretization": {"name": "der", "elements": 17},
    "sim": {"name": "jump", "time_limit_s": 0.02, "start_fraction": 0.9, "sample_interval_s": 2e-7},
    "robot": {"yield_stress_Pa": 2e9},
}
COMPOSITIONS = {
    "two nodes held": {"discretization": {"name": "der", "elements": 17, "clamp": "two_nodes"}},
    "no stage at the end": {
        "integrator": "implicit_midpoint",
        "discretization": {"name": "corotational", "elements": 17},
        "contact": {"name": "hunt_crossley", "stiffness_N_m": 1e4},
        "drag": {"name": "quadratic", "area_m2": 2e-4},
    },
    "two stages": {
        "integrator": "tr_bdf2",
        "frame": {"name": "elastic", "leg_elements": 5, "top_elements": 6, "bending_ratio": 1e4},
        "damping": "mass_proportional",
    },
    "a constraint": {"contact": "signorini", "integrator": "implicit_euler"},
}
FIRST, *OTHERS = COMPOSITIONS.values()
CHANGES = [FIRST, *(pytest.param(one, marks=pytest.mark.slow) for one in OTHERS)]


def read_off(jump):
    """Loads by name, off the samples of a trajectory that has every step."""
    arrays, time_s = jump.arrays, jump.arrays["time_s"]
    strain = np.abs(arrays["node_strain"])
    sample, node = np.unravel_index(strain.argmax(), strain.shape)
    mesh = jump.simulation.discretization
    torques = {side: arrays[f"clamp_{side}_torque_N_m"] for side in ("left", "right")}
    rates = {side: np.gradient(arrays[f"clamp_{side}_rad"], time_s) for side in torques}
    found = {
        "max_strain": strain.max(),
        "max_strain_at_bar": node / mesh.elements + clamped_bar(mesh),
        "max_strain_time_s": time_s[sample],
        "max_stress_Pa": jump.simulation.robot.youngs_modulus_Pa * strain.max(),
        "peak_clamp_torque_N_m": max(np.abs(torque).max() for torque in torques.values()),
        "peak_clamp_power_W": sum(torques[side] * rates[side] for side in torques).max(),
        "clamp_work_J": arrays["clamp_work_J"][-1],
        "ground_impulse_N_s": arrays["ground_impulse_y_N_s"][-1],
        "peak_ground_force_N": np.nan,
    }
    found["safety_factor"] = jump.simulation.robot.yield_stress_Pa / found["max_stress_Pa"]
    if "node_normal_N" in arrays:  # a constraint's are none of a state's
        forces = (arrays[f"{of}_normal_N"].sum(axis=1) for of in ("node", "corner"))
        found["peak_ground_force_N"] = sum(forces).max()
    off = np.searchsorted(time_s, jump.liftoff_time_s)
    given_J = found["clamp_work_J"] + arrays["elastic_J"][0] - arrays["elastic_J"][off]
    weight_N = mass_kg(jump.simulation) * jump.simulation.robot.gravity_m_s2
    rise_m = jump.y_world_bar * jump.simulation.robot.length_m - arrays["com_y_m"][0]
    return found | {"efficiency": weight_N * rise_m / given_J}


@pytest.mark.compiles
@pytest.mark.parametrize("changes", CHANGES, ids=COMPOSITIONS)
def test_loads_are_those_of_a_trajectory_with_every_step(changes):
    one = with_tier("draft", **(COARSE | changes))
    batch, jump = simulate_batch([one], lanes=1, outputs=NAMES), simulate(one)
    assert jump.status == "ok" and batch.steps[0] == jump.steps
    assert len(jump.arrays["time_s"]) == jump.steps + 1
    expected = read_off(jump)
    assert expected.keys() == {*NAMES}
    for name in NAMES:
        # A trajectory's rates of the clamps are differences of their angles.
        exact = 1e-6 if name == "peak_clamp_power_W" else 1e-11
        found = getattr(batch, name)[0]
        assert found == pytest.approx(expected[name], rel=exact, nan_ok=True), name
        assert found == pytest.approx(getattr(jump, name), rel=1e-13, nan_ok=True), name


def test_a_recorded_jump_s_loads_do_not_depend_on_how_far_apart_samples_are():
    """The ground's largest force lies between them."""
    apart, usual = (
        simulate(with_tier("draft", sim={"name": "jump", "sample_interval_s": interval_s}))
        for interval_s in (1e-3, 2e-5)
    )
    for name in ("max_strain", "max_strain_time_s", "peak_clamp_torque_N_m", "peak_ground_force_N"):
        assert getattr(apart, name) == getattr(usual, name)
    forces = (apart.arrays[f"{of}_normal_N"].sum(axis=1) for of in ("node", "corner"))
    assert usual.peak_ground_force_N > 1.05 * sum(forces).max()


DESIGNS = np.array(
    [(0.10, 0.20, 0.768, 0.3), (0.1, 0.41, 0.768, 0.3), (0.02, 0.11, 0.4, 0.1),
     (0.15, 0.29, 1.5, 0.6), (-0.10, 0.23, 0.5, 0.5)]
)  # fmt: skip


def same(one, other):
    """Whether two columns are, unknown values included."""
    return np.array_equal(one, other, equal_nan=one.dtype != object)


@pytest.fixture(scope="module")
def alone():
    return simulate_designs(BASE, DESIGNS, threads=1, lanes=1, outputs=NAMES)


@pytest.mark.slow
@pytest.mark.parametrize("names", [NAMES, ["max_strain"]], ids=["all", "strain"])
def test_lanes_and_threads_change_no_bit(alone, names):
    wide = simulate_designs(BASE, np.tile(DESIGNS, (3, 1)), threads=2, lanes=8, outputs=names)
    for name in names:
        assert same(getattr(wide, name), np.tile(getattr(alone, name), 3)), name


@pytest.mark.compiles
def test_jumps_are_the_same_and_have_columns_for_what_was_asked(alone):
    plain = simulate_designs(BASE, DESIGNS, threads=1, lanes=8)
    some = simulate_designs(BASE, DESIGNS, threads=1, lanes=8, outputs=["max_strain"])
    assert type(plain) is Batch and plain.columns().keys() | {*NAMES} == alone.columns().keys()
    assert some.columns().keys() - plain.columns().keys() == {"max_strain"}
    for found in (alone, some):
        for output in Batch.declared():
            if not output.timing:
                assert same(plain.columns()[output.name], found.columns()[output.name])
    assert "max_strain" in str(some) and "max_strain" in some.to_frame()
    assert np.isnan(alone.max_strain[1]) and np.isfinite(np.delete(alone.max_strain, 1)).all()
    with refused("outputs"):
        assert some.clamp_work_J is None


@pytest.mark.compiles
def test_what_differs_between_robots_counts_for_each():
    inputs = ("robot.thickness_m", "robot.youngs_modulus_Pa", "robot.yield_stress_Pa")
    rows = np.array([(4.5e-5, 2.1e11, 2e9), (5e-5, 1.9e11, 2.5e9)])
    many = simulate_designs(BASE, rows, inputs=inputs, threads=1, lanes=8, outputs=NAMES)
    for k, row in enumerate(rows):
        robot = dict(zip((path.removeprefix("robot.") for path in inputs), row, strict=True))
        one = simulate_batch([replace(BASE, robot=BASE.robot.changed(**robot))], outputs=NAMES)
        assert all(getattr(many, name)[k] == getattr(one, name)[0] for name in NAMES)


@pytest.mark.compiles
def test_loads_have_the_dimensions_of_their_units():
    base = replace(BASE, robot=BASE.robot.changed(yield_stress_Pa=2e9))
    factors, rows = Factors(0.5, 4.0, 0.125), []
    for one in (base, scaled(base, factors)):
        rows.append(simulate_batch([one], lanes=8, outputs=NAMES).rows()[0])
    expected = scaled_row(LoadedBatch, rows[0], factors)
    for name in NAMES:
        assert rows[1][name] == pytest.approx(expected[name], rel=1e-12), name


def test_every_output_that_is_offered_reads_what_can_be_recorded():
    assert {*reads_of(NAMES)} == {*KINDS} and reads_of([]) == []
    assert reads_of(["max_stress_Pa", "max_strain"]) == ["bending"]


@pytest.mark.parametrize(
    ("outputs", "said"),
    [("max_strain", "a list of some of"), (3, "a list of some of"), (["spam"], "max_strain, "),
     (["x_bar"], "every batch has"), (["damping_ratio_1"], "one robot's trajectory or modes"),
     (["max_residual"], "one robot's trajectory or modes"), ([None], "max_strain, "),
     (["max_strain", "max_strain"], "each once")],
)  # fmt: skip
def test_what_batches_do_not_have_is_refused(outputs, said):
    for run in (lambda: simulate_designs(BASE, DESIGNS, outputs=outputs),
                lambda: simulate_batch([BASE], outputs=outputs)):  # fmt: skip
        with refused("outputs", said):
            run()


def test_loads_are_refused_with_sensitivities_and_on_a_card(monkeypatch):
    with refused("outputs"):
        simulate_designs(BASE, DESIGNS, outputs=["max_strain"], sensitivities=True)
    monkeypatch.setattr("snapjump.batch.simulate.check_backend", lambda simulation: None)
    with refused("backend"):
        simulate_designs(replace(BASE, backend=CudaBackend()), DESIGNS, outputs=["max_strain"])
