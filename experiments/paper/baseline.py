"""The paper's baseline robot, and its ranges: what every figure varies one thing of."""

from snapjump.plan.parts.axes import default_axes

AXES = default_axes()
# delta_alpha (rad), epsilon, m_bar, mu
BASELINE = (0.1, 0.2, 0.768, 0.3)
NAMES = tuple(axis.column for axis in AXES)
SYMBOLS = {axis.column: axis.short for axis in AXES}
RANGES = {axis.column: axis.range for axis in AXES}
TIERS = ("standard", "paper", "reference")
