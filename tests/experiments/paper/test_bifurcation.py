"""Branches and landmarks on a coarse mesh; verdicts on made-up ones; the figures."""

import copy
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cells import STANDARD, all_done, check_figures, done

from experiments.arches import exact
from experiments.arches import landmarks as exact_arch
from experiments.arches.branches import branch_rows, shape_rows
from experiments.compositions import changed, composed
from experiments.paper.base import CONFIRMED, LIMITED, NOT_CONFIRMED
from experiments.paper.bifurcation import part as judge
from experiments.paper.bifurcation.part import TIERS, Bifurcation, compared_rows
from snapjump.run.studies.base import FAILED
from snapjump.statics.arch import StaticArch
from snapjump.statics.branch import Branch, Point
from snapjump.statics.critical import find_snap, start_point
from snapjump.statics.landmarks import symmetric_fold, turned_back

COARSE = changed(STANDARD, {"discretization": {"elements": 32}})
EPSILON = 0.2
Rows = list[dict[str, Any]]


@pytest.fixture(scope="module")
def branches() -> Rows:
    return branch_rows({"groups": COARSE, "epsilon": EPSILON})


@pytest.fixture(scope="module")
def landmarks() -> Rows:
    return compared_rows({"groups": COARSE, "epsilons": (0.1, EPSILON, 0.3)})


def named(rows: Rows, name: str) -> Rows:
    return [row for row in rows if row["branch"] == name]


def test_branches_lose_their_stability_at_the_critical_angle(branches: Rows) -> None:
    simulation = composed(COARSE)
    snap = find_snap(simulation.robot, simulation.discretization, EPSILON, 0.0)
    up, down = named(branches, "up"), named(branches, "down")
    first = next(row for row in up if row["negative_eigenvalues"] > 0)
    assert first["alpha_rad"] == pytest.approx(snap.alpha_rad, abs=1e-6)
    assert first["energy_bar"] == pytest.approx(snap.before.energy, abs=1e-4)
    assert all(row["negative_eigenvalues"] == 0 for row in up[: up.index(first)])
    assert up[0]["alpha_rad"] < -1.3 and down[-1]["alpha_rad"] > 1.3
    mirrored = next(row for row in down[::-1] if row["negative_eigenvalues"] > 0)
    assert mirrored["alpha_rad"] == pytest.approx(-snap.alpha_rad, abs=1e-6)
    assert mirrored["midpoint_bar"] == pytest.approx(-first["midpoint_bar"], abs=1e-4)


def test_the_leaning_branch_is_unstable_from_pitchfork_to_pitchfork(branches: Rows) -> None:
    leaning = named(branches, "leaning")
    angles = [row["alpha_rad"] for row in leaning]
    assert all(row["negative_eigenvalues"] > 0 for row in leaning)
    assert angles == sorted(angles, reverse=True)
    assert angles[-1] == pytest.approx(-angles[0], abs=0.02)


def test_landmarks_on_a_coarse_mesh(landmarks: Rows) -> None:
    for row in landmarks:
        assert row["alpha_back_rad"] == pytest.approx(-row["alpha_critical_rad"], abs=1e-7)
        assert 0.5 < judge.gap_percent(row) < 1.2
        assert row["leaning"] == pytest.approx(1.0, abs=1e-6)
        assert set(exact_arch.exact_row(row["epsilon"])) == set(exact_arch.NAMES) <= set(row)
    assert 0.1 < exact_arch.overall(landmarks, exact_arch.STRETCHES)[0] < 2.0


def test_a_branch_that_is_lost_is_named() -> None:
    simulation = composed(COARSE)
    arch = StaticArch(simulation.robot, simulation.discretization, EPSILON)

    class Lost(Branch):
        def follow(self, point: Point, length: float) -> Iterator[Point]:
            return iter(())

    with pytest.raises(ArithmeticError, match="lost at a clamp angle of 0 rad"):
        symmetric_fold(Lost(arch, 0.0))
    snapped = arch.equilibrium(start_point(Branch(arch, 0.0), False).state, 0.0, 0.0)
    with pytest.raises(ArithmeticError, match="lost at a clamp angle of 0 rad"):
        turned_back(Lost(arch, 0.0), snapped)


def test_a_row_of_exact_numbers_differs_in_nothing() -> None:
    rows = [{"epsilon": e, **exact_arch.exact_row(e)} for e in exact.COMPARED]
    for beam in (exact_arch.STRETCHES, exact_arch.RIGID):
        assert exact_arch.overall(rows, beam)[0] < 1e-10
    rows[1]["energy_flat_bar"] *= 0.98
    assert exact_arch.overall(rows, exact_arch.RIGID) == (pytest.approx(2.0), "energy, flat clamps")


def test_errors_that_fall_with_the_square_of_the_mesh_are_of_order_two() -> None:
    tiers = {
        tier: [
            {"epsilon": 0.2, "elements": n}
            | {key: v * (1.0 + 3.0 / n**2) for key, v in exact_arch.exact_row(0.2).items()}
        ]
        for tier, n in zip(exact_arch.LADDER, (40, 80, 160), strict=True)
    }
    assert exact_arch.orders(tiers) == pytest.approx(2.0)


@pytest.fixture
def exactly(landmarks: Rows) -> Rows:
    """The landmarks, without any error."""
    return [{**row, **exact_arch.exact_row(row["epsilon"])} for row in landmarks]


def test_a_snap_without_a_loop_is_none(exactly: Rows) -> None:
    tiers = dict.fromkeys(("standard", "reference", "paper"), exactly)

    def verdict(change: Any) -> str:
        other = [row | change(row) for row in exactly]
        return judge.snap_statement({**tiers, "standard": other}).verdict

    assert judge.snap_statement(tiers).verdict == CONFIRMED
    assert verdict(lambda row: {"alpha_critical_rad": 1.01 * row["alpha_critical_rad"]}) == LIMITED
    assert verdict(lambda row: {"alpha_back_rad": row["alpha_critical_rad"]}) == NOT_CONFIRMED
    assert not any(judge.snaps({**row, "midpoint_after_bar": 0.1}) for row in exactly)


def test_angles_that_do_not_grow(landmarks: Rows) -> None:
    tiers = dict.fromkeys(("standard", "reference"), landmarks)

    def verdict(*alphas: float) -> str:
        epsilons = (0.05, 0.08, 0.2, 0.3)
        rows = [
            {"epsilon": e, "alpha_critical_rad": a} for e, a in zip(epsilons, alphas, strict=True)
        ]
        return judge.growth_statement(rows, tiers).verdict

    assert verdict(0.4, 0.5, 0.9, 1.1) == CONFIRMED
    assert verdict(0.6, 0.5, 0.9, 1.1) == LIMITED
    assert verdict(0.4, 0.5, 1.1, 0.9) == NOT_CONFIRMED


def test_the_fold_may_come_first_in_made_up_arches(exactly: Rows) -> None:
    tiers = dict.fromkeys(("standard", "reference", "paper"), exactly)
    first = judge.fold_statement(exactly, tiers)
    assert first.verdict == NOT_CONFIRMED and "at 3 of 3 pre-compressions" in first.found
    folding = copy.deepcopy(exactly)
    folding[0]["alpha_fold_rad"] = folding[0]["alpha_critical_rad"]
    # The error of exact angles is none; what comes at the same angle counts as the fold even so.
    coarse = [{**row, "alpha_critical_rad": 1.001 * row["alpha_critical_rad"]} for row in exactly]
    assert judge.fold_statement(folding, {**tiers, "standard": coarse}).verdict == LIMITED
    for row in folding:
        row["alpha_fold_rad"] = row["alpha_critical_rad"]
    last = judge.fold_statement(folding, {**tiers, "standard": coarse})
    assert last.verdict == CONFIRMED and "at 0 of 3 pre-compressions" in last.found


def stepped(*angles: float) -> Rows:
    """Snaps at these angles, with the paper's step and a hundredth of it."""
    return [
        {"step_s": s, "alpha_snap_rad": a, "theta_max_rad": 0.6, "snap_duration_ms": 1.0}
        for s, a in zip(judge.STEPS_S, angles, strict=True)
    ]


def test_nodes_and_steps_of_the_static_study(exactly: Rows) -> None:
    def verdict(error: float, *angles: float) -> str:
        rows = [{**row, "energy_flat_bar": error * row["energy_flat_bar"]} for row in exactly]
        return judge.nodes_statement(rows, stepped(*angles)).verdict

    assert verdict(1.0, 0.64, 0.64) == CONFIRMED
    assert verdict(1.03, 0.64, 0.64) == verdict(1.0, 0.65, 0.64) == LIMITED
    assert verdict(1.06, 0.64, 0.64) == verdict(1.0, 0.7, 0.64) == NOT_CONFIRMED
    assert (
        "(energy, flat clamps)"
        in judge.nodes_statement(
            [{**row, "energy_flat_bar": 1.03 * row["energy_flat_bar"]} for row in exactly],
            stepped(0.65, 0.64),
        ).found
    )


def test_conclusion_with_its_figures(branches: Rows, landmarks: Rows, tmp_path: Path) -> None:
    part = Bifurcation()
    planned = part.plan(COARSE, 0)
    assert len(planned) == 11 and json.dumps([dict(cell.inputs) for cell in planned])
    shapes = shape_rows({"groups": COARSE, "epsilon": EPSILON})
    kinds = {"branches": branches, "shapes": shapes, "angles": landmarks, "compared": landmarks}
    kinds["steps"] = stepped(0.65, 0.64)
    cells = all_done(part, COARSE, lambda cell: kinds[cell.inputs["kind"]])
    for tier, elements in zip(TIERS, (56, 104, 224, 66), strict=True):
        cells[tier] = done(tier, [{**row, "elements": elements} for row in landmarks])
    found = part.conclude(cells)
    assert len(found.statements) == 4
    assert np.isfinite(list(found.summary.values())).all()
    check_figures(found, tmp_path, 20_000)


def test_nothing_is_judged_without_all_cells(landmarks: Rows) -> None:
    broken = done("paper", [], FAILED, "it broke")
    found = Bifurcation().conclude({"standard": done("standard", landmarks), "paper": broken})
    assert not found.statements and "paper (failed: it broke)" in found.section.paragraphs[0]
