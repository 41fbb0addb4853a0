"""One cell: a surrogate trained on so many jumps and judged, and where it is off; or the floor of a
tier."""

from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.dataset.read import Dataset, load_dataset
from snapjump.declare.members import make_member
from snapjump.learning.data import JumpData
from snapjump.learning.forward_model import ForwardModel
from snapjump.learning.learn import learn
from snapjump.learning.measures import errors, measures
from snapjump.learning.timing import microseconds
from snapjump.learning.training import Training
from snapjump.plan.parts.axes import Axis
from snapjump.run.studies.base import Row

from ..compositions import composed
from .floor import floor_rows

TRAINED, PLACE, FLOOR = "trained", "place", "floor"
BINS = 5
SHARES = (0.5, 0.1, 0.01)

opened = cache(load_dataset)


def trained_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """Errors of a surrogate on its own test set and on the judge's, and by input."""
    own: Dataset = opened(inputs["dataset"])
    training = Training(**inputs["training"])
    options = make_member("surrogate", inputs["surrogate"])
    data = JumpData(own, training, inputs["seed"])
    learned = learn(data, options, lambda share, text: None)
    about = learned.about
    forward = ForwardModel(learned.network, about)
    one = data.test.designs[:1].double().numpy()
    found: Row = {
        "kind": TRAINED,
        "jumps": about["rows_train"] + about["rows_validation"],
        "parameters": about["parameters"],
        "epochs": about["epochs"],
        "train_seconds": about["train_seconds"],
        "inference_us": microseconds(lambda: forward.predict(one)),
        **{f"own_{key}": value for key, value in about["measures"].items()},
    }
    # A dataset of the judge's plan is split alike (the study checks it), one of another plan has no
    # design in common: nothing here was learned from.
    judge = JumpData(opened(inputs["judge"]), Training(), inputs["seed"])
    found |= measures(learned.network, judge.test)
    rows = [found]
    if inputs["places"]:
        designs = judge.test.designs.double().numpy()
        off = errors(learned.network, judge.test)
        found |= concentration(off)
        rows += [{"kind": PLACE, **row} for row in by_input(designs, off, forward.axes)]
    return rows


def floor_of(inputs: Mapping[str, Any]) -> list[Row]:
    """The floor of a tier, a row for each cell of the grid that was looked into."""
    base = composed(inputs["groups"])
    ranges = tuple((low, high) for low, high in inputs["ranges"])
    rows = floor_rows(base, ranges, inputs["cells"], inputs["seed"])
    return [{"kind": FLOOR, **row} for row in rows]


def by_input(designs: Array, errors: Array, axes: Sequence[Axis]) -> list[Row]:
    """Mean absolute errors in fifths of each input's range; designs (N, I), errors (N, 2) in L."""
    rows = []
    for values, axis in zip(designs.T, axes, strict=True):
        edges = np.linspace(axis.low, axis.high, BINS + 1)
        place = np.clip(np.digitize(values, edges) - 1, 0, BINS - 1)
        for k in range(BINS):
            inside = place == k
            if inside.any():
                x, y = np.abs(errors[inside]).mean(axis=0)
                rows.append({
                    "input": axis.column, "from": float(edges[k]), "to": float(edges[k + 1]),
                    "designs": int(inside.sum()), "mae_x_bar": float(x), "mae_y_bar": float(y),
                })  # fmt: skip
    return rows


def concentration(errors: Array) -> dict[str, float]:
    """Shares of all error that the worst half, tenth and hundredth of the designs have."""
    sizes = np.sort(np.abs(errors).mean(axis=1))[::-1]
    sums = sizes.cumsum() / sizes.sum()
    return {
        f"share_of_worst_{100 * share:g}_percent": float(
            sums[max(1, round(share * len(sizes))) - 1]
        )
        for share in SHARES
    }
