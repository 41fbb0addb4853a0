"""ONNX: the same numbers for any number of designs."""

import numpy as np
import pytest
from forward_models import about, jumps, network

from snapjump.checks import ParameterError
from snapjump.learning import export as module
from snapjump.learning.export import check_exportable, export, one_core
from snapjump.learning.forward_model import ForwardModel

GROUPS = {
    "resnet": {"name": "resnet", "width": 8, "blocks": 1},
    "ensemble": {"name": "ensemble", "members": 3, "width": 8, "blocks": 1},
}


@pytest.fixture(scope="module")
def onnx(tmp_path_factory) -> dict[str, bytes]:
    """Exported files."""
    found = {}
    for name, group in GROUPS.items():
        path = tmp_path_factory.mktemp(name) / "model.onnx"
        told = export(ForwardModel(network(group), about(group)), path)
        assert told.max_difference < 1e-5 and told.onnx_us > 0.0 and told.torch_us > 0.0
        found[name] = path.read_bytes()
    return found


@pytest.mark.parametrize("name", GROUPS)
def test_onnx_says_what_torch_says(onnx, name):
    model = ForwardModel(network(GROUPS[name]), about(GROUPS[name]))
    session = one_core(onnx[name])
    for count in (1, 2, 500):
        designs = jumps(count, 7).designs.numpy()
        (apexes,) = session.run(None, {"designs": designs})
        expected = model.predict(designs)
        assert apexes.shape == (count, 2)
        assert np.allclose(apexes, expected, rtol=1e-4, atol=1e-4 * np.abs(expected).max())


def test_a_difference_is_told_and_no_file_left(onnx, tmp_path, monkeypatch):
    group = GROUPS["resnet"]
    other = ForwardModel(network(group, seed=1), about(group))
    monkeypatch.setattr(module, "_onnx", lambda model: onnx["resnet"])
    with pytest.raises(ArithmeticError, match="differs from torch"):
        export(other, tmp_path / "model.onnx")
    assert not list(tmp_path.iterdir())


def test_what_is_no_network_is_refused():
    group = {"name": "rbf", "neighbours": 20, "kernel": "cubic", "smoothing": 0.0}
    with pytest.raises(ParameterError, match=r"checkpoint = 'a path'.*rbf"):
        check_exportable(ForwardModel(network(group), about(group)), "a path")
