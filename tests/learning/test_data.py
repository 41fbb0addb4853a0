"""Which jumps are learned from, in what order and batches, and at which rates."""

from dataclasses import asdict

import numpy as np
import pytest
import torch
from forward_models import law
from refusals import refused
from small_datasets import WIDE_STICK, made_up_dataset, small, smooth_dataset

from snapjump.checks import ParameterError
from snapjump.learning.data import Batches, JumpData, read_rows, split
from snapjump.learning.training import Training
from snapjump.run.tasks.complete import whole


def test_a_split_is_of_all_rows_and_by_the_seed():
    training = Training(test_share=0.2, validation_share=0.1)
    parts, again = (split(1000, training, 3) for _ in range(2))
    assert [len(part) for part in parts] == [720, 80, 200]
    assert sorted(np.concatenate(parts)) == list(range(1000))
    assert all(np.array_equal(one, other) for one, other in zip(parts, again, strict=True))
    assert set(split(1000, Training(), 4).test) != set(parts.test)


def test_fewer_rows_have_the_same_test_set():
    whole, some, more = (split(1000, Training(rows=rows), 0) for rows in (None, 300, 600))
    assert np.array_equal(whole.test, some.test)
    assert [len(some.train), len(some.validation)] == [270, 30]
    # Those of the smaller one are among those of the larger: curves against size are of one path.
    assert {*some.train, *some.validation} <= {*more.train, *more.validation}
    assert len(split(1000, Training(rows=800), 0).train) == len(whole.train)


NO_SPLITS = (
    ("dataset.path", 49, {}), ("dataset.path", 100, {"validation_share": 0.01}),
    ("training.rows", 1000, {"rows": 801}), ("training.rows", 1000, {"rows": 94}),
)  # fmt: skip


@pytest.mark.parametrize(("key", "count", "values"), NO_SPLITS)
def test_splits_that_there_are_not(key, count, values):
    with refused(key):
        split(count, Training(**values), 0)


def follows_the_law(rows):
    apexes, _ = law(rows.designs.double().numpy())
    assert np.allclose(rows.apexes.numpy(), apexes, rtol=1e-5, atol=1e-5)


def test_the_rows_are_the_dataset_s(jump_set):
    found = jump_set()
    parts = (found.train, found.validation, found.test)
    assert [len(part.designs) for part in parts] == [288, 32, 80]
    for part in parts:
        follows_the_law(part)
        assert torch.isnan(part.slopes).all() and part.slopes.shape == (len(part.designs), 2, 4)


def test_batches_are_all_rows_once_in_an_order_of_seed_and_epoch(jump_set):
    found = jump_set()
    batches = found.train_dataloader()
    assert isinstance(batches, Batches) and len(batches) == len(list(batches)) == 18
    first, again, other = (
        torch.cat([rows.designs for rows in some])
        for some in (batches, found.train_dataloader(), Batches(found.train, 16, (0, 1)))
    )
    assert torch.equal(first, again) and not torch.equal(first, found.train.designs)
    assert torch.equal(first.sort(dim=0).values, found.train.designs.sort(dim=0).values)
    assert not torch.equal(first, other)
    for rows in batches:
        follows_the_law(rows)


def test_slopes_of_a_dataset_that_has_them(tmp_path):
    dataset = smooth_dataset(tmp_path, small(60, 60, sensitivities=True, friction=WIDE_STICK))
    rows = read_rows(dataset)
    _, slopes = law(rows.designs.double().numpy())
    known = torch.isfinite(rows.slopes).numpy()
    assert np.allclose(rows.slopes.numpy()[known], slopes[known], rtol=1e-4, atol=1e-4)
    # Made up as well: nine in ten graze no contact.
    grazed = ~known.all(axis=(1, 2))
    frame = dataset.frame(["differentiable"])
    assert np.array_equal(grazed, ~frame["differentiable"].to_numpy(dtype=bool))
    assert 0 < grazed.sum() < 20


def test_jumps_that_failed_are_left_out(tmp_path):
    rows = read_rows(made_up_dataset(tmp_path, small(100, 50)))
    assert len(rows.designs) == 90 and torch.isfinite(rows.apexes).all()


def test_a_dataset_without_a_jump_is_refused(tmp_path):
    nan = {"x_bar": np.nan, "y_bar": np.nan}
    dataset = smooth_dataset(tmp_path, small(60, 60), status="step_underflow", **nan)
    with pytest.raises(ParameterError, match=r"dataset\.path.*status is ok"):
        JumpData(dataset, Training(), 0)


def test_batches_double_in_equal_stretches():
    training = Training(epochs=50, batch_first=64, batch_last=1024)
    sizes = [training.batch_size(epoch) for epoch in range(50)]
    assert sizes == np.repeat([64, 128, 256, 512, 1024], 10).tolist()
    assert {Training(batch_first=9, batch_last=9).batch_size(e) for e in range(240)} == {9}
    few = Training(epochs=2)
    assert [few.batch_size(epoch) for epoch in range(2)] == [64, 256]


def test_the_rate_rises_and_falls_to_nothing():
    training = Training(epochs=200, learning_rate=0.5)
    rates = [training.rate(epoch) for epoch in range(200)]
    assert max(rates) == pytest.approx(0.5, rel=0.01) and rates.index(max(rates)) < 10
    assert 0.0 < rates[0] < 0.15 and rates[100] == pytest.approx(0.25)
    assert 0.0 < rates[-1] < 1e-4 and sorted(rates[10:], reverse=True) == rates[10:]
    assert Training(epochs=1).rate(0) > 0.0


def test_every_key_must_be_there_and_no_other():
    values = asdict(Training())
    assert whole(Training, values) == Training()
    with pytest.raises(ParameterError, match=r"training\.optimizer"):
        whole(Training, {**values, "optimizer": "sgd"})
    for key in values:
        with pytest.raises(ParameterError, match=f"training.{key}"):
            whole(Training, {other: value for other, value in values.items() if other != key})
    with pytest.raises(ParameterError, match="training"):
        whole(Training, None)
