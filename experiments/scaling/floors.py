"""The least cycles that a node can take: what its operations and lines cost at least, whichever of
the processor's units is busy longest.

The units for sums and products, the one that divides and the caches work at the same time. What
waits for what is left out, as are comparisons, choices, addresses, masks and numbers that are
parked on the stack.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from snapjump.composition import Simulation
from snapjump.engine.march import march as march_on
from snapjump.engine.model import Model
from snapjump.scenes.jump_march import jump_march
from snapjump.scenes.runner import March

from .costs import Costs, costs
from .ledger import Ledger, Operations, with_ledger
from .split import PASSES, REPEATS, caller, moments, parts, pieces, untouched

COUNT = 4  # times that a piece is done


def roofline(
    simulations: Sequence[Simulation], models: Sequence[Model], lanes: int
) -> dict[str, Any]:
    """Cycles that operations and lines cost, what a pass's parts take of them for a node of all
    lanes together, and the least cycles of that."""
    march = jump_march(simulations, models, lanes=lanes)
    price = costs(lanes, march.memory.block.nbytes)
    taken = counted(march)
    return {
        "cycles": rounded(price._asdict(), 3),
        "of_a_node": {key: rounded(done._asdict(), 2) for key, done in taken.items()},
        "floors": {key: rounded(floor(done, price), 1) for key, done in taken.items()},
    }


def rounded(figures: dict[str, float], digits: int) -> dict[str, float]:
    """Figures as they are told."""
    return {key: round(float(value), digits) for key, value in figures.items()}


def counted(march: March) -> dict[str, Operations]:
    """Operations and lines of a pass's parts, of all lanes together and a node: means over the
    moments at which :func:`split` takes times."""
    programs: dict[str, tuple[Any, Ledger]] = {}
    rows = []
    for go_on in moments(march):
        if not programs:
            kernels = {name: kernel for name, (kernel, *_) in pieces(march).items()}
            kernels["pass"] = march_on
            programs = {name: with_ledger(kernel.py_func) for name, kernel in kernels.items()}
        rows.append(parts(counts(march, programs)))
        go_on(PASSES * (REPEATS - 1))  # as many as are timed, less those that were counted
    return {
        key: Operations(*np.mean([row[key] for row in rows], axis=0) / len(march.masses))
        for key in rows[0]
    }


def counts(march: March, programs: dict[str, tuple[Any, Ledger]]) -> dict[str, Any]:
    """What the pieces and a pass of a march take, as arrays."""
    worker = march.crew[0]
    found = {}
    with untouched(worker.memory):
        for name, (_, model, memory) in pieces(march).items():
            program, ledger = programs[name]
            call = caller(march, program, model, memory)
            ledger.operations(1)
            call(COUNT)
            found[name] = np.array(ledger.operations(COUNT))
    program, ledger = programs["pass"]
    program(*march.arguments(worker), PASSES)
    found["pass"] = np.array(ledger.operations(PASSES))
    return found


def floor(done: Operations, price: Costs) -> dict[str, float]:
    """Cycles of a node by unit; ``floor``: of the one that is busy longest."""
    products = done.products * price.products + done.fused * price.fused
    units = {
        # Some processors have units of their own for sums.
        "arithmetic": max(
            done.sums * price.sums, products, (done.sums + done.products + done.fused) * price.turns
        ),
        "division": done.quotients * price.quotients + done.roots * price.roots,
        "memory": done.lines_read * price.lines_read + done.lines_written * price.lines_written,
    }
    return {**units, "floor": max(units.values())}
