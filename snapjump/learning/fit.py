"""Gradient descent by Adam on the jumps of a dataset; one that was interrupted goes on."""

import math
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import torch

from snapjump.declare.scenes import Progress
from snapjump.files.atomic import atomic_file
from snapjump.learning.data import WHOLE, Batches, JumpData
from snapjump.learning.training import Training
from snapjump.surrogate.base import Surrogate

STATE = "last.ckpt"
SAVE_EVERY_S = 5.0
VALIDATION = "validation_mae_bar"


class Fitted(NamedTuple):
    """``curves``: a row an epoch, none for what is not trained by descent; ``seconds``: of all runs
    that the training took."""

    curves: list[dict[str, float]]
    seconds: float


def descend(network: Surrogate, data: JumpData, folder: Path, progress: Progress) -> Fitted:
    """Train a network that has its standardisation, and leave it with its best weights.

    ``folder`` holds the state from which the same call goes on. Raises FloatingPointError if the
    validation error is no number any more.
    """
    training, file = data.training, folder / STATE
    optimizer = torch.optim.Adam(network.parameters(), lr=training.learning_rate, fused=True)
    state = kept_state(file)
    if state:
        network.load_state_dict(state["network"])
        optimizer.load_state_dict(state["optimizer"])
    curves, best = state.get("curves", []), state.get("best", {})
    begun = time.perf_counter() - state.get("seconds", 0.0)
    saved = -math.inf
    with torch_threads(training.threads):
        while not has_ended(curves, training):
            row = one_epoch(network, optimizer, data, len(curves))
            if row[VALIDATION] <= min([row[VALIDATION], *(r[VALIDATION] for r in curves)]):
                best = {name: value.clone() for name, value in network.state_dict().items()}
            curves.append(row)
            now = time.perf_counter()
            if has_ended(curves, training) or now - saved >= SAVE_EVERY_S:
                state = {"curves": curves, "best": best, "seconds": now - begun}
                state |= {"network": network.state_dict(), "optimizer": optimizer.state_dict()}
                with atomic_file(file, "wb") as opened:
                    torch.save(state, opened)
                saved = now
            text = f"epoch {row['epoch']}, validation MAE {row[VALIDATION]:.4f} L"
            progress(row["epoch"] / training.epochs, text)
    last = curves[-1]
    if not math.isfinite(last[VALIDATION]):
        raise FloatingPointError(
            f"the validation error is {last[VALIDATION]} after epoch {last['epoch']}: "
            "a lower training.learning_rate may help"
        )
    network.load_state_dict(best)
    return Fitted(curves, state["seconds"])


def one_epoch(
    network: Surrogate, optimizer: torch.optim.Optimizer, data: JumpData, epoch: int
) -> dict[str, float]:
    """Learn from every jump of the training set once; the row of the curves."""
    training = data.training
    # Of the epoch's number alone, so that there is no state that a resumed run could lose.
    rate, losses = training.rate(epoch), []
    for group in optimizer.param_groups:
        group["lr"] = rate
    for rows in data.batches(epoch):
        optimizer.zero_grad()
        loss = network.loss(rows)
        loss.backward()
        optimizer.step()
        losses.append(loss.detach())
    with torch.inference_mode():
        off = [network(r.designs) - r.apexes for r in Batches(data.validation, WHOLE)]
    return {
        "epoch": epoch + 1,
        "train_loss": float(torch.stack(losses).mean()),
        VALIDATION: float(torch.cat(off).abs().mean()),
        "learning_rate": rate,
        "batch_size": training.batch_size(epoch),
    }


def has_ended(curves: list[dict[str, float]], training: Training) -> bool:
    """Whether the last epoch is done, nothing has become better for long, or all is lost."""
    errors = [row[VALIDATION] for row in curves]
    if not errors or not math.isfinite(errors[-1]):
        return bool(errors)
    waited = len(errors) - 1 - int(np.argmin(errors))
    return len(errors) >= training.epochs or waited >= training.patience


def kept_state(file: Path) -> dict[str, Any]:
    """The state that an earlier run left, if it can be read."""
    try:
        state: dict[str, Any] = torch.load(file, weights_only=True)
    except Exception:  # whatever is wrong with it, training anew makes it good
        return {}
    return state


@contextmanager
def torch_threads(count: int = 1) -> Iterator[None]:
    """Let torch use so many threads in the block: small networks are slower on two than on one."""
    before = torch.get_num_threads()
    torch.set_num_threads(count)
    try:
        yield
    finally:
        torch.set_num_threads(before)
