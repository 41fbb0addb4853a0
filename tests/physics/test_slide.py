"""C4, C5: one mass with smoothed Coulomb friction, against closed forms."""

import numpy as np
import pytest


def test_slide_to_rest(single_mass, run, reference):
    exact = reference("C4_slide")
    result = run(single_mass("slide", 1e-5, mu=exact["mu"], speed_m_s=exact["v0"]))
    assert result.distance_m == pytest.approx(exact["x_total"], rel=1e-4)
    speed = result.arrays["node_vx_m_s"][:, 0]
    time = result.arrays["time_s"]
    reached = np.interp(-exact["eps_v"], -speed, time)
    assert reached == pytest.approx(exact["t_to_eps"], rel=1e-4)
    assert 0.0 <= result.final_speed_m_s < 1e-9


def on_an_incline(single_mass, run, row, speed_m_s):
    scene = {"speed_m_s": speed_m_s, "duration_s": 0.01}
    slope_rad = -np.arctan(row["tan"])
    return run(single_mass("slide", 1e-5, mu=row["mu"], slope_rad=slope_rad, **scene))


@pytest.mark.parametrize("slope", [0.05, 0.15, 0.29])
def test_creep_on_an_incline(slope, single_mass, run, reference):
    row = next(r for r in reference("C5_incline") if r["tan"] == slope)
    result = on_an_incline(single_mass, run, row, 0.0)
    assert result.final_speed_m_s == pytest.approx(row["creep_v"], rel=1e-6)


def test_slip_on_an_incline(single_mass, run, reference):
    row, start = next(r for r in reference("C5_incline") if "accel_over_gcos" in r), 0.1
    result = on_an_incline(single_mass, run, row, start)
    acceleration = (result.final_speed_m_s - start) / result.arrays["time_s"][-1]
    normal = 10.0 * np.cos(np.arctan(row["tan"]))
    assert acceleration / normal == pytest.approx(row["accel_over_gcos"], rel=1e-6)
