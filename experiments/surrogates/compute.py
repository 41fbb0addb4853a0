"""One cell: a surrogate trained on so many jumps and judged, or the floor of a tier."""

from collections.abc import Mapping
from functools import cache
from typing import Any

from experiments.compositions import composed
from experiments.surrogates.floor import floor_rows
from experiments.surrogates.places import by_input, concentration
from snapjump.dataset.read import Dataset, open_dataset
from snapjump.declare.members import make_member
from snapjump.learning.data import JumpData
from snapjump.learning.forward_model import ForwardModel
from snapjump.learning.learn import learn
from snapjump.learning.measures import errors, measures
from snapjump.learning.timing import microseconds
from snapjump.learning.training import Training
from snapjump.studies.base import Row

TRAINED, PLACE, FLOOR = "trained", "place", "floor"

opened = cache(open_dataset)


def trained_rows(inputs: Mapping[str, Any]) -> list[Row]:
    """What a surrogate's error is on its own test set and on the judge's, and where it sits."""
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
