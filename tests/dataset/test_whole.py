"""A dataset at once: made the first time, found the second."""

from experiments.compositions import described
from snapjump.dataset.specification import specify
from snapjump.dataset.whole import whole_dataset
from snapjump.simulation import build


def test_made_and_found(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    groups = described(build({"accuracy": {"name": "draft"}}))
    backend = {"name": "lanes"}
    specification = specify(
        {**groups, "backend": backend, "plan": {"name": "sobol", "count": 16}}, 8
    )
    (first, made), (second, found) = (whole_dataset(specification, backend) for _ in range(2))
    assert (made.made, found.made, found.kept) == (16, 0, 16)
    assert first.rows == 16 and first.sha256 == second.sha256
