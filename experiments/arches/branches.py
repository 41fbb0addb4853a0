"""Cells of the arch whose clamps turn alike: points of its branches, and shapes on them."""

from collections.abc import Mapping
from typing import Any

from snapjump.run.studies.base import Row
from snapjump.statics.arch import StaticArch
from snapjump.statics.branch import Branch
from snapjump.statics.critical import Snap, find_snap, start_point
from snapjump.statics.landmarks import symmetric_fold
from snapjump.statics.paths import leaning_path, symmetric_path

from ..compositions import composed

NEAR = 0.93  # of the critical angle, from where on steps along a branch are fine
HALF_WAY = 0.5  # of the critical angle, for the shape of a leaning arch


def arch_of(inputs: Mapping[str, Any]) -> tuple[StaticArch, Snap]:
    """The arch of a cell, and its snap."""
    simulation, epsilon = composed(inputs["groups"]), inputs["epsilon"]
    robot, mesh = simulation.robot, simulation.discretization
    return StaticArch(robot, mesh, epsilon), find_snap(robot, mesh, epsilon, 0.0)


def branch_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """Points of the branches at one pre-compression: angle, middle, energy, negative eigenvalues.

    ``up`` and ``down`` go to both sides of flat clamps; ``leaning`` leaves ``up`` at its first
    instability and ends at that of ``down``.
    """
    arch, snap = arch_of(inputs)
    branch, near = Branch(arch, 0.0), NEAR * snap.alpha_rad
    paths = {
        "up": symmetric_path(branch, True, near),
        "down": symmetric_path(branch, False, near),
        "leaning": leaning_path(arch, snap.before),
    }
    points = [
        (name, point, arch.equilibrium(point.state, point.left, point.left))
        for name, path in paths.items()
        for point in path
    ]
    return [
        {
            "branch": name,
            "alpha_rad": float(point.left),
            "midpoint_bar": found.midpoint,
            "energy_bar": found.energy,
            "negative_eigenvalues": point.negative_eigenvalues,
        }
        for name, point, found in points
    ]


def shape_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """Nodes of the shapes before, at and after the snap, and of two that are not stable."""
    arch, snap = arch_of(inputs)
    branch, half = Branch(arch, 0.0), HALF_WAY * snap.alpha_rad
    states = {
        "flat clamps": start_point(branch).state,
        "critical": snap.before.state,
        "snapped": snap.after.state,
        "at the fold": symmetric_fold(branch).state,
        "leaning": next(p for p in leaning_path(arch, snap.before) if p.left < half).state,
    }
    return [
        {"shape": name, "x_bar": float(x), "y_bar": float(y)}
        for name, state in states.items()
        for x, y in zip(state[0 :: arch.node_dofs], state[1 :: arch.node_dofs], strict=True)
    ]
