"""A whole jump in plain Python: no compilation, so that many compositions can be tried."""

from typing import Any

import numpy as np

from snapjump.engine.model import Model
from snapjump.engine.work import System, Work

# The mesh is the same for all lanes.
LANED = set(Work._fields) - {"mesh", "system"}


def view(work: Work, lanes: Any) -> Work:
    """The memory of one lane, without the axis of lanes."""
    system = System(*(array[..., 0] for array in work.system))
    arrays = {name: array[..., 0] for name, array in work._asdict().items() if name in LANED}
    return work._replace(system=system, **arrays)


def filled(template: Model, numbers: Any) -> Model:
    """The template's classes with other numbers."""
    members, position = [], 0
    for member in template:
        members.append(type(member)(*numbers[position : position + len(member)]))
        position += len(member)
    return Model(*members)


def without_compiling(monkeypatch: Any) -> None:
    """Let marches run as the Python that they are written in."""
    from snapjump.engine import march
    from snapjump.scenes import resting, runner
    from snapjump.statics.resting_gap import resting_gap

    monkeypatch.setattr(march, "view_work", view)
    monkeypatch.setattr(march, "with_numbers", filled)
    monkeypatch.setattr(runner, "march", march.march.py_func)
    monkeypatch.setattr(runner, "find_starts", march.find_starts.py_func)
    monkeypatch.setattr(resting, "resting_gap", resting_gap.py_func)
    monkeypatch.setattr(runner, "load", lambda *arguments: None)
    np.seterr(all="ignore")
