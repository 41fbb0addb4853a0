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


@pytest.mark.parametrize("slope", [0.05, 0.15, 0.29])
def test_creep_on_an_incline(slope, single_mass, run, reference):
    row = next(r for r in reference("C5_incline") if r["tan"] == slope)
    result = run(
        single_mass(
            "slide", 1e-5, mu=row["mu"], speed_m_s=0.0, slope_rad=-np.arctan(slope), duration_s=0.01
        )
    )
    assert result.final_speed_m_s == pytest.approx(row["creep_v"], rel=1e-6)


def test_slip_on_an_incline(single_mass, run, reference):
    row = next(r for r in reference("C5_incline") if "accel_over_gcos" in r)
    slope, start = row["tan"], 0.1
    result = run(
        single_mass(
            "slide",
            1e-5,
            mu=row["mu"],
            speed_m_s=start,
            slope_rad=-np.arctan(slope),
            duration_s=0.01,
        )
    )
    acceleration = (result.final_speed_m_s - start) / result.arrays["time_s"][-1]
    normal = 10.0 * np.cos(np.arctan(slope))
    assert acceleration / normal == pytest.approx(row["accel_over_gcos"], rel=1e-6)
