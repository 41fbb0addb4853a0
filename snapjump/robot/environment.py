"""The environment: what a jump meets."""

import math
from typing import Any

import numpy as np

from snapjump.checks import ParameterError
from snapjump.declare.fields import Part, number
from snapjump.robot.robot import SMALLEST, Robot


def mass_bar(mass_kg: float, robot: Robot) -> float:
    """A mass as m g L^2/EI."""
    square = robot.length_m * robot.length_m
    return mass_kg * (robot.gravity_m_s2 * square / robot.bending_stiffness_N_m2)


class Environment(Part):
    """Friction coefficient mu, the robot's whole mass as mass_bar = m g L^2 / EI, and the slope of
    the ground, positive where it rises towards +x."""

    group = "environment"

    mu: float = number(
        0.3, least=0.0, most=100.0, usual=(0.0, 5.0), doc="friction coefficient", symbol="μ",
        plan=(0.1, 0.6), kind="environment", takes_arrays=True,
    )  # fmt: skip
    mass_bar: float = number(
        0.768, above=0.0, doc="m g L^2/EI of the whole robot", symbol="m̄", plan=(0.3, 2.0),
        kind="environment", takes_arrays=True,
    )  # fmt: skip

    slope_rad: float = number(
        0.0, least=-1.5, most=1.5, unit="rad", doc="slope of the ground",
        symbol="σ", plan=(-0.05, 0.05), kind="environment",
    )  # fmt: skip

    def check_slope(self, mu: float) -> None:
        """Raises ParameterError for a slope on which friction of a coefficient holds nothing."""
        if self.slope_rad != 0.0 and abs(math.tan(self.slope_rad)) >= mu:
            steepest = math.atan(mu)
            allowed = "0 without friction"
            if mu > 0.0:
                between = f"between {-steepest:.6g} and {steepest:.6g} rad"
                allowed = f"{between}, where friction of coefficient {mu:g} holds the robot"
            raise ParameterError("environment.slope_rad", self.slope_rad, allowed)

    def lightest_bar(self, robot: Robot) -> float:
        """mass_bar of the beam alone."""
        return robot.beam_mass_kg * mass_bar(1.0, robot)

    def has_mass(self, robot: Robot) -> Any:
        """Whether there is gravity to define mass_bar with, and more mass than the beam's; of
        many, which of them."""
        heavy = self.mass_bar > self.lightest_bar(robot)
        return (robot.gravity_m_s2 >= SMALLEST) & heavy

    def mass_kg(self, robot: Robot) -> float:
        """The robot's whole mass.

        Raises ParameterError if that is no more than the beam's own mass, or if there is no
        gravity to define mass_bar with.
        """
        if np.all(self.has_mass(robot)):
            return self.mass_bar / mass_bar(1.0, robot)
        if robot.gravity_m_s2 < SMALLEST:
            why = "without gravity a jump has no apex, and mass_bar = m g L^2/EI defines no mass"
            allowed = f"at least {SMALLEST:g}, since {why}"
            raise ParameterError("robot.gravity_m_s2", robot.gravity_m_s2, allowed)
        allowed = f"above {self.lightest_bar(robot):.6g}, the mass of the beam alone"
        raise ParameterError("environment.mass_bar", self.mass_bar, allowed)
