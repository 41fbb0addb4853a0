"""The achievable region against simulations."""

import json

import numpy as np
import pytest
from made_up_maps import RANGES, MadeUpModel, MadeUpSimulator, straight

from experiments import region

TOO_HIGH = 0.05  # of the forward model's heights


def test_a_model_that_jumps_too_high_accepts_above_and_rejects_below(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    model = MadeUpModel(lambda designs: (1.0 + TOO_HIGH) * straight(designs), RANGES)
    monkeypatch.setattr(region, "open_forward_model", lambda path: model)
    monkeypatch.setattr(region, "JumpSimulator", lambda base: MadeUpSimulator(straight))
    region.main()
    found = json.loads(capsys.readouterr().out)
    assert found["targets"] == 2000
    # The region is x / y from 0.01 to 0.19 (times a slope), y from 0.1 to 0.3 (times a height),
    # and targets are in 1.2 times its box either way: the areas that both edges sweep, over that.
    box = 1.2**2 * (0.19 * 0.3 - 0.01 * 0.1) * 0.2
    swept = 0.5 * 0.18 * np.array([0.3, 0.1]) ** 2 * ((1.0 + TOO_HIGH) ** 2 - 1.0)
    accepted, rejected = 100.0 * swept / box
    assert found["false_accept_percent"] == pytest.approx(accepted, rel=0.3)
    assert found["false_reject_percent"] == pytest.approx(rejected, rel=0.7)
    assert (
        0.0 < found["false_accept_median_distance_bar"] < found["false_accept_largest_distance_bar"]
    )


def test_a_perfect_model_is_never_wrong() -> None:
    assert region.report([], [])["false_reject_percent"] == 0.0
