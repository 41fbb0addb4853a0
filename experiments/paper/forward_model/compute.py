"""Cells: the dataset, the paper's network trained on it, and inverse design of random targets."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from experiments.compositions import changed
from snapjump.dataset.read import Dataset, open_dataset
from snapjump.run.studies.base import Row

# The paper: 3 x 372 neurons with ReLU.
NETWORK = "mlp"
# Paper, its dataset and its forward model.
PAPER_JUMPS, PAPER_HOURS, PAPER_THREADS = 50_625, 4.0, 20
PAPER_MAE_BAR = 0.07
# Paper, its table of methods: mean miss and its standard deviation (mm), seconds a target.
PAPER_MEAN_MM, PAPER_STD_MM = 2.9, 2.5
PAPER_SECONDS = {"data-driven": 0.33, "bayesian": 513.0, "finite_difference": 1129.0}


class Method(NamedTuple):
    """``inverse``: its group; ``network``: the forward model it asks, None for the one that comes
    with the library; ``problems``: how many random targets it is given (the first of them)."""

    inverse: dict[str, Any]
    network: str | None
    problems: int


DATA_DRIVEN = "adam, the paper's network"
METHODS = {
    DATA_DRIVEN: Method({"name": "adam"}, NETWORK, 100),
    "gauss_newton": Method({"name": "gauss_newton"}, None, 100),
    "physics": Method({"name": "physics"}, None, 100),
    "bayesian": Method({"name": "bayesian"}, None, 6),
    "finite_difference": Method({"name": "finite_difference"}, None, 6),
}


PLAN = {"name": "grid"}  # with its defaults the paper's: 15 values of each of the four inputs
SHARD_SIZE = 4096
EVERY = 5  # which of the test set's jumps are drawn


def generated(inputs: Mapping[str, Any]) -> tuple[Dataset, Any]:
    """The dataset, made or found where ``task=dataset`` keeps it, and how its making went."""
    from snapjump.dataset.folder import DatasetFolder, default_path
    from snapjump.dataset.generate import generate
    from snapjump.dataset.specification import specify
    from snapjump.executor.local import LocalExecutor

    groups = changed(inputs["groups"], {"backend": {"name": "lanes"}})
    specification = specify({**groups, "plan": inputs["plan"]}, inputs["shard_size"])
    folder = DatasetFolder(default_path(specification))
    folder.check(specification)
    locks = folder.claim(1, 1)
    try:
        went = generate(folder, specification, LocalExecutor(), groups["backend"], _silent)
    finally:
        for lock in locks:
            lock.release()
    return open_dataset(folder.path), went


def dataset_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """One row: jumps and what they cost; times by the clock are null if all was there before."""
    dataset, went = generated(inputs)
    kernel = dataset.table(["kernel_seconds"]).column("kernel_seconds").to_numpy()
    whole = went.made == dataset.rows
    return [
        {
            "jumps": dataset.rows,
            "ok": dataset.statuses.get("ok", 0),
            "kernel_core_seconds": float(kernel.sum()),
            "wall_seconds": went.seconds if whole else None,
            "cores": went.cores if whole else None,
            "dataset_sha256": dataset.sha256,
        }
    ]


def trained(inputs: Mapping[str, Any]) -> tuple[Any, Any]:
    """The network of the paper's size, trained or found, and the data it was trained on."""
    from snapjump.declare.members import make_member
    from snapjump.learning.data import JumpData
    from snapjump.learning.learn import learn
    from snapjump.learning.training import Training

    dataset, _ = generated(inputs)
    data = JumpData(dataset, Training(**inputs["training"]), inputs["seed"])
    return learn(data, make_member("surrogate", inputs["surrogate"]), _silent), data


def forward_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row of measures, then a row for some of the test set's jumps with what is predicted."""
    from snapjump.learning.forward_model import ForwardModel
    from snapjump.learning.timing import microseconds

    learned, data = trained(inputs)
    about, model = learned.about, ForwardModel(learned.network, learned.about)
    # In single precision the ends of a range lie a rounding outside of it.
    designs = np.clip(data.test.designs[::EVERY].double().numpy(), *np.array(model.ranges).T)
    apexes = data.test.apexes[::EVERY].double().numpy()
    measured: Row = {
        "kind": "measures",
        **about["measures"],
        "train_seconds": about["train_seconds"],
        "parameters": about["parameters"],
        "rows_train": about["rows_train"],
        "rows_test": about["rows_test"],
        "inference_us": microseconds(lambda: model.predict(designs[:1])),
    }
    return [measured] + [
        {
            "kind": "prediction",
            "x_bar": float(simulated[0]),
            "y_bar": float(simulated[1]),
            "predicted_x_bar": float(told[0]),
            "predicted_y_bar": float(told[1]),
        }
        for simulated, told in zip(apexes, model.predict(designs), strict=True)
    ]


def inverse_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row for each target (:func:`experiments.inverse_benchmark.compute.solve_block`), by the
    forward model that comes with the library or by the one trained here."""
    from experiments.inverse_benchmark.compute import solve_block

    if inputs["surrogate"] is None:
        from snapjump.targets.request import checkpoint_path

        file = checkpoint_path(None)
    else:
        file = Path(trained(inputs)[0].file)
    return solve_block({**inputs, "checkpoint": str(file)})


def _silent(share: float, text: str) -> None:
    """Progress of a cell is that of the study."""
