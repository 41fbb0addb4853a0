"""From a dataset to a checkpoint: what it says, and that nothing is trained twice."""

from typing import Any

import numpy as np
import pytest
from forward_models import RANGES, RESNET
from refusals import refused
from small_datasets import CONFIG, WIDE_STICK, made_up_dataset, silent, small, smooth_dataset

from snapjump.checks import ParameterError
from snapjump.declare.members import make_member, member_class, member_names
from snapjump.files.sources import package_files
from snapjump.learning.data import JumpData
from snapjump.learning.forward_model import forward_model
from snapjump.learning.learn import CURVES, DETERMINES, FORWARD_MODEL, check_slopes, learn
from snapjump.learning.training import Training
from snapjump.simulation import build
from snapjump.targets.request import trained_forward

OPTIONS = make_member("surrogate", RESNET)


def test_the_modules_that_determine_the_weights_exist():
    assert set(DETERMINES) <= {source.name for source in package_files()}


def refuse(share: float, text: str) -> None:
    raise AssertionError("trained again")


def test_what_a_checkpoint_says(jump_set, tmp_path):
    found = jump_set()
    learned = learn(found, OPTIONS, silent, {"seed": 0}, tmp_path)
    model = forward_model(learned.file)
    about = model.about
    assert about == learned.about and about["surrogate"] == RESNET
    assert about["dataset"]["sha256"] == about["dataset_sha256"] == found.dataset.sha256
    assert about["dataset"]["specification"] == found.dataset.specification
    assert np.array_equal(model.ranges, RANGES) and about["seed"] == 0
    assert about["training"]["epochs"] == about["epochs"] == len(learned.curves) == 6
    assert [about[f"rows_{part}"] for part in ("train", "validation", "test")] == [288, 32, 80]
    assert about["parameters"] == 4 * 16 + 16 + 2 * (16 * 16 + 16) + 16 * 2 + 2
    assert about["configuration"] == {"seed": 0} and "torch" in about["origin"]["versions"]
    off = np.abs(model.predict(found.test.designs.double().numpy()) - found.test.apexes.numpy())
    assert about["measures"]["mae_bar"] == pytest.approx(off.mean(), rel=1e-4)


def test_nothing_is_trained_twice_and_what_is_damaged_is(jump_set, tmp_path):
    first = learn(jump_set(), OPTIONS, silent, None, tmp_path)
    again = learn(jump_set(), OPTIONS, refuse, None, tmp_path)
    assert not first.kept and again.kept
    assert again.file == first.file and again.curves == first.curves
    assert {f.name for f in first.file.parent.iterdir()} == {".lock", FORWARD_MODEL, CURVES}
    content = first.file.read_bytes()
    first.file.write_bytes(content[:-1])
    assert not learn(jump_set(), OPTIONS, silent, None, tmp_path).kept
    changes: list[dict[str, Any]] = [{"seed": 1}, {"epochs": 5}, {"rows": 200}]
    files = {learn(jump_set(**change), OPTIONS, silent, None, tmp_path).file for change in changes}
    assert len({*files, first.file}) == 4


def test_what_needs_no_descent(jump_set, tmp_path):
    learned = learn(jump_set(), member_class("surrogate", "rbf")(), silent, None, tmp_path)
    assert learned.curves == [] and learned.about["epochs"] == 0
    model = forward_model(learned.file)
    found = jump_set()
    designs = found.test.designs.double().numpy()
    assert np.abs(model.predict(designs) - found.test.apexes.numpy()).mean() < 0.1
    assert model.jacobian(designs[:3]).shape == (3, 2, 4)


def test_intervals_come_from_the_validation_set(jump_set, tmp_path):
    options = member_class("surrogate", "ensemble")(members=3, width=8, blocks=1)
    learned = learn(jump_set(), options, silent, None, tmp_path)
    measured = learned.about["measures"]
    assert 0.7 < measured["coverage"] <= 1.0 and measured["half_width_bar"] > 0.0
    half_widths = forward_model(learned.file).half_widths(jump_set().test.designs.numpy())
    assert half_widths is not None
    assert half_widths.mean() == pytest.approx(measured["half_width_bar"], rel=1e-4)


def test_slopes_must_be_there_for_what_needs_them(jump_set, tmp_path):
    options = member_class("surrogate", "gradient_mlp")(width=8, layers=1)
    how = "dataset.sensitivities=true friction.velocity_threshold_m_s=0.01"
    with refused("dataset.path", how) as caught:
        check_slopes(options, jump_set())
    assert caught.value.value in str(caught.value)
    sticky = small(100, 100, sensitivities=True)
    unknown = smooth_dataset(tmp_path / "unknown", sticky, differentiable=False)
    training = Training(epochs=2, batch_first=16, batch_last=16, validation_share=0.2)
    with refused("dataset.path", how):
        check_slopes(options, JumpData(unknown, training, 0))
    specification = small(100, 100, sensitivities=True, friction=WIDE_STICK)
    dataset = smooth_dataset(tmp_path / "slopes", specification)
    with_slopes = JumpData(dataset, training, 0)
    assert len(learn(with_slopes, options, silent, None, tmp_path).curves) == 2


@pytest.mark.parametrize("name", member_names("surrogate"))
def test_a_forward_model_has_the_inputs_of_its_dataset(name, tmp_path):
    inputs = {"robot.thickness_m": None, "environment.mass_bar": None, "design.epsilon": None}
    plan = {"name": "latin_hypercube", "count": 160, "inputs": inputs}
    changes: dict[str, Any] = {"plan": plan, "friction": WIDE_STICK}
    specification = small(160, 160, sensitivities=True, **changes)
    dataset = made_up_dataset(tmp_path / "data", specification)
    data = JumpData(dataset, Training(epochs=1), 0)
    learned = learn(data, member_class("surrogate", name)(), silent, None, tmp_path)
    model = forward_model(learned.file)
    assert [axis.path for axis in model.axes] == list(inputs)
    designs = specification.plan.designs(0, 5)
    assert model.predict(designs).shape == (5, 2)
    assert model.jacobian(designs).shape == (5, 2, 3)
    with pytest.raises(ParameterError, match=r"thickness_m = 0.001"):
        model.predict(np.array([[1e-3, 1.0, 0.2]]))
    robot = {"thickness_m": 6e-5}  # an input, whatever it is in the configuration
    model.check_model(build({**CONFIG, **changes, "plan": {}, "robot": robot}))
    with pytest.raises(ParameterError, match="environment.mu = 0.4"):
        model.check_model(build({**CONFIG, **changes, "environment": {"mu": 0.4}}))
    with pytest.raises(ParameterError, match="for inverse design"):
        trained_forward(learned.file)
