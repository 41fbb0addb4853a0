"""The file of a forward model: kept and exported exactly, refused in one line if it is wrong."""

import json
import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import torch
from forward_models import RBF, RESNET, about, jumps, network
from refusals import refused
from safetensors.torch import save_file

from snapjump.checks import ParameterError
from snapjump.learning import export as module
from snapjump.learning.checkpoint import FORMAT, _sha256, read_checkpoint, write_checkpoint
from snapjump.learning.export import check_exportable, export, one_core
from snapjump.learning.forward_model import ForwardModel, forward_model


@pytest.fixture
def kept_model(tmp_path) -> Path:
    """The file of a network that has learned nothing."""
    write_checkpoint(tmp_path / "model.safetensors", network(), about())
    return tmp_path / "model.safetensors"


def test_what_was_kept_is_read(kept_model):
    found = read_checkpoint(kept_model)
    assert found.about == json.loads(json.dumps(about()))
    with torch.no_grad():
        designs = jumps(50).designs
        assert torch.equal(found.network(designs), network()(designs))
    assert np.isfinite(forward_model(str(kept_model)).predict(designs.numpy())).all()
    assert [f.name for f in kept_model.parent.iterdir()] == ["model.safetensors"]


def unusable(path: Path, why: str) -> None:
    with refused("checkpoint") as caught:
        read_checkpoint(path)
    assert caught.value.value == str(path)
    assert why in caught.value.allowed


def test_no_file_and_a_folder(tmp_path):
    unusable(tmp_path / "none.safetensors", "there is no such file")
    unusable(tmp_path, "it cannot be read")


@pytest.mark.parametrize("share", [0.0, 0.01, 0.5, 0.999])
def test_a_file_that_was_cut_off(kept_model, share):
    os.truncate(kept_model, int(share * kept_model.stat().st_size))
    unusable(kept_model, "it cannot be read")


def test_a_changed_byte_anywhere(kept_model):
    content = kept_model.read_bytes()
    random = np.random.default_rng(0)
    for place in [9, *random.integers(8, len(content), 100), len(content) - 1]:
        changed = bytearray(content)
        changed[place] ^= 1
        kept_model.write_bytes(bytes(changed))
        unusable(kept_model, "a forward model that task=train left")


def test_foreign_files(tmp_path):
    file, weights = tmp_path / "foreign.safetensors", {"weight": torch.ones(2)}
    save_file(weights, file)
    unusable(file, "its format is None")
    save_file(weights, file, {"format": "snapjump forward model 99"})
    unusable(file, "forward model 99")
    file.write_text("a text")
    unusable(file, "it cannot be read")
    torch.save(weights, file)
    unusable(file, "it cannot be read")


OTHERS = {
    "its weights are of another network": [{"width": 17}, {"blocks": 2}],
    "it has members that are not known here": [{"name": "transformer"}, {"depth": 3}],
}


@pytest.mark.parametrize("why", OTHERS)
def test_weights_of_another_surrogate(tmp_path, why):
    file = tmp_path / "model.safetensors"
    for change in OTHERS[why]:
        write_checkpoint(file, network(), about({**RESNET, **change}))
        unusable(file, why)


def sealed_as_ours(file: Path, about: Any, tensors: Any) -> None:
    """A checkpoint whose checksum is right, whatever it says."""
    text = about if isinstance(about, str) else json.dumps(about)
    content = {"format": FORMAT, "about": text, "sha256": _sha256(text, tensors)}
    save_file(tensors, file, content)


NESTED = "[" * 100_000 + "]" * 100_000
FOREIGN = [
    None, [], 3, "text", {}, NESTED, "{", {"surrogate": None}, {"surrogate": RESNET},
    {**about(), "surrogate": []}, {**about(), "dataset": None}, {**about(), "dataset": {}},
    {**about(), "dataset": {"sha256": 3, "specification": about()["dataset"]["specification"]}},
    {**about(), "dataset": {"sha256": "0", "specification": {"configuration": []}}},
    {**about(), "ranges": None}, {**about(), "ranges": [[0, 1]]}, {**about(), "inputs": [1, 2]},
    {**about(), "inputs": [{"path": "nowhere"}]},
]  # fmt: skip


@pytest.mark.parametrize("content", FOREIGN, ids=lambda content: str(content)[:40])
def test_whatever_a_foreign_file_says_it_is_one_line(tmp_path, content):
    file = tmp_path / "model.safetensors"
    text = content if content in (NESTED, "{") else json.dumps(content)
    sealed_as_ours(file, text, network().state_dict())
    with pytest.raises(ParameterError, match=r"checkpoint = ") as caught:
        forward_model(file)
    assert "\n" not in str(caught.value) and len(str(caught.value)) < 600


def test_weights_of_other_kinds(tmp_path):
    file = tmp_path / "model.safetensors"
    weights = network().state_dict()
    sealed_as_ours(file, about(), {name: value.int() for name, value in weights.items()})
    unusable(file, "")
    save_file({name: value.bfloat16() for name, value in weights.items()}, file,
              {"format": FORMAT, "about": json.dumps(about())})  # fmt: skip
    unusable(file, "")


def test_finite_weights_that_predict_nothing(tmp_path):
    file, broken = tmp_path / "model.safetensors", network()
    with torch.no_grad():
        for value in broken.parameters():
            value.fill_(1e30)
    write_checkpoint(file, broken, about())
    with pytest.raises(ParameterError, match="not finite"):
        forward_model(file)


def test_nan_reaches_no_file(tmp_path):
    broken = network()
    broken.outputs.mean[0] = torch.nan
    with pytest.raises(ValueError, match=r"outputs\.mean is not finite"):
        write_checkpoint(tmp_path / "model.safetensors", broken, about())
    with pytest.raises(ValueError):
        write_checkpoint(tmp_path / "model.safetensors", network(), {"mae_bar": float("nan")})
    assert not list(tmp_path.iterdir())


GROUPS = {
    "resnet": {"name": "resnet", "width": 8, "blocks": 1},
    "ensemble": {"name": "ensemble", "members": 3, "width": 8, "blocks": 1},
}


def model_of(name: str, seed: int = 0) -> ForwardModel:
    return ForwardModel(network(GROUPS[name], seed), about(GROUPS[name]))


@pytest.mark.parametrize("name", GROUPS)
def test_onnx_says_what_torch_says(tmp_path, name):
    model, file = model_of(name), tmp_path / "model.onnx"
    told = export(model, file)
    assert told.max_difference < 1e-5 and told.onnx_us > 0.0 and told.torch_us > 0.0
    session = one_core(file.read_bytes())
    for count in (1, 2, 500):
        designs = jumps(count, 7).designs.numpy()
        (apexes,) = session.run(None, {"designs": designs})
        expected = model.predict(designs)
        assert apexes.shape == (count, 2)
        assert np.allclose(apexes, expected, rtol=1e-4, atol=1e-4 * np.abs(expected).max())


def test_a_difference_is_told_and_no_file_left(tmp_path, monkeypatch):
    exported = module._onnx(model_of("resnet"))
    monkeypatch.setattr(module, "_onnx", lambda model: exported)
    with pytest.raises(ArithmeticError, match="differs from torch"):
        export(model_of("resnet", seed=1), tmp_path / "model.onnx")
    assert not list(tmp_path.iterdir())


def test_what_is_no_network_is_refused():
    with pytest.raises(ParameterError, match=r"checkpoint = 'a path'.*rbf"):
        check_exportable(ForwardModel(network(RBF), about(RBF)), "a path")
