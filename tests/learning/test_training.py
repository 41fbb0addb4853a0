"""How a forward model is trained: batches, rates, and every value that is not allowed."""

from dataclasses import asdict

import pytest
from refusals import refused

from snapjump.checks import ParameterError
from snapjump.learning.training import Training
from snapjump.run.tasks.complete import whole


def test_batches_double_in_equal_stretches():
    training = Training(epochs=50, batch_first=64, batch_last=1024)
    sizes = [training.batch_size(epoch) for epoch in range(50)]
    assert sizes == [64] * 10 + [128] * 10 + [256] * 10 + [512] * 10 + [1024] * 10
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


@pytest.mark.parametrize(
    ("key", "values"),
    [
        ("test_share", (0.0, 0.95, float("nan"), "a fifth", None)),
        ("validation_share", (0.0, 1.0, -0.1)),
        ("rows", (0, -1, 2.5, "all")),
        ("epochs", (0, 1.5, None)),
        ("patience", (0, True)),
        ("batch_first", (0, 2**31, 1.0)),
        ("batch_last", (32, 1000, 96)),
        ("learning_rate", (0.0, -1e-3, 2.0, float("inf"), "1e-3")),
        ("threads", (0, 2000)),
    ],
)
def test_values_that_are_not_allowed(key, values):
    for value in values:
        with refused(f"training.{key}") as caught:
            whole(Training, {**asdict(Training()), key: value})
        assert caught.value.value is value


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
