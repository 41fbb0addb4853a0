"""The march of a beam that snaps alone: clamps held in space, turning from flat."""

from collections.abc import Callable
from typing import Any

from snapjump.composition import Simulation
from snapjump.contact.base import ContactOptions
from snapjump.engine.clamp.smooth_start import SmoothStart
from snapjump.engine.model import Model
from snapjump.engine.termination.timed import TimedTermination
from snapjump.frame.fixed import FixedFrame
from snapjump.scenes.jump_march import no_recorder
from snapjump.scenes.runner import March
from snapjump.statics.arch import StaticArch


def snap_march(
    simulation: Simulation,
    recorder: Callable[[int], Any] = no_recorder,
    height: float = 0.0,
    contact: ContactOptions | None = None,
) -> March:
    """The arch at rest, its mounts at a height (in L).

    ``recorder`` makes a recorder for so many coordinates; ``contact``: another law than none.
    """
    robot, scene, scales = simulation.robot, simulation.sim, simulation.robot.scales
    epsilon, delta_alpha = simulation.design.epsilon, simulation.design.delta_alpha
    arch = StaticArch(robot, simulation.discretization, epsilon)
    state = arch.flat(delta_alpha)
    state[1 :: arch.node_dofs] += height
    model = Model(
        discretization=simulation.discretization.beam(robot),
        frame=FixedFrame.Body(0.5 * (1.0 - epsilon), height),
        clamp=SmoothStart(
            start=0.0,
            end=robot.rotation_end_rad,
            rate=robot.rotation_rate_rad_s * scales.time_s,
            delta_alpha=delta_alpha,
            rise_time=scene.rise_time_s / scales.time_s,
        ),
        contact=(contact or simulation.contact).law(scales),
        friction=simulation.friction.law(scales, simulation.environment.mu),
        damping=simulation.damping.law(scales),
    )
    return March(
        models=[model],
        masses=simulation.discretization.masses(),
        states=state[None, :],
        simulation=simulation,
        termination=TimedTermination(scene.duration_s / scales.time_s),
        recorder=recorder(len(state)),
    )
