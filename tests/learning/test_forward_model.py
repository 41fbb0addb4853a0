"""Asking a forward model: values, slopes, what it refuses to answer, and measures of its errors."""

from dataclasses import replace

import numpy as np
import pandas as pd
import pytest
import torch
from forward_models import RANGES, about, jumps, network
from refusals import refused
from small_datasets import CONFIG

from snapjump import ParameterError, Robot
from snapjump.composition import with_tier
from snapjump.damping.kelvin_voigt import KelvinVoigt
from snapjump.drag.quadratic import QuadraticDrag
from snapjump.drive.smooth_start import SmoothStart
from snapjump.integrator.bdf2 import Bdf2
from snapjump.learning.forward_model import ForwardModel
from snapjump.learning.measures import errors, measures
from snapjump.simulation import build
from snapjump.surrogate.base import Surrogate
from snapjump.surrogate.resnet import Resnet


@pytest.fixture
def model() -> ForwardModel:
    """A forward model that has learned nothing."""
    return ForwardModel(network(), about())


def test_it_predicts_what_the_network_does(model):
    designs = jumps(5000).designs
    found = model.predict(designs.numpy())
    assert found.shape == (5000, 2) and found.dtype == np.float64
    with torch.no_grad():
        assert np.allclose(found, model.network(designs).numpy(), rtol=1e-5, atol=1e-5)
    assert model.predict(np.empty((0, 4))).shape == (0, 2)
    assert model.half_widths(designs.numpy()) is None


def test_its_slopes_are_those_of_its_values(model):
    model.network.double()
    designs, step = jumps(7).designs.double().numpy(), 1e-5
    for axis, move in enumerate(step * np.eye(4)):
        slopes = (model.predict(designs + move) - model.predict(designs - move)) / (2.0 * step)
        found = model.jacobian(designs)[:, :, axis]
        assert np.allclose(found, slopes, rtol=1e-6, atol=1e-6)


def test_slopes_of_a_network_that_torch_cannot_differentiate(model, monkeypatch):
    designs = jumps(20).designs.double().numpy()
    designs[0], designs[1] = np.array(RANGES).T  # no step leads out of the box
    exact = model.jacobian(designs)
    monkeypatch.setattr(Resnet, "differentiable", False)
    found = model.jacobian(designs)
    assert np.abs(found - exact).max() < 0.02 * np.abs(exact).max()


@pytest.mark.parametrize("axis", range(4))
@pytest.mark.parametrize("value", [-1e9, 1e9, np.nan, np.inf])
def test_it_does_not_extrapolate(model, axis, value):
    name = ("delta_alpha_rad", "epsilon", "mass_bar", "mu")[axis]
    designs = np.tile(np.mean(RANGES, axis=1), (3, 1))
    designs[1, axis] = value
    low, high = RANGES[axis]
    for ask in (model.predict, model.jacobian):
        with refused(name) as caught:
            ask(designs)
        assert f"[{low:g}, {high:g}]" in caught.value.allowed


def test_the_ends_of_the_ranges_are_inside(model):
    assert np.array_equal(model.ranges, RANGES)
    low, high = np.array(RANGES).T
    assert np.isfinite(model.predict(np.array([low, high, high * (1.0 + 1e-12)]))).all()


def test_designs_of_another_shape(model):
    for designs in (np.zeros(4), np.zeros((2, 3))):
        with pytest.raises(ParameterError, match="designs"):
            model.predict(designs)


def test_columns_of_a_frame_are_found_by_their_names(model):
    rows = np.array(RANGES).T
    frame = pd.DataFrame(rows, columns=[axis.column for axis in model.axes])
    np.testing.assert_array_equal(model.predict(frame[frame.columns[::-1]]), model.predict(rows))


def test_the_same_physical_model_at_other_numerics(model):
    same = build(CONFIG)
    model.check_model(same)
    finer = replace(same, discretization=replace(same.discretization, elements=96))
    model.check_model(replace(finer, integrator=Bdf2(), accuracy="reference"))


OTHERS = {
    "robot.width_m": Robot(width_m=0.02),
    "damping.relaxation_time_s": KelvinVoigt(1e-6),
    "contact.distance_m": with_tier("draft").contact,
    "friction": with_tier("paper").friction,
}


@pytest.mark.parametrize("key", OTHERS)
def test_another_physical_model_is_refused(model, key):
    part = {key.partition(".")[0]: OTHERS[key]}
    with refused(key, "trained with"):
        model.check_model(replace(build(CONFIG), **part))


def test_families_that_a_checkpoint_does_not_know_had_their_defaults(model):
    """It was trained before there were drives and drag; and a drive's number was the robot's."""
    kept = model.about["dataset"]["specification"]["configuration"]
    robot = {**kept["robot"], "rotation_rate_rad_s": 20.0, "rotation_end_rad": 1.5}
    older = {key: v for key, v in kept.items() if key not in ("drag", "drive")} | {"robot": robot}
    model.about["dataset"]["specification"]["configuration"] = older
    base = build(CONFIG)
    model.check_model(base)
    for key, part in (("drag", QuadraticDrag()), ("drive", SmoothStart())):
        with refused(key, "trained with"):
            model.check_model(replace(base, **{key: part}))
    robot["rotation_rate_rad_s"] = 30.0
    with refused("drive.rate_rad_s", "30.0, which the forward model was trained with"):
        model.check_model(base)


ROWS, OFF = jumps(100), torch.tensor([[3.0, -1.0], [-4.0, 1.0]]).repeat(50, 1)


class Off(Surrogate):
    """Wrong by OFF; its intervals are 3.5 wide, so that one x in two lies inside, and all y."""

    def __init__(self, half_width: float | None = None):
        super().__init__()
        self.half_width = half_width

    def forward(self, designs: torch.Tensor) -> torch.Tensor:
        return ROWS.apexes + OFF

    def half_widths(self, designs: torch.Tensor) -> torch.Tensor | None:
        return None if self.half_width is None else torch.full((len(designs), 2), self.half_width)


def test_measures():
    assert np.allclose(errors(Off(3.5), ROWS), OFF, atol=1e-5)
    found = measures(Off(3.5), ROWS)
    expected = {
        "mae_bar": (3.5 + 1.0) / 2.0, "mae_x_bar": 3.5, "mae_y_bar": 1.0,
        "rms_x_bar": np.sqrt(12.5), "median_x_bar": 3.5, "p95_x_bar": 4.0, "p95_y_bar": 1.0,
        "p95_bar": 4.0, "coverage": 0.75, "coverage_x": 0.5, "coverage_y": 1.0,
        "half_width_bar": 3.5,
    }  # fmt: skip
    for key, value in expected.items():
        assert found[key] == pytest.approx(value, rel=1e-4), key
    # Without intervals there is no coverage.
    assert "coverage" not in measures(Off(), ROWS)
