"""The jumps of a dataset in memory: split by a seed, and handed out in batches that grow."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
import torch
from numpy.typing import NDArray
from pytorch_lightning import LightningDataModule

from snapjump.checks import ParameterError
from snapjump.dataset.columns import APEX, slope_columns
from snapjump.dataset.read import Dataset
from snapjump.learning.training import Training
from snapjump.surrogate.base import Rows

SMALLEST_PART = 10  # jumps; fewer say nothing of the rest
WHOLE = 4096  # jumps of a batch that nothing is learned from

RULE = (
    "numpy.random.default_rng(seed).permutation of the rows with status ok, in the dataset's order:"
    " the first test_share of them are the test set; of the others, or of the first training.rows "
    "of them, the first validation_share are the validation set and the rest the training set"
)


class Split(NamedTuple):
    """Numbers of jumps, in the order of those that are ok."""

    train: NDArray[np.int64]
    validation: NDArray[np.int64]
    test: NDArray[np.int64]


def split(count: int, training: Training, seed: int) -> Split:
    """A split by :data:`RULE`. The test set depends on seed, count and test_share alone."""
    order = np.random.default_rng(seed).permutation(count)
    tested = round(training.test_share * count)
    rest = order[tested:]
    if training.rows is not None:
        if training.rows > len(rest):
            allowed = f"null, or at most the {len(rest)} jumps that are not for testing"
            raise ParameterError("training.rows", training.rows, allowed)
        rest = rest[: training.rows]
    validated = round(training.validation_share * len(rest))
    found = Split(rest[validated:], rest[:validated], order[:tested])
    for name, part in found._asdict().items():
        if len(part) < SMALLEST_PART:
            need = f"training, validation and test set need {SMALLEST_PART} each"
            allowed = f"more jumps: {need}, and the {name} set of these has {len(part)}"
            if training.rows is None:
                raise ParameterError("dataset.path", count, allowed)
            raise ParameterError("training.rows", training.rows, allowed)
    return found


class Batches:
    """Batches of all rows, in a random order that a seed determines, or as they are without one."""

    def __init__(self, rows: Rows, size: int, seed: tuple[int, int] | None = None):
        self.rows, self.size, self.seed = rows, size, seed

    def __len__(self) -> int:
        return -(-len(self.rows.designs) // self.size)

    def __iter__(self) -> Iterator[Rows]:
        count = len(self.rows.designs)
        numbers = np.arange(count)
        if self.seed is not None:
            np.random.default_rng(self.seed).shuffle(numbers)
        for chosen in torch.from_numpy(numbers).split(self.size):
            yield Rows(*(part[chosen] for part in self.rows))


class JumpData(LightningDataModule):
    """``train``, ``validation`` and ``test`` rows of a dataset, by a seed.
    Raises ParameterError for a dataset that has too few jumps that are ok."""

    def __init__(self, dataset: Dataset, training: Training, seed: int):
        super().__init__()
        self.dataset, self.training, self.seed = dataset, training, seed
        rows = read_rows(dataset)
        if not len(rows.designs):
            path = str(dataset.folder.path)
            raise ParameterError("dataset.path", path, "a dataset with jumps whose status is ok")
        parts = [torch.from_numpy(part) for part in split(len(rows.designs), training, seed)]
        self.train, self.validation, self.test = (
            Rows(*(values[part] for values in rows)) for part in parts
        )

    def train_dataloader(self) -> Batches:
        """The batches of the trainer's epoch: another order, and perhaps size, in each."""
        epoch = 0 if self.trainer is None else self.trainer.current_epoch
        return Batches(self.train, self.training.batch_size(epoch), (self.seed, epoch))

    def val_dataloader(self) -> Batches:
        """The validation set."""
        return Batches(self.validation, WHOLE)

    def transfer_batch_to_device(self, batch: Rows, device: Any, dataloader_idx: int) -> Rows:
        """It is where it belongs."""
        return batch


def read_rows(dataset: Dataset) -> Rows:
    """All jumps that are ok, as float32; slopes are NaN where the dataset has none, or where a
    grazed contact makes them those of one side only."""
    inputs, slopes = [axis.column for axis in dataset.axes], []
    if dataset.specification["sensitivities"]:
        slopes = [name for apex in APEX for name in slope_columns(apex, dataset.axes)]
    frame = dataset.frame([*inputs, *APEX, *slopes, "differentiable", "status"])
    frame = frame[frame["status"] == "ok"]

    def tensor(columns: list[str]) -> torch.Tensor:
        return torch.tensor(frame[columns].to_numpy(dtype=np.float32))

    designs, apexes = tensor(inputs), tensor(list(APEX))
    shape = (len(frame), len(APEX), len(inputs))
    if slopes:
        frame.loc[frame["differentiable"] != True, slopes] = np.nan  # noqa: E712  # null is none
        return Rows(designs, apexes, tensor(slopes).reshape(shape))
    return Rows(designs, apexes, torch.full((1, 1, 1), torch.nan).expand(shape))
