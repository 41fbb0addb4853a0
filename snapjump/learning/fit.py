"""Training a network on the jumps of a dataset; one that was interrupted goes on."""

import logging
import math
import uuid
import warnings
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from pytorch_lightning import Trainer
from pytorch_lightning.callbacks import EarlyStopping

from snapjump.batch.progress import Progress
from snapjump.files.notice import notice
from snapjump.learning.data import JumpData
from snapjump.learning.keeper import AtomicFiles, Keeper, Step
from snapjump.learning.lightning_module import VALIDATION, Descent
from snapjump.learning.threads import torch_threads
from snapjump.surrogate.base import Surrogate

STATE = "last.ckpt"


class Fitted(NamedTuple):
    """``curves``: a row an epoch, none for what is not trained by descent."""

    curves: list[dict[str, float]]
    seconds: float


def untold(row: Mapping[str, float]) -> None:
    """Nobody hears of a step."""


def descend(
    network: Surrogate, data: JumpData, folder: Path, progress: Progress, step: Step = untold
) -> Fitted:
    """Train a network that has its standardisation, and leave it with its best weights.

    ``folder`` holds the state from which the same call goes on. Raises FloatingPointError if the
    validation error is no number any more.
    """
    training = data.training
    keeper = Keeper(folder / STATE, progress, step)
    # At the end of the validation, so that the keeper saves what has come of it.
    early = EarlyStopping(VALIDATION, patience=training.patience, check_on_train_epoch_end=False)
    with quiet(), torch_threads(training.threads):
        trainer = Trainer(
            accelerator="cpu",
            devices=1,
            max_epochs=training.epochs,
            callbacks=[early, keeper],
            plugins=[AtomicFiles()],
            default_root_dir=folder,
            logger=False,
            enable_checkpointing=False,
            enable_progress_bar=False,
            enable_model_summary=False,
            num_sanity_val_steps=0,
            reload_dataloaders_every_n_epochs=1,
        )
        try:
            trainer.fit(
                Descent(network, training), datamodule=data, ckpt_path=resumable(keeper.file)
            )
        except SystemExit:  # Lightning's answer to Ctrl-C
            raise KeyboardInterrupt from None
    last = keeper.curves[-1]
    if not math.isfinite(last[VALIDATION]):
        raise FloatingPointError(
            f"the validation error is {last[VALIDATION]} after epoch {last['epoch']}: "
            "a lower training.learning_rate may help"
        )
    network.load_state_dict(keeper.best)
    return Fitted(keeper.curves, keeper.seconds)


def resumable(file: Path) -> Path | None:
    """The state that an earlier run left. One that is damaged is put aside, and that is told."""
    if not file.exists():
        return None
    try:
        AtomicFiles().load_checkpoint(file)
    except (OSError, ValueError) as error:
        aside = file.with_name(f"{file.name}.damaged-{uuid.uuid4().hex[:8]}")
        file.rename(aside)
        notice(f"training begins anew: {aside} cannot be gone on from ({error})")
        return None
    return file


@contextmanager
def quiet() -> Iterator[None]:
    """Without Lightning's words about the machine and its advice."""
    logger = logging.getLogger("pytorch_lightning")
    before = logger.level
    logger.setLevel(logging.ERROR)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", module="pytorch_lightning")
        try:
            yield
        finally:
            logger.setLevel(before)
