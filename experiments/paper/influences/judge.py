"""Pre-compression and mass: which way the apex moves."""

from experiments.paper.influences.rules import (
    COMMAND,
    Sweeps,
    columns,
    one_way,
    percent,
    power,
    ways_back,
)
from experiments.paper.jumps import numbers
from experiments.paper.statement import Statement
from snapjump.studies.base import Row


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
        f"{percent(papers[1])}, the roughness of their time step).",
        accuracy,
        COMMAND,
    )


def mass_statement(sweeps: Sweeps, statics: Row, accuracy: str) -> Statement:
    """Fall with the mass."""
    own, papers = (ways_back(sweeps[t], "mass_bar", False, False) for t in ("standard", "paper"))
    v, x, y = columns(sweeps["standard"], "mass_bar")
    _, paper_x, paper_y = columns(sweeps["paper"], "mass_bar")
    gained = v * (y - numbers(sweeps["standard"], "liftoff_y_bar"))
    share = gained / statics["energy_released_bar"]
    return Statement(
        "x_c and y_c fall as the mass m̄ grows.",
        one_way(own),
        f"From m̄ = {v[0]:g} to {v[-1]:g} x_c falls from {x[0]:.2g} to {x[-1]:.2g} L and y_c from "
        f"{y[0]:.2g} to {y[-1]:.2g} L, with ways back of {percent(own[0])} and "
        f"{percent(own[1])} (the paper's settings: {percent(papers[0])} and "
        f"{percent(papers[1])}). They fall like m̄^{power(v, x):.2f} and m̄^{power(v, y):.2f} (the "
        f"paper's settings: {power(v, paper_x):.2f} and {power(v, paper_y):.2f}), not like 1/m̄: "
        f"of the {statics['energy_released_bar']:.2g} EI/L that the snap releases a light robot "
        f"turns {percent(share[0])} into height, a heavy one {percent(share[-1])}.",
        accuracy,
        COMMAND,
    )
