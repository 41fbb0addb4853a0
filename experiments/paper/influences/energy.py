"""What becomes of the energy that the snap releases: height, motion and losses of one jump."""

from experiments.paper.influences.contact import STRIKE_INTERVAL_S, followed
from snapjump.composition import Simulation
from snapjump.statics.critical import find_snap
from snapjump.studies.base import Row


def energy_row(simulation: Simulation) -> Row:
    """Shares of what the design's arch, mismatch and all, releases under slow loading (EI/L).

    The rise counts from where the robot stands to the apex; ``turning``: what is left of the
    kinetic energy at lift-off without the centre of mass; ``numerical``: what the integrator
    took. All come to 1 but for the clamps' work and what the beam still holds.
    """
    robot, design = simulation.robot, simulation.design
    snap = find_snap(robot, simulation.discretization, design.epsilon, design.delta_alpha)
    released = snap.before.energy - snap.after.energy
    kept = followed(simulation, STRIKE_INTERVAL_S).arrays
    mass_kg = simulation.environment.mass_kg(robot)
    vx, vy = float(kept["com_vx_m_s"][-1]), float(kept["com_vy_m_s"][-1])
    climbed_m = float(kept["com_y_m"][-1] - kept["com_y_m"][0])
    upward_J = 0.5 * mass_kg * vy**2
    sideways_J = 0.5 * mass_kg * vx**2
    parts = {
        "rise": upward_J + mass_kg * robot.gravity_m_s2 * climbed_m,
        "sideways": sideways_J,
        "turning": float(kept["kinetic_J"][-1]) - upward_J - sideways_J,
        "friction": float(kept["friction_loss_J"][-1]),
        "damping": float(kept["damping_loss_J"][-1]),
        "numerical": float(kept["numerical_loss_J"][-1]),
    }
    return {
        "energy_released_bar": released,
        **{f"{name}_share": value / (released * robot.scales.energy_J)
           for name, value in parts.items()},
    }  # fmt: skip
