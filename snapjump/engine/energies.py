"""Elastic energies of many states of a robot."""

from typing import Any

from snapjump.engine.model import with_numbers
from snapjump.frame.base import STILL
from snapjump.number.array import uncounted
from snapjump.number.dispatch import compiled


@compiled
def elastic_energies(
    template: Any, numbers: Any, mesh: Any, times: Any, states: Any, energies: Any
) -> None:
    """Fill the energies (S), in EI/L, of beam and frame in states (S, D) at times (S)."""
    model = with_numbers(template, uncounted(numbers))
    mesh = uncounted(mesh)
    states = uncounted(states)
    dofs = model.frame.dofs(mesh)
    for n in range(times.shape[0]):
        state = states[n]
        angles = model.clamp.angles(times[n])
        tangents = model.frame.end_tangents(mesh, model.load, angles, state, STILL)
        beam = model.discretization.internal_energy(state[dofs:], tangents)
        energies[n] = beam + model.frame.energy(mesh, state)
