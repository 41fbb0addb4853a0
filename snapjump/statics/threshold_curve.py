"""Thresholds of many pre-compressions of one beam: interpolated, with their derivatives.

A threshold costs milliseconds, one of a random design is needed once, and sensitivities need its
derivative by epsilon. In the square root of the compression both its figures are analytic (shallow
arches snap at 2 sqrt(epsilon)), so that a polynomial through a score of them is as good as they
are.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.polynomial import Chebyshev
from numpy.typing import ArrayLike, NDArray

from snapjump.checks import ParameterError
from snapjump.number.trigonometry import cos
from snapjump.robot.robot import Robot
from snapjump.statics.rounding import LostToRoundingError
from snapjump.statics.threshold import symmetric_threshold

Array = NDArray[np.float64]
NODES = 20
MARGIN = 0.98


def direct(robot: Robot, discretization: Any, compressions: Array) -> Array:
    """Angle (rad) and depth (L) of every compression's threshold, each computed: (2, R)."""
    found = [symmetric_threshold(robot, discretization, float(value)) for value in compressions]
    return np.array([[t.alpha_rad for t in found], [t.h1_bar for t in found]])


def chebyshev_through(values: Array, ends: Array) -> Chebyshev:
    """The polynomial through values (n) at Chebyshev's nodes, largest first, between two ends.

    Its coefficients are sums (Trefethen 2019, chapter 3), whose bits depend on no LAPACK.
    """
    count = len(values)
    coefficients = []
    for order in range(count):
        waves = [cos(np.pi * order * k / (2 * count)) for k in range(1, 2 * count, 2)]
        total = sum(wave * value for wave, value in zip(waves, values, strict=True))
        coefficients.append(total * ((1.0 if order == 0 else 2.0) / count))
    return Chebyshev(coefficients, domain=ends)


@dataclass(frozen=True)
class ThresholdCurve:
    """Critical angle and depth over compressions from ``low`` to ``high`` of one robot and mesh.

    ``angle_error`` (rad), ``depth_error`` (L): largest difference from thresholds computed halfway
    between those that the curve goes through.
    """

    robot: Robot
    discretization: Any
    low: float
    high: float
    angle: Chebyshev
    depth: Chebyshev
    angle_error: float
    depth_error: float

    @classmethod
    def through(
        cls, robot: Robot, discretization: Any, low: float, high: float, nodes: int = NODES
    ) -> "ThresholdCurve":
        """The curve through so many thresholds between two compressions (shares of the length).

        Raises ParameterError where an arch of the range has no threshold.
        """
        if not 0.0 < low < high <= 0.4:
            raise ParameterError("low, high", (low, high), "0 < low < high <= 0.4")
        ends = np.sqrt([low, high])
        # Every other point is one of Chebyshev's nodes, those between are for the check.
        cosines = np.array([cos(np.pi * k / (2 * nodes)) for k in range(1, 2 * nodes)])
        roots = 0.5 * (ends[0] + ends[1]) + 0.5 * (ends[1] - ends[0]) * cosines
        try:
            values = direct(robot, discretization, roots**2)
        except LostToRoundingError:
            raise
        except ArithmeticError as error:
            raise ParameterError(
                "low, high",
                (low, high),
                f"pre-compressions that all buckle the beam of this robot and mesh "
                f"({discretization.elements} elements), and snap back when its clamps turn",
            ) from error
        angle, depth = (chebyshev_through(row[::2], ends) for row in values)
        between = slice(1, None, 2)
        return cls(
            robot,
            discretization,
            low,
            high,
            angle,
            depth,
            float(np.abs(angle(roots[between]) - values[0, between]).max()),
            float(np.abs(depth(roots[between]) - values[1, between]).max()),
        )

    @classmethod
    def over(cls, robot: Robot, discretization: Any, compressions: Array) -> "ThresholdCurve":
        """The curve that covers all these compressions, and a little more."""
        low, high = float(np.min(compressions)), float(np.max(compressions))
        return cls.through(robot, discretization, MARGIN * low, min(high / MARGIN, 0.4))

    def covers(self, compression: ArrayLike) -> Any:
        """Whether compressions lie in the curve's range."""
        values = np.asarray(compression)
        return (values >= self.low) & (values <= self.high)

    def values(self, compression: ArrayLike) -> tuple[Any, Any]:
        """Critical angles (rad) and depths (L); only where the curve covers it."""
        root = np.sqrt(compression)
        return self.angle(root), self.depth(root)

    def slopes(self, compression: ArrayLike) -> tuple[Any, Any]:
        """Their derivatives by the compression."""
        root = np.sqrt(compression)
        return self.angle.deriv()(root) / (2.0 * root), self.depth.deriv()(root) / (2.0 * root)
