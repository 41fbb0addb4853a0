"""Configurations of before: kept ones open, old keys on a command line learn their new name."""

import math

import pytest

from snapjump.checks import ParameterError
from snapjump.declare.former_options import FORMER, check_arguments, with_present_options
from snapjump.simulation import build

KEPT = {
    "sim": {"name": "slide", "speed_m_s": 0.2, "incline": 0.25},
    "environment": {"mu": 0.4, "mass_bar": 0.768},
    "linear_solver": {"name": "banded"},
}


def test_a_kept_configuration_opens_under_the_names_of_today() -> None:
    simulation = build(KEPT)
    assert simulation.environment.slope_rad == pytest.approx(-math.atan(0.25), rel=1e-15)
    assert simulation.environment.mu == 0.4 and simulation.sim.speed_m_s == 0.2
    assert KEPT["sim"]["incline"] == 0.25  # type: ignore[index]
    assert "linear_solver" not in with_present_options(KEPT)


def test_level_ground_has_no_slope_of_either_sign() -> None:
    kept = with_present_options({"sim": {"name": "slide", "incline": 0.0}})
    assert math.copysign(1.0, kept["environment"]["slope_rad"]) == 1.0


@pytest.mark.parametrize("prefix", ["", "+", "~"])
@pytest.mark.parametrize("key", [*FORMER, "linear_solver.name", "linear_solver@other"])
def test_an_old_key_is_refused_with_its_new_name(prefix: str, key: str) -> None:
    with pytest.raises(ParameterError) as caught:
        check_arguments(["sim=jump", f"{prefix}{key}=1"])
    text = str(caught.value)
    assert text.startswith(key.partition("@")[0]) and "\n" not in text
    (new,) = (f for old, f in FORMER.items() if key.startswith(old))
    assert new.path in text


def test_keys_of_today_pass() -> None:
    check_arguments(["sim=slide", "environment.slope_rad=0.1", "-m", "linear_solvers=1"])
