"""A whole jump in plain Python: no compilation, so that many compositions can be tried."""

from typing import Any

import numpy as np


def without_compiling(monkeypatch: Any) -> None:
    """Let marches run as the Python that they are written in."""
    from snapjump.engine import march
    from snapjump.scenes import resting, runner
    from snapjump.statics.resting_gap import resting_gap

    monkeypatch.setattr(runner, "march", march.march.py_func)
    monkeypatch.setattr(runner, "find_starts", march.find_starts.py_func)
    monkeypatch.setattr(resting, "resting_gap", resting_gap.py_func)
    monkeypatch.setattr(runner, "load", lambda *arguments: None)
    np.seterr(all="ignore")
