"""C1, C2, C2b, C3, C8: one mass in the barrier, against quadrature of its energy.

C7, an elastic bar that hits a wall end on, cannot be expressed: loose nodes have no elements, and
a beam's ends are held by a frame.
"""

import numpy as np
import pytest
from physical import run, single_mass, thrown
from references import outputs_of as reference
from scipy.interpolate import CubicHermiteSpline

from snapjump.contact.base import at_rest
from snapjump.scenes.mass import mass_model
from snapjump.statics.resting_gap import resting_gap

STIFFNESS_N_M = 1e4
REACH_M = 5e-4
NAMES = {"implicit_euler": "IE", "tr_bdf2": "TRBDF2", "sdirk2": "SDIRK2"}
STEPS = 400
MASS_KG = 1e-3
TIME_S = np.sqrt(MASS_KG / STIFFNESS_N_M)
FINE = 2400  # hard impacts turn round within a few percent of the contact time


def of_one_gram(vhat: float, tc: float) -> tuple[float, float, float]:
    """Mass (kg), speed (m/s) and contact time (s) of a bounce that is given without dimensions."""
    return MASS_KG, vhat * REACH_M / TIME_S, tc * TIME_S


def flight(arrays) -> tuple[float, float]:
    """Smallest gap (m), and time from entering the barrier to leaving it (s)."""
    time, gap, speed = (arrays[k] for k in ("time_s", "node_y_m", "node_vy_m_s"))
    path = CubicHermiteSpline(time, gap[:, 0], speed[:, 0])
    turns = path.derivative().roots(extrapolate=False)
    lowest = min(float(path(t)) for t in turns)
    leaves = path.solve(REACH_M, extrapolate=False)
    return lowest, float(leaves[leaves > turns[0]].max() - time[0])


def peak_force_N(simulation, gap_m: float) -> float:
    scales = simulation.robot.scales
    gap = gap_m / scales.length_m
    force = mass_model(simulation, 0.0, 0.0).contact.force(gap, at_rest(gap))
    return float(force) * scales.force_N


def bounce(mass_kg, speed_m_s, contact_s, steps=STEPS):
    step = contact_s / steps
    times = {"duration_s": 1.1 * contact_s, "sample_interval_s": 0.5 * step}
    return run(single_mass("bounce", step, mass_kg=mass_kg, speed_m_s=speed_m_s, **times))


@pytest.mark.parametrize("speed", [0.01, 0.1, 0.5, 1.0, 2.0, 3.0])
def test_nondimensional(speed):
    """Gaps over d_hat, speeds over d_hat sqrt(K/m), times in sqrt(m/K)."""
    row = next(r for r in reference("C1_barrier_nondim") if r["vhat"] == speed)
    errors = []
    for steps in (STEPS, FINE):
        result = bounce(*of_one_gram(speed, row["tc"]), steps=steps)
        lowest, contact = flight(result.arrays)
        assert lowest / REACH_M == pytest.approx(row["xmin"], abs=1e-4)
        assert contact / TIME_S == pytest.approx(row["tc"], rel=1e-3)
        assert result.min_gap_m > 0.0
        errors.append(abs(lowest / REACH_M / row["xmin"] - 1.0))
    assert errors[-1] < 1e-4


def test_dimensional():
    for row in reference("C2_barrier_dim"):
        if row["g"] != 0.0:
            continue
        result = bounce(row["m"], row["v"], row["tc"])
        assert flight(result.arrays)[1] == pytest.approx(row["tc"], rel=1e-3)
        result = bounce(row["m"], row["v"], row["tc"], steps=FINE)
        lowest, contact = flight(result.arrays)
        assert lowest == pytest.approx(row["dmin"], rel=1e-4)
        assert contact == pytest.approx(row["tc"], rel=1e-3)
        force = peak_force_N(result.simulation, lowest)
        assert force == pytest.approx(row["Fmax"], rel=1e-3)


def test_with_weight():
    exact = reference("C2b_with_gravity")
    step = exact["tc"] / STEPS
    times = {"duration_s": 1.1 * exact["tc"], "sample_interval_s": 0.5 * step}
    simulation = single_mass("bounce", step, mass_kg=4e-3, **times)
    lowest, contact = flight(thrown(simulation, REACH_M, 1.0, gravity_m_s2=10.0).arrays)
    assert lowest == pytest.approx(exact["dmin"], rel=1e-4)
    assert contact == pytest.approx(exact["tc"], rel=1e-3)
    assert peak_force_N(simulation, lowest) == pytest.approx(exact["Fmax"], rel=1e-3)


def test_hardest_impact_keeps_its_gap():
    """vhat = 5 leaves 3.7e-6 of the barrier: no fixed step resolves it, yet no gap closes."""
    row = reference("C1_barrier_nondim")[-1]
    for steps in (5, 40, STEPS):
        impact = of_one_gram(row["vhat"], row["tc"])
        assert bounce(*impact, steps=steps).min_gap_m > 0.0


def test_rest():
    for row in reference("C3_rest_gap"):
        simulation = single_mass("slide", 1e-5, mass_kg=row["m"], speed_m_s=0.0, duration_s=1e-3)
        scales = simulation.robot.scales
        model = mass_model(simulation, row["g"], 0.0)
        weight = row["m"] / scales.mass_kg * model.load.gravity()
        gap = resting_gap(model.contact, weight, 1.0) * scales.length_m
        assert gap == pytest.approx(row["gap"], rel=1e-8)
        heights = run(simulation).arrays["node_y_m"]
        assert np.allclose(heights, row["gap"], rtol=1e-8, atol=0.0)


@pytest.mark.parametrize("integrator", NAMES)
def test_restitution(integrator):
    """Mean over eight phases of the first step against the moment of entering the barrier."""
    rows = [r for r in reference("C8_restitution_vs_dt") if r["method"] == NAMES[integrator]]
    contacts = {r["vhat"]: r["tc"] for r in reference("C1_barrier_nondim")}
    for row in rows:
        impact = of_one_gram(row["vhat"], contacts[row["vhat"]])
        for count, mean in zip(row["n_per_tc"], row["e_mean"], strict=True):
            found = restitutions(integrator, *impact, count)
            assert np.mean(found) == pytest.approx(mean, abs=1e-3), (row["vhat"], count)


def restitutions(integrator, mass, speed, contact, count) -> list[float]:
    step = contact / count
    times = {"duration_s": 4.0 * contact + 20.0 * step, "sample_interval_s": contact}
    simulation = single_mass("bounce", step, integrator, mass_kg=mass, **times)
    ratios = []
    for phase in range(8):
        result = thrown(simulation, REACH_M + phase / 8.0 * step * speed, speed)
        assert result.min_gap_m > 0.0
        ratios.append(result.arrays["node_vy_m_s"][-1, 0] / speed)
    return ratios
