"""What friction's stick zone moves: ``python -m experiments.stick_zone`` prints one JSON object.

The tiers have a wider zone, eps_v, than the paper. Designs spread over the paper's ranges jump with
both; mesh and steps are finer than any tier's, so that what moves is the model's answer.
"""

from dataclasses import replace
from typing import Any

from snapjump.batch import simulate_batch, variants
from snapjump.checks import check_integer
from snapjump.composition import Simulation, with_tier
from snapjump.tiers import TIERS

from .command import measured
from .designs import spread_designs
from .errors import error_figures, relative_errors

WIDE, NARROW = (
    float(TIERS[name].numbers["friction.velocity_threshold_m_s"]) for name in ("standard", "paper")
)
ELEMENTS = 448
CONVERGED = {"tolerance": 5e-10, "contact_steps": 0.5, "stick_share": 1.0}


def converged(threshold_m_s: float) -> Simulation:
    """The tiers' model with a stick zone, by a finer mesh, smaller steps and another integrator."""
    base = with_tier("reference", integrator="tr_bdf2")
    return replace(
        base,
        discretization=base.discretization.changed(elements=ELEMENTS),
        stepping=base.stepping.changed(**CONVERGED),
        friction=base.friction.changed(velocity_threshold_m_s=threshold_m_s),
    )


def report(designs: int = 64) -> dict[str, Any]:
    """Medians and 95th percentiles of the move from the tiers' zone to the paper's."""
    check_integer("--designs", designs, 1, 4096)
    wide, narrow = (
        simulate_batch(variants(converged(threshold), spread_designs(designs)))
        for threshold in (WIDE, NARROW)
    )
    moves = relative_errors(narrow.x_bar, narrow.y_bar, wide.x_bar, wide.y_bar)
    return {
        "designs": designs,
        "from_m_s": WIDE,
        "to_m_s": NARROW,
        **{name: float(f"{value:.2g}") for name, value in error_figures(*moves).items()},
    }


if __name__ == "__main__":
    measured(report)
