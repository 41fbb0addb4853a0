"""Cells from nothing: a dataset, and a network that is trained on it."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from snapjump.dataset.specification import specify
from snapjump.dataset.whole import whole_dataset
from snapjump.declare.members import make_member
from snapjump.learning.training import Training
from snapjump.run.studies.base import Row

from ..compositions import changed

EVERY = 5  # which of the test set's jumps are told


def generated(inputs: Mapping[str, Any]) -> tuple[Any, Any]:
    """The dataset, and how its making went."""
    groups = changed(inputs["groups"], {"backend": {"name": "lanes"}})
    specification = specify({**groups, "plan": inputs["plan"]}, inputs["shard_size"])
    return whole_dataset(specification, groups["backend"])


def trained(inputs: Mapping[str, Any]) -> tuple[Any, Any]:
    """The network of the paper's size, trained or found, and the data it was trained on."""
    from snapjump.learning.data import JumpData
    from snapjump.learning.learn import learn

    data = JumpData(generated(inputs)[0], Training(**inputs["training"]), inputs["seed"])
    surrogate = make_member("surrogate", inputs["surrogate"])
    return learn(data, surrogate, lambda share, text: None), data


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


def forward_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """A row of measures, then a row for some of the test set's jumps with what is predicted."""
    from snapjump.learning.forward_model import ForwardModel
    from snapjump.learning.timing import microseconds

    learned, data = trained(inputs)
    about, model = learned.about, ForwardModel(learned.network, learned.about)
    # In single precision the ends of a range lie a rounding outside of it.
    designs = np.clip(data.test.designs[::EVERY].double().numpy(), *np.array(model.ranges).T)
    apexes = data.test.apexes[::EVERY].double().numpy()
    told = ("train_seconds", "parameters", "rows_train", "rows_test")
    measured: Row = {
        "kind": "measures",
        **about["measures"],
        **{key: about[key] for key in told},
        "inference_us": microseconds(lambda: model.predict(designs[:1])),
    }
    keys = ("x_bar", "y_bar", "predicted_x_bar", "predicted_y_bar")
    places = np.hstack([apexes, model.predict(designs)]).tolist()
    return [measured] + [
        {"kind": "prediction", **dict(zip(keys, row, strict=True))} for row in places
    ]
