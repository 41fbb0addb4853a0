"""Measured clamp angles: what they are between rows, what is refused, and a jump of them."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scaled import Factors, scaled
from scipy.interpolate import PchipInterpolator

from snapjump.batch import simulate_batch, simulate_designs
from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.dataset.specification import specify
from snapjump.drive.constant_rate import ConstantRate
from snapjump.drive.table import Table
from snapjump.run.tasks.simulate import Simulate
from snapjump.simulation import build

SMALL, LARGE = Factors(2.0**-7, 2.0**-9, 2.0**-18), Factors(2.0**7, 2.0**11, 2.0**18)
TIMES = np.linspace(0.003, 0.083, 41)
HEADINGS = "time_s, left_rad, right_rad"


def rows_of(left, lag=0.1):
    return [[float(t), float(a), float(a - lag)] for t, a in zip(TIMES, left, strict=True)]


def written(folder, rows, headings=HEADINGS):
    path = folder / "angles.csv"
    path.write_text("\n".join([headings, *(", ".join(map(repr, row)) for row in rows)]) + "\n")
    return str(path)


RAMP = rows_of(np.minimum(20.0 * (TIMES - TIMES[0]), 1.5))
WAVY = rows_of(0.7 - 0.7 * np.cos(40.0 * (TIMES - TIMES[0])))


def test_angles_go_through_the_rows_as_monotone_cubics():
    one = Simulation(drive=Table(rows=WAVY))
    law, time_s = one.drive.programme(one, 0.0), one.robot.scales.time_s
    cubic = PchipInterpolator(TIMES - TIMES[0], [row[1] for row in WAVY])
    for seconds in (0.0, 0.0004, 0.002, 0.0433, 0.0799):
        angles = law.angles(seconds / time_s)
        assert angles.left == pytest.approx(float(cubic(seconds)), abs=1e-12)
        assert angles.left_rate == pytest.approx(float(cubic(seconds, 1)) * time_s, abs=1e-10)
        assert angles.left - angles.right == pytest.approx(0.1, abs=1e-12)
    held = law.angles(1e4)
    assert (held.left, held.left_rate, held.right_rate) == (WAVY[-1][1], 0.0, 0.0)
    assert law.rate == pytest.approx(one.drive.rate_rad_s * time_s)


@pytest.mark.parametrize("factors", [SMALL, LARGE])
def test_a_table_of_a_world_of_other_scales_turns_alike(factors):
    one = Simulation(drive=Table(rows=WAVY))
    slower = [[time * factors.time, *angles] for time, *angles in WAVY]
    other = replace(scaled(one, factors), drive=Table(rows=slower))
    found, expected = (each.drive.programme(each, 0.7) for each in (other, one))
    assert found[:-1] == expected[:-1] and np.array_equal(found.pieces, expected.pieces)


def test_a_file_is_its_rows(tmp_path):
    path = written(tmp_path, RAMP)
    read = Table(file=path)
    assert [list(row) for row in read.rows] == RAMP
    kept = Simulation(drive=read).configuration
    (tmp_path / "angles.csv").unlink()
    assert build(kept).drive.rows == read.rows


def test_content_counts(tmp_path):
    """In datasets, and in what a sweep's cell has read."""
    plan = {"name": "sobol", "count": 4}

    def told(rows):
        config = {"drive": {"name": "table", "file": written(tmp_path, rows)}}
        task = Simulate()
        inputs = {"design.epsilon": [0.15, 0.25]}
        made = specify({**config, "plan": {**plan, "inputs": inputs}}, 4)
        return made.plain["configuration"]["drive"]["rows"], task.reads(config)

    one, other = told(RAMP), told(WAVY)
    assert one[0] != other[0] and one[1] != other[1] and one[1].keys() == {"drive.file"}


@pytest.mark.parametrize(
    ("rows", "told"),
    [
        (RAMP[:2], "drive.rows = 2 .* 3 to 2000 rows"),
        ([*RAMP[:3], RAMP[1]], "drive.rows .time_s. = 0.005 .* ascend"),
        ([*RAMP[:3], [1.0, 2.0, 0.0]], "drive.rows .left_rad. = 2.0 .* rad"),
        ([*RAMP[:3], [1.0, math.nan, 0.0]], "drive.rows .left_rad. = nan"),
        ([*RAMP[:3], [1.0, 0.0]], "drive.rows = .1.0, 0.0. .* rows of time_s, left_rad, right_rad"),
    ],
)
def test_rows_that_are_refused(rows, told):
    with pytest.raises(ParameterError, match=told):
        Table(rows=rows)


def test_files_that_are_refused(tmp_path):
    with pytest.raises(ParameterError, match="drive.file = None .* a line of headings"):
        Simulation(drive="table")
    with pytest.raises(ParameterError, match="drive.file .*No such file"):
        Table(file=str(tmp_path / "nowhere.csv"))
    with pytest.raises(ParameterError, match="it lacks right_rad"):
        Table(file=written(tmp_path, RAMP, "time_s, left_rad, other"))
    with pytest.raises(ParameterError, match="numbers in line 3"):
        Table(file=written(tmp_path, [RAMP[0], ["x", 0.0, 0.0], *RAMP[1:]]))


def test_what_does_not_go_with_a_table():
    drive = Table(rows=RAMP)
    with pytest.raises(ParameterError, match="design.delta_alpha = 0.05 .* 0.1 rad, by which"):
        Simulation(drive=drive, design={"delta_alpha": 0.05})
    with pytest.raises(ParameterError, match="sim.start_fraction = 0.5 .* 0 with drive=table"):
        Simulation(drive=drive, sim={"name": "jump", "start_fraction": 0.5})
    with pytest.raises(ParameterError, match="backend = 'cuda'"):
        Simulation(drive=drive, backend="cuda")
    others = [Simulation(drive=one, backend="lanes") for one in (drive, Table(rows=WAVY))]
    with pytest.raises(ParameterError, match="drive = 'table' .* the table of the first robot"):
        simulate_batch(others)


@pytest.mark.slow
def test_a_ramp_jumps_as_a_constant_rate_does():
    """Up to its first piece, in which the clamps begin at rest; in lanes as alone."""
    base = with_tier("draft", drive=Table(rows=RAMP))
    rows = [[0.1, 0.2, 0.768, 0.3], [0.1, 0.15, 1.2, 0.4], [0.1, 0.25, 1.0, 0.2]]
    lanes, one = (simulate_designs(base, rows, threads=1, lanes=k) for k in (8, 1))
    assert np.array_equal(lanes.x_bar, one.x_bar) and np.array_equal(lanes.y_bar, one.y_bar)
    usual = simulate_designs(with_tier("draft", drive=ConstantRate()), rows, threads=1)
    assert np.allclose(lanes.y_bar, usual.y_bar, rtol=0.02)
    assert np.all(lanes.apex_time_s == pytest.approx(usual.apex_time_s, rel=0.02))
