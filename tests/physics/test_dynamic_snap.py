"""D6, D7: the dynamic snap of the beam alone, against a Galerkin solution; its ledger's order."""

import numpy as np
import pytest
from physical import beam, run
from references import outputs_of as reference

from snapjump.composition import Simulation
from snapjump.robot.design import Design
from snapjump.sim.snap import Snap
from snapjump.simulation import simulate

TIME_S = 4.3817804600413289e-3  # of the paper's beam
VELOCITY_M_S = 0.02 / TIME_S
# Until the end of the first swing; what follows depends on the finest detail.
CASES = {
    "as01": ("D6_snap_dyn_as01", 8.3),
    "sym01": ("D6_snap_dyn_sym01", 7.9),
    "sym02": ("D6_snap_dyn_sym02", 11.0),
}
# Elements with rotations, whose programs no other test needs.
TURNING = [
    pytest.param(name, marks=pytest.mark.slow) for name in ("corotational", "geometrically_exact")
]


def tilt_until(result, moment_s: float) -> float:
    """Largest angle of the midpoint's tangent until a moment."""
    x, y = result.arrays["node_x_m"], result.arrays["node_y_m"]
    k = x.shape[1] // 2
    tilt = np.arctan2(y[:, k + 1] - y[:, k - 1], x[:, k + 1] - x[:, k - 1])
    return float(np.abs(tilt[result.arrays["time_s"] <= moment_s]).max())


@pytest.mark.parametrize("name", ["der", *TURNING])
@pytest.mark.parametrize("case", CASES)
def test_galerkin(case, name):
    entry, duration = CASES[case]
    exact = reference(entry)
    design = Design(exact["eps"], exact["delta"])
    result = run(beam(5e-6, 112, design=design, name=name, duration_s=duration * TIME_S))
    crossing = result.snap_time_s / TIME_S
    assert crossing == pytest.approx(exact["t_cross_T"], rel=5e-3)
    assert result.midpoint_velocity_m_s == pytest.approx(exact["vmid_cross_SI"], rel=0.02)
    if exact["delta"] == 0.0:
        # Rounding grows fast once the arch has become unstable, but not that fast.
        assert tilt_until(result, result.snap_time_s) < 1e-8
    else:
        assert result.theta_max_rad == pytest.approx(exact["theta_mid_absmax"], rel=0.02)
    height = result.arrays["node_y_m"][:, 56] / 0.02
    time = result.arrays["time_s"] / TIME_S
    assert height[0] == pytest.approx(exact["ymid_static0"], rel=1e-3)
    for moment in (2.0, 5.0):
        assert np.interp(moment, time, height) == pytest.approx(
            exact[f"ymid_T{moment:.1f}"], rel=2e-3
        )


@pytest.mark.parametrize(("lag", "tilt"), [(0.02, 0.8356), (0.1, 0.8962)])
def test_figures_do_not_depend_on_how_far_apart_samples_are(lag, tilt):
    """``tilt``: of an independent code, 32 Hermite elements, SDIRK4 at 1e-6."""
    apart, close = (
        simulate(
            Simulation(
                sim=Snap(sample_interval_s=interval), design=Design(0.2, lag), accuracy="reference"
            )
        )
        for interval in (1e-3, 5e-6)
    )
    for name in ("theta_max_rad", "midpoint_min_m", "alpha_snap_rad", "snap_duration_s"):
        assert getattr(apart, name) == getattr(close, name)
    assert close.theta_max_rad == pytest.approx(tilt, rel=2e-4)
    assert close.theta_max_rad == pytest.approx(tilt_until(close, np.inf), rel=1e-4)
    assert close.midpoint_min_m <= close.arrays["node_y_m"][:, 112].min()
    assert len(apart.arrays["time_s"]) < 70


def test_limit_of_many_elements():
    """D7: t_cross by Richardson over 40 and 80 elements."""
    for design, limit in ((Design(0.1, 0.1), 7.5112), (Design(0.2, 0.0), 10.9522)):
        coarse, fine = (
            run(beam(1e-5, n, design=design, duration_s=0.05)).snap_time_s / TIME_S
            for n in (40, 80)
        )
        assert (4.0 * fine - coarse) / 3.0 == pytest.approx(limit, rel=2e-4)


@pytest.mark.compiles
def test_implicit_euler_rows():
    """D7: an independent code with the same elements, integrator and fixed step."""
    for row in reference("D7_der_dynamic_crosscheck"):
        design = Design(row["eps"], row["delta"])
        scene = {"duration_s": 1.2 * row["t_cross_s"], "sample_interval_s": row["dt"]}
        result = run(beam(row["dt"], row["n"], "implicit_euler", design=design, **scene))
        # That code reads crossings off straight lines between steps.
        height, time_s = result.arrays["node_y_m"][:, row["n"] // 2], result.arrays["time_s"]
        k = int(np.flatnonzero(height < 0.0)[0])
        share = height[k - 1] / (height[k - 1] - height[k])
        crossed_s = time_s[k - 1] + share * (time_s[k] - time_s[k - 1])
        assert crossed_s == pytest.approx(row["t_cross_s"], rel=1e-6)
        assert result.snap_time_s == pytest.approx(crossed_s, rel=1e-5)
        left = result.arrays["clamp_left_rad"]
        crossing_rad = left[k - 1] + share * (left[k] - left[k - 1])
        assert crossing_rad == pytest.approx(row["alpha_cross"], rel=1e-6)
        assert result.alpha_snap_rad == pytest.approx(crossing_rad, rel=1e-5)
        speed = result.arrays["node_vy_m_s"][:, row["n"] // 2]
        crossing_m_s = speed[k - 1] + share * (speed[k] - speed[k - 1])
        assert crossing_m_s / VELOCITY_M_S == pytest.approx(row["vmid"], rel=1e-5)
        assert result.midpoint_velocity_m_s == pytest.approx(crossing_m_s, rel=1e-3)
        height = height / 0.02
        time = result.arrays["time_s"] / TIME_S
        assert height[0] == pytest.approx(row["ymid0"], rel=1e-8)
        assert np.interp(5.0, time, height) == pytest.approx(row["ymid5"], rel=1e-5)
        if row["delta"]:
            assert result.theta_max_rad == pytest.approx(row["th_max"], rel=1e-4)
        else:
            assert tilt_until(result, result.snap_time_s) < 1e-8


ORDERS = {"implicit_euler": 1.0, "tr_bdf2": 2.0, "sdirk2": 2.0}


@pytest.mark.parametrize("integrator", ORDERS)
def test_snap(integrator):
    losses = []
    for step in (2e-5, 1e-5, 5e-6):
        until_it_snaps = beam(step, 32, integrator, design=Design(0.1, 0.1), duration_s=0.0315)
        result = run(until_it_snaps, "no_snap")
        losses.append(result.arrays["numerical_loss_J"][-1] / result.arrays["elastic_J"][0])
    orders = np.log2(np.abs(losses[:-1]) / np.abs(losses[1:]))
    assert orders[-1] == pytest.approx(ORDERS[integrator], abs=0.15)
    assert abs(losses[-1]) < 1e-4
