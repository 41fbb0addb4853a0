"""The snaps: cells against the library's scene and an independent solution; verdicts both ways."""

import math
from typing import Any

import numpy as np
import pytest
from cells import STANDARD

from experiments.arches.exact_snap import agreement, exact_snaps, largest_percent
from experiments.arches.swings import SETTINGS, snap_groups, snap_of
from experiments.paper.base import CONFIRMED, LIMITED, NOT_CONFIRMED
from experiments.paper.snaps.figure import STYLES, draw_snaps, draw_tiny
from experiments.paper.snaps.part import (
    TINY,
    Snaps,
    limit_in_words,
    motion_rows,
    outcome_rows,
    symmetric_until,
    symmetry,
    symmetry_verdict,
)
from snapjump.scenes.swing import follow, outcome
from snapjump.simulation import simulate


@pytest.fixture(scope="module")
def undamped() -> list[dict[str, Any]]:
    """The two snaps of the figure without damping."""
    inputs = {"groups": snap_groups(STANDARD, "undamped"), "epsilon": 0.1, "rate_rad_s": 20.0}
    return motion_rows({**inputs, "mismatches_rad": [0.0, 0.1]})


def test_snaps_are_those_of_the_independent_solution(undamped):
    numbers = [row for row in undamped if row["kind"] == "outcome"]
    table = agreement({"undamped": numbers}, exact_snaps())
    assert len(table) == 6 + 8  # no tangents with equal clamps
    assert largest_percent(table, "own") < 0.5
    assert largest_percent(table, "undamped") < 0.5


def test_agreement_sees_a_difference():
    exact = exact_snaps()
    wrong = [{**row, "crossing_T": 1.1 * row["crossing_T"]} for row in exact if row["terms"] >= 12]
    wrong = [row for row in wrong if row["terms"] != 20]
    table = agreement({"wrong": wrong}, exact)
    assert largest_percent(table, "wrong") == pytest.approx(10.0)


def test_a_swing_is_the_snap_of_the_library():
    simulation = snap_of(snap_groups(STANDARD, "standard"), 0.2, 0.1)
    own, library = outcome(follow(simulation)), simulate(simulation)
    assert own["alpha_snap_rad"] == pytest.approx(library.alpha_snap_rad, abs=1e-4)
    assert own["midpoint_velocity_m_s"] == pytest.approx(library.midpoint_velocity_m_s, rel=1e-2)
    assert own["theta_later_rad"] == pytest.approx(library.theta_max_rad, rel=1e-2)
    assert own["theta_max_rad"] == own["theta_later_rad"]


def test_a_beam_that_does_not_snap_has_no_numbers():
    groups = snap_groups(STANDARD, "standard")
    groups["drive"] = {**groups["drive"], "end_rad": 0.3}
    row = outcome(follow(snap_of(groups, 0.1, 0.1)))
    assert row["status"] == "ok" and row["theta_max_rad"] is None


def test_a_tiny_mismatch_is_amplified_in_proportion():
    inputs = {"groups": snap_groups(STANDARD, "standard"), "epsilon": 0.1, "rate_rad_s": 20.0}
    rows = outcome_rows({**inputs, "mismatches_rad": [1e-6, 1e-5]})
    tilts = [row["theta_max_rad"] for row in rows]
    assert tilts[1] == pytest.approx(10.0 * tilts[0], rel=1e-2)
    assert 400.0 < tilts[0] / 1e-6 < 800.0


def tilts(*pairs: tuple[float, float | None]) -> list[dict[str, Any]]:
    return [{"delta_alpha_rad": lag, "theta_max_rad": angle} for lag, angle in pairs]


def test_the_mismatch_that_is_seen():
    degree = math.radians(1.0)
    proportional = tilts((0.0, 1e-14), (1e-6, 1e-4), (1e-4, 1e-2), (1e-2, 1.0))
    assert symmetric_until(proportional) == pytest.approx(degree * 1e-2)
    assert symmetric_until(tilts((0.0, 1e-14), (1e-4, 0.1))) == pytest.approx(1e-3 * degree)
    assert symmetric_until(tilts((0.0, 0.5), (1e-4, 0.5))) == 0.0
    assert symmetric_until(tilts((0.0, 0.0), (1e-4, 1e-3), (1e-2, None))) == math.inf
    assert "no mismatch at all" in limit_in_words(0.2, 0.0, 0.5)
    assert "more than was tried" in limit_in_words(20.0, math.inf, 0.0)


def test_the_verdict_can_come_out_each_way():
    assert symmetry_verdict(1e-12, 0.6, [5e-3, math.inf]) == CONFIRMED
    assert symmetry_verdict(1e-12, 0.6, [5e-3, 1e-5]) == LIMITED
    assert symmetry_verdict(0.1, 0.6, [5e-3]) == NOT_CONFIRMED
    assert symmetry_verdict(1e-14, 1e-3, [5e-3]) == NOT_CONFIRMED


def test_the_statement_tells_the_limit(undamped):
    pair = [row for row in undamped if row["kind"] == "outcome"]
    rates = {20.0: tilts((0.0, 1e-13), (1e-5, 6e-3), (1e-4, 6e-2)), 0.2: tilts((0.0, 0.59))}
    by_rate = {r: (symmetric_until(rows), rows[0]["theta_max_rad"]) for r, rows in rates.items()}
    told = symmetry(dict.fromkeys(SETTINGS, pair), by_rate).found
    assert "0.2 rad/s (0.59 rad from rounding)" in told and "2.9e-05 rad at 20" in told


def test_the_plan():
    cells = Snaps().plan(STANDARD, 0)
    assert len(cells) == len(SETTINGS) + len(TINY)
    assert cells[1].inputs["groups"]["discretization"]["elements"] == 99
    assert cells[2].inputs["groups"]["damping"] == {"name": "none"}
    assert set(STYLES) == set(TINY)


def test_the_figures(undamped, tmp_path):
    motions = dict.fromkeys(("standard", "undamped", "paper"), undamped)
    draw_snaps(motions, exact_snaps(), tmp_path / "snaps.png")
    rows = tilts((0.0, 0.0), *((float(lag), float(lag)) for lag in np.logspace(-8, -1, 8)))
    draw_tiny(dict.fromkeys(TINY, rows), 0.1, tmp_path / "tiny.png")
    assert all((tmp_path / name).stat().st_size > 10_000 for name in ("snaps.png", "tiny.png"))
