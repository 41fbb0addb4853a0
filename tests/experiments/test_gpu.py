"""The study of the card: its designs, its model of the caches, and what it says without a card."""

import json
from types import SimpleNamespace

import numpy as np
import pytest
from command_line import python
from robots import BASELINE

from experiments.designs import HIGH, LOW
from experiments.gpu import busy_share, grid
from experiments.gpu_traffic import Cache, Counted, counted, measure
from snapjump.engine import march as engine
from snapjump.number.memory import aligned_zeros


def test_the_grid_is_the_paper_s():
    designs = np.array(grid(15))
    assert designs.shape == (50_625, 4)
    assert (designs.min(axis=0) == LOW).all() and (designs.max(axis=0) == HIGH).all()
    assert len(np.unique(designs, axis=0)) == 50_625


def test_warps_last_as_long_as_their_longest_thread():
    passes = np.concatenate([np.full(32, 10), np.r_[40, np.zeros(31)]]).astype(int)
    march = SimpleNamespace(passes_of_threads=[passes])
    assert busy_share(march) == pytest.approx((320 + 40) / (32 * (10 + 40)))


def test_a_cache_reads_what_it_lost_and_writes_back_what_was_changed():
    cache = Cache(2)
    for address, written in ((1, False), (1, True), (2, True), (1, False), (3, False), (2, False)):
        cache.touch(address, written)
    # 1, 3, and 2 again were read; 2 and 1 had been changed when they made room.
    assert (cache.reads, cache.writes) == (3, 2)


def test_views_of_one_number_are_one_number():
    cache = Cache(100)
    memory = aligned_zeros((4, 3, 1))
    whole = counted(memory, [cache])
    part = counted(memory[1:], [cache])[0]
    assert isinstance(part, Counted) and part.shape == (3,)
    whole[1, 2] = 5.0
    assert part[2] == 5.0
    assert (cache.reads, len(cache.kept)) == (0, 1)


def test_larger_caches_pass_on_less_of_a_jump_s_traffic():
    usual = engine.view_work
    found = measure(BASELINE, 3)
    assert engine.view_work is usual
    small, large = found["l1"], found["l1_and_l2"]
    assert small.read > large.read > 0.0 and small.written > large.written > 0.0
    # Every node's numbers of the linear system, at least: 16 read and written again.
    nodes = len(BASELINE.discretization.masses())
    assert large.read > 16 * 8 * nodes and large.written > 16 * 8 * nodes


def test_without_a_card_there_is_one_line():
    cuda = pytest.importorskip("numba.cuda")
    if cuda.is_available():
        pytest.skip("there is a card")
    done = python("-m", "experiments.gpu", code=2)
    assert done.stdout.startswith("backend = 'cuda'") and done.stdout.count("\n") == 1


@pytest.mark.slow
@pytest.mark.processes
def test_the_study_runs_on_a_simulated_card():
    """A whole jump of each of two designs, in plain Python; the card's times mean nothing."""
    pytest.importorskip("numba_cuda", reason="numba-cuda is not installed")
    words = ("--tiers", "draft", "--points", "1", "--designs", "2")
    done = python("-m", "experiments.gpu", *words, NUMBA_ENABLE_CUDASIM="1")
    found = json.loads(done.stdout)
    assert found["card"] == "simulator"
    assert found["draft"]["statuses"] == {"ok": 1}
    assert found["draft"]["agreement"]["same_status"] == 2
    assert found["draft"]["estimated_bytes_an_iteration"] > 0.0
