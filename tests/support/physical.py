"""What the physics tests are built from: arches, beams, masses and jumps; each costs once."""

from functools import cache
from typing import Any

import numpy as np
from families import FAMILIES

from snapjump import Design, Environment, Result, Robot
from snapjump.composition import Simulation, with_tier
from snapjump.friction.implicit import ImplicitFriction
from snapjump.scenes.mass import march_mass, mass_model
from snapjump.sim.bounce import BounceOutputs
from snapjump.simulation import simulate
from snapjump.statics.arch import StaticArch
from snapjump.statics.critical import Snap, find_snap
from snapjump.stepping.adaptive import AdaptiveStep
from snapjump.stepping.fixed import FixedStep

DISCRETIZATIONS = FAMILIES["discretization"]
# epsilon, delta_alpha, mu, mass_bar
DESIGNS = {
    "baseline": (0.2, 0.1, 0.3, 0.768),
    "light": (0.15, 0.05, 0.4, 0.3),
    "even": (0.25, 0.01, 0.2, 0.6),
    "heavy": (0.3, 0.15, 0.5, 1.5),
}
JUMPS: dict[str, Result] = {}


def slender(ratio: float) -> Robot:
    """A robot with b/L = ratio, hence EI/(EA L^2) = ratio^2 / 12."""
    return Robot(thickness_m=0.02 * ratio)


def parts_of(design: tuple[float, ...]) -> dict[str, Any]:
    """A design and its environment, as parts of a simulation."""
    epsilon, lag, mu, mass_bar = design
    return {"design": Design(epsilon, lag), "environment": Environment(mu, mass_bar)}


def discretized(name: str, elements: int, clamp: str = "half_element") -> Any:
    """Options of a discretization by name; only ``der`` has a choice of clamps."""
    chosen = {"clamp": clamp} if name == "der" else {}
    return DISCRETIZATIONS[name](elements=elements, **chosen)


def arch(
    epsilon: float,
    elements: int,
    ratio: float = 1e-4,
    clamp: str = "half_element",
    name: str = "der",
) -> StaticArch:
    """An arch of a robot with b/L = ratio; small ratios stand for inextensible beams."""
    return StaticArch(slender(ratio), discretized(name, elements, clamp), epsilon)


@cache
def snap(
    epsilon: float,
    elements: int,
    delta_alpha: float = 0.0,
    ratio: float = 1e-4,
    clamp: str = "half_element",
    name: str = "der",
) -> Snap:
    """The snap of such an arch."""
    return find_snap(slender(ratio), discretized(name, elements, clamp), epsilon, delta_alpha)


def beam(
    step_s: float,
    elements: int = 80,
    integrator: str = "tr_bdf2",
    design: Design | None = None,
    name: str = "der",
    **scene: float,
) -> Simulation:
    """A simulation of the beam alone, undamped, at a fixed step."""
    return Simulation(
        sim=FAMILIES["sim"]["snap"](**scene),
        design=design or Design(),
        discretization=discretized(name, elements),
        damping="none",
        integrator=integrator,
        stepping=FixedStep(step_s),
        friction=ImplicitFriction(1e-4) if scene == "slide" else None,
    )


def single_mass(
    scene: str,
    step_s: float,
    integrator: str = "tr_bdf2",
    mu: float = 0.3,
    slope_rad: float = 0.0,
    **numbers: float,
) -> Simulation:
    """A simulation of one mass on the barrier, at a fixed step."""
    return Simulation(
        sim=FAMILIES["sim"][scene](**numbers),
        environment=Environment(mu=mu, slope_rad=slope_rad),
        integrator=integrator,
        stepping=FixedStep(step_s),
        friction=ImplicitFriction(1e-4) if scene == "slide" else None,
    )


def thrown(
    simulation: Simulation, height_m: float, speed_m_s: float, gravity_m_s2: float = 0.0
) -> Result:
    """What becomes of one mass that is thrown downwards from a height."""
    scales = simulation.robot.scales
    model = mass_model(simulation, gravity_m_s2, 0.0)
    start = (0.0, height_m / scales.length_m)
    fall = (0.0, -speed_m_s / scales.velocity_m_s)
    return march_mass(simulation, model, start, fall, BounceOutputs, None)


def run(simulation: Simulation, status: str = "ok") -> Result:
    """Simulate, requiring that the scene ends as it should."""
    result = simulate(simulation)
    assert result.status == status, result.message
    assert all(np.isfinite(values).all() for values in result.arrays.values())
    return result


def jump(allowed: tuple[str, ...] = ("ok",), **parts: Any) -> Result:
    """A cheap jump; every part can be replaced."""
    cheap = {
        "discretization": DISCRETIZATIONS["der"](elements=40),
        "stepping": AdaptiveStep(tolerance=1e-6),
    }
    simulation = with_tier("standard", **(cheap | parts))
    key = repr(simulation)
    if key not in JUMPS:
        JUMPS[key] = simulate(simulation)
    assert JUMPS[key].status in allowed, JUMPS[key].message
    return JUMPS[key]
