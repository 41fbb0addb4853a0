import json

from snapjump.files.provenance import now, provenance


def test_a_result_can_be_traced(tmp_path):
    origin = provenance("python run.py seed=3", seed=3, started_at=now())
    assert json.loads(json.dumps(origin)) == origin
    assert origin["command"] == "python run.py seed=3"
    assert origin["seed"] == 3
    assert origin["started_at"] <= origin["finished_at"]
    assert len(origin["source_sha256"]) == 64
    assert {"git_revision", "git_dirty"} <= set(origin)
    assert {"python", "numpy", "numba", "mlflow", "hydra-core"} <= set(origin["versions"])
    assert {"system", "processor", "cores"} <= set(origin["machine"])
