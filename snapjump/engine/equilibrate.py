"""One equilibrium, with its tangent matrix left in memory: the entry for statics from Python."""

from typing import Any

from snapjump.engine.assemble import Motion, assemble
from snapjump.engine.clock import SIZE
from snapjump.engine.equilibrium import solve_equilibrium
from snapjump.engine.model import with_numbers
from snapjump.engine.view import view_work
from snapjump.number.dispatch import compiled


@compiled
def equilibrate(template: Any, numbers: Any, masses: Any, memory: Any, iterate: bool) -> Any:
    """Solve for the equilibrium near the state in ``memory`` at time 0, or only assemble there if
    not ``iterate``.

    Afterwards ``memory`` holds residual and band (one lane). Returns the number of
    negative pivots at the last iteration, the last correction (L), which is how well the state is
    known, and whether Newton's method failed.
    """
    work = view_work(memory, (0,))
    for k in range(numbers.shape[0]):
        work.numbers[k] = numbers[k]
    model = with_numbers(template, work.numbers)
    negative = 0.0
    failed = False
    if iterate:
        negative, failed = solve_equilibrium(model, masses, work, 0.0)
    else:
        angles = model.clamp.angles(0.0)
        model.frame.place_ends(work.mesh, model.discretization, angles, work.state)
    assemble(model, Motion(0.0, 0.0, 0.0, 0.0), masses, work)
    return negative, work.clock[SIZE], failed
