"""Robots at rest with flat clamps: what the search for the start of a jump begins from."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from snapjump.composition import Simulation
from snapjump.engine.model import Model
from snapjump.scenes.frame_body import compression
from snapjump.statics.chain_state import chain_state
from snapjump.statics.elastica import buckled_arch, resampled
from snapjump.statics.resting_gap import resting_gap

Array = NDArray[np.float64]


def resting_guesses(simulations: Sequence[Simulation], models: Sequence[Model]) -> Array:
    """States (R, D) of robots of one composition: frame, then nodes (2 or 3 coordinates each)."""
    discretization, rod = simulations[0].discretization, models[0].discretization
    beam_mass = float(np.sum(discretization.masses()))
    x, y = buckled_arch(
        np.array([compression(simulation) for simulation in simulations]), discretization.elements
    )
    chain, skipped = discretization.moving_elements, rod.clamp_distance()
    x, y = resampled(x, skipped, chain), resampled(y, skipped, chain)
    rows = []
    for k, (simulation, model) in enumerate(zip(simulations, models, strict=True)):
        frame = model.frame
        weight = (frame.mass + beam_mass) * model.load.gravity()
        gap = resting_gap(model.contact, weight, 2.0 * model.ground.corner_share)
        mesh = simulation.frame.mesh(frame)
        beam = chain_state(rod, x[k], y[k] + (gap - frame.foot_y) + frame.mount_y)
        state = np.concatenate([np.zeros(frame.dofs(mesh)), beam])
        frame.rest(mesh, state, gap)
        rows.append(state)
    return np.array(rows)


def resting_guess(simulation: Simulation, model: Model) -> Array:
    """State (D) of one robot."""
    return resting_guesses([simulation], [model])[0]
