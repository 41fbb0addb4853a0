"""Any surrogate under gradient descent: its loss, Adam, and the error on the validation set."""

import torch
from pytorch_lightning import LightningModule
from torch import Tensor

from snapjump.learning.training import Training
from snapjump.surrogate.base import Rows, Surrogate

VALIDATION = "validation_mae_bar"


class Descent(LightningModule):
    """What Lightning trains."""

    def __init__(self, network: Surrogate, training: Training):
        super().__init__()
        self.network, self.training_options = network, training
        self._losses: list[Tensor] = []
        self._errors: list[Tensor] = []

    def configure_optimizers(self) -> torch.optim.Optimizer:
        """Adam, as in the paper; the rate is set epoch by epoch."""
        rate = self.training_options.learning_rate
        return torch.optim.Adam(self.network.parameters(), lr=rate, fused=True)

    def on_train_epoch_start(self) -> None:
        # Of the epoch's number alone, so that there is no state that a resumed run could lose.
        rate = self.training_options.rate(self.current_epoch)
        for group in self.trainer.optimizers[0].param_groups:
            group["lr"] = rate

    def training_step(self, rows: Rows, batch_idx: int) -> Tensor:
        loss = self.network.loss(rows)
        self._losses.append(loss.detach())
        return loss

    def take_train_loss(self) -> float:
        """Mean over the batches since it was last taken."""
        loss = float(torch.stack(self._losses).mean())
        self._losses.clear()
        return loss

    def validation_step(self, rows: Rows, batch_idx: int) -> None:
        self._errors.append((self.network(rows.designs) - rows.apexes).abs())

    def on_validation_epoch_end(self) -> None:
        self.log(VALIDATION, torch.cat(self._errors).mean())
        self._errors.clear()
