"""Small robots for tests of the engine: coarse, hence quick, but whole."""

from dataclasses import replace
from typing import Any

from snapjump import Design, Environment
from snapjump.composition import Simulation, with_tier
from snapjump.contact.logbarrier import LogBarrier
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.engine.model import Model, TimeLimit
from snapjump.integrator.generalized_alpha import GeneralizedAlpha
from snapjump.scenes.jump_march import jump_march
from snapjump.scenes.jump_start import composed_model
from snapjump.stepping.adaptive import AdaptiveStep

# epsilon: critical angle (rad) and depth of the lowest point there (L), S5 of physics.json
CRITICAL = {0.1: (0.6385, 0.0543), 0.2: (0.9117, 0.0736), 0.3: (1.127, 0.0860)}

# epsilon, delta_alpha, mu, mass_bar
DESIGNS = (
    (0.1, 0.02, 0.1, 0.4), (0.2, 0.10, 0.3, 0.768), (0.3, 0.15, 0.6, 1.5), (0.2, 0.05, 0.2, 2.0),
    (0.1, 0.19, 0.5, 0.3), (0.3, 0.02, 0.3, 0.900), (0.2, 0.15, 0.4, 1.2), (0.1, 0.10, 0.2, 0.6),
    (0.2, 0.01, 0.6, 0.5), (0.3, 0.19, 0.1, 0.300), (0.2, 0.00, 0.3, 1.0),
)  # fmt: skip


def small_simulation(epsilon: float, delta_alpha: float, mu: float, mass_bar: float) -> Simulation:
    return with_tier(
        "draft",
        design=Design(epsilon, delta_alpha),
        environment=Environment(mu, mass_bar),
        discretization=DiscreteElasticRod(24),
        stepping=AdaptiveStep(1e-5, 2.0),
        contact=LogBarrier(distance_m=1e-3),
    )


BASELINE = small_simulation(0.2, 0.1, 0.3, 0.768)


def small_model(simulation: Simulation) -> Model:
    """A robot that starts near its threshold, without any statics."""
    angle, depth = CRITICAL[simulation.design.epsilon]
    return composed_model(simulation, 0.85 * angle, 1.05 * depth, simulation.sim.time_limit_s)


# What rounding makes of a jump in so few steps grows least with fast oscillations annihilated, and
# sticking resolved.
QUIET = {
    "integrator": GeneralizedAlpha(spectral_radius=0.0),
    "stepping": AdaptiveStep(1e-5, 2.0, 16.0),
}


def small_march(
    designs: Any,
    lanes: int,
    starts: Any = None,
    duration: float = 20.0,
    threads: int = 1,
    **parts: Any,
) -> Any:
    """A march of robots of these designs; ``starts``: a queue's state, velocity, acceleration."""
    simulations = [replace(small_simulation(*design), **parts) for design in designs]
    limit = TimeLimit(duration)
    models = [small_model(simulation)._replace(time_limit=limit) for simulation in simulations]
    march = jump_march(simulations, models, lanes=lanes, threads=threads)
    if starts is not None:
        for target, values in zip(march.queue[1:4], starts, strict=True):
            target[...] = values
    return march
