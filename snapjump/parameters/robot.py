"""The robot: what is built once, in SI units, with the values of the paper's table.

Powers are products, here and wherever a jump's numbers come from: the bits of ``**`` depend on the
processor.
"""

import math
from typing import Literal

from snapjump.checks import ParameterError, check_number
from snapjump.declare.fields import Part, number
from snapjump.units import Scales

# Of every number that has to be positive: their products and powers remain numbers.
SMALLEST, LARGEST = 1e-15, 1e20


class Robot(Part):
    """A beam clamped in a rigid frame (leg, top, leg).

    ``mount_height`` is the height of the clamps above the feet: a number in metres, or
    ``"optimal"`` for the depth h1(epsilon) of the beam's lowest point as it snaps, so that it
    just touches the ground then, or ``"fitted"`` for the released program's fit of that.
    """

    group = "robot"

    length_m: float = number(0.02, least=SMALLEST, most=LARGEST, unit="m")
    width_m: float = number(0.01, least=SMALLEST, most=LARGEST, unit="m")
    thickness_m: float = number(5e-5, least=SMALLEST, most=LARGEST, unit="m")
    youngs_modulus_Pa: float = number(2e11, least=SMALLEST, most=LARGEST, unit="Pa")  # noqa: N815 (the unit is a capital)
    density_kg_m3: float = number(5000.0, least=SMALLEST, most=LARGEST, unit="kg/m^3")
    frame_height_m: float = number(0.01, least=SMALLEST, most=LARGEST, unit="m")
    gravity_m_s2: float = number(10.0, least=0.0, most=LARGEST, unit="m/s^2")
    rotation_rate_rad_s: float = number(20.0, least=SMALLEST, most=LARGEST, unit="rad/s")
    rotation_end_rad: float = number(1.5, least=0.0, most=math.pi / 2, unit="rad")
    mount_height: float | Literal["optimal", "fitted"] = "optimal"

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.thickness_m > 0.1 * self.length_m:
            raise ParameterError(
                "robot.thickness_m",
                self.thickness_m,
                f"a slender beam: at most a tenth of robot.length_m = {self.length_m:g} m",
            )
        if isinstance(self.mount_height, str):
            if self.mount_height not in ("optimal", "fitted"):
                allowed = "'optimal', 'fitted' or a number of metres"
                raise ParameterError("robot.mount_height", self.mount_height, allowed)
        else:
            check_number(
                "robot.mount_height",
                self.mount_height,
                0.0,
                self.frame_height_m,
                above=True,
                unit="m (up to robot.frame_height_m), or 'optimal' or 'fitted'",
            )

    @property
    def bending_stiffness_N_m2(self) -> float:  # noqa: N802
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
