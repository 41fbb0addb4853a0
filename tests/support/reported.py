"""A configuration, as far as it is reported of."""

from typing import Any

DRAFT_JUMP: dict[str, Any] = {
    "sim": {"name": "jump"},
    "design": {"epsilon": 0.2, "delta_alpha": 0.1},
    "environment": {"mu": 0.3, "mass_bar": 0.768},
    "robot": {"length_m": 0.02},
    "accuracy": {"name": "draft", "known_error": "3 %"},
}
