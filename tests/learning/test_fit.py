"""Descent: it learns, stops early, goes on after a kill to the same bits, and tells of NaN."""

from pathlib import Path
from typing import Any

import pytest
import torch
from forward_models import RESNET
from small_datasets import silent

from snapjump.declare.members import make_member
from snapjump.learning import keeper
from snapjump.learning.data import JumpData
from snapjump.learning.fit import STATE, Fitted, descend
from snapjump.learning.training import Training
from snapjump.surrogate.base import Surrogate


class Killed(BaseException):
    """What ends a process between two epochs."""


def dies_after(epochs: int, told: list[str], error: type[BaseException] = Killed) -> Any:
    """Progress that ends after so many epochs and notes what it is told."""

    def dies(share: float, text: str) -> None:
        told.append(text)
        if len(told) == epochs:
            raise error

    return dies


@pytest.fixture
def steady(monkeypatch) -> None:
    """A learning rate of silent, by which nothing becomes better."""
    monkeypatch.setattr(Training, "rate", lambda training, epoch: 0.0)


def network(data: JumpData) -> Surrogate:
    torch.manual_seed(0)
    made: Surrogate = make_member("surrogate", RESNET).network()
    made.fit(data.train)
    return made


def fitted(data: JumpData, folder: Path, progress=silent) -> tuple[Surrogate, Fitted]:
    made = network(data)
    folder.mkdir(exist_ok=True)
    return made, descend(made, data, folder, progress)


def equal(one: Surrogate, other: Surrogate) -> bool:
    theirs = other.state_dict()
    return all(torch.equal(values, theirs[name]) for name, values in one.state_dict().items())


@pytest.fixture
def every_epoch(monkeypatch) -> None:
    """States are saved after each epoch."""
    monkeypatch.setattr(keeper, "SAVE_EVERY_S", 0.0)


def test_it_learns_and_says_how_far_it_is(jump_set, tmp_path):
    told: list[tuple[float, str]] = []
    found = jump_set(epochs=20, patience=20, learning_rate=0.01)
    _, fit = fitted(found, tmp_path, lambda share, text: told.append((share, text)))
    errors = [row["validation_mae_bar"] for row in fit.curves]
    losses = [row["train_loss"] for row in fit.curves]
    assert errors[-1] < 0.2 * errors[0] and losses[-1] < 0.2 * losses[0]
    assert [row["epoch"] for row in fit.curves] == list(range(1, 21))
    assert [row["batch_size"] for row in fit.curves] == [16] * 7 + [32] * 7 + [64] * 6
    assert fit.curves[0]["learning_rate"] == found.training.rate(0)
    assert [share for share, _ in told] == [pytest.approx(n / 20) for n in range(1, 21)]
    assert told[0][1].startswith("epoch 1, validation MAE") and fit.seconds > 0.0


def test_what_is_kept_are_the_best_weights(jump_set, tmp_path, monkeypatch):
    found = jump_set(epochs=6)
    monkeypatch.setattr(type(found.training), "rate", lambda training, epoch: 1e-3 * 4.0**epoch)
    made, fit = fitted(found, tmp_path)
    errors = [row["validation_mae_bar"] for row in fit.curves]
    with torch.no_grad():
        error = (made(found.validation.designs) - found.validation.apexes).abs().mean()
    assert float(error) == pytest.approx(min(errors), rel=1e-5)
    assert min(errors) < 0.9 * errors[-1]  # or it would be no test


@pytest.mark.parametrize("after", [1, 2, 5])
def test_a_training_that_was_killed_goes_on_to_the_same_bits(
    jump_set, tmp_path, every_epoch, after
):
    whole, expected = fitted(jump_set(), tmp_path / "whole")
    epochs: list[str] = []
    with pytest.raises(Killed):
        fitted(jump_set(), tmp_path / "killed", dies_after(after, epochs))
    resumed, fit = fitted(jump_set(), tmp_path / "killed", lambda share, text: epochs.append(text))
    assert len(epochs) == 6  # none of them twice
    assert equal(resumed, whole)
    assert fit.curves == expected.curves


def check_ended(data: JumpData, folder: Path, epochs: int) -> None:
    """A training ends after so many epochs, and is not gone on with."""
    first, again = (fitted(data, folder)[1] for _ in range(2))
    assert len(first.curves) == epochs and again == first


def test_a_training_that_had_ended_is_not_gone_on_with(jump_set, tmp_path):
    check_ended(jump_set(), tmp_path, 6)


@pytest.mark.parametrize("patience", [2, 3])
def test_it_stops_when_nothing_becomes_better(jump_set, tmp_path, steady, patience):
    check_ended(jump_set(epochs=50, patience=patience), tmp_path, patience + 1)


def test_patience_goes_on_where_it_was(jump_set, tmp_path, every_epoch, steady):
    found = jump_set(epochs=50, patience=3)
    with pytest.raises(Killed):
        fitted(found, tmp_path, dies_after(3, []))
    _, fit = fitted(found, tmp_path)
    assert len(fit.curves) == 4


def test_ctrl_c_is_not_swallowed(jump_set, tmp_path):
    with pytest.raises(KeyboardInterrupt):
        fitted(jump_set(), tmp_path, dies_after(1, [], KeyboardInterrupt))


def cut_off(file: Path) -> None:
    file.write_bytes(file.read_bytes()[:1000])


def is_a_folder(file: Path) -> None:
    file.unlink()
    file.mkdir()


def holds(content: Any) -> Any:
    """Damage that leaves something else that torch can read."""
    return lambda file: torch.save(content, file)


def changed(file: Path) -> None:
    """A bit in the middle."""
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(bytes(content))


DAMAGES = {
    "cut off": cut_off,
    "a flipped bit": changed,
    "folder": is_a_folder,
    "text": lambda file: file.write_text("a text"),
    "nothing": lambda file: file.write_text(""),
    "empty": holds({}),
    "tensor": holds(torch.ones(3)),
    "other keys": holds({"epoch": 3, "global_step": "many", "state_dict": None}),
}


@pytest.mark.parametrize("damage", DAMAGES)
@pytest.mark.parametrize("after", [3, 6])
def test_a_state_that_is_damaged_is_put_aside_and_begun_anew(
    jump_set, tmp_path, every_epoch, capsys, damage, after
):
    whole, _ = fitted(jump_set(), tmp_path / "whole")
    with pytest.raises(Killed):
        fitted(jump_set(), tmp_path / "killed", dies_after(after, []))
    DAMAGES[damage](tmp_path / "killed" / STATE)
    again, fit = fitted(jump_set(), tmp_path / "killed")
    assert equal(again, whole) and len(fit.curves) == 6
    assert len(list((tmp_path / "killed").glob(f"{STATE}.damaged-*"))) == 1
    (told,) = capsys.readouterr().err.splitlines()
    assert told.startswith("training begins anew: ")


def test_a_loss_that_is_no_number_is_told(jump_set, tmp_path):
    found = jump_set()
    made = network(found)
    made.loss = lambda rows: torch.nan * made(rows.designs).sum()  # type: ignore[method-assign]
    with pytest.raises(FloatingPointError, match=r"nan after epoch 1.*learning_rate"):
        descend(made, found, tmp_path, silent)


def test_torch_has_its_threads_back(jump_set, tmp_path):
    before = torch.get_num_threads()
    torch.set_num_threads(2)
    try:
        fitted(jump_set(epochs=1), tmp_path)
        assert torch.get_num_threads() == 2
    finally:
        torch.set_num_threads(before)
