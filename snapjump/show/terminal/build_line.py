"""The robot to be built, in the units of the workbench: one line of a closing block."""

import math
from collections.abc import Mapping
from typing import Any

from snapjump.declare.fields import construct
from snapjump.robot.other_units import in_other_units
from snapjump.robot.robot import Robot
from snapjump.show.terminal.block import number


def build_line(
    config: Mapping[str, Any], epsilon: float, delta_alpha: float, mount_height_bar: float | None
) -> str:
    """Lengths in mm, the mismatch in degrees, the mass in grams, with the gravity that makes
    mass_bar of it."""
    robot = construct("robot", Robot, config["robot"])

    def mm(length_m: float) -> str:
        return number(1e3 * length_m)

    beam = " x ".join(mm(each) for each in (robot.length_m, robot.width_m, robot.thickness_m))
    lag = f"right clamp lags {number(math.degrees(delta_alpha))} deg"
    told = [f"beam {beam} mm", f"clear span {mm(robot.length_m * (1.0 - epsilon))} mm", lag]
    if mount_height_bar is not None:
        told.append(f"clamps {mm(robot.length_m * mount_height_bar)} mm above the feet")
    told.append(f"frame {mm(robot.frame_height_m)} mm high")
    mass = config["environment"]["mass_bar"]
    grams = in_other_units("environment.mass_bar", mass, robot)
    return ", ".join([*told, f"{grams} in all where g = {number(robot.gravity_m_s2)} m/s^2"])
