"""Pre-compression and mass: which way the apex moves."""

from collections.abc import Mapping, Sequence

from experiments.paper.influences.rules import (
    COMMAND,
    Sweeps,
    columns,
    one_way,
    percent,
    power,
    ways_back,
)
from experiments.paper.statement import Statement
from snapjump.studies.base import Row

TOLD = 0.01  # of the energy: shares below it are not worth a word


def epsilon_statement(sweeps: Sweeps, accuracy: str) -> Statement:
    """Growth with the pre-compression."""
    own, papers = (ways_back(sweeps[t], "epsilon", True, True) for t in ("standard", "paper"))
    v, x, y = columns(sweeps["standard"], "epsilon")
    return Statement(
        "x_c and y_c grow monotonically with the pre-compression ε.",
        one_way(own),
        f"From ε = {v[0]:g} to {v[-1]:g} x_c grows from {x[0]:.2g} to {x[-1]:.2g} L and y_c from "
        f"{y[0]:.2g} to {y[-1]:.2g} L; the largest way back is {percent(own[0])} and "
        f"{percent(own[1])} of the growth (the paper's settings: {percent(papers[0])} and "
        f"{percent(papers[1])}).",
        accuracy,
        COMMAND,
    )


def mass_statement(
    sweeps: Sweeps, energies: Mapping[str, Sequence[Row]], accuracy: str
) -> Statement:
    """Fall with the mass; energies: at standard and with the paper's settings, by mass."""
    own, papers = (ways_back(sweeps[t], "mass_bar", False, False) for t in ("standard", "paper"))
    v, x, y = columns(sweeps["standard"], "mass_bar")
    _, paper_x, paper_y = columns(sweeps["paper"], "mass_bar")
    released = energies["standard"][0]["energy_released_bar"]
    return Statement(
        "x_c and y_c fall as the mass m̄ grows.",
        one_way(own),
        f"From m̄ = {v[0]:g} to {v[-1]:g} x_c falls from {x[0]:.2g} to {x[-1]:.2g} L and y_c from "
        f"{y[0]:.2g} to {y[-1]:.2g} L, with ways back of {percent(own[0])} and "
        f"{percent(own[1])} (the paper's settings: {percent(papers[0])} and "
        f"{percent(papers[1])}). They fall like m̄^{power(v, x):.2f} and m̄^{power(v, y):.2f} (the "
        f"paper's settings: {power(v, paper_x):.2f} and {power(v, paper_y):.2f}), where height "
        f"in proportion to energy would be m̄^-1. Of what the slow snap of the mismatched arch "
        f"releases, {released:.2g} EI/L, {shares(energies['standard'])}. With the paper's "
        f"settings {shares(energies['paper'])}.",
        accuracy,
        COMMAND,
    )


def shares(rows: Sequence[Row]) -> str:
    """Where the energy goes, of the lightest and of the heaviest robot."""
    names = {
        "rise": "becomes height above where the robot stands",
        "friction": "goes to friction",
        "damping": "to the material's damping",
        "numerical": "to the integrator",
        "turning": "to turning and vibration",
    }
    told = ", ".join(
        f"{percent(rows[0][f'{name}_share'])} and {percent(rows[-1][f'{name}_share'])} {what}"
        for name, what in names.items()
        if max(abs(row[f"{name}_share"]) for row in rows) >= TOLD
    )
    return f"at m̄ = {rows[0]['mass_bar']:g} and at {rows[-1]['mass_bar']:g}, in this order, {told}"
