"""The table of limits: whole, ordered, with sources, and the one that judges read."""

import math
import re
from pathlib import Path

import pytest

from experiments.paper import limits
from experiments.paper.base import CONFIRMED, LIMITED, NOT_CONFIRMED
from experiments.paper.limits import LIMITS, Limit, judged, limit_rows
from experiments.paper.study import PARTS

FOLDER = Path(limits.__file__).parent
CODE = "\n".join(file.read_text(encoding="utf-8") for file in FOLDER.glob("*/*.py"))


def test_every_limit_has_a_part_and_is_read():
    assert {key.split(".")[0] for key in LIMITS} == set(PARTS)
    for key in LIMITS:
        part, *rest = key.split(".")
        assert f'"{key}"' in CODE or f'"{part}.{rest[0]}.{{' in CODE or f'"{part}.{{' in CODE, key


@pytest.mark.parametrize("key", LIMITS)
def test_a_limit_is_no_narrower_than_confirmation(key):
    limit = LIMITS[key]
    assert re.search("paper|ours|the same", limit.source) and limit.of
    assert not math.isnan(limit.confirmed) and not math.isnan(limit.within)


def test_verdicts_by_limits(monkeypatch):
    monkeypatch.setitem(LIMITS, "most", Limit(1.0, 2.0, "", ""))
    monkeypatch.setitem(LIMITS, "least", Limit(2.0, 1.0, "", "", True))
    monkeypatch.setitem(LIMITS, "only", Limit(math.inf, 2.0, "", ""))
    assert [judged("most", v) for v in (1.0, 1.5, 2.5)] == [CONFIRMED, LIMITED, NOT_CONFIRMED]
    assert [judged("least", v) for v in (2.0, 1.5, 0.5)] == [CONFIRMED, LIMITED, NOT_CONFIRMED]
    assert [judged("only", v) for v in (2.0, 2.5, math.nan)] == [CONFIRMED, *[NOT_CONFIRMED] * 2]
    assert judged("most", 0.0, 1.5) == LIMITED and judged("most", math.nan) == NOT_CONFIRMED


def test_the_table_for_readers():
    rows = {row["of"]: row for row in limit_rows()}
    assert rows["`bifurcation.snap.loop`"]["confirmed"] == "at least 0.5"
    assert rows["`causes.negligible`"]["within a limit"] == "any"
