"""Energy and momentum bounds on flights, which a true one cannot exceed.

No robot gets farther than the energy of its beam carries it, nor along the ground faster than
friction, at most a share of the push of the ground, can drive it (Coulomb).
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.engine import outcome as c
from snapjump.engine.status import ENERGY_GAINED, MOMENTUM_GAINED, OK
from snapjump.scenes.flight import flight, world

Array = NDArray[np.float64]

# Elastic energy of the arch at its critical angle, over epsilon: 89 to 96 EI/L (S5 of the
# references); three times that leaves room for what the clamps do afterwards.
ENERGY_PER_COMPRESSION = 3.0 * 96.0
# Clamps that turn fast drive the beam: of the square of their rate (rad/T).
ENERGY_PER_RATE_SQUARED = 10.0

# What steps may add to friction's impulse, and of the ground's impulse.
FRICTION_MARGIN, REMAINDER = 1.2, 0.02


def farthest_apex(model: Any, beam_mass: float) -> Any:
    """Bound on how far (L) a robot can rise, and come while it does, with its beam's energy.

    ``model``: one, or R of them side by side.
    """
    frame = model.frame
    compression = 1.0 - 2.0 * frame.half_span + 2.0 * getattr(frame, "inset", 0.0)
    fastest = model.clamp.rate * np.maximum(1.0, np.abs(model.clamp.right_over_left()))
    turning = ENERGY_PER_RATE_SQUARED * fastest * fastest
    energy = ENERGY_PER_COMPRESSION * compression + turning
    return 1.0 + energy / ((frame.mass + beam_mass) * model.load.acceleration)


def driven_too_far(model: Any, outcome: Array) -> Any:
    """Whether robots (R) have more momentum along the ground than friction can have given them."""
    time, load = outcome[:, c.TIME], model.load
    along = np.abs(outcome[:, c.COM_VX] - load.pull() * time)
    pushed = np.abs(outcome[:, c.COM_VY] + load.gravity() * time)
    return along > (FRICTION_MARGIN * model.friction.largest_ratio() + REMAINDER) * pushed


def checked_status(model: Any, beam_mass: float, outcome: Array) -> Array:
    """The statuses (R) of jumps that ended with outcomes (R, COLUMNS); a flight that cannot be true
    is no success."""
    flown = flight(0.0, model.load, outcome, model.drag)
    distance, height = world(model.load, flown.apex_x, flown.apex_y)
    # Thrown at the best angle, the apex is half as high as straight up, and as far as that.
    gained = np.maximum(height, np.abs(distance)) > farthest_apex(model, beam_mass)
    status = outcome[:, c.STATUS]
    status = np.where((status == OK) & gained, float(ENERGY_GAINED), status)
    driven = driven_too_far(model, outcome)
    return np.where((status == OK) & driven, float(MOMENTUM_GAINED), status)
