"""A snap without ground, with contact compiled out and compiled in but out of reach."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from experiments.compositions import composed
from experiments.scenes.jumps import timed
from snapjump.clamp.smooth_start import SmoothStart
from snapjump.declare.members import make_member
from snapjump.ending.timed import TimedEnding
from snapjump.engine import clock as c
from snapjump.engine.model import Model
from snapjump.engine.status import NAMES
from snapjump.frame.fixed import FixedFrame
from snapjump.load.none import NoLoad
from snapjump.scenes.runner import March
from snapjump.statics.arch import StaticArch
from snapjump.studies.base import Row

ABOVE = 2.0  # L: mounts so high that nothing comes near the ground


def snap_rows(
    groups: Mapping[str, Any], designs: list[tuple[float, float]], repeats: int
) -> list[Row]:
    """Snaps of designs (delta_alpha, epsilon): where and how fast the midpoint is at the end."""
    return timed(
        lambda: snaps(groups, designs, "logbarrier"),
        lambda: snaps(groups, designs, "none"),
        repeats,
    )


def snaps(groups: Mapping[str, Any], designs: list[tuple[float, float]], contact: str) -> list[Row]:
    """Outcomes of snaps one after the other, with a contact law that never acts or with none."""
    simulation = composed(groups)
    law = make_member("contact", {"name": contact}).law(simulation.robot.scales)
    rows = []
    for lag, epsilon in designs:
        one = replace(simulation, design=replace(simulation.design, epsilon=epsilon,
                                                 delta_alpha=lag))  # fmt: skip
        march = snap_march(one, law)
        outcome = march.run()[0]
        middle = march.memory.state.shape[0] // 2
        rows.append(
            {
                "status": NAMES[int(outcome[c.STATUS])],
                "x_bar": float(march.memory.state[middle - middle % 2, 0]),
                "y_bar": float(march.memory.state[middle - middle % 2 + 1, 0]) - ABOVE,
                "newton_iterations": float(outcome[c.ITERATIONS]),
            }
        )
    return rows


def snap_march(simulation: Any, law: Any) -> March:
    """The snap scene's march, its mounts above a ground."""
    robot, scene, scales = simulation.robot, simulation.sim, simulation.robot.scales
    arch = StaticArch(robot, simulation.discretization, simulation.design.epsilon)
    lag = simulation.design.delta_alpha
    state = arch.flat(lag)
    state[1 :: arch.node_dofs] += ABOVE
    model = Model(
        discretization=simulation.discretization.beam(robot),
        frame=FixedFrame.Body(0.5 * (1.0 - simulation.design.epsilon), ABOVE),
        clamp=SmoothStart(
            start=0.0,
            end=robot.rotation_end_rad,
            rate=robot.rotation_rate_rad_s * scales.time_s,
            delta_alpha=lag,
            rise_time=scene.rise_time_s / scales.time_s,
        ),
        contact=law,
        friction=simulation.friction.law(scales, 0.0),
        damping=simulation.damping.law(scales),
        load=NoLoad(),
    )
    return March(
        models=[model],
        masses=simulation.discretization.masses(),
        states=np.array([state]),
        simulation=simulation,
        ending=TimedEnding(scene.duration_s / scales.time_s),
    )
