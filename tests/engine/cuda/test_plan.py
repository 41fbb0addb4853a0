"""A card's robots within a bound on memory; without a card it is said so before any work."""

import pytest
from refusals import refused

from snapjump.backend.cuda import CudaBackend
from snapjump.batch import simulate_batch
from snapjump.checks import ParameterError
from snapjump.composition import with_tier
from snapjump.engine.cuda import availability
from snapjump.engine.cuda.availability import check_card
from snapjump.engine.cuda.plan import GIB, ROBOTS_A_THREAD, make_plan
from snapjump.scenes import jump_start
from snapjump.simulation import simulate

THREAD, ROBOT = 40_000, 6_000


@pytest.mark.parametrize("robots", [1, 64, 65, 5000, 10**6, 10**9])
@pytest.mark.parametrize("memory_gib", [0.01, 1.0, 100.0])
def test_a_plan_keeps_to_its_memory_and_covers_all_robots(robots, memory_gib):
    plan = make_plan(robots, THREAD, ROBOT, memory_gib, 64)
    assert plan.threads * THREAD + min(plan.robots, robots) * ROBOT <= memory_gib * GIB
    assert plan.threads < robots + 64
    chunks = plan.chunks(robots) if robots <= 10**6 else [slice(0, robots)]
    assert chunks[0].start == 0 and chunks[-1].stop == robots
    assert all(a.stop == b.start for a, b in zip(chunks, chunks[1:], strict=False))
    assert all(c.stop - c.start <= plan.robots for c in chunks[:-1])


def test_more_memory_is_used_for_more_threads_until_each_robot_has_one():
    threads = [make_plan(50_625, THREAD, ROBOT, gib, 64).threads for gib in (0.1, 1.0, 4.0, 8.0)]
    assert threads == sorted(threads)
    assert threads[0] * (THREAD + ROBOTS_A_THREAD * ROBOT) <= 0.1 * GIB
    assert threads[-1] == 64 * 792  # 50,625 in blocks of 64


def test_too_little_memory_for_one_block_is_refused():
    with pytest.raises(ParameterError, match=r"backend.memory_gib = 0.001.*at least 0.00525 GiB"):
        make_plan(10, THREAD, ROBOT, 0.001, 64)


@pytest.fixture
def without_package(monkeypatch):
    monkeypatch.setattr(availability, "find_spec", lambda name: None)


def test_a_missing_package_is_named(without_package):
    with refused("backend", "backend = 'cuda'", "numba-cuda", "pip install"):
        check_card(0)


def test_a_missing_card_and_a_device_beyond_the_last_are_named(monkeypatch):
    cuda = pytest.importorskip("numba.cuda")
    monkeypatch.setattr(availability, "find_spec", lambda name: name)
    monkeypatch.setattr(cuda, "is_available", lambda: False)
    monkeypatch.setattr(cuda, "cuda_error", lambda: "no driver\nat all")
    with pytest.raises(ParameterError, match=r"NVIDIA card.*\(no driver\)$"):
        check_card(0)
    monkeypatch.setattr(cuda, "is_available", lambda: True)
    monkeypatch.setattr(cuda, "gpus", [None, None])
    check_card(1)
    with pytest.raises(ParameterError, match=r"backend.device = 2 .*\[0, 1\]"):
        check_card(2)


def test_no_statics_are_solved_before(without_package, monkeypatch):
    def never(*arguments):
        raise AssertionError("work has begun")

    monkeypatch.setattr(jump_start, "symmetric_threshold", never)
    on_card = with_tier("draft", backend=CudaBackend())
    for begin, given in (
        (on_card.sim.check_start, on_card), (simulate, on_card), (simulate_batch, [on_card]),
    ):  # fmt: skip
        with pytest.raises(ParameterError, match="numba-cuda"):
            begin(given)
