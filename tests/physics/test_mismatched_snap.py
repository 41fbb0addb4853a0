"""S7: critical angles with a mismatch between the clamps, inextensible and extensible."""

import numpy as np
import pytest
from differences import richardson
from physical import arch, snap
from references import outputs_of as reference
from scipy.optimize import brentq

from snapjump.discretization.der import DiscreteElasticRod
from snapjump.robot.robot import Robot
from snapjump.statics.branch import Branch
from snapjump.statics.critical import LONGEST_STEP, find_snap, start_point

# EI/(EA L^2) of the paper's beam, b/L = 2.5e-3; inextensible ones are slender instead.
RATIOS = {"0.0e+00": 1e-4, "5.2e-07": 2.5e-3}
CASES = [
    (epsilon, lag, "0.0e+00") for epsilon in (0.1, 0.2, 0.3) for lag in (0.005, 0.01, 0.1, 0.19)
] + [(epsilon, 0.1, "5.2e-07") for epsilon in (0.1, 0.2, 0.3)]
TURNING = ("corotational", "geometrically_exact")
MORE = [(epsilon, lag, "0.0e+00") for epsilon in (0.1, 0.2, 0.3) for lag in (0.02, 0.05)]
NAMES = (
    "before_E", "before_ymid", "after_E", "after_ymid", "before_theta_mid", "after_theta_mid",
)  # fmt: skip


def middle_tangent(equilibrium) -> float:
    k = len(equilibrium.x) // 2
    rise = equilibrium.y[k + 1] - equilibrium.y[k - 1]
    return float(np.arctan2(rise, equilibrium.x[k + 1] - equilibrium.x[k - 1]))


def figures(found) -> np.ndarray:
    before, after = found.before, found.after
    states = [before.energy, before.midpoint, after.energy, after.midpoint]
    return np.array([*states, middle_tangent(before), middle_tangent(after)])


def symmetric_fold(elements: int, epsilon: float, ratio: float) -> float:
    """The largest angle on the branch of symmetric shapes."""
    branch = Branch(arch(epsilon, elements, ratio), 0.0)
    point = start_point(branch)
    for following in branch.follow(point, LONGEST_STEP):
        if following.direction[-1] < 0.0:
            break
        point = following
    start = point

    def turn(length: float) -> float:
        return float(branch.step(start, length).direction[-1])

    return branch.step(start, brentq(turn, 1e-9, LONGEST_STEP, xtol=1e-7)).left


@pytest.mark.parametrize("epsilon", [0.1, 0.2, 0.3])
def test_symmetric(epsilon):
    """The inextensible limit is extrapolated from two extensible beams: the shift is linear in
    EI/EA L^2, and rounding grows with stiffness."""
    stiff, soft = 5e-4, RATIOS["5.2e-07"]
    share = stiff**2 / (soft**2 - stiff**2)
    for find, name in (
        (lambda n, ratio: snap(epsilon, n, ratio=ratio).alpha_rad, "alpha_pitchfork"),
        (lambda n, ratio: symmetric_fold(n, epsilon, ratio), "alpha_fold"),
    ):
        soft_angle, stiff_angle = (
            richardson(*(find(n, ratio) for n in (40, 80, 160))) for ratio in (soft, stiff)
        )
        extensible = reference(f"S7_sym_lam5.2e-07_eps{epsilon:g}")[name]
        assert soft_angle == pytest.approx(extensible, rel=1e-6)
        inextensible = reference(f"S7_sym_lam0.0e+00_eps{epsilon:g}")[name]
        assert stiff_angle + share * (stiff_angle - soft_angle) == pytest.approx(
            inextensible, rel=1e-6
        )


@pytest.mark.parametrize(
    "name, epsilon, lag, lam",
    [("der", *case) for case in CASES]
    + [pytest.param("der", *case, marks=pytest.mark.slow) for case in MORE]
    + [(name, e, 0.1, lam) for name in TURNING for e in (0.1, 0.2, 0.3) for lam in RATIOS],
)
def test_fold(name, epsilon, lag, lam):
    exact = reference(f"S7_mismatch_eps{epsilon:g}_d{lag:g}_lam{lam}")
    ratio = RATIOS[lam] if name == "der" else max(RATIOS[lam], 2e-4)
    coarse, fine = (snap(epsilon, n, lag, ratio, name=name) for n in (80, 160))
    assert fine.alpha_rad == pytest.approx(exact["aL"], rel=1e-3)
    assert fine.before.right == pytest.approx(exact["aR"], rel=1e-3)
    expected = np.array([exact[name] for name in NAMES])
    limit = (4.0 * figures(fine) - figures(coarse)) / 3.0
    assert np.allclose(limit, expected, rtol=1e-3, atol=0.0)


def test_shallow_arches_snap_at_the_shallow_limit():
    """S6: alpha / sqrt(epsilon) -> 2; the whole branch is then shorter than one long step."""
    thin = DiscreteElasticRod(elements=112)
    for epsilon in (2e-4, 1e-3):
        alpha = find_snap(Robot(thickness_m=5e-6), thin, epsilon, 0.0).alpha_rad
        assert alpha / np.sqrt(epsilon) == pytest.approx(2.0, rel=5e-3)
