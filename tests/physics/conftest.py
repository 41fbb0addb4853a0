"""References, and what several of the physics tests are built from."""

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest
from families import FAMILIES
from references import outputs_of

from snapjump import Design, Environment, Result, Robot
from snapjump.composition import Simulation, with_tier
from snapjump.declare.members import member_class
from snapjump.simulation import simulate
from snapjump.statics.arch import StaticArch
from snapjump.statics.critical import Snap, find_snap

DISCRETIZATIONS = FAMILIES["discretization"]
DER = DISCRETIZATIONS["der"]


def slender(ratio: float) -> Robot:
    """A robot with b/L = ratio, hence EI/(EA L^2) = ratio^2 / 12."""
    return Robot(thickness_m=0.02 * ratio)


def discretized(name: str, elements: int, clamp: str = "half_element") -> Any:
    """Options of a discretization by name; only ``der`` has a choice of clamps."""
    chosen = {"clamp": clamp} if name == "der" else {}
    return DISCRETIZATIONS[name](elements=elements, **chosen)


@pytest.fixture(scope="session")
def reference() -> Callable[[str], Any]:
    """The outputs of a reference entry."""
    return outputs_of


@pytest.fixture(scope="session")
def richardson() -> Callable[..., Any]:
    """Limit of values at N, 2N and 4N elements whose error has terms in 1/N^2 and 1/N^next."""

    def limit(coarse: Any, middle: Any, fine: Any, following: int = 4) -> Any:
        first, second = (4.0 * middle - coarse) / 3.0, (4.0 * fine - middle) / 3.0
        share = 2.0**following
        return (share * second - first) / (share - 1.0)

    return limit


@pytest.fixture(scope="session")
def arch() -> Callable[..., StaticArch]:
    """An arch of a robot with b/L = ratio; small ratios stand for inextensible beams."""

    def make(
        epsilon: float,
        elements: int,
        ratio: float = 1e-4,
        clamp: str = "half_element",
        name: str = "der",
    ):
        return StaticArch(slender(ratio), discretized(name, elements, clamp), epsilon)

    return make


@pytest.fixture(scope="session")
def snap() -> Callable[..., Snap]:
    """The snap of an arch, each computed once."""

    @cache
    def find(
        epsilon: float,
        elements: int,
        delta_alpha: float = 0.0,
        ratio: float = 1e-4,
        clamp: str = "half_element",
        name: str = "der",
    ) -> Snap:
        options = discretized(name, elements, clamp)
        return find_snap(slender(ratio), options, epsilon, delta_alpha)

    return find


@pytest.fixture(scope="session")
def beam() -> Callable[..., Simulation]:
    """A simulation of the beam alone, undamped, at a fixed step (s)."""

    def compose(
        step_s: float,
        elements: int = 80,
        integrator: str = "tr_bdf2",
        design: Design | None = None,
        robot: Robot | None = None,
        name: str = "der",
        **scene: float,
    ) -> Simulation:
        return Simulation(
            sim=member_class("sim", "snap")(**scene),
            robot=robot or Robot(),
            design=design or Design(),
            discretization=discretized(name, elements),
            frame=member_class("frame", "fixed")(),
            contact=member_class("contact", "none")(),
            friction=member_class("friction", "none")(),
            damping=member_class("damping", "none")(),
            integrator=member_class("integrator", integrator)(),
            stepping=member_class("stepping", "fixed")(step_s=step_s),
        )

    return compose


@pytest.fixture(scope="session")
def single_mass() -> Callable[..., Simulation]:
    """A simulation of one mass on the barrier, at a fixed step (s)."""

    def compose(
        scene: str,
        step_s: float,
        integrator: str = "tr_bdf2",
        mu: float = 0.3,
        slope_rad: float = 0.0,
        **numbers: float,
    ) -> Simulation:
        return Simulation(
            sim=member_class("sim", scene)(**numbers),
            environment=Environment(mu=mu, slope_rad=slope_rad),
            frame=member_class("frame", "fixed")(),
            integrator=member_class("integrator", integrator)(),
            stepping=member_class("stepping", "fixed")(step_s=step_s),
        )

    return compose


@pytest.fixture(scope="session")
def run() -> Callable[[Simulation], Result]:
    """Simulate, requiring that the scene ends as it should."""

    def succeed(simulation: Simulation) -> Result:
        result = simulate(simulation)
        assert result.status == "ok", result.message
        assert all(np.isfinite(values).all() for values in result.arrays.values())
        return result

    return succeed


@pytest.fixture(scope="session")
def jump() -> Callable[..., Result]:
    """A cheap jump, each computed once; every part can be replaced."""
    done: dict[str, Result] = {}

    def simulate_once(allowed: tuple[str, ...] = ("ok",), **parts: Any) -> Result:
        cheap = {
            "discretization": DER(elements=40),
            "stepping": member_class("stepping", "adaptive")(tolerance=1e-6),
        }
        simulation = with_tier("standard", **(cheap | parts))
        key = repr(simulation)
        if key not in done:
            done[key] = simulate(simulation)
        assert done[key].status in allowed, done[key].message
        return done[key]

    return simulate_once
