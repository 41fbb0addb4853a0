"""Inverse designs for targets: their cells, and the verdict with misses that are made up."""

from typing import Any

import numpy as np
import pytest
from cells import STANDARD, all_done, check_figures

from experiments.compositions import described
from experiments.paper.base import CONFIRMED, LIMITED, NOT_CONFIRMED
from experiments.paper.designs import part as judge
from experiments.paper.designs.figure import flight
from experiments.paper.designs.part import GROUPS, MANY_ROBOTS, METHODS, Designs
from snapjump.composition import with_tier
from snapjump.robot.robot import Robot
from snapjump.run.studies.base import Cell


def row(miss: float | None, case: Any = MANY_ROBOTS[0]) -> dict[str, Any]:
    places = {
        f"{name}_{axis}_bar": None if name == "standard" and miss is None else value
        for name in ("predicted", "standard", "reference", "paper")
        for axis, value in (("x", case.x_bar), ("y", case.y_bar))
    }
    return {
        "robot": case.label,
        "mass_bar": case.mass_bar,
        "mu": case.mu,
        "target_x_bar": case.x_bar,
        "target_y_bar": case.y_bar,
        "delta_alpha_rad": 0.1,
        "epsilon": 0.2,
        "reachable": True,
        "seconds": 0.5,
        "simulations": 24,
        **places,
        **{f"miss_{tier}_mm": miss for tier in ("standard", "reference", "paper")},
        "liftoff_x_bar": 0.0,
        "liftoff_y_bar": 0.5,
        "liftoff_vx_m_s": 0.3,
    }


def verdict(*misses: float | None) -> str:
    rows = [row(miss) for miss in misses]
    return judge.millimetres(dict.fromkeys(METHODS, rows)).verdict


def test_millimetres_or_not():
    assert verdict(0.1, 0.2, 4.6) == CONFIRMED
    assert verdict(0.1, 0.2, 0.1, 0.1, 0.1, 12.0) == LIMITED
    assert verdict(0.1, 0.2, None) == LIMITED
    assert verdict(5.0, 6.0) == NOT_CONFIRMED
    assert verdict(None, 6.0) == NOT_CONFIRMED


def test_each_method_has_to_hold():
    good = [row(0.1)] * 3
    wide = [row(5.0)] * 3  # together with good ones 2.6 mm in the mean

    def of(adam: Any, gauss_newton: Any) -> str:
        methods = {"adam": adam, "gauss_newton": gauss_newton, "physics": good}
        return judge.millimetres(methods).verdict

    assert of(good, good) == CONFIRMED
    assert of(good, wide) == of(wide, good) == NOT_CONFIRMED
    assert of(good, [*good, row(None)]) == LIMITED


def test_the_accuracy_is_how_far_the_tiers_are_apart():
    rows = [{**row(0.5), "miss_reference_mm": 0.8, "miss_paper_mm": 7.5}, row(0.2), row(None)]
    told = judge.millimetres(dict.fromkeys(METHODS, rows)).accuracy
    assert "at `reference` differ by up to 0.3 mm" in told and "at `paper` by up to 7 mm" in told


def test_two_robots_share_a_target():
    targets = [(case.x_bar, case.y_bar) for case in MANY_ROBOTS]
    assert len(targets) - len(set(targets)) == 1
    assert len({(case.mass_bar, case.mu) for case in MANY_ROBOTS}) == len(MANY_ROBOTS)


def test_a_flight_ends_at_the_apex_and_begins_at_lift_off():
    rise, fall = flight(row(0.1))
    case = MANY_ROBOTS[0]
    assert rise[:, -1] == pytest.approx([case.x_bar, case.y_bar])
    assert rise[1, 0] == pytest.approx(0.5)
    assert fall[:, 0] == pytest.approx(rise[:, -1])
    # Its curvature is gravity's.
    robot = Robot()
    second = robot.gravity_m_s2 * robot.length_m / 0.3**2
    slope = np.gradient(rise[1], rise[0])
    assert np.gradient(slope, rise[0])[5:-5] == pytest.approx(-second, rel=1e-3)


def test_a_cell_at_draft_reaches_what_it_is_to():
    planned = Designs().plan(STANDARD, 0)[0]
    target = [["A", 0.768, 0.3, 3.5, 16.0]]
    found = {}
    for method in ("gauss_newton", "physics"):
        inputs = {
            **planned.inputs, "groups": described(with_tier("draft")), "method": method,
            "cases": target, "tiers": ["draft", "standard"],
        }  # fmt: skip
        (found[method],) = Designs().compute(inputs)
    learned, refined = found["gauss_newton"], found["physics"]
    # The forward model is that of standard; physics hits at the tier that it searches at.
    assert learned["miss_standard_mm"] < 2.0
    assert refined["miss_draft_mm"] < 0.1 < refined["miss_standard_mm"] < 20.0
    assert refined["simulations"] > 0 and learned["simulations"] == 1
    assert 0.0 < learned["liftoff_y_bar"] < 2.0 < learned["draft_y_bar"]


def test_conclusion_and_figures(tmp_path):
    def rows_of(cell: Cell) -> Any:
        return [row(0.3, case) for case in GROUPS[cell.inputs["group"]]]

    found = Designs().conclude(all_done(Designs(), STANDARD, rows_of))
    assert [one.verdict for one in found.statements] == [CONFIRMED]
    assert found.summary["designs_adam_mean_mm"] == pytest.approx(0.3)
    assert len(found.section.tables["designs"].rows) == sum(map(len, GROUPS.values()))
    check_figures(found, tmp_path)
