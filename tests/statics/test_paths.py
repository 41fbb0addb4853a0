"""Whole branches of the arch: over the folds, and between the pitchforks."""

import pytest

from snapjump.composition import with_tier
from snapjump.statics.arch import StaticArch
from snapjump.statics.branch import Branch
from snapjump.statics.critical import find_snap
from snapjump.statics.paths import leaning_path, symmetric_path

SIMULATION = with_tier("draft")
EPSILON = 0.1


@pytest.fixture(scope="module")
def arch() -> StaticArch:
    return StaticArch(SIMULATION.robot, SIMULATION.discretization, EPSILON)


def test_paths_change_their_stability_at_the_critical_angle_and_end_in_their_mirror_images(arch):
    snap = find_snap(SIMULATION.robot, SIMULATION.discretization, EPSILON, 0.0)
    points = list(symmetric_path(Branch(arch, 0.0), True, 0.9 * snap.alpha_rad))
    lefts = [point.left for point in points]
    first = next(point for point in points if point.negative_eigenvalues > 0)
    assert first.left == pytest.approx(snap.alpha_rad, abs=1e-7)
    assert max(lefts) > snap.alpha_rad  # the fold comes later
    leaning = list(leaning_path(arch, snap.before))
    assert leaning[0].left == pytest.approx(snap.alpha_rad)
    assert leaning[-1].left == pytest.approx(-snap.alpha_rad, abs=0.02)
    assert all(point.negative_eigenvalues > 0 for point in leaning)
