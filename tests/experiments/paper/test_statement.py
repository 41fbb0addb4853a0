"""Verdicts, and their table."""

import pytest

from experiments.paper.base import (
    CONFIRMED,
    LIMITED,
    NOT_CONFIRMED,
    Statement,
    statement_rows,
    verdict,
)
from experiments.paper.study import counts, readme_block


def test_a_verdict_follows_from_what_holds():
    assert verdict(True) == verdict(True, True) == CONFIRMED
    assert verdict(False, True) == LIMITED
    assert verdict(False) == NOT_CONFIRMED
    with pytest.raises(AssertionError, match="perhaps"):
        Statement("It jumps", "perhaps", "It does", "`standard`")


def test_tables_number_the_statements():
    statements = [
        Statement("It jumps", CONFIRMED, "15 L", "`standard`"),
        Statement("It flies", NOT_CONFIRMED, "It falls", "`reference`", "task=paper figure=x"),
    ]
    rows = statement_rows(statements)
    assert [row["no."] for row in rows] == [1, 2]
    assert rows[1]["command"] == "`python run.py task=paper figure=x`"
    told = "1 confirmed, 0 confirmed within a limit, 1 not confirmed"
    assert counts(statements) == told
    block = readme_block(statements)
    assert "| 2 | It flies | not confirmed |" in block and told in block
