"""The robot: what is built once, in SI units, with the values of the paper's table.

Powers are products, here and wherever a jump's numbers come from: the bits of ``**`` depend on the
processor.
"""

import math
from functools import partial
from typing import Literal

from snapjump.checks import ParameterError
from snapjump.declare.fields import Part, number
from snapjump.units import Scales

# Of every number that has to be positive: their products and powers remain numbers.
SMALLEST, LARGEST = 1e-15, 1e20
positive = partial(number, least=SMALLEST, most=LARGEST)


class Robot(Part):
    """A beam clamped in a rigid frame (leg, top, leg).

    ``mount_height`` is the height of the clamps above the feet: a number in metres, or
    ``"optimal"`` for the depth h1(epsilon) of the beam's lowest point as it snaps, so that it
    just touches the ground then, or ``"fitted"`` for the released program's fit of that.
    """

    group = "robot"

    length_m: float = positive(
        0.02, unit="m", doc="length of the beam", symbol="L", plan=(0.015, 0.03), usual=(1e-4, 2.0)
    )
    width_m: float = positive(
        0.01, unit="m", doc="width of the beam", symbol="w", plan=(0.005, 0.02), usual=(1e-5, 1.0)
    )
    thickness_m: float = positive(
        5e-5,
        unit="m",
        doc="thickness of the beam",
        symbol="b",
        plan=(3.5e-5, 7.5e-5),
        usual=(1e-7, 0.05),
    )
    youngs_modulus_Pa: float = positive(
        2e11, unit="Pa", doc="Young's modulus", symbol="E", plan=(1e11, 3e11), usual=(1e4, 2e12)
    )
    density_kg_m3: float = positive(
        5000.0,
        unit="kg/m^3",
        doc="density of the beam",
        symbol="ρ",
        plan=(2000.0, 8000.0),
        usual=(1.0, 25e3),
    )
    frame_height_m: float = positive(
        0.01,
        unit="m",
        doc="height of the frame",
        symbol="l₂",
        plan=(0.005, 0.02),
        usual=(1e-5, 2.0),
        takes_arrays=True,
    )
    gravity_m_s2: float = number(
        10.0, least=0.0, most=LARGEST, unit="m/s^2", doc="gravity", symbol="g", plan=(1.6, 10.0),
        kind="environment", usual=(0.0, 300.0), takes_arrays=True,
    )  # fmt: skip
    mount_height: float | Literal["optimal", "fitted"] = number(
        "optimal", above=0.0, unit="m", words=("optimal", "fitted"), symbol="h",
        plan=(1.5e-3, 4e-3), doc="height of the clamps above the feet",
        usual=(1e-6, 1.0),
    )  # fmt: skip
    yield_stress_Pa: float | None = number(
        None, above=0.0, unit="Pa", doc="stress at which the beam yields; it moves no apex",
        symbol="σ_y", plan=(1e9, 2e9), usual=(1e4, 1e11), takes_arrays=True,
    )  # fmt: skip

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.thickness_m > 0.1 * self.length_m:
            allowed = f"a slender beam: at most a tenth of robot.length_m = {self.length_m:g} m"
            raise ParameterError("robot.thickness_m", self.thickness_m, allowed)
        if not isinstance(self.mount_height, str) and self.mount_height > self.frame_height_m:
            numbers = f"a number in (0, {self.frame_height_m:g}] m (up to robot.frame_height_m)"
            allowed = f"{numbers}, or 'optimal' or 'fitted'"
            raise ParameterError("robot.mount_height", self.mount_height, allowed)

    @property
    def bending_stiffness_N_m2(self) -> float:
        area = self.width_m * self.thickness_m
        return self.youngs_modulus_Pa * area * self.thickness_m * self.thickness_m / 12.0

    @property
    def beam_mass_kg(self) -> float:
        return self.density_kg_m3 * self.width_m * self.thickness_m * self.length_m

    @property
    def stretching_stiffness_bar(self) -> float:
        """EA L^2 / EI = 12 (L/b)^2."""
        slenderness = self.length_m / self.thickness_m
        return 12.0 * slenderness * slenderness

    @property
    def scales(self) -> Scales:
        """Length L, time T = L^2 sqrt(rho A / EI), mass rho A L."""
        cube = self.length_m * self.length_m * self.length_m
        time_s = math.sqrt(self.beam_mass_kg * cube / self.bending_stiffness_N_m2)
        return Scales(self.length_m, time_s, self.beam_mass_kg)
