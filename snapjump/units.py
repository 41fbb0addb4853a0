"""The scales that make the mechanics dimensionless: length L, time T, mass of the beam.

With EI = rho A = L = 1 only ratios are left, so that scaling E, rho or L at fixed dimensionless
groups changes no result. T = L^2 sqrt(rho A / EI).
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Scales:
    """One unit of each dimensionless quantity, in SI."""

    length_m: float
    time_s: float
    mass_kg: float

    @property
    def velocity_m_s(self) -> float:
        return self.length_m / self.time_s

    @property
    def acceleration_m_s2(self) -> float:
        return self.length_m / (self.time_s * self.time_s)

    @property
    def force_N(self) -> float:
        return self.mass_kg * self.acceleration_m_s2

    @property
    def energy_J(self) -> float:
        return self.force_N * self.length_m

    @property
    def stiffness_N_m(self) -> float:
        return self.force_N / self.length_m
