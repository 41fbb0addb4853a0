"""Drag in a march: the acceleration that the air gives all masses in the stage at hand.

The velocity of the centre of mass there is foreseen, to second order, from the beginning of its
step, so that no equation of the stage couples all coordinates.
"""

from typing import Any

from snapjump.engine.centre_of_mass import mean_of
from snapjump.number.dispatch import routine
from snapjump.number.functions import where


@routine
def feel_air(model: Any, masses: Any, work: Any, ahead: Any, mask: Any) -> None:
    """Set ``work.air`` of the masked lanes, whose stage is a time (T) ``ahead`` of their step's
    beginning."""
    vx, vy = mean_of(model, masses, work.mesh, work.velocity[0])
    ax, ay = mean_of(model, masses, work.mesh, work.acceleration[0])
    along, across = model.drag.acceleration(vx + ahead * ax, vy + ahead * ay)
    work.air[0] = where(mask, along, work.air[0])
    work.air[1] = where(mask, across, work.air[1])
