"""Without a card it is said so in one line, before any work."""

import pytest
from refusals import refused

from snapjump.backend.cuda import CudaBackend
from snapjump.batch import simulate_batch
from snapjump.checks import ParameterError
from snapjump.composition import with_tier
from snapjump.engine.cuda import availability
from snapjump.engine.cuda.availability import check_card
from snapjump.simulation import simulate


@pytest.fixture
def without_package(monkeypatch):
    monkeypatch.setattr(availability, "find_spec", lambda name: None)


def test_a_missing_package_is_named(without_package):
    with refused("backend", "backend = 'cuda'", "numba-cuda", "pip install"):
        check_card(0)


@pytest.fixture
def cuda(monkeypatch):
    """numba's, which thinks that its package is there."""
    monkeypatch.setattr(availability, "find_spec", lambda name: name)
    return pytest.importorskip("numba.cuda")


def test_a_missing_card_is_named(monkeypatch, cuda):
    monkeypatch.setattr(cuda, "is_available", lambda: False)
    monkeypatch.setattr(cuda, "cuda_error", lambda: "no driver\nat all")
    with pytest.raises(ParameterError, match=r"NVIDIA card.*\(no driver\)$"):
        check_card(0)


def test_a_device_beyond_the_last_is_refused(monkeypatch, cuda):
    monkeypatch.setattr(cuda, "is_available", lambda: True)
    monkeypatch.setattr(cuda, "gpus", [None, None])
    check_card(1)
    with pytest.raises(ParameterError, match=r"backend.device = 2 .*\[0, 1\]"):
        check_card(2)


@pytest.mark.parametrize(
    "begin",
    [
        lambda simulation: simulation.sim.check_start(simulation),
        simulate,
        lambda simulation: simulate_batch([simulation]),
    ],
)
def test_no_statics_are_solved_before(without_package, monkeypatch, begin):
    from snapjump.scenes import jump_start

    def never(*arguments):
        raise AssertionError("work has begun")

    monkeypatch.setattr(jump_start, "symmetric_threshold", never)
    with pytest.raises(ParameterError, match="numba-cuda"):
        begin(with_tier("draft", backend=CudaBackend()))
