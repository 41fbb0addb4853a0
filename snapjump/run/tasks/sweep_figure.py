"""The figure of a sweep: its cells with labels, units, and the errors that they state."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.declare.inputs import Input, inputs_of
from snapjump.declare.outputs import Output
from snapjump.files.result_folder import ResultFolder
from snapjump.run.tasks.base import FINISHED
from snapjump.run.tasks.sweep import Sweep
from snapjump.run.tasks.sweep_cells import Cell, main_results
from snapjump.show.plots.sweep import Swept, draw_sweep
from snapjump.simulation import build


def draw(sweep: Sweep, cells: Sequence[Cell]) -> bool:
    """Draw the main results against the inputs, if there is anything to draw."""
    results = main_results(cells)
    if not results or not cells[0].inputs:
        return False
    simulation = next((found for found in map(_simulation, cells) if found), None)
    inputs = inputs_of(simulation) if simulation else {}
    outputs = {o.name: o for o in simulation.sim.outputs.declared()} if simulation else {}
    labels = {key: output_label(key, outputs) for key in results}
    swept = Swept(
        title=sweep.title,
        inputs={
            input_label(key, inputs): [cell.inputs[key] for cell in cells]
            for key in cells[0].inputs
        },
        results={labels[key]: _column(cells, key) for key in results},
        failed=["" if cell.status in FINISHED else cell.status for cell in cells],
        errors={labels[key]: error for key, error in _errors(cells).items() if key in labels},
    )
    return ResultFolder(sweep.folder).write_figures(
        lambda folder: draw_sweep(swept, folder / "summary.png")
    )


def _simulation(cell: Cell) -> Simulation | None:
    """What a cell simulated, which names its inputs and outputs."""
    try:
        return build(cell.folder.config() or {}) if cell.status in FINISHED else None
    except ParameterError:
        return None


def _column(cells: Sequence[Cell], key: str) -> Array:
    found = [cell.numbers.get(key, math.nan) for cell in cells]
    kept = [cell.status in FINISHED for cell in cells]
    return np.where(kept, found, math.nan)


def _errors(cells: Sequence[Cell]) -> dict[str, Array]:
    """Estimated errors of the apex (L), as the jumps themselves say."""
    x, y = _column(cells, "x_bar"), _column(cells, "y_bar")
    sizes = {"x": np.maximum(abs(x), 0.1 * y), "y": y}
    return {
        f"{name}_bar": 0.01 * _column(cells, f"{name}_error_estimate_percent") * size
        for name, size in sizes.items()
        if np.isfinite(_column(cells, f"{name}_error_estimate_percent")).any()
    }


def input_label(key: str, inputs: Mapping[str, Input]) -> str:
    """A key for people: its symbol and unit, if it is an input."""
    known = inputs.get(key)
    if known is None:
        return key
    symbol = f", {known.symbol}" if known.symbol != known.name else ""
    return f"{known.meaning.partition(':')[0]}{symbol}" + (f" ({known.unit})" if known.unit else "")


def output_label(name: str, outputs: Mapping[str, Output[Any]]) -> str:
    """An output for people: its name and unit."""
    unit = outputs[name].unit if name in outputs else ""
    if unit == "L":
        return f"{name.removesuffix('_bar')} / L"
    return f"{name} ({unit})" if unit not in ("", "1") else name
