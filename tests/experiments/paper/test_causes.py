"""Choices that lead from one end to the other, and the verdicts on made-up shifts."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from cells import COARSE, STANDARD, all_done, check_figures, done

from experiments.compositions import changed, composed, groups_at
from experiments.errors import Shift, shift
from experiments.exchanges import (
    DAMPING,
    ENDS,
    FRAME,
    PAPER,
    REFERENCE,
    START,
    choices,
    program,
    variants,
)
from experiments.paper.base import CONFIRMED, LIMITED, NOT_CONFIRMED
from experiments.paper.causes import part as judge
from experiments.paper.causes import words
from experiments.paper.causes.part import Causes
from experiments.paper.settings import BASELINE
from snapjump.run.studies.base import FAILED


def shifted(x: float, y: float, tail: float = 1.0) -> Shift:
    """Medians and tails of so many times as much."""
    return Shift(x, tail * x, y, tail * y, y)


def rows(*apexes: tuple[float, float], status: str = "ok", gap: float = 1e-4) -> list[Any]:
    return [{"status": status, "x_bar": x, "y_bar": y, "min_gap_m": gap} for x, y in apexes]


def test_all_choices_lead_from_one_end_to_the_other():
    at = {end: groups_at(STANDARD, end) for end in ENDS}
    there, back = dict(at[PAPER]), dict(at[REFERENCE])
    for title, (converged, papers) in choices(at).items():
        if title not in (FRAME, START):
            there, back = changed(there, converged), changed(back, papers)
    # By adaptive steps the paper's integrator is not meant to be replaced alone.
    apart = {"stepping": None, "accuracy": None}
    assert there | apart == at[REFERENCE] | apart
    assert back["damping"]["relaxation_time_s"] == 0.0
    apart = {"damping": None, "accuracy": None}
    assert back | apart == at[PAPER] | apart


def test_exchanges_can_be_composed_and_differ_from_their_ends():
    at = {end: groups_at(STANDARD, end) for end in ENDS}
    made = variants(at)
    assert {end for end, _ in made} == set(ENDS)
    for (end, title), groups in made.items():
        assert composed(groups) != composed(at[end]), (end, title)
    assert program(made[REFERENCE, DAMPING]) == program(at[REFERENCE])
    names = [cell.name for cell in Causes().plan(STANDARD, 0)]
    assert len(set(names)) == len(names)


def test_shift():
    base = rows((1.0, 10.0), (2.0, 10.0), (0.0, 10.0))
    found = shift(rows((1.1, 11.0), (2.2, 11.0), (0.1, 11.0)), base)
    # The last x is compared with a tenth of the height.
    assert (found.x_median, found.y_median, found.y_signed) == pytest.approx((10.0, 10.0, 10.0))
    assert shift(rows((1.0, 10.0), (2.0, 10.0), (np.nan, np.nan)), base).x_p95 == np.inf


def test_verdicts():
    assert judge.matters(shifted(0.1, 0.1, 5.0)) == CONFIRMED
    assert judge.matters(shifted(2.0, 0.1, 5.0)) == LIMITED
    assert judge.matters(shifted(0.1, 6.0)) == NOT_CONFIRMED
    good = rows(*[(1.0, 10.0)] * 199)
    assert judge.stable(good) == CONFIRMED
    assert judge.stable(good + rows((np.nan, np.nan), status="step_underflow")) == LIMITED
    assert judge.stable(rows((1.0, 2.0), status="not_finite")) == NOT_CONFIRMED


def test_failures_in_a_frame_are_told():
    ladder = {1e3: shifted(2.0, 1.0), 1e4: shifted(0.2, 0.1)}

    def found(lost: int) -> str:
        own = ladder[1e3]
        others = {"paper": own, "off": own, "epsilon": (0.2, 0.19), "designs": 32}
        return words.frame(LIMITED, ladder, lost, **others).found

    assert "1 of 32 jumps fail and count as infinitely far." in found(1)
    assert "0 of 32 jumps fail." in found(0)


def test_steps_that_do_not_help_are_told():
    slow, fast = (
        words.step(LIMITED, {1e-5: shifted(6.0, 2.0), 1e-6: last}, finest_s=1e-7, designs=32).found
        for last in (shifted(4.0, 1.0), shifted(0.6, 0.2))
    )
    assert "agree: to 4 % in x_c and 1 % in y_c" in slow
    assert "slowly" in slow and "slowly" not in fast


def test_noise_names_what_matters_in_the_papers_settings_alone():
    at = {end: groups_at(STANDARD, end) for end in ENDS}
    moved = {(end, title): shifted(3.0, 1.0) for end in ENDS for title in choices(at)}
    assert "No other choice" in words.seeming(moved)
    moved[REFERENCE, "lagged friction"] = shifted(0.05, 0.01)
    assert "So do lagged friction: they seem" in words.seeming(moved)


def test_starts_of_a_rigid_frame_keep_their_compression():
    row = Causes().compute({"groups": COARSE, "designs": [BASELINE], "kind": "starts"})[0]
    assert row["epsilon_left"] == pytest.approx(BASELINE[1], abs=1e-9)


def test_report(tmp_path):
    """The whole part from jumps that are made up, and without one of its cells."""
    rng = np.random.default_rng(0)
    part = Causes()

    def rows_of(cell: Any) -> Any:
        if cell.inputs.get("kind") == "starts":
            return [{"clear_span_bar": 0.81, "epsilon_left": 0.19}]
        count = len(cell.inputs["designs"])
        return rows(*rng.normal((5.0, 14.0), 0.1, (count, 2)))

    cells = all_done(part, STANDARD, rows_of)
    found = part.conclude(cells)
    assert [one.verdict for one in found.statements] == [*[LIMITED] * 4, NOT_CONFIRMED, CONFIRMED]
    assert "ε = 0.190" in found.statements[0].found
    check_figures(found, tmp_path)
    assert "Failed jumps" not in " ".join(found.section.paragraphs)
    one = cells[PAPER]
    gained = [*one.rows[:-1], *rows((np.nan, np.nan), status="energy_gained")]
    told = part.conclude({**cells, PAPER: replace(one, rows=gained)}).section.paragraphs[-1]
    assert "paper (1 of 32 jumps failed: energy_gained)" in told
    lost = done(one.cell, [], FAILED, "no memory")
    assert "no memory" in part.conclude({**cells, PAPER: lost}).section.paragraphs[0]
