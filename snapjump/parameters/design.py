"""The design: what is chosen before a jump."""

from snapjump.declare.fields import Part, number


class Design(Part):
    """Pre-compression epsilon (clear span L(1 - epsilon)) and lag of the right clamp (rad)."""

    group = "design"

    epsilon: float = number(0.2, above=0.0, most=0.4)
    delta_alpha: float = number(0.1, least=-0.5, most=0.5, unit="rad")
