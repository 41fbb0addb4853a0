"""Measures of errors that are known."""

import numpy as np
import pytest
import torch
from forward_models import jumps

from snapjump.learning.measures import errors, measures
from snapjump.surrogate.base import Rows, Surrogate

OFF = torch.tensor([[3.0, -1.0], [-4.0, 1.0]]).repeat(50, 1)


class Off(Surrogate):
    """Wrong by OFF; its intervals are 3.5 wide, so that one x in two lies inside, and all y."""

    def __init__(self, rows: Rows, known: bool):
        super().__init__()
        self.rows, self.known = rows, known

    def forward(self, designs: torch.Tensor) -> torch.Tensor:
        return self.rows.apexes + OFF

    def half_widths(self, designs: torch.Tensor) -> torch.Tensor | None:
        return torch.full((len(designs), 2), 3.5) if self.known else None


def test_measures():
    rows = jumps(100)
    assert np.allclose(errors(Off(rows, True), rows), OFF, atol=1e-5)
    found = measures(Off(rows, True), rows)
    expected = {
        "mae_bar": (3.5 + 1.0) / 2.0, "mae_x_bar": 3.5, "mae_y_bar": 1.0,
        "rms_x_bar": np.sqrt(12.5), "median_x_bar": 3.5, "p95_x_bar": 4.0, "p95_y_bar": 1.0,
        "p95_bar": 4.0, "coverage": 0.75, "coverage_x": 0.5, "coverage_y": 1.0,
        "half_width_bar": 3.5,
    }  # fmt: skip
    for key, value in expected.items():
        assert found[key] == pytest.approx(value, rel=1e-4), key


def test_without_intervals_there_is_no_coverage():
    rows = jumps(100)
    assert "coverage" not in measures(Off(rows, False), rows)
