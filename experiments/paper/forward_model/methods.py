"""The methods of inverse design that are tried, and what the paper reports of its own."""

from typing import Any, NamedTuple

# The paper: 3 x 372 neurons with ReLU.
NETWORK = "mlp"
# Paper, its dataset and its forward model.
PAPER_JUMPS, PAPER_HOURS, PAPER_THREADS = 50_625, 4.0, 20
PAPER_MAE_BAR = 0.07
# Paper, its table of methods: mean miss and its standard deviation (mm), seconds a target.
PAPER_MEAN_MM, PAPER_STD_MM = 2.9, 2.5
PAPER_SECONDS = {"data-driven": 0.33, "bayesian": 513.0, "finite_difference": 1129.0}


class Method(NamedTuple):
    """``inverse``: its group; ``network``: the forward model it asks, None for the one that comes
    with the library; ``problems``: how many random targets it is given (the first of them)."""

    inverse: dict[str, Any]
    network: str | None
    problems: int


DATA_DRIVEN = "adam, the paper's network"
METHODS = {
    DATA_DRIVEN: Method({"name": "adam"}, NETWORK, 100),
    "gauss_newton": Method({"name": "gauss_newton"}, None, 100),
    "physics": Method({"name": "physics"}, None, 100),
    "bayesian": Method({"name": "bayesian"}, None, 10),
    "finite_difference": Method({"name": "finite_difference"}, None, 10),
}
