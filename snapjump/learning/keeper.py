"""What a training keeps as it goes: curves, the best weights, and all that it needs to go on."""

import hashlib
import io
import math
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import torch
from pytorch_lightning import Callback, LightningModule, Trainer
from pytorch_lightning.plugins.io import CheckpointIO

from snapjump.batch.progress import Progress
from snapjump.files.atomic import write_bytes
from snapjump.learning.lightning_module import VALIDATION, Descent

SAVE_EVERY_S = 5.0
Step = Callable[[Mapping[str, float]], None]
DIGEST = hashlib.sha256().digest_size


class AtomicFiles(CheckpointIO):
    """Lightning's checkpoints, whole or not at all, behind their hash, and without code inside."""

    def save_checkpoint(
        self, checkpoint: dict[str, Any], path: Any, storage_options: Any = None
    ) -> None:
        stream = io.BytesIO()
        torch.save(checkpoint, stream)
        content = stream.getvalue()
        write_bytes(Path(path), hashlib.sha256(content).digest() + content)

    def load_checkpoint(
        self, path: Any, map_location: Any = None, weights_only: bool | None = None
    ) -> dict[str, Any]:
        """Raises ValueError for a file that is not as it was written."""
        whole = Path(path).read_bytes()
        content = whole[DIGEST:]
        if hashlib.sha256(content).digest() != whole[:DIGEST]:
            raise ValueError("its checksum is another")
        found: dict[str, Any] = torch.load(io.BytesIO(content), map_location, weights_only=True)
        return found

    def remove_checkpoint(self, path: Any) -> None:
        Path(path).unlink(missing_ok=True)


class Keeper(Callback):
    """``curves``: a row an epoch; ``best``: the weights of the smallest validation error;
    ``seconds``: of all runs that this training took; ``stopped``: whether it is at its end."""

    def __init__(self, file: Path, progress: Progress, step: Step):
        """``step`` is told every row of the curves."""
        self.file, self.progress, self.step = file, progress, step
        self.curves: list[dict[str, float]] = []
        self.best: dict[str, torch.Tensor] = {}
        self.seconds = 0.0
        self.stopped = False
        self._clock, self._saved = time.perf_counter(), -math.inf

    def state_dict(self) -> dict[str, Any]:
        """All of it, in a checkpoint."""
        return {name: getattr(self, name) for name in ("curves", "best", "seconds", "stopped")}

    def load_state_dict(self, state: dict[str, Any]) -> None:
        """What an earlier run kept."""
        vars(self).update(state)

    def on_train_start(self, trainer: Trainer, pl_module: LightningModule) -> None:
        """A training that had already stopped does not go on."""
        trainer.should_stop = self.stopped
        self._clock = time.perf_counter()
        for row in self.curves:  # of an earlier run
            self.step(row)

    def on_train_epoch_end(self, trainer: Trainer, pl_module: LightningModule) -> None:
        """Add to the curves; keep what is better; save now and then, and at the end."""
        assert isinstance(pl_module, Descent)
        epoch, error = trainer.current_epoch, float(trainer.callback_metrics[VALIDATION])
        training = pl_module.training_options
        if error <= min((row[VALIDATION] for row in self.curves), default=error):
            weights = pl_module.network.state_dict()
            self.best = {name: value.clone() for name, value in weights.items()}
        self.curves.append(
            {
                "epoch": epoch + 1,
                "train_loss": pl_module.take_train_loss(),
                VALIDATION: error,
                "learning_rate": training.rate(epoch),
                "batch_size": training.batch_size(epoch),
            }
        )
        self.step(self.curves[-1])
        now = time.perf_counter()
        self.seconds, self._clock = self.seconds + now - self._clock, now
        self.stopped = trainer.should_stop
        if self.stopped or epoch + 1 == training.epochs or now - self._saved >= SAVE_EVERY_S:
            trainer.save_checkpoint(self.file)
            self._saved = now
        text = f"epoch {epoch + 1}, validation MAE {error:.4f} L"
        self.progress((epoch + 1) / training.epochs, text)
