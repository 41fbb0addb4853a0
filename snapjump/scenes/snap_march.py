"""The march of a beam that snaps alone: clamps held in space, as the drive moves them."""

from collections.abc import Callable
from typing import Any

from snapjump.composition import Simulation
from snapjump.contact.base import ContactOptions
from snapjump.engine.model import Model
from snapjump.engine.recorder.none import NoRecorder
from snapjump.engine.status import NO_EQUILIBRIUM, RUNNING
from snapjump.engine.termination.timed import TimedTermination
from snapjump.frame.fixed import FixedFrame
from snapjump.scenes.runner import MOST_ITERATIONS, Array, March
from snapjump.statics.arch import StaticArch
from snapjump.statics.critical import find_snap

# Of Newton's method, times the nodes that each of them moves: half a minute of a core.
MOST_NODE_ITERATIONS = 4.0e8


def no_recorder(coordinates: int, steps: int) -> NoRecorder:
    """Nothing is recorded."""
    return NoRecorder()


def snap_march(
    simulation: Simulation,
    recorder: Callable[[int, int], Any] = no_recorder,
    height: float = 0.0,
    contact: ContactOptions | None = None,
) -> March:
    """The arch at rest, its mounts at a height (in L). Without one that is stable the march is
    over before it begins, with the status ``no_equilibrium``.

    ``recorder`` makes a recorder for so many coordinates and steps; ``contact``: another law than
    none.
    """
    robot, scene, scales = simulation.robot, simulation.sim, simulation.robot.scales
    epsilon = simulation.design.epsilon
    arch = StaticArch(robot, simulation.discretization, epsilon)
    start, state, found = beginning(simulation, arch)
    state[1 :: arch.node_dofs] += height
    model = Model(
        discretization=simulation.discretization.beam(robot),
        frame=FixedFrame.Body(0.5 * (1.0 - epsilon), height),
        clamp=simulation.drive.programme(simulation, start),
        contact=(contact or simulation.contact).law(scales),
        friction=simulation.friction.law(scales, simulation.environment.mu),
        damping=simulation.damping.law(scales),
    )
    masses = simulation.discretization.masses()
    most = min(MOST_ITERATIONS, MOST_NODE_ITERATIONS / len(masses))
    march = March(
        models=[model],
        masses=masses,
        states=state[None, :],
        simulation=simulation,
        termination=TimedTermination(scene.duration_s / scales.time_s),
        recorder=recorder(len(state), int(most)),  # a step takes an iteration at least
        most_iterations=most,
    )
    march.queue.status[0] = RUNNING if found else NO_EQUILIBRIUM
    return march


def beginning(simulation: Simulation, arch: StaticArch) -> tuple[float, Array, bool]:
    """The left clamp's angle (rad) and the state of the arch at rest, and whether there is a stable
    one: where it is flat, or, of one that is held there, where it snaps."""
    drive, design = simulation.drive, simulation.design
    try:
        if drive.held:
            snap = find_snap(
                simulation.robot, simulation.discretization, design.epsilon, design.delta_alpha
            )
            return snap.alpha_rad, snap.before.state, True
        state = drive.rest(simulation, arch)
        return drive.start_rad(0.0), state, arch.negative_pivots == 0
    except ArithmeticError:
        return 0.0, arch.guess(), False
