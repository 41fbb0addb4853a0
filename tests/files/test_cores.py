"""The cores that a process may use, on systems that tell and on others."""

import os

from snapjump.files.cores import own_cores


def test_a_bound_process_has_fewer():
    bound = os.sched_getaffinity(0)
    assert own_cores() == sorted(bound)
    os.sched_setaffinity(0, {min(bound)})
    try:
        assert own_cores() == [min(bound)]
    finally:
        os.sched_setaffinity(0, bound)


def test_systems_that_do_not_bind_have_all(monkeypatch):
    monkeypatch.delattr(os, "sched_getaffinity")
    monkeypatch.setattr(os, "cpu_count", lambda: 3)
    assert own_cores() == [0, 1, 2]
    monkeypatch.setattr(os, "cpu_count", lambda: None)
    assert own_cores() == [0]
