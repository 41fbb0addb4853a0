"""A trained forward model in one file: its weights as safetensors, and where they come from.

The file's metadata have ``format``, ``about`` (JSON: the surrogate's group, the dataset's hash and
specification, inputs, seed, training, versions, measures) and ``sha256``, of ``about`` and of every
tensor. Nothing in it is executed.
"""

import hashlib
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import torch
from safetensors import SafetensorError, safe_open
from safetensors.torch import save
from torch import Tensor

from snapjump.checks import ParameterError, of_ours
from snapjump.declare.members import check_known, make_member
from snapjump.files.atomic import write_bytes
from snapjump.files.sealed import canonical
from snapjump.plan.parts.axes import Axis, recorded_axes
from snapjump.surrogate.base import Inputs, Surrogate

FORMAT = "snapjump forward model 1"  # another number for other metadata


class Checkpoint(NamedTuple):
    """A network that only predicts, and what is known of it, plain."""

    network: Surrogate
    about: dict[str, Any]


def write_checkpoint(path: Path, network: Surrogate, about: Mapping[str, Any]) -> None:
    """Write it whole. Raises ValueError for weights or numbers that are not finite."""
    tensors = {name: value.detach().contiguous() for name, value in network.state_dict().items()}
    for name, value in tensors.items():
        if not torch.isfinite(value).all():
            raise ValueError(f"{name} is not finite")
    text = canonical(about)
    metadata = {"format": FORMAT, "about": text, "sha256": _sha256(text, tensors)}
    write_bytes(path, save(tensors, metadata))


def read_checkpoint(path: str | Path) -> Checkpoint:
    """Read and check one. Raises ParameterError, which says what is wrong with the file."""
    path = Path(path)
    with of_ours(lambda reason: _refused(path, reason)):
        return _read(path)


def _read(path: Path) -> Checkpoint:
    metadata, tensors = _contents(path)
    form = metadata.get("format")
    if form != FORMAT:
        raise _refused(path, f"its format is {form!r} and not {FORMAT!r}")
    text = metadata.get("about", "")
    if metadata.get("sha256") != _sha256(text, tensors):
        raise _refused(path, "it is damaged: its checksum is another")
    about = json.loads(text)
    try:
        with torch.device("meta"):  # neither time nor memory for weights that are replaced
            network: Surrogate = make_member("surrogate", about["surrogate"]).network(
                learned_inputs(recorded_axes(about))
            )
        network.load_state_dict(tensors, assign=True)
        check_known(about["dataset"]["specification"]["configuration"])
    except ParameterError as error:
        raise _refused(path, f"it has members that are not known here: {error}") from error
    except RuntimeError as error:  # other names or shapes
        reason = " ".join(str(error).split())
        raise _refused(path, f"its weights are of another network: {reason}") from error
    for name, value in tensors.items():
        if not torch.isfinite(value).all():
            raise _refused(path, f"{name} is not finite")
    return Checkpoint(network.requires_grad_(False).eval(), about)


def learned_inputs(axes: Sequence[Axis]) -> Inputs:
    """The inputs of a surrogate for these axes."""
    paths = [axis.path for axis in axes]
    mass = "environment.mass_bar"
    return Inputs(len(paths), paths.index(mass) if mass in paths else None)


def _contents(path: Path) -> tuple[dict[str, str], dict[str, Tensor]]:
    try:
        with safe_open(path, framework="pt") as file:
            # Copies: the file may be replaced later.
            tensors = {name: file.get_tensor(name).clone() for name in file.keys()}
            return file.metadata() or {}, tensors
    except FileNotFoundError:
        missing = not path.exists()  # safetensors says so of what may not be read, too
        raise _refused(path, "there is no such file" if missing else "it cannot be read") from None
    except (OSError, SafetensorError) as error:
        raise _refused(path, f"it cannot be read: {' '.join(str(error).split())}") from error


def _sha256(text: str, tensors: Mapping[str, Tensor]) -> str:
    digest = hashlib.sha256(text.encode())
    for name in sorted(tensors):
        value = tensors[name]
        digest.update(f"\n{name} {value.dtype} {list(value.shape)}\n".encode())
        digest.update(value.contiguous().numpy().tobytes())
    return digest.hexdigest()


def _refused(path: Path, reason: str) -> ParameterError:
    return ParameterError(
        "checkpoint", str(path), f"a forward model that task=train left: {reason}"
    )
