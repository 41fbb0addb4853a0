"""``task=export``: the file it leaves, and checkpoints that are refused."""

from pathlib import Path

import pytest
from command_line import result_in
from forward_models import about, network
from refusals import refused

from snapjump.checks import ParameterError
from snapjump.learning.checkpoint import write_checkpoint
from snapjump.run.tasks.export import Export

RBF = {"name": "rbf", "neighbours": 20, "kernel": "cubic", "smoothing": 0.0}


def test_a_forward_model_becomes_onnx(command, tmp_path):
    write_checkpoint(tmp_path / "model.safetensors", network(), about())
    done = command("task=export", "checkpoint=model.safetensors", "tracking=off")
    assert done.stderr == "" or "Warning" not in done.stderr
    folder, result = result_in(tmp_path)
    assert 0.0 <= result["max_difference"] < 1e-5
    assert result["onnx_us"] > 0.0 and result["torch_us"] > 0.0
    assert (folder / "forward_model.onnx").stat().st_size > 1000
    assert "us with onnxruntime" in done.stdout and "forward_model.onnx" in done.stdout


@pytest.mark.parametrize("value", ["", 3, "none.safetensors", "text.safetensors"])
def test_checkpoints_that_are_none(value, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "text.safetensors").write_text("a text")
    with refused("checkpoint") as caught:
        Export().prepare({"checkpoint": value, "seed": 0})
    assert caught.value.value == value


def test_what_is_no_network(tmp_path):
    path = str(tmp_path / "model.safetensors")
    write_checkpoint(Path(path), network(RBF), about(RBF))
    with pytest.raises(ParameterError, match="rbf"):
        Export().prepare({"checkpoint": path, "seed": 0})
