"""A jump's time loop compiled by a second process, while this one compiles its statics."""

import atexit
import pickle
import subprocess
import sys
import threading
from contextlib import suppress
from typing import Any

import numpy as np

from snapjump.composition import Simulation
from snapjump.engine.march import march
from snapjump.engine.recorder.trajectory import make_recorder
from snapjump.engine.termination.flight import FlightTermination
from snapjump.files.cores import own_cores
from snapjump.number.once import load, types_of, would_compile
from snapjump.scenes.jump_start import composed_model
from snapjump.scenes.runner import March
from snapjump.scenes.trajectory import read

HEIGHT_BAR, LIMIT_S = 0.1, 1e-3  # of a robot whose numbers do not matter
_begun: dict[Any, "subprocess.Popen[bytes]"] = {}  # by the types of what they compile
PROGRAM = "import sys; sys.path[:] = {path!r}; from {module} import main; main()"


def compile_ahead(simulation: Simulation) -> None:
    """Have a recorded jump's time loop compiled meanwhile, where it is not on disk and there is a
    second core. Whoever needs it waits for that process, which ends with this one at the latest."""
    if len(own_cores()) < 2 or not sys.executable:
        return
    loop = bare_march(simulation)
    arguments = (*loop.arguments(loop.crew[0]), 0)
    program = types_of(march, arguments)
    if program in _begun or not would_compile(march, arguments):
        return
    # A law that is defined in a notebook cannot travel; then it is compiled here, later.
    with suppress(pickle.PicklingError, AttributeError, TypeError, OSError):
        _begun[program] = begun(pickle.dumps(simulation))


@atexit.register
def end_all() -> None:
    """End the processes that are still at it."""
    for process in _begun.values():
        process.terminate()
        process.wait()


def begun(simulation: bytes) -> "subprocess.Popen[bytes]":
    """A process that compiles the time loop of a pickled simulation."""
    code = PROGRAM.format(path=sys.path, module=__name__)
    process = subprocess.Popen(
        [sys.executable, "-c", code],
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    assert process.stdin is not None
    with suppress(BrokenPipeError), process.stdin:
        process.stdin.write(simulation)
    threading.Thread(target=process.wait, daemon=True).start()  # or it stayed as a zombie
    return process


def main() -> None:
    """What the second process does: about half of the work."""
    loop = bare_march(pickle.load(sys.stdin.buffer))
    load(march, *loop.arguments(loop.crew[0]), 0)
    read(loop, np.zeros(1), loop.states, loop.states)


def bare_march(simulation: Simulation) -> March:
    """A recorded march of the types of a simulation's jump, whose numbers mean nothing."""
    model = composed_model(simulation, 0.0, HEIGHT_BAR, LIMIT_S)
    masses, mesh = simulation.discretization.masses(), simulation.frame.mesh(model.frame)
    size = model.frame.dofs(mesh) + model.discretization.node_dofs() * len(masses)
    return March(
        models=[model],
        masses=masses,
        states=np.zeros((1, size)),
        simulation=simulation,
        termination=FlightTermination(),
        recorder=make_recorder(size, 1.0, 1.0),
        mesh=mesh,
    )
