"""Sweeps of jumps: of the designs' four numbers, and of the mounts' height; and the statics."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from experiments.compositions import composed
from experiments.paper.baseline import BASELINE, NAMES
from experiments.paper.influences.contact import pressed_row, sliding_row
from experiments.paper.influences.energy import energy_row
from experiments.paper.influences.sweeps import MOUNT_HEIGHT
from experiments.paper.jumps import LANES, THREADS, batch_rows, jump_rows
from snapjump.batch import simulate_batch, variant
from snapjump.composition import Simulation
from snapjump.statics.critical import find_snap
from snapjump.statics.threshold import symmetric_threshold
from snapjump.studies.base import Row

# Mounts below the depth of the arch at a later start would put it into the ground.
FROM_FLAT = 0.0


def rows_of(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each value of what is varied."""
    base = variant(composed(inputs["groups"]), BASELINE)
    kind, values = inputs["kind"], inputs["values"]
    if kind == "statics":
        return [statics_row(base)]
    if kind == "sliding":
        return [{"mu": mu, **sliding_row(variant(base, (*BASELINE[:3], mu)))} for mu in values]
    if kind == "energies":
        masses = [variant(base, (*BASELINE[:2], m, BASELINE[3])) for m in values]
        return [{"mass_bar": m, **energy_row(one)} for m, one in zip(values, masses, strict=True)]
    if kind == "pressed":
        return [{MOUNT_HEIGHT: h, **pressed_row(mounted(base, h))} for h in values]
    if kind == MOUNT_HEIGHT:
        batch = simulate_batch([mounted(base, h) for h in values], LANES, threads=THREADS)
        rows = batch_rows(batch)
        return [{MOUNT_HEIGHT: h, **row} for h, row in zip(values, rows, strict=True)]
    place = NAMES.index(kind)
    return jump_rows(base, [(*BASELINE[:place], v, *BASELINE[place + 1 :]) for v in values])


def mounted(base: Simulation, height_bar: float) -> Simulation:
    """The robot with its clamps at another height (in L), turning from flat: a beam that reaches
    below low mounts would start in the ground."""
    robot = replace(base.robot, mount_height=height_bar * base.robot.length_m)
    return replace(base, robot=robot, sim=base.sim.changed(start_fraction=FROM_FLAT))


def statics_row(base: Simulation) -> Row:
    """Heights and energies (EI/L) of the baseline's arch under slow loading.

    h1: depth of the lowest point as it loses stability; h2: depth of the lowest point, and of the
    middle, of the arch that has snapped; both with clamps that turn alike."""
    robot, mesh, epsilon = base.robot, base.discretization, base.design.epsilon
    snap = find_snap(robot, mesh, epsilon, 0.0)
    return {
        "h1_bar": symmetric_threshold(robot, mesh, epsilon).h1_bar,
        "h2_bar": -snap.after.lowest,
        "h2_middle_bar": snap.h2_bar,
        "alpha_critical_rad": snap.alpha_rad,
        "energy_released_bar": snap.before.energy - snap.after.energy,
    }
