"""Band matrices as whole ones."""

from typing import Any

import numpy as np


def whole(band: Any) -> Any:
    """The symmetric matrix of a lower band (size, width); what lies below its last row is none."""
    size, width = band.shape
    lower = sum(np.diag(band[: size - k, k], -k) for k in range(width))
    return lower + np.tril(lower, -1).T
