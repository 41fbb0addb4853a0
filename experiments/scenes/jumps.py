"""Jumps with and without what the scene leaves out: loading, flight, the frame's bending.

Times are processor time, the shortest of a few repetitions, starts included.
"""

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from experiments.compositions import changed, composed
from snapjump.batch import simulate_batch, variants
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.declare.members import member_names
from snapjump.ending.apex import ApexEnding
from snapjump.engine import clock as c
from snapjump.engine.status import NAMES, OK
from snapjump.scenes.jump_march import jump_march
from snapjump.scenes.jump_start import jump_model
from snapjump.simulation import simulate
from snapjump.studies.base import Row

LANES = 8
KEPT = ("status", "x_bar", "y_bar", "newton_iterations")
FLIGHT_LIMIT_S = 2.0
FLOWN_HEIGHT = 1.0  # L: higher than any robot stands

Designs = Sequence[tuple[float, float, float, float]]


def timed(full: Callable[[], list[Row]], scene: Callable[[], list[Row]], repeats: int) -> list[Row]:
    """Both, in turn, after one run each that compiles: see :func:`compared`."""
    rows = full(), scene()
    seconds: tuple[list[float], list[float]] = ([], [])
    for _ in range(repeats):
        for run, spent in zip((full, scene), seconds, strict=True):
            begun = time.process_time()
            run()
            spent.append(time.process_time() - begun)
    return compared(rows[0], rows[1], min(seconds[0]), min(seconds[1]))


def ballistic(simulation: Simulation, designs: Designs) -> list[Row]:
    """Jumps that end as soon as nothing can touch the ground any more: the scene as it is."""
    return simulate_batch(variants(simulation, designs), LANES).rows(*KEPT)


def flown(simulation: Simulation, designs: Designs) -> list[Row]:
    """The same jumps followed through the air until the centre of mass sinks."""
    simulations = variants(simulation, designs)
    models = [jump_model(one) for one in simulations]
    ending = ApexEnding(FLIGHT_LIMIT_S / simulation.robot.scales.time_s, FLOWN_HEIGHT)
    march = jump_march(simulations, models, ending=ending, lanes=LANES)
    march.find_starts()
    rows = []
    for model, outcome in zip(models, march.run(), strict=True):
        status = int(outcome[c.STATUS])
        fall = model.load.acceleration
        # The step that ended has passed the apex by less than itself: back along the parabola.
        past = outcome[c.COM_VY] / fall if status == OK else np.nan
        rows.append(
            {
                "status": NAMES[status],
                "x_bar": float(outcome[c.COM_X] + outcome[c.COM_VX] * past),
                "y_bar": float(outcome[c.COM_Y] + 0.5 * outcome[c.COM_VY] * past),
                "newton_iterations": float(outcome[c.ITERATIONS]),
            }
        )
    return rows


def one_by_one(simulation: Simulation, designs: Designs) -> list[Row]:
    """Jumps of any composition, one after the other."""
    results = [simulate(one) for one in variants(simulation, designs)]
    return [{key: result.summary[key] for key in KEPT} for result in results]


def start_rows(groups: Mapping[str, Any], designs: Designs, repeats: int) -> list[Row]:
    """The quasi-static start against clamps that turn from flat."""
    late = composed(groups)
    early = replace(late, sim=late.sim.changed(start_fraction=0.0))
    return timed(lambda: ballistic(early, designs), lambda: ballistic(late, designs), repeats)


def ending_rows(groups: Mapping[str, Any], designs: Designs, repeats: int) -> list[Row]:
    """The ballistic end against a flight to the apex."""
    simulation = composed(groups)
    return timed(
        lambda: flown(simulation, designs), lambda: ballistic(simulation, designs), repeats
    )


def frame_rows(groups: Mapping[str, Any], designs: Designs, repeats: int) -> list[Row]:
    """The rigid frame against the elastic one, robot by robot."""
    if "elastic" not in member_names("frame"):
        raise ParameterError("frame", "elastic", "one of " + ", ".join(member_names("frame")))
    rigid, elastic = composed(groups), composed(changed(groups, {"frame": {"name": "elastic"}}))
    return timed(lambda: one_by_one(elastic, designs), lambda: one_by_one(rigid, designs), 1)


def compared(full: list[Row], scene: list[Row], full_s: float, scene_s: float) -> list[Row]:
    """A row for each design: outcomes with everything and as the scene has it, and the times."""
    count = len(full)
    return [
        {
            "full_status": a["status"],
            "scene_status": b["status"],
            "full_x": a["x_bar"],
            "full_y": a["y_bar"],
            "scene_x": b["x_bar"],
            "scene_y": b["y_bar"],
            "full_newton_iterations": a["newton_iterations"],
            "scene_newton_iterations": b["newton_iterations"],
            "full_ms": 1e3 * full_s / count,
            "scene_ms": 1e3 * scene_s / count,
        }
        for a, b in zip(full, scene, strict=True)
    ]
