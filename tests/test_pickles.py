"""Simulations and results travel between processes."""

import pickle
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import pytest
from families import FAMILIES, of_simulations

from snapjump.checks import ParameterError
from snapjump.composition import with_tier
from snapjump.simulation import simulate
from snapjump.tiers import TIERS


@pytest.mark.parametrize("tier", TIERS)
def test_a_tier(tier: str) -> None:
    again = pickle.loads(pickle.dumps(with_tier(tier)))
    assert again == with_tier(tier)
    assert again.integrator.scheme().stage_count() == with_tier(tier).integrator.stages


@of_simulations
def test_every_member(family: str, name: str) -> None:
    try:
        simulation = with_tier("draft", **{family: name})
    except ParameterError:
        part = FAMILIES[family][name]()
        assert pickle.loads(pickle.dumps(part)) == part
    else:
        again = pickle.loads(pickle.dumps(simulation))
        assert again == simulation
        # What was given is still known from what the tier chose.
        assert [p.given for p in again.parts] == [p.given for p in simulation.parts]


BENT = with_tier("draft", sim="cantilever")


def test_a_result_of_another_process() -> None:
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        found = pool.submit(simulate, BENT).result()
    assert found.status == "ok" and found.simulation == BENT
    assert found.deflection_bar == simulate(BENT).deflection_bar


def test_joblib_and_dask() -> None:
    joblib = pytest.importorskip("joblib")
    apart = joblib.Parallel(n_jobs=2, backend="loky")([joblib.delayed(simulate)(BENT)] * 2)
    assert [one.deflection_bar for one in apart] == [simulate(BENT).deflection_bar] * 2
    distributed = pytest.importorskip("distributed", reason="needs snapjump[cluster]")
    options = {"n_workers": 1, "threads_per_worker": 1, "dashboard_address": None}
    with distributed.Client(distributed.LocalCluster(**options)) as client:
        assert client.submit(simulate, BENT).result().status == "ok"
