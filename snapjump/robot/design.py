"""The design: what is chosen before a jump."""

from snapjump.declare.fields import Part, number


class Design(Part):
    """Pre-compression epsilon (clear span L(1 - epsilon)) and mismatch of the clamps (rad)."""

    group = "design"

    epsilon: float = number(
        0.2, above=0.0, most=0.4, doc="pre-compression", symbol="ε", plan=(0.1, 0.3),
        kind="control", takes_arrays=True,
    )  # fmt: skip
    delta_alpha: float = number(
        0.1, least=-0.5, most=0.5, unit="rad", doc="mismatch: the right clamp lags by it",
        symbol="Δα", plan=(0.01, 0.19), kind="control", column="delta_alpha_rad", takes_arrays=True,
    )  # fmt: skip
