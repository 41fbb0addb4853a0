"""Robots at rest with flat clamps: what the search for the start of a jump begins from.

What robots have in common is computed once: arches of one compression, gaps under one weight.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from snapjump.arrays import Array, distinct_rows
from snapjump.composition import Simulation
from snapjump.engine.model import Model
from snapjump.scenes.frame_body import compression
from snapjump.scenes.march_outputs import side_by_side
from snapjump.statics.chain_state import chain_state
from snapjump.statics.elastica import buckled_arch, resampled
from snapjump.statics.resting_gap import resting_gap


def resting_guesses(base: Simulation, models: Sequence[Model], compressions: Array) -> Array:
    """States (R, D) of robots of one composition and mesh, of compressions (R): frame, then nodes
    (2 or 3 coordinates each)."""
    robots, rod = len(models), models[0].discretization
    side, mesh = side_by_side(models, range(robots), robots), base.frame.mesh(models[0].frame)
    frame = side.frame
    weights = (frame.mass + float(np.sum(base.discretization.masses()))) * side.load.gravity()
    gaps = resting_gaps(side.contact, weights, 2.0 * side.ground.corner_share)
    held, middle = frame.dofs(mesh), np.broadcast_to(frame.rest_middle(), robots)
    alike = np.column_stack([compressions, gaps - frame.foot_y, frame.mount_y, middle])
    different, places = distinct_rows(alike)
    shortening, feet, mounts, middles = different.T[:, :, None]
    x, y = arches(base, rod, shortening[:, 0])
    beams = chain_state(rod, x + middles, y + feet + mounts)
    kinds = np.zeros((len(beams), held + beams.shape[1]))
    kinds[:, held:] = beams
    states: Array = kinds[places]
    frame.rest(mesh, states.T, gaps)
    return states


def arches(base: Simulation, rod: Any, compressions: Array) -> tuple[Array, Array]:
    """Places x, y of the chains' nodes (R, N each), y above the clamps."""
    chain, skipped = base.discretization.moving_elements, rod.clamp_distance()
    different, places = np.unique(compressions, return_inverse=True)
    x, y = buckled_arch(different, base.discretization.elements)
    return resampled(x, skipped, chain)[places], resampled(y, skipped, chain)[places]


def resting_gaps(contact: Any, weights: Array, points: Array) -> Array:
    """Gaps (R, in L) at which laws side by side carry weights (R) at so many points (R)."""
    loads = np.column_stack([*contact, weights, points])
    different, places = distinct_rows(loads)
    found = [
        resting_gap(type(contact)(*law), weight, count)
        for *law, weight, count in different.tolist()
    ]
    return np.array(found)[places]


def resting_guess(simulation: Simulation, model: Model) -> Array:
    """State (D) of one robot."""
    return resting_guesses(simulation, [model], np.array([compression(simulation)]))[0]
