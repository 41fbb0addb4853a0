"""A rigid frame's mass: as it is measured, or evenly along leg, top, leg."""

from typing import Any

import numpy as np

from snapjump.checks import ParameterError
from snapjump.declare.fields import number
from snapjump.frame.base import FrameOptions, Outline
from snapjump.frame.parts.mass_layout import Lump, evenly_with_ends, measured, with_ends


class FrameMass(FrameOptions):
    """Where a rigid frame's own centre of mass is, its moment of inertia, and masses at its clamps.

    Its own mass is the robot's less the beam's and the clamps'.
    """

    mass_centre_height_m: float | None = number(
        None, above=0.0, unit="m", doc="the frame's own centre of mass above the feet",
        symbol="h_c", plan=(3e-3, 1e-2), takes_arrays=True,
    )  # fmt: skip
    mass_centre_offset_m: float = number(
        0.0, least=-100.0, most=100.0, unit="m",
        doc="the frame's own centre of mass to the right of the middle",
        symbol="x_c", plan=(-1e-3, 1e-3), takes_arrays=True,
    )  # fmt: skip
    inertia_kg_m2: float | None = number(
        None, above=0.0, unit="kg m^2", doc="the frame's own moment of inertia about its centre",
        symbol="I_c", plan=(5e-8, 2e-7), takes_arrays=True,
    )  # fmt: skip
    clamp_mass_kg: float = number(
        0.0, least=0.0, unit="kg", doc="mass at each clamp, as of a motor; part of mass_bar",
        symbol="m_c", plan=(0.0, 5e-4), takes_arrays=True,
    )  # fmt: skip

    def check_with(self, simulation: Any) -> None:
        robot = simulation.robot
        half_m = 0.5 * robot.length_m * (1.0 - simulation.design.epsilon)
        if np.any(np.abs(self.mass_centre_offset_m) >= half_m):
            allowed = f"between -{half_m:.6g} and {half_m:.6g} m, where the feet are"
            raise ParameterError("frame.mass_centre_offset_m", self.mass_centre_offset_m, allowed)
        if np.any(self.clamp_mass_kg > 0.0):
            frame_kg = simulation.environment.mass_kg(robot) - robot.beam_mass_kg
            if np.any(2.0 * self.clamp_mass_kg >= frame_kg):
                allowed = f"less than {0.5 * frame_kg:.6g} kg, half of the robot without its beam"
                raise ParameterError("frame.clamp_mass_kg", self.clamp_mass_kg, allowed)

    @property
    def symmetric(self) -> bool:
        return not np.any(self.mass_centre_offset_m)

    def with_clamps(self, outline: Outline) -> Lump:
        """The frame and all that moves with it, from the middle between its feet (L, rho A L)."""
        width, height, mount, mass, end = outline[:5]
        clamp = self.clamp_mass_kg / outline.mass_kg
        mass, end, half = mass - 2.0 * clamp, end + clamp, 0.5 * width
        height_m, inertia = self.mass_centre_height_m, self.inertia_kg_m2
        if height_m is None and inertia is None and self.symmetric:
            return evenly_with_ends(mass, width, height, end, mount)
        x = self.mass_centre_offset_m / outline.length_m
        y = None if height_m is None else height_m / outline.length_m
        if inertia is not None:
            inertia = inertia / (outline.mass_kg * outline.length_m * outline.length_m)
        return with_ends(measured(mass, width, height, (x, y), inertia), end, half, mount)
