"""The paper's baseline robot, and its ranges: what every figure varies one thing of."""

# delta_alpha (rad), epsilon, m_bar, mu
BASELINE = (0.1, 0.2, 0.768, 0.3)
NAMES = ("delta_alpha_rad", "epsilon", "mass_bar", "mu")
SYMBOLS = {"delta_alpha_rad": "Δα (rad)", "epsilon": "ε", "mass_bar": "m̄", "mu": "μ"}
RANGES = {
    "delta_alpha_rad": (0.01, 0.19),
    "epsilon": (0.1, 0.3),
    "mass_bar": (0.3, 2.0),
    "mu": (0.1, 0.6),
}
TIERS = ("standard", "paper", "reference")
