"""The quasi-static start of a march: equilibrium, velocity and acceleration at its first moment.

The loading before it is slow, so the robot follows its static branch; the velocity is that
branch's tangent and the acceleration its curvature.
"""

from typing import Any

from snapjump.drive.parts.two_rates import TwoRates
from snapjump.engine.centre_of_mass import centre_of_mass
from snapjump.engine.equilibrium import solve_equilibrium
from snapjump.engine.model import Model
from snapjump.engine.status import NO_EQUILIBRIUM, RUNNING
from snapjump.friction.parts.holding import Holding
from snapjump.number.dispatch import kernel, routine
from snapjump.number.functions import negate, where

CONTINUATION_STEPS = 16
FIRST_TURN = 0.02  # of a step
TURNING = TwoRates  # what every drive's clamps do near the start, but for how fast
DIFFERENCE_RAD = 2e-3  # clamp angle between the equilibria that velocity is taken from


@kernel
def with_angles(model: Any, left: Any, delta_alpha: Any) -> Any:
    """The model with other clamp angles at time 0, and friction that holds it on its slope: slow
    loading has no sliding velocity, and a lagged law would look for one that is not there yet."""
    drive = model.clamp
    clamp = TURNING(left, drive.end, drive.rate, delta_alpha, drive.right_over_left())
    return Model(
        model.discretization,
        model.frame,
        clamp,
        model.contact,
        Holding(model.load.pull() / model.load.gravity()),
        model.damping,
        model.drag,
        model.load,
        model.ground,
        model.time_limit,
    )


@kernel
def stay_in_place(model: Any, masses: Any, work: Any) -> None:
    """Where no friction holds the frame, keep the centre of mass in place instead of it; let what
    friction holds on a slope creep."""
    free = negate(model.friction.holds())
    mesh = work.mesh
    _, _, speed, _ = centre_of_mass(model, masses, mesh, work.start, work.velocity[0])
    _, _, push, _ = centre_of_mass(model, masses, mesh, work.start, work.acceleration[0])
    zero = 0.0 * speed
    speed = where(free, speed, zero - model.load.creep())
    push = where(free, push, zero)
    model.frame.slide(mesh, work.velocity[0], -speed)
    model.frame.slide(mesh, work.acceleration[0], -push)
    for node in range(masses.shape[0]):
        i = model.frame.dofs(mesh) + model.discretization.node_dofs() * node
        work.velocity[0, i] = work.velocity[0, i] - speed
        work.acceleration[0, i] = work.acceleration[0, i] - push


@routine
def follow_branch(model: Any, masses: Any, work: Any) -> Any:
    """Follow equilibria from flat clamps up to the march's beginning, whose state, velocity and
    acceleration are filled in.

    ``work.state`` holds a guess for flat clamps. Both angles grow in proportion, so that the
    branch begins at the symmetric arch. Returns the status: RUNNING, or NO_EQUILIBRIUM where the
    branch was lost or is not stable.
    """
    clamp = model.clamp
    state = work.state
    size = state.shape[0]
    past = work.velocity[0]
    older = work.acceleration[0]
    lost = clamp.rate < 0.0
    held = model.frame.dofs(work.mesh) if model.frame.border_width() == 3 else 0
    # Flat clamps, a first small turn that gives the branch's direction, then even steps.
    for k in range(-1, CONTINUATION_STEPS + 1):
        share = k / CONTINUATION_STEPS
        if k < 0:
            share = 0.0
        elif k == 0:
            share = FIRST_TURN / CONTINUATION_STEPS
        partial = with_angles(model, share * clamp.start, share * clamp.delta_alpha)
        negative, failed = solve_equilibrium(partial, masses, work, 0.0)
        lost = lost | failed | (negative > 0.0)
        for i in range(size):
            equilibrium = state[i]
            if i < held:
                # The feet stay on the ground: no guess may lift them out of a short reach.
                older[i] = past[i]
                past[i] = equilibrium
                continue
            if k == 0:
                state[i] = past[i] + (equilibrium - past[i]) / FIRST_TURN
                equilibrium = past[i]
            elif k == 1:
                state[i] = 2.0 * equilibrium - past[i]
            elif 1 < k < CONTINUATION_STEPS:
                state[i] = 3.0 * equilibrium - 3.0 * past[i] + older[i]
            older[i] = past[i]
            past[i] = equilibrium
    for i in range(size):
        work.start[i] = past[i]

    resting = with_angles(model, clamp.start, clamp.delta_alpha)
    difference = DIFFERENCE_RAD / clamp.rate
    negative, failed = solve_equilibrium(resting, masses, work, -difference)
    lost = lost | failed | (negative > 0.0)
    for i in range(size):
        work.velocity[0, i] = state[i]
        state[i] = work.start[i] if i < held else 2.0 * work.start[i] - state[i]
    negative, failed = solve_equilibrium(resting, masses, work, difference)
    lost = lost | failed | (negative > 0.0)
    for i in range(size):
        before = work.velocity[0, i]
        after = state[i]
        now = work.start[i]
        share = clamp.initial_share()
        bend = (after - 2.0 * now + before) / (difference * difference)
        work.velocity[0, i] = share * ((after - before) / (2.0 * difference))
        work.acceleration[0, i] = share * share * bend
        state[i] = now
    dofs = model.frame.dofs(work.mesh)
    if dofs > 0:
        stay_in_place(model, masses, work)
    first = 1 + dofs
    middle = (masses.shape[0] - 1) // 2 * model.discretization.node_dofs() + first
    lost = lost | (state[middle] < state[first])
    return where(lost, 1.0 * NO_EQUILIBRIUM, 1.0 * RUNNING)
