"""From a dataset to a forward model: trained once, continued where it stopped, then found again.

outputs/training/<surrogate>-<hash>/last.ckpt                  what a training goes on from
outputs/training/<surrogate>-<hash>/curves.json                and, once it has ended,
outputs/training/<surrogate>-<hash>/forward_model.safetensors  what has come of it
"""

import time
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any, NamedTuple

import torch

from snapjump.checks import ParameterError
from snapjump.declare.members import member_group
from snapjump.declare.scenes import Progress
from snapjump.files.lock import FileLock
from snapjump.files.provenance import origin
from snapjump.files.sealed import read_sealed, sha256_of, write_sealed
from snapjump.files.sources import combined_hash, package_files, plugin_files
from snapjump.learning.checkpoint import (
    Checkpoint,
    learned_inputs,
    read_checkpoint,
    write_checkpoint,
)
from snapjump.learning.data import RULE, JumpData
from snapjump.learning.fit import STATE, Fitted, descend, untold
from snapjump.learning.keeper import Step
from snapjump.learning.measures import measures
from snapjump.learning.threads import torch_threads
from snapjump.surrogate.base import Surrogate, SurrogateOptions

DEFAULT = Path("outputs/training")
DIGITS = 16
FORWARD_MODEL, CURVES = "forward_model.safetensors", "curves.json"
# The modules that determine the weights, beside that of the surrogate and the dataset.
DETERMINES = (
    *("learning/data.py", "learning/fit.py", "learning/keeper.py"),
    *("learning/lightning_module.py", "learning/training.py"),
    *("surrogate/base.py", "surrogate/parts/layers.py"),
)
PARTS = ("train", "validation", "test")  # of the jumps


class Learned(NamedTuple):
    """``file``: the checkpoint; ``curves``: a row an epoch, none for what has no epochs;
    ``kept``: whether it had been trained before."""

    file: Path
    network: Surrogate
    about: dict[str, Any]
    curves: list[dict[str, float]]
    kept: bool


def check_slopes(options: SurrogateOptions, data: JumpData) -> None:
    """Raise ParameterError for a surrogate that needs slopes and a dataset that has none, or none
    that are known to be the map's."""
    if options.network().needs_slopes and bool(data.train.slopes.isnan().all()):
        name = member_group(options)["name"]
        allowed = (
            f"a dataset with differentiable jumps with surrogate={name} "
            "(dataset.sensitivities=true friction.velocity_threshold_m_s=0.01 when it is made)"
        )
        raise ParameterError("dataset.path", str(data.dataset.folder.path), allowed)


def learn(
    data: JumpData,
    options: SurrogateOptions,
    progress: Progress,
    configuration: Mapping[str, Any] | None = None,
    place: Path = DEFAULT,
    step: Step = untold,
) -> Learned:
    """Train a surrogate, or go on, or find what has been trained.

    ``configuration``: the resolved one of the run, for the checkpoint. Raises FloatingPointError
    if the training diverges. ``step`` is told a row of the curves an epoch.
    """
    check_slopes(options, data)
    group = member_group(options)
    determined = {
        "surrogate": group,
        "training": asdict(data.training),
        "dataset_sha256": data.dataset.sha256,
        "seed": data.seed,
    }
    names = (*DETERMINES, f"surrogate/{group['name']}.py")
    files = (*package_files(), *plugin_files())
    sources = combined_hash(source for source in files if source.name in names)
    digest = sha256_of({**determined, "sources": sources})[:DIGITS]
    folder = place / f"{group['name']}-{digest}"
    folder.mkdir(parents=True, exist_ok=True)
    lock = FileLock(folder / ".lock")
    if not lock.acquire(wait=False):
        progress(0.0, "waiting for another process that trains the same")
        lock.acquire()
    try:
        found = _finished(folder)
        if found is not None:
            return found
        with torch_threads(data.training.threads):
            network, fitted = _fitted(data, options, folder, progress, step)
            about = {**_about(data, network, fitted), **determined}
        about |= {"origin": origin(), "configuration": dict(configuration or {})}
        write_sealed(folder / CURVES, {"curves": fitted.curves})
        write_checkpoint(folder / FORWARD_MODEL, network, about)
        (folder / STATE).unlink(missing_ok=True)
        return Learned(folder / FORWARD_MODEL, network, about, fitted.curves, kept=False)
    finally:
        lock.release()


def _fitted(
    data: JumpData, options: SurrogateOptions, folder: Path, progress: Progress, step: Step
) -> tuple[Surrogate, Fitted]:
    """The network with all that it learns."""
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(data.seed)
        network: Surrogate = options.network(learned_inputs(data.dataset.axes))
    started = time.perf_counter()
    network.fit(data.train)
    fitted = Fitted([], time.perf_counter() - started)
    if network.by_descent:
        fitted = descend(network, data, folder, progress, step)
    network.requires_grad_(False).eval()
    network.calibrate(data.validation)
    return network, fitted


def _about(data: JumpData, network: Surrogate, fitted: Fitted) -> dict[str, Any]:
    """The metadata of a checkpoint."""
    dataset = data.dataset
    return {
        "dataset": {
            "sha256": dataset.sha256,
            "rows": dataset.rows,
            "specification": dataset.specification,
        },
        "inputs": [asdict(axis) for axis in dataset.axes],
        "split": RULE,
        **{f"rows_{name}": len(getattr(data, name).designs) for name in PARTS},
        "parameters": sum(values.numel() for values in network.parameters()),
        "epochs": len(fitted.curves),
        "train_seconds": fitted.seconds,
        "measures": measures(network, data.test),
    }


def _finished(folder: Path) -> Learned | None:
    """The forward model that an earlier run has finished, if it is whole."""
    kept = read_sealed(folder / CURVES)
    try:
        found: Checkpoint = read_checkpoint(folder / FORWARD_MODEL)
    except ParameterError:
        return None
    if kept is None:
        return None
    return Learned(folder / FORWARD_MODEL, *found, kept["curves"], kept=True)
