"""Trajectories of coarse jumps, and the verdict on how the mismatch tunes them."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from cells import COARSE, all_done, check_figures, done

from experiments.paper.base import CONFIRMED, LIMITED, NOT_CONFIRMED
from experiments.paper.cells import varied
from experiments.paper.trajectories import part as module
from experiments.paper.trajectories.figure import flight
from experiments.paper.trajectories.part import Trajectories, slant, tuned, tuning
from snapjump.run.studies.base import FAILED, column


def sweep(ratios: list[float], lean: float) -> list[dict[str, Any]]:
    """Rows of a sweep whose jumps are all ten high."""
    return [
        {
            "delta_alpha_rad": 0.01 * k, "x_bar": 10.0 * ratio, "y_bar": 10.0,
            "liftoff_vx_m_s": np.tan(np.radians(lean)), "liftoff_vy_m_s": 1.0,
        }
        for k, ratio in enumerate(ratios)
    ]  # fmt: skip


def test_verdicts():
    growing = slant(sweep([0.0, 0.2, 0.4, 0.6], 20.0))
    assert np.isnan(growing.grows_until_rad) and growing.lean_deg == pytest.approx(20.0)
    assert tuned(growing, 60.0) == CONFIRMED
    assert tuned(growing, 30.0) == LIMITED
    turning = slant(sweep([0.0, 0.4, 0.3, 0.5], 20.0))
    for own, lean, begun in (
        (growing, 30.0, "Oblique, not near horizontal. Without"),
        (turning, 60.0, "Not throughout. Without"),
        (growing, 60.0, "Without"),
    ):
        spread = sweep([0.0, 0.6], lean)
        for row in spread:
            row |= dict.fromkeys(("delta_alpha_rad", "epsilon", "mass_bar", "mu"), 0.1)
        told = tuning(own, growing, spread, {"off": (0.0, 0.0), "compared": 11})
        assert told.found.startswith(begun)
    assert turning.grows_until_rad == pytest.approx(0.01)
    assert turning.back == pytest.approx(0.2)
    assert tuned(turning, 60.0) == LIMITED
    assert tuned(slant(sweep([0.1, 0.2, 0.4, 0.6], 20.0)), 60.0) == NOT_CONFIRMED
    assert tuned(slant(sweep([0.0, 0.01, 0.02, 0.03], 2.0)), 2.0) == NOT_CONFIRMED


def test_paths_end_where_flights_begin():
    design = varied("delta_alpha_rad", [0.05])[0]
    inputs = {"groups": COARSE, "designs": [design]}
    path = Trajectories().compute({"kind": "path", **inputs})
    jump = Trajectories().compute({"kind": "jumps", **inputs})[0]
    x, y = flight(jump)
    assert (x[60], y[60]) == pytest.approx((jump["x_bar"], jump["y_bar"]))
    last = int(np.flatnonzero(column(path, "ground_force_N") > 0.0)[-1])
    assert path[last]["x_bar"] == pytest.approx(x[0], abs=0.01)
    assert path[last]["y_bar"] == pytest.approx(y[0], abs=0.02)


def test_report(monkeypatch, tmp_path):
    """The whole part with every tier coarse."""
    monkeypatch.setattr(module, "groups_at", lambda groups, tier: COARSE)
    monkeypatch.setattr(module, "DESIGNS", 8)
    monkeypatch.setattr(module, "MISMATCHES", [0.0, 0.05, 0.1])
    part = Trajectories()
    cells = all_done(part, COARSE)
    found = part.conclude(cells)
    assert [one.verdict for one in found.statements][1] == CONFIRMED
    assert len(found.statements) == 2 and found.summary["trajectories_lean_most_deg"] > 5.0
    check_figures(found, tmp_path)
    few_rows = [{**cells["ranges"].rows[0], "status": "not_finite", "liftoff_vx_m_s": None}]
    spread = replace(cells["ranges"], rows=[*cells["ranges"].rows, *few_rows])
    assert "1 failed)" in part.conclude({**cells, "ranges": spread}).statements[0].found
    swept = cells["mismatches, standard"]
    broken = replace(swept, rows=[*swept.rows[:-1], *few_rows])
    none = part.conclude({**cells, "mismatches, standard": broken})
    assert not none.statements and "not_finite" in none.section.paragraphs[0]
    lost = {**cells, "ranges": done("ranges", [], FAILED, "no memory")}
    assert "no memory" in part.conclude(lost).section.paragraphs[0]
