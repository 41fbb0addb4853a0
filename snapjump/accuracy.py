"""Accuracy tiers: which modules and numbers go together, and what error they are known to make.

The physical model (damping, K_c, d_hat) is the same in draft, standard and reference; ``paper``
is the paper's own choice, for comparison. The figures in ``known_error`` are those of
``python run.py task=tradeoff``.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Tier:
    """Numbers and members that a tier sets; see the members' options for their meaning."""

    name: str
    integrator: str
    stepping: str
    friction: str
    damping: str
    elements: int
    clamp: str
    weighting: str
    tolerance: float
    contact_steps: float
    step_s: float
    start_fraction: float
    known_error: str


TIERS: dict[str, Tier] = {
    tier.name: tier
    for tier in (
        Tier(
            name="paper",
            integrator="implicit_euler",
            stepping="fixed",
            friction="lagged",
            damping="none",
            elements=66,
            clamp="two_nodes",
            weighting="per_node",
            tolerance=1e-6,
            contact_steps=2.0,
            step_s=1e-5,
            start_fraction=0.0,
            known_error="x within 20 %, y within 7 % of the converged limit (95 % of designs)",
        ),
        Tier(
            name="draft",
            integrator="tr_bdf2",
            stepping="adaptive",
            friction="implicit",
            damping="kelvin_voigt",
            elements=56,
            clamp="half_element",
            weighting="per_length",
            tolerance=1e-6,
            contact_steps=2.0,
            step_s=1e-5,
            start_fraction=0.85,
            known_error="x within 2.6 %, y within 0.4 % of the converged limit (95 % of designs)",
        ),
        Tier(
            name="standard",
            integrator="tr_bdf2",
            stepping="adaptive",
            friction="implicit",
            damping="kelvin_voigt",
            elements=104,
            clamp="half_element",
            weighting="per_length",
            tolerance=4.5e-8,
            contact_steps=2.0,
            step_s=1e-5,
            start_fraction=0.85,
            known_error="x within 0.45 %, y within 0.12 % of the converged limit (95 % of designs)",
        ),
        Tier(
            name="reference",
            integrator="tr_bdf2",
            stepping="adaptive",
            friction="implicit",
            damping="kelvin_voigt",
            elements=224,
            clamp="half_element",
            weighting="per_length",
            tolerance=2e-9,
            contact_steps=1.0,
            step_s=1e-5,
            start_fraction=0.8,
            known_error="x within 0.04 %, y within 0.02 % of the converged limit (95 % of designs)",
        ),
    )
}
