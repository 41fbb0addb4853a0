"""Every source: its numbers, words, limits and citation; and what becomes of made-up rows."""

import math
import re
from pathlib import Path
from typing import Any

import pytest
from cells import STANDARD, all_done, check_figures
from command_line import ROOT

from experiments.arches import exact
from experiments.benchmarks import base
from experiments.benchmarks.base import ALL_VERDICTS, INCOMPARABLE, LIMITS, SOURCES, UNREADABLE
from experiments.benchmarks.study import PARTS
from experiments.benchmarks.surface.part import KNOWN_RAD, KNOWN_STRETCHES
from experiments.paper.base import CONFIRMED, NOT_CONFIRMED
from experiments.parted import row_sources
from snapjump.run.studies.base import FAILED, Cell, Done, Row

FOLDER = Path(base.__file__).parent
CODE = "\n".join(file.read_text(encoding="utf-8") for file in FOLDER.glob("*/*.py"))


def test_every_source_has_a_part_limits_and_words():
    assert SOURCES.keys() == PARTS.keys()
    assert {key.split(".")[0] for key in LIMITS} == set(PARTS)
    for key, limit in LIMITS.items():
        _, name = key.split(".")
        assert f'"{name}"' in CODE and limit.of and limit.source.startswith("ours"), key
        assert limit.holds(limit.confirmed, limit.within), "no narrower than confirmation"


def test_sources_are_cited():
    cited = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    for name, source in SOURCES.items():
        found = re.findall(r"arXiv:\d{4}\.\d{5}", source.reference) or [source.link]
        assert all(one in cited for one in found), f"{name}: {found}"


def test_a_number_is_there_or_the_reason_why_it_is_not():
    for source in SOURCES.values():
        assert source.read.strip()
        for number in source.numbers.values():
            assert number.place.strip()
            assert str(number) != UNREADABLE or "not readable" in number.place


@pytest.mark.parametrize("name", list(PARTS))
def test_every_part_is_whole(name):
    part = PARTS[name]()
    cells = part.plan(STANDARD, 0)
    used = {source.name for source in row_sources(part)}
    assert f"experiments.benchmarks.{name}.part" in used
    assert not {u for u in used if re.search(r"\.(figure|words|limits)$", u)}
    broken = Done(cells[0], FAILED, "it broke", [], "run", "", "")
    assert "it broke" in part.conclude({cells[0].name: broken}).section.paragraphs[0]


# Rows as they would be if everything were as the sources say, or off by a share.


def symmetries(cell: Cell, off: float) -> list[Row]:
    size = (1.0 / cell.inputs["elements"]) ** 2
    stretch = 1e-4 * cell.inputs["thickness_m"] ** 2
    numbers = {"one end": 1.781776, "alike": 2.0, "fold": 2.011905}
    return [
        {"epsilon": e, "stretch": stretch,
         **{k: (1 + off) * v + e - 1e3 * stretch - 10 * size for k, v in numbers.items()}}
        for e in cell.inputs["epsilons"]
    ]  # fmt: skip


def surface(cell: Cell, off: float) -> list[Row]:
    points = [(d, e) for d in cell.inputs["delta_alphas_rad"] for e in cell.inputs["epsilons"]]
    angles = [2.0 * math.sqrt(e) - 0.5 * d for d, e in points]
    if cell.inputs["kind"] == "meshes":
        size = cell.inputs["groups"]["discretization"]["elements"] ** -2.0
        return [{"alpha_critical_rad": (1 + off) * angle - size} for angle in angles]
    known = [
        (KNOWN_RAD, e, lam, exact.mismatched(e, KNOWN_RAD, lam > 0.0)["aL"])
        for e in exact.COMPARED
        for lam in KNOWN_STRETCHES
    ]
    rows = [(*p, 5e-7, angle) for p, angle in zip(points, angles, strict=True)] + known
    names = ("delta_alpha_rad", "epsilon", "stretch", "alpha_critical_rad")
    return [{**dict(zip(names, row, strict=True)), "residual": 1e-9} for row in rows]


def delay(cell: Cell, off: float) -> list[Row]:
    law = cell.inputs["exponent"] + 10 * off
    return [
        {"status": "ok", "rate": r, "rate_rad_s": r, "rate_m_s": r, "fold": 1.8, "snap": 1.9,
         "steps": 10, "delay": cell.inputs["prefactor"] * r**law}
        for r in cell.inputs["rates"]
    ]  # fmt: skip


def slowing(cell: Cell, off: float) -> list[Row]:
    law = cell.inputs["exponent"] + 10 * off
    return [
        {"status": "ok", "distance": d, "time": cell.inputs["prefactor"] * d**law}
        for d in cell.inputs["distances"]
    ]


def span(cell: Cell, off: float) -> list[Row]:
    if cell.inputs["kind"] == "fold":
        return [
            {"status": "ok", "rate_m_s": r, "snap": 0.1 - 0.05 * r**0.8, "mesh": 0.1 + 10 * off,
             "fold": 0.1 + 10 * off}
            for r in cell.inputs["rates_m_s"]
        ]  # fmt: skip
    rate = cell.inputs["rate_m_s"]
    slope = (20.0 if off == 0.0 else 1.0) * 0.01 / rate if rate < 1.0 else 1.0
    return [
        {"rate_m_s": rate, "delta_alpha_rad": lag,
         "theta_max_rad": slope * lag ** (1 + 100 * off)}
        for lag in cell.inputs["mismatches_rad"]
    ]  # fmt: skip


def rotations(cell: Cell, off: float) -> list[Row]:
    if cell.inputs["kind"] == "delays":
        return delay(cell, off)
    return [{"epsilon": e, "one end": 1.8, "alike": 2.0, "fold": 2.01} for e in (0.1, 0.2, 0.3)]


def cascade(cell: Cell, off: float) -> list[Row]:
    height = 0.9 if off == 0.0 else 9.0
    jump = {"status": "ok", "height_m": height, "with_drag_m": height, "liftoff_vy_m_s": 4.0}
    if cell.inputs["kind"] == "band":
        return [{"design.epsilon": 0.1, **jump, "height_m": height + k / 50} for k in range(-5, 6)]
    if cell.inputs["kind"] == "single":
        return [{"unknown": "design.epsilon", "value": 0.1, **jump}]
    return [{"design.epsilon": e, **jump} for e in cell.inputs["epsilons"]]


def cubes(cell: Cell, off: float) -> list[Row]:
    made = {
        "default ground": {"restitution": 0.125 + 100 * off},
        "bounce": {"restitution": 0.78854},
        "slide": {"distance_m": (1 + 10 * off) / (2.0 * 0.15 * 9.81)},
    }
    return [made[cell.name]]


MADE_UP = {
    f.__name__: f for f in (symmetries, surface, delay, slowing, span, rotations, cascade, cubes)
}


@pytest.mark.parametrize("name", list(PARTS))
def test_rows_as_the_source_has_them_and_others(name, tmp_path):
    part = PARTS[name]()
    for off, expected in ((0.0, CONFIRMED), (0.01, NOT_CONFIRMED)):
        rows: Any = lambda cell, off=off: MADE_UP[name](cell, off)  # noqa: E731
        found = part.conclude(all_done(part, STANDARD, rows))
        verdicts = {one.key.split(".")[1]: one.verdict for one in found.comparisons}
        judged = {key: v for key, v in verdicts.items() if v != INCOMPARABLE}
        assert set(verdicts.values()) <= set(ALL_VERDICTS) and expected in judged.values(), judged
        if off == 0.0:
            assert NOT_CONFIRMED not in judged.values(), judged
        for one in found.comparisons:
            row = one.row()
            assert row["quantity"] and row["remark"] and "{" not in row["remark"], one.key
        assert all(isinstance(v, float) and math.isfinite(v) for v in found.summary.values())
    check_figures(found, tmp_path)
