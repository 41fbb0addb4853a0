"""The paper's baseline robot, the ranges about it, and the tiers that it is simulated at."""

from ..designs import AXES, BASELINE
from ..designs import COLUMNS as NAMES

__all__ = ["BASELINE", "LABELS", "NAMES", "PLAIN", "RANGES", "SYMBOLS", "TIERS"]
SYMBOLS = {axis.column: axis.short for axis in AXES}
PLAIN = {name: symbol.removesuffix(" (rad)") for name, symbol in SYMBOLS.items()}
RANGES = {axis.column: axis.range for axis in AXES}
LABELS = {
    "mount_height_bar": "mount height h / L",
    "delta_alpha_rad": "mismatch Δα (rad)",
    "epsilon": "pre-compression ε",
    "mass_bar": "mass m̄",
    "mu": "friction coefficient μ",
}
TIERS = ("standard", "paper", "reference")
