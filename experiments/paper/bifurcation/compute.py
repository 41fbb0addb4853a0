"""Rows of the bifurcation diagrams: branches, shapes, and landmarks at several accuracies."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import islice
from typing import Any

import numpy as np

from experiments.compositions import composed
from snapjump.run.studies.base import Row
from snapjump.statics.arch import Equilibrium, StaticArch
from snapjump.statics.branch import Branch, Point
from snapjump.statics.critical import find_snap, refine, start_point
from snapjump.statics.landmarks import (
    Landmarks,
    find_landmarks,
    symmetric_fold,
)

STEP, FINE_STEP = 0.05, 0.012  # along a branch (norm of free coordinates and angle)
NEAR = 0.93  # of the critical angle, from where on steps are fine
FARTHEST_RAD = 1.4
MOST_POINTS = 400
HALF_WAY = 0.5  # of the critical angle, for the shape of a leaning arch
MISMATCH_RAD = 0.1  # for which there are exact numbers of a beam that stretches


def branch_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """Points of the branches at one pre-compression: angle, middle, energy, negative eigenvalues.

    ``up`` and ``down`` are walked to both sides of flat clamps, over their folds until the clamps
    are flat again; ``leaning`` leaves ``up`` at its first instability and ends at that of
    ``down``.
    """
    simulation = composed(inputs["groups"])
    arch = StaticArch(simulation.robot, simulation.discretization, inputs["epsilon"])
    branch = Branch(arch, 0.0)
    snap = find_snap(simulation.robot, simulation.discretization, inputs["epsilon"], 0.0)
    near = NEAR * snap.alpha_rad
    rows = []
    for name, upward in (("up", True), ("down", False)):
        forwards = start_point(branch, upward)
        backwards = branch.point(forwards.state, 0.0, -forwards.direction)
        before = list(walk(branch, backwards, near))[::-1]
        points = [*before, forwards, *walk(branch, forwards, near)]
        rows += [point_row(arch, name, point) for point in points]
    return rows + [point_row(arch, "leaning", point) for point in leaning(arch, snap.before)]


def walk(branch: Branch, first: Point, near_rad: float) -> Iterator[Point]:
    """From flat clamps to the farthest angle, or over the fold until they are flat again; with the
    very point at which stability is lost, as the first that is unstable."""
    point, side = first, np.sign(first.direction[-1])
    for _ in range(MOST_POINTS):
        step = FINE_STEP if abs(point.left) > near_rad else STEP
        following = next(branch.follow(point, step), None)
        if following is None or not 0.0 < side * following.left < FARTHEST_RAD:
            return
        if point.eigenvalue > 0.0 >= following.eigenvalue:
            yield replace(refine(branch, point, following), negative_eigenvalues=1)
        yield following
        point = following


def leaning(arch: StaticArch, critical: Equilibrium) -> Iterator[Point]:
    """Shapes that are not symmetric, from one pitchfork to the other: it is entered along the
    critical mode, and turns round at its end into its own mirror image."""
    branch = Branch(arch, 0.0, symmetric=False)
    arch.residual(critical.state, critical.left, critical.right)
    mode = np.append(arch.critical_mode(), 0.0)
    seed = Point(critical.state, critical.left, 0.0, 0.0, 1, mode)
    yield seed
    for point in islice(branch.follow(seed, STEP), MOST_POINTS):
        if point.direction[-1] > 0.0:
            return
        yield point


def point_row(arch: StaticArch, name: str, point: Point) -> Row:
    """A point of a branch as a row."""
    found = arch.equilibrium(point.state, point.left, point.left)
    return {
        "branch": name,
        "alpha_rad": float(point.left),
        "midpoint_bar": found.midpoint,
        "energy_bar": found.energy,
        "negative_eigenvalues": point.negative_eigenvalues,
    }


def shape_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """Nodes of the shapes before, at and after the snap, and of two that are not stable."""
    simulation = composed(inputs["groups"])
    robot, mesh, epsilon = simulation.robot, simulation.discretization, inputs["epsilon"]
    arch = StaticArch(robot, mesh, epsilon)
    branch = Branch(arch, 0.0)
    snap = find_snap(robot, mesh, epsilon, 0.0)
    half = next(p for p in leaning(arch, snap.before) if p.left < HALF_WAY * snap.alpha_rad)
    states = {
        "flat clamps": start_point(branch).state,
        "critical": snap.before.state,
        "snapped": snap.after.state,
        "at the fold": symmetric_fold(branch).state,
        "leaning": half.state,
    }
    return [
        {"shape": name, "x_bar": float(x), "y_bar": float(y)}
        for name, state in states.items()
        for x, y in zip(state[0 :: arch.node_dofs], state[1 :: arch.node_dofs], strict=True)
    ]


def angle_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """Landmarks at each pre-compression."""
    simulation = composed(inputs["groups"])
    return [
        landmark_row(epsilon, find_landmarks(simulation, epsilon)) for epsilon in inputs["epsilons"]
    ]


def landmark_row(epsilon: float, found: Landmarks) -> Row:
    """Angles (rad), heights (L) and energies (EI/L) of the landmarks."""
    before, after = found.snap.before, found.snap.after
    return {
        "epsilon": epsilon,
        "alpha_critical_rad": float(found.snap.alpha_rad),
        "alpha_fold_rad": float(found.fold.left),
        "alpha_back_rad": float(found.back_rad),
        "leaning": found.leaning,
        "midpoint_before_bar": before.midpoint,
        "lowest_before_bar": before.lowest,
        "energy_before_bar": before.energy,
        "midpoint_after_bar": after.midpoint,
        "energy_after_bar": after.energy,
        "negative_pivots_after": after.negative_pivots,
        "midpoint_fold_bar": found.fold.midpoint,
        "energy_fold_bar": found.fold.energy,
    }


def compared_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """Landmarks at the pre-compressions that there are exact numbers for, flat clamps and
    mismatched ones included."""
    simulation = composed(inputs["groups"])
    robot, mesh = simulation.robot, simulation.discretization
    rows = angle_rows(inputs)
    for row in rows:
        arch = StaticArch(robot, mesh, row["epsilon"])
        flat = arch.equilibrium(arch.solve_equilibrium(arch.guess(), 0.0, 0.0), 0.0, 0.0)
        snap = find_snap(robot, mesh, row["epsilon"], MISMATCH_RAD)
        row |= {
            "midpoint_flat_bar": flat.midpoint,
            "energy_flat_bar": flat.energy,
            "mismatched_alpha_critical_rad": float(snap.alpha_rad),
            "mismatched_midpoint_before_bar": snap.before.midpoint,
            "mismatched_energy_before_bar": snap.before.energy,
            "mismatched_midpoint_after_bar": snap.after.midpoint,
            "mismatched_energy_after_bar": snap.after.energy,
            "elements": mesh.elements,
        }
    return rows
