"""A forward model as ONNX: designs in, apexes in L out, any number at a time."""

import contextlib
import io
import json
import logging
import warnings
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import torch

from snapjump.checks import ParameterError
from snapjump.files.atomic import write_bytes
from snapjump.learning.forward_model import ForwardModel
from snapjump.learning.threads import torch_threads
from snapjump.learning.timing import microseconds

INPUT, OUTPUT = "designs", "apexes"
TOLERANCE = 1e-5  # of the difference to torch, relative to the standard deviation of the apexes
EXAMPLES = 1000
ROUNDING = 1e-6  # of a range: float32 cannot hold its ends exactly


class Exported(NamedTuple):
    """``max_difference``: between onnxruntime and torch, in standard deviations of the apexes;
    times of one design on one core, in us."""

    max_difference: float
    onnx_us: float
    torch_us: float


def check_exportable(model: ForwardModel, path: str) -> None:
    """Raise ParameterError for a surrogate that is no network."""
    if not model.network.differentiable:
        name = model.about["surrogate"]["name"]
        raise ParameterError(
            "checkpoint", path, f"a network, and {name} has no operations that ONNX knows"
        )


def export(model: ForwardModel, path: Path, seed: int = 0) -> Exported:
    """Write it, standardisation included, and compare it with torch on random designs.
    Raises ArithmeticError if they differ by more than :data:`TOLERANCE`."""
    content = _onnx(model)
    session = one_core(content)
    low, high = np.array(model.ranges).T
    random = np.random.default_rng(seed)
    designs = (low + (high - low) * random.random((EXAMPLES, len(low)))).astype(np.float32)
    given = {INPUT: designs}
    torched = torch.from_numpy(designs)
    with torch.inference_mode(), torch_threads():
        expected = model.network(torched).numpy()
        found = session.run([OUTPUT], given)[0]
        difference = float((np.abs(found - expected) / expected.std(axis=0)).max())
        if not difference <= TOLERANCE:
            raise ArithmeticError(f"ONNX differs from torch by {difference:.2g}")
        one, one_torched = {INPUT: designs[:1]}, torched[:1]
        onnx_us = microseconds(lambda: session.run([OUTPUT], one))
        torch_us = microseconds(lambda: model.network(one_torched))
    write_bytes(path, content)
    return Exported(difference, onnx_us, torch_us)


def one_core(content: bytes) -> Any:
    """An onnxruntime session that uses one thread."""
    import onnxruntime

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    return onnxruntime.InferenceSession(content, options, providers=["CPUExecutionProvider"])


class Guarded(torch.nn.Module):
    """A network that answers NaN outside of the box (I, 2) it was trained in."""

    low: torch.Tensor
    high: torch.Tensor

    def __init__(self, network: torch.nn.Module, ranges: Any):
        super().__init__()
        self.network = network
        low, high = torch.tensor(ranges, dtype=torch.float64).T
        slack = ROUNDING * (high - low)
        self.register_buffer("low", (low - slack).float())
        self.register_buffer("high", (high + slack).float())

    def forward(self, designs: torch.Tensor) -> torch.Tensor:
        """Apexes (N, 2) of designs (N, I)."""
        inside = ((designs >= self.low) & (designs <= self.high)).all(dim=1, keepdim=True)
        return torch.where(inside, self.network(designs), torch.nan)


def _onnx(model: ForwardModel) -> bytes:
    # Of two designs: torch takes an axis of length one for a constant.
    example = torch.tensor(model.ranges).T.contiguous()
    logger = logging.getLogger("torch.onnx")
    before, logger.level = logger.level, logging.ERROR
    try:
        with contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of torch about torch
            program = torch.onnx.export(
                Guarded(model.network, model.ranges),
                (example,),
                input_names=[INPUT],
                output_names=[OUTPUT],
                dynamic_shapes=({0: torch.export.Dim("designs")},),
                dynamo=True,
                verbose=False,
            )
    finally:
        logger.level = before
    assert program is not None
    proto = program.model_proto
    told = {
        "inputs": ", ".join(axis.column for axis in model.axes),
        "outputs": "x_bar, y_bar (L); NaN outside of the ranges",
        "ranges": json.dumps(model.ranges),
        "dataset_sha256": model.about["dataset"]["sha256"],
    }
    for key, value in told.items():
        proto.metadata_props.add(key=key, value=value)
    content: bytes = proto.SerializeToString()
    return content
