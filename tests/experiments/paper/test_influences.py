"""Sweeps of coarse jumps, and the verdicts on curves that are made up."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from cells import COARSE, all_done, check_figures

from experiments.paper.base import CONFIRMED, LIMITED, NOT_CONFIRMED
from experiments.paper.cells import furthest, jump_rows
from experiments.paper.influences import part as module
from experiments.paper.influences import words
from experiments.paper.influences.heights import MOUNT_HEIGHT, Height, height, height_verdicts
from experiments.paper.influences.part import SWEEPS, Influences, friction_statements, levels_off
from experiments.paper.limits import judged
from experiments.paper.settings import BASELINE
from experiments.trends import plateau
from snapjump.simulation import build

H1, H2 = 0.07, 0.27
HEIGHTS = np.linspace(0.01, 0.35, 137)
NEAR = {"off": (0.1, 0.1), "counts": {"standard": 137, "reference": 35}}


def heights(x: Any, y: Any) -> list[dict[str, Any]]:
    return [
        {MOUNT_HEIGHT: h, "x_bar": a, "y_bar": b} for h, a, b in zip(HEIGHTS, x, y, strict=True)
    ]


def ramp(last: float) -> Any:
    """1 up to h1, 0 from ``last`` on."""
    return np.clip((last - HEIGHTS) / (last - H1), 0.0, 1.0)


def found(x: Any, y: Any) -> Height:
    return height(heights(x, y), H1, H2, ("y_c", "x_c"))


def test_height_as_the_paper_says():
    one = found(5.0 * ramp(H2), 14.0 * ramp(H2) + 0.4)
    assert set(height_verdicts(one).values()) == {CONFIRMED}
    assert one.close_from == HEIGHTS[0] and one.best < 1e-12
    higher = found(5.0 * ramp(H2), 14.0 * ramp(H2) + np.where(HEIGHTS < 0.05, 1.4, 0.4))
    assert higher.best == pytest.approx(1.0 / 14.4) and higher.best_height < 0.05
    assert height_verdicts(higher)["best"] == NOT_CONFIRMED


def test_height_otherwise():
    waves = 1.0 + np.where(HEIGHTS < H1, 0.04, 0.1) * np.sin(200.0 * (HEIGHTS - H1))
    one = found(5.0 * ramp(0.29) * waves, 14.0 * ramp(0.29) * waves + 0.4)
    assert [*height_verdicts(one).values()][:3] == [LIMITED] * 3
    tilted = (2.0 - HEIGHTS / H1) * ramp(0.34)
    one = found(np.sin(40.0 * HEIGHTS), 14.0 * np.abs(tilted) + 0.4)
    assert set(height_verdicts(one).values()) == {NOT_CONFIRMED}


def test_limits_of_the_plateau_are_told():
    rising = np.where(HEIGHTS < H1, 0.5 + 0.5 * HEIGHTS / H1, 1.0) * ramp(H2)
    pressed = [{MOUNT_HEIGHT: 0.05, "load_over_weight": 3.0, "alpha_snap_rad": 1.0}]

    def told(one: Height) -> str:
        said = words.heights(height_verdicts(one), one, one, first=0.01, near=NEAR)
        return words.oblique(said, one, pressed, {"alpha_critical_rad": 0.9})[0].found

    turned = told(found(5.0 * rising, 14.0 * ramp(H2) + 0.4))
    assert turned.startswith("In y_c only") and "height remains" in turned
    same = told(found(5.0 * ramp(H2), 14.0 * ramp(H2) + 0.4))
    assert same.startswith("Here h1") and "height remains" not in same


def test_robots_that_never_jump_confirm_nothing():
    one = found(0.0 * HEIGHTS + 1.0, 0.0 * HEIGHTS + 0.4)
    assert np.isnan(one.last_jump) and height_verdicts(one)["beyond_h2"] == NOT_CONFIRMED


def test_rules():
    assert judged("influences.monotone", np.nan, 0.0) == NOT_CONFIRMED
    v = np.linspace(0.0, 1.0, 101)
    level = np.minimum(v, 0.3)
    assert levels_off(plateau(v, level)) == CONFIRMED
    waves = plateau(v, level + 0.01 * np.sin(60.0 * v))
    storm = plateau(v, level + 0.05 * np.sin(60.0 * v))
    assert levels_off(waves) == levels_off(waves, storm) == LIMITED
    assert levels_off(storm) == NOT_CONFIRMED
    told = words.limit_of_level
    assert told(LIMITED, {"x_c": storm, "y_c": waves}).startswith("In y_c only.")
    assert told(LIMITED, {"x_c": waves}).startswith("To within")
    assert told(CONFIRMED, {"x_c": waves}) == ""
    assert levels_off(plateau(v, level + 0.5 * v)) == NOT_CONFIRMED


def test_contact_that_sticks_is_said_to():
    row = {"braking_share": 0.1, "sticking_share": 0.001, "friction_over_normal": 0.2}
    assert "Not because the contact sticks" in words.why(
        [{"mu": 0.1, **row}, {"mu": 0.4, **row}], 0.2
    )
    stuck = {**row, "sticking_share": 0.6, "mu": 0.4}
    assert words.why([stuck], 0.2).startswith("The contact sticks under up to 60 %")


def test_friction_verdicts():
    mus = np.linspace(0.0, 0.6, 61)
    row = {"braking_share": 0.1, "sticking_share": 0.0, "friction_over_normal": 0.2}
    sliding = [{"mu": 0.1, **row}, {"mu": 0.5, **row}]

    def verdicts(x: Any, y: Any) -> list[str]:
        rows = [{"mu": m, "x_bar": a, "y_bar": b} for m, a, b in zip(mus, x, y, strict=True)]
        found = friction_statements({"standard": rows, "paper": rows}, sliding, NEAR)
        return [one.verdict for one in found]

    assert verdicts(np.minimum(mus, 0.2), 14.0 + 0.0 * mus) == [CONFIRMED, CONFIRMED]
    assert verdicts(mus, 14.0 + 10.0 * mus) == [NOT_CONFIRMED, NOT_CONFIRMED]


def computed(kind: str, **inputs: Any) -> list[dict[str, Any]]:
    return Influences().compute({"kind": kind, "groups": COARSE, **inputs})


def test_sweeps_are_of_the_jumps_they_name():
    design = (*BASELINE[:3], 0.25)
    row = computed("jumps", designs=[design])[0]
    assert row["x_bar"] == jump_rows(build(COARSE), [design])[0]["x_bar"]
    standing = computed("heights", design=BASELINE, heights=[0.1, 0.4])
    assert standing[0]["y_bar"] > 5.0 > 0.5 > standing[1]["y_bar"] > 0.3
    assert furthest([row], [{**row, "x_bar": row["x_bar"] + 0.5}], "x_bar", "mu") == 0.5
    assert SWEEPS["mu"].inputs("standard")["designs"][25] == design
    assert len(SWEEPS["mu"].inputs("reference")["designs"]) == 26


def test_energies_are_those_of_the_jump_they_name():
    designs = [(*BASELINE[:2], 1.0, BASELINE[3])]
    row = computed("energies", designs=designs)[0]
    jump = computed("jumps", designs=designs)[0]
    standing = computed("heights", design=BASELINE, heights=[0.4])[0]["y_bar"]
    # A robot of lower mounts stands a little lower.
    rise = row["rise_share"] * row["energy_released_bar"]
    assert row["mass_bar"] == 1.0 and rise == pytest.approx(jump["y_bar"] - standing, abs=0.1)
    told = sum(value for key, value in row.items() if key.endswith("_share"))
    assert 0.9 < told < 1.15


def test_report(monkeypatch, tmp_path):
    """The whole part, every tier coarse and few values of each parameter."""
    few = {kind: replace(sweep, count=17) for kind, sweep in SWEEPS.items()}
    monkeypatch.setattr(module, "SWEEPS", few)
    coarse = {**COARSE, "stepping": {"name": "adaptive", "tolerance": 1e-5}}
    monkeypatch.setattr(module, "groups_at", lambda groups, tier: coarse)
    monkeypatch.setattr(module, "SHORT_CHANGES", {"stepping": {"tolerance": 3e-6}})
    part = Influences()
    cells = all_done(part, COARSE)
    found = part.conclude(cells)
    assert len(found.statements) == 13
    assert "h1 = 0.0" in found.statements[0].found
    swept = cells["epsilon, standard"]
    broken = {**swept.rows[3], "status": "step_underflow", "x_bar": None, "y_bar": None}
    lost = replace(swept, rows=[*swept.rows[:3], broken, *swept.rows[4:]])
    none = part.conclude({**cells, "epsilon, standard": lost})
    assert not none.statements
    assert "epsilon, standard (1 of 17 jumps failed: step_underflow)" in none.section.paragraphs[0]
    check_figures(found, tmp_path)
