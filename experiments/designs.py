"""Designs that studies are made over: spread evenly over the paper's ranges."""

from scipy.stats import qmc

# delta_alpha (rad), epsilon, m_bar, mu
LOW = (0.01, 0.1, 0.3, 0.1)
HIGH = (0.19, 0.3, 2.0, 0.6)


def spread_designs(count: int, seed: int = 7) -> list[tuple[float, float, float, float]]:
    """``count`` designs (delta_alpha, epsilon, m_bar, mu) of a scrambled Sobol sequence."""
    points = qmc.Sobol(4, rng=seed).random(count)
    return [tuple(float(v) for v in row) for row in qmc.scale(points, LOW, HIGH)]  # type: ignore[misc]
