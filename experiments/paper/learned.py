"""The forward model that comes with the library, as cells of parts depend on it."""

import hashlib
from collections.abc import Mapping
from typing import Any

from experiments.compositions import composed


def shipped_forward(groups: Mapping[str, Any]) -> dict[str, str]:
    """Inputs of a cell that asks it: ``checkpoint`` and its hash.

    Raises ParameterError if it was trained with another physical model than the groups'.
    """
    from snapjump.learning.forward_model import open_forward_model
    from snapjump.targets.request import SHIPPED

    open_forward_model(SHIPPED).check_model(composed(groups))
    digest = hashlib.sha256(SHIPPED.read_bytes()).hexdigest()
    return {"checkpoint": str(SHIPPED), "checkpoint_sha256": digest}
