"""SDIRK2 (Alexander 1977): two stages, gamma = 1 - 1/sqrt(2), L-stable."""

import math
from dataclasses import dataclass
from typing import ClassVar

from snapjump.integrator.base import Integrator

GAMMA = 1.0 - 1.0 / math.sqrt(2.0)


@dataclass(frozen=True)
class Sdirk2(Integrator):
    """Second order, two implicit stages, L-stable."""

    rows: ClassVar = ((0.0,), (0.0, GAMMA), (0.0, 1.0 - GAMMA, GAMMA))
    order: ClassVar = 2
    damping_at_infinity: ClassVar = 0.0
