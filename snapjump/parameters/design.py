"""The design: what is chosen before a jump."""

from dataclasses import dataclass

from snapjump.checks import check_number


@dataclass(frozen=True)
class Design:
    """Pre-compression epsilon (clear span L(1 - epsilon)) and lag of the right clamp (rad)."""

    epsilon: float = 0.2
    delta_alpha: float = 0.1

    def __post_init__(self) -> None:
        check_number("design.epsilon", self.epsilon, 0.0, 0.4, above=True)
        check_number("design.delta_alpha", self.delta_alpha, -0.5, 0.5, unit="rad")
