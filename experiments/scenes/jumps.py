"""Jumps and snaps with and without what their scene leaves out: loading, flight, the frame's
bending, the ground.

Times are processor time, the shortest of a few repetitions, starts included.
"""

import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from snapjump.batch import simulate_batch, variants
from snapjump.composition import Simulation
from snapjump.declare.inputs import DEFAULT_INPUTS
from snapjump.declare.members import make_member
from snapjump.engine import outcome as c
from snapjump.engine.status import NAMES, OK
from snapjump.engine.termination.apex import ApexTermination
from snapjump.run.studies.base import Row
from snapjump.scenes.jump_march import jump_march
from snapjump.scenes.jump_start import jump_model
from snapjump.scenes.snap_march import snap_march
from snapjump.simulation import simulate

LANES = 8
KEPT = ("status", "x_bar", "y_bar", "newton_iterations")
FLIGHT_LIMIT_S = 2.0
FLOWN_HEIGHT = 1.0  # L: higher than any robot stands
ABOVE = 2.0  # L: mounts so high that nothing comes near the ground

Designs = Sequence[Sequence[float]]
Both = tuple[Callable[[], list[Row]], Callable[[], list[Row]]]  # with everything, as the scene is


def timed(both: Both, repeats: int) -> list[Row]:
    """Rows of :func:`compared` from repeated runs of both in turn, after one each that compiles."""
    full, scene = (run() for run in both)
    seconds: tuple[list[float], list[float]] = ([], [])
    for _ in range(repeats):
        for run, spent in zip(both, seconds, strict=True):
            begun = time.process_time()
            run()
            spent.append(time.process_time() - begun)
    return compared(full, scene, min(seconds[0]), min(seconds[1]))


def ballistic(simulation: Simulation, designs: Designs) -> list[Row]:
    """Jumps that end as soon as nothing can touch the ground any more: the scene as it is."""
    return simulate_batch(variants(simulation, designs), LANES).rows(*KEPT)


def flown(simulation: Simulation, designs: Designs) -> list[Row]:
    """The same jumps followed through the air until the centre of mass sinks."""
    simulations = variants(simulation, designs)
    models = [jump_model(one) for one in simulations]
    termination = ApexTermination(FLIGHT_LIMIT_S / simulation.robot.scales.time_s, FLOWN_HEIGHT)
    march = jump_march(simulations, models, termination=termination, lanes=LANES)
    march.find_starts()
    rows = []
    for model, outcome in zip(models, march.run(), strict=True):
        # The step that ended has passed the apex by less than itself: back along the parabola.
        past = outcome[c.COM_VY] / model.load.acceleration if outcome[c.STATUS] == OK else np.nan
        x = outcome[c.COM_X] + outcome[c.COM_VX] * past
        rows.append(row_of(outcome, x, outcome[c.COM_Y] + 0.5 * outcome[c.COM_VY] * past))
    return rows


def one_by_one(simulation: Simulation, designs: Designs) -> list[Row]:
    """Jumps of any composition, one after the other."""
    results = [simulate(one) for one in variants(simulation, designs)]
    return [{key: result.summary[key] for key in KEPT} for result in results]


def snaps(simulation: Simulation, designs: Designs, contact: str) -> list[Row]:
    """Outcomes of snaps one after the other, with a contact law that never acts or with none: where
    the midpoint is at the end."""
    law = make_member("contact", {"name": contact})
    rows = []
    for one in variants(simulation, [design[:2] for design in designs], DEFAULT_INPUTS[:2]):
        march = snap_march(one, height=ABOVE, contact=law)
        outcome = march.run()[0]
        middle = march.memory.state.shape[0] // 4 * 2
        x, y = march.memory.state[middle : middle + 2, 0]
        rows.append(row_of(outcome, x, y - ABOVE))
    return rows


def row_of(outcome: Any, x: float, y: float) -> Row:
    """The row of a march that ended there."""
    return {
        "status": NAMES[int(outcome[c.STATUS])],
        "x_bar": float(x),
        "y_bar": float(y),
        "newton_iterations": float(outcome[c.ITERATIONS]),
    }


def start(base: Simulation, designs: Designs) -> Both:
    """A quasi-static start late in the loading against clamps that turn from flat."""
    late = replace(base, sim=base.sim.changed(start_fraction=0.85))
    return lambda: ballistic(base, designs), lambda: ballistic(late, designs)


def end(base: Simulation, designs: Designs) -> Both:
    """The ballistic end against a flight to the apex."""
    return lambda: flown(base, designs), lambda: ballistic(base, designs)


def frame(base: Simulation, designs: Designs) -> Both:
    """The rigid frame against the elastic one, robot by robot."""
    elastic = replace(base, frame=make_member("frame", {"name": "elastic"}))
    return lambda: one_by_one(elastic, designs), lambda: one_by_one(base, designs)


def contact(base: Simulation, designs: Designs) -> Both:
    """A snap without ground, contact compiled out and compiled in but out of reach."""
    return lambda: snaps(base, designs, "logbarrier"), lambda: snaps(base, designs, "none")


def compared(full: list[Row], scene: list[Row], full_s: float, scene_s: float) -> list[Row]:
    """A row for each design: outcomes with everything and as the scene has it, and the times."""
    times = {"full_ms": 1e3 * full_s / len(full), "scene_ms": 1e3 * scene_s / len(full)}
    names = {key: key.removesuffix("_bar") for key in KEPT}
    return [
        {f"full_{name}": one[key] for key, name in names.items()}
        | {f"scene_{name}": other[key] for key, name in names.items()}
        | times
        for one, other in zip(full, scene, strict=True)
    ]
