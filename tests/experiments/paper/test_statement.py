"""Verdicts, and their table."""

from experiments.paper.base import (
    CONFIRMED,
    LIMITED,
    NOT_CONFIRMED,
    Statement,
    statement_rows,
    verdict,
    weakest,
)
from experiments.paper.study import counts, readme_block


def test_a_verdict_follows_from_what_holds():
    assert verdict(True) == verdict(True, True) == CONFIRMED
    assert verdict(False, True) == LIMITED
    assert verdict(False) == NOT_CONFIRMED
    assert weakest(CONFIRMED, LIMITED) == LIMITED
    assert weakest(LIMITED, NOT_CONFIRMED, CONFIRMED) == NOT_CONFIRMED


def test_tables_number_the_statements():
    statements = [
        Statement("jumps.it", "It jumps", CONFIRMED, "15 L", "`standard`"),
        Statement("flights.it", "It flies", NOT_CONFIRMED, "it falls", "`reference`"),
    ]
    rows = statement_rows(statements)
    assert [row["no."] for row in rows] == [1, 2]
    assert [row["what we find"] for row in rows] == ["15 L", "It falls"]
    assert rows[1]["command"] == "`python run.py task=paper figure=flights`"
    told = "1 confirmed, 0 confirmed within a limit, 1 not confirmed"
    assert counts(statements) == told
    block = readme_block(statements)
    assert "| 2 | It flies | not confirmed |" in block and told in block
