"""The methods that are compared, and what the paper reports of its own."""

from collections.abc import Mapping
from typing import Any

# Name in the table: the group that composes it, as in conf/inverse.
METHODS: Mapping[str, Mapping[str, Any]] = {
    "adam": {"name": "adam"},
    "gauss_newton": {"name": "gauss_newton"},
    "physics": {"name": "physics"},
    "physics, exact slopes": {"name": "physics", "slopes": "exact"},
    "physics, finishing at reference": {"name": "physics", "finishing": "reference"},
    "bayesian": {"name": "bayesian"},
    "finite_difference": {"name": "finite_difference"},
}
LENGTH_MM = 20.0  # the paper's beam, which its misses are told for
# Source: the paper, table of its methods for inverse design.
PAPER = (
    {"method": "the paper: data-driven", "mean_mm": 2.9, "std_mm": 2.5, "seconds": 0.33},
    {"method": "the paper: Bayesian", "mean_mm": 3.5, "seconds": 513.0},
    {"method": "the paper: finite-difference descent", "mean_mm": 2.2, "seconds": 1129.0},
)
TIERS = ("standard", "reference")  # that designs are judged at, beside the run's own
SOLVED_MM = 0.1  # a miss at the tier that a method finished at, below which a target counts as hit
