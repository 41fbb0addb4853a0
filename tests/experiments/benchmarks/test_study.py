"""The study at toy size, from its cells to its page, and one march of each kind."""

from pathlib import Path
from typing import Any

import pytest
from cells import GIVEN, STANDARD, run_study

from experiments.benchmarks import shallow, study
from experiments.benchmarks.amplitude import (
    DELAY_EXPONENTS,
    TIME_EXPONENTS,
    delay_prefactor,
    time_prefactor,
)
from experiments.benchmarks.arches import DAMPING, INERTIA, MISMATCH, snapping_groups
from experiments.benchmarks.cubes.part import BOUNCE, SLIDE, Cubes
from experiments.benchmarks.delay.marches import opened_rows, turned_rows
from experiments.benchmarks.rotations.part import flat
from experiments.benchmarks.slowing.marches import time_rows
from experiments.benchmarks.span.part import FOLD, SLOW, Span
from experiments.benchmarks.symmetries import part as symmetries
from snapjump.checks import ParameterError

NEAR = {INERTIA: 0.15, DAMPING: 0.06}  # of the laws, at the distances and rates below


def configured(**groups: Any) -> dict[str, Any]:
    return {**STANDARD, **GIVEN, "task": {"name": "benchmarks"}, **groups}


def test_a_page_from_cells_and_none_done_twice(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(study, "PARTS", {"symmetries": symmetries.Symmetries})
    monkeypatch.setattr(symmetries, "ELEMENTS", (24, 32, 40, 48))
    monkeypatch.setattr(symmetries, "EPSILONS", (0.03, 0.06))
    outcome, folder = run_study(study.Benchmarks(), configured(figures=False), Path("one"))
    assert outcome.status == "ok" and outcome.summary["cells"] == 8
    assert outcome.summary["symmetries_one_end"] == pytest.approx(1.78, abs=0.01)
    report = (folder.path / "report.md").read_text()
    assert "## How to read this" in report and "arXiv:2302.12152" in report
    assert "| α/√ε of the snap when one clamp turns" in report and "`symmetries.limit`" in report
    again, _ = run_study(study.Benchmarks(), configured(figures=False), Path("two"))
    assert again.summary["cells_kept"] == 8


def test_other_scenes_are_refused():
    with pytest.raises(ParameterError, match="sim = 'snap' .* jump with task=benchmarks"):
        study.Benchmarks().prepare(configured(sim={"name": "snap"}))


@pytest.mark.slow
@pytest.mark.parametrize("regime", [INERTIA, DAMPING])
def test_delays_and_times_are_near_the_amplitude_equation(regime):
    groups, near = snapping_groups(STANDARD, regime), NEAR[regime]
    both, one = shallow.fold(shallow.lagging(MISMATCH)), shallow.fold(shallow.ONE_END)
    law, rate, distance = DELAY_EXPONENTS[regime], 3e-3, 1e-4
    for rows, made, share, product in (
        (opened_rows, groups, 1.0, both.opening),
        (turned_rows, groups, 1.0, both.product),
        (turned_rows, flat(groups), 0.0, one.product),
    ):
        expected = delay_prefactor(regime, product)
        inputs = {"groups": made, "rates": [rate], "right_share": share, "exponent": law}
        inputs = {**inputs, "prefactor": expected}
        (row,) = rows(inputs)
        assert row["status"] == "ok"
        assert row["delay"] == pytest.approx(expected * rate**law, rel=near)
    law, expected = TIME_EXPONENTS[regime], time_prefactor(regime, both.product)
    inputs = {"groups": groups, "distances": [distance], "exponent": law, "prefactor": expected}
    (row,) = time_rows(inputs)
    assert row["time"] == pytest.approx(expected * distance**law, rel=near)


@pytest.mark.slow
def test_a_slowly_opened_span_snaps_behind_its_fold():
    part = Span()
    cell = next(cell for cell in part.plan(STANDARD, 0) if cell.name == SLOW)
    slow, fast = part.compute({**cell.inputs, "rates_m_s": [3e-3, 1e-2]})
    assert slow["status"] == fast["status"] == "ok"
    assert fast["snap"] < slow["snap"] < slow["mesh"] == fast["mesh"]
    assert slow["mesh"] == pytest.approx(FOLD, rel=2e-3) and slow["fold"] == FOLD
    delays = [row["mesh"] - row["snap"] for row in (slow, fast)]
    assert delays[1] / delays[0] == pytest.approx((1e-2 / 3e-3) ** 0.8, rel=0.1)


@pytest.mark.compiles
def test_a_bounce_and_a_slide_at_the_cube_s_parameters():
    part = Cubes()
    cells = {cell.name: cell for cell in part.plan(STANDARD, 0)}
    (bounce,) = part.compute(cells[BOUNCE].inputs)
    assert bounce["restitution"] == pytest.approx(0.78854, rel=0.005)
    (slide,) = part.compute(cells[SLIDE].inputs)
    assert slide["distance_m"] == pytest.approx(1.0 / (2.0 * 0.15 * 9.81), rel=0.005)
