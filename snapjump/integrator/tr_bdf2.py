"""TR-BDF2 (Bank et al. 1985; Hosea and Shampine 1996): trapezoidal rule, then BDF2."""

import math
from dataclasses import dataclass
from typing import ClassVar

from snapjump.integrator.base import Integrator

GAMMA = 1.0 - 1.0 / math.sqrt(2.0)
OMEGA = math.sqrt(2.0) / 4.0


@dataclass(frozen=True)
class TrBdf2(Integrator):
    """Second order, an explicit and two implicit stages, L-stable; third-order error estimate."""

    rows: ClassVar = ((0.0,), (GAMMA, GAMMA), (OMEGA, OMEGA, GAMMA))
    order: ClassVar = 2
    damping_at_infinity: ClassVar = 0.0
