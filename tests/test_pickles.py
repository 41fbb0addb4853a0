"""Simulations and results travel between processes."""

import pickle
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import pytest
from families import FAMILIES, of_simulations

from snapjump.checks import ParameterError
from snapjump.composition import Simulation, with_tier
from snapjump.results import Result
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


def bent(simulation: Simulation) -> Result:
    """The result of a bent cantilever."""
    return simulate(simulation)


def test_a_result_of_another_process() -> None:
    simulation = with_tier("draft", sim="cantilever")
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        found = pool.submit(bent, simulation).result()
    assert found.status == "ok" and found.simulation == simulation
    assert found.deflection_bar == simulate(simulation).deflection_bar


def test_joblib_and_dask() -> None:
    joblib = pytest.importorskip("joblib")
    simulation = with_tier("draft", sim="cantilever")
    jobs = [joblib.delayed(bent)(simulation)] * 2
    apart = joblib.Parallel(n_jobs=2, backend="loky")(jobs)
    assert [one.deflection_bar for one in apart] == [bent(simulation).deflection_bar] * 2
    distributed = pytest.importorskip("distributed", reason="needs snapjump[cluster]")
    options = {"n_workers": 1, "threads_per_worker": 1, "dashboard_address": None}
    with distributed.Client(distributed.LocalCluster(**options)) as client:
        assert client.submit(bent, simulation).result().status == "ok"
