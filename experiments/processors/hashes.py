"""Hashes of what jumps, snaps and datasets begin with, and of what becomes of 64 drafts."""

import hashlib
from collections.abc import Iterable
from typing import Any

import numpy as np

from snapjump.batch import simulate_designs
from snapjump.batch.prepare import prepare_designs
from snapjump.batch.simulate import marches
from snapjump.composition import with_tier
from snapjump.contact.hunt_crossley import HuntCrossley
from snapjump.discretization.corotational import Corotational
from snapjump.discretization.der import DiscreteElasticRod
from snapjump.discretization.geometrically_exact import GeometricallyExact
from snapjump.robot.robot import Robot
from snapjump.scenes.runner import MOST_ITERATIONS
from snapjump.statics.arch import StaticArch
from snapjump.statics.critical import find_snap
from snapjump.statics.threshold import symmetric_threshold
from snapjump.statics.threshold_curve import ThresholdCurve

from ..designs import spread_designs

DRAFTS = 64
LANES = 8
MISMATCH_RAD = 0.1
COMPRESSIONS = (0.05, 0.2, 0.33)
MESHES = (
    DiscreteElasticRod(elements=104),
    DiscreteElasticRod(elements=66, clamp="two_nodes"),
    Corotational(elements=64),
    GeometricallyExact(elements=64),
)


def digest(arrays: Iterable[Any]) -> str:
    """Hash of numbers to the last bit, 16 hex digits."""
    found = hashlib.sha256()
    for array in arrays:
        found.update(np.ascontiguousarray(array, dtype=float).tobytes())
    return found.hexdigest()[:16]


def statics() -> str:
    """Guesses, equilibria, snaps and thresholds."""
    arrays: list[Any] = []
    for mesh in MESHES:
        arch = StaticArch(Robot(), mesh, 0.2)
        arrays += [arch.guess(), arch.flat(MISMATCH_RAD)]
        for epsilon in COMPRESSIONS:
            for lag in (0.0, MISMATCH_RAD):
                snap = find_snap(Robot(), mesh, epsilon, lag)
                arrays += [snap.alpha_rad, snap.h1_bar, snap.h2_bar, snap.before.energy]
                arrays += [snap.before.state, snap.after.state]
            threshold = symmetric_threshold(Robot(), mesh, epsilon)
            arrays += [threshold.alpha_rad, threshold.h1_bar]
    curve = ThresholdCurve.through(Robot(), MESHES[0], 0.1, 0.3)
    arrays += [*curve.values(np.linspace(0.1, 0.3, 50)), *curve.slopes(0.2)]
    return digest(arrays)


def models() -> str:
    """Numbers of the laws that are solved for, and of the integrators' tableaux."""
    base = with_tier("draft")
    schemes = [with_tier(name).integrator.scheme() for name in ("draft", "standard", "reference")]
    law = HuntCrossley().law(base.robot.scales)
    return digest([law, *(np.concatenate([np.ravel(part) for part in s]) for s in schemes)])


def starts() -> str:
    """States, velocities and accelerations that the drafts' jumps begin with."""
    ready = prepare_designs(with_tier("draft"), np.array(spread_designs(DRAFTS)))
    arrays: list[Any] = []
    for _, march in marches(ready, LANES, 1, MOST_ITERATIONS):
        march.find_starts()
        arrays += [march.numbers, *march.queue[1:5]]
    return digest(arrays)


def drafts() -> str:
    """Apexes, steps and iterations of the drafts' jumps."""
    batch = simulate_designs(with_tier("draft"), np.array(spread_designs(DRAFTS)), lanes=LANES)
    return digest([batch.x_bar, batch.y_bar, batch.steps, batch.newton_iterations])


HASHES = {"statics": statics, "models": models, "starts": starts, "drafts": drafts}
