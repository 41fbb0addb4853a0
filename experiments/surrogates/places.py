"""Where in the space of designs the error sits."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from snapjump.plan.parts.axes import Axis
from snapjump.studies.base import Row

Array = NDArray[np.float64]
BINS = 5
SHARES = (0.5, 0.1, 0.01)


def by_input(designs: Array, errors: Array, axes: Sequence[Axis]) -> list[Row]:
    """Mean absolute errors in fifths of each input's range; designs (N, I), errors (N, 2) in L."""
    rows = []
    for values, axis in zip(designs.T, axes, strict=True):
        edges = np.linspace(axis.low, axis.high, BINS + 1)
        place = np.clip(np.digitize(values, edges) - 1, 0, BINS - 1)
        for k in range(BINS):
            inside = place == k
            if inside.any():
                x, y = np.abs(errors[inside]).mean(axis=0)
                rows.append(
                    {
                        "input": axis.column,
                        "from": float(edges[k]),
                        "to": float(edges[k + 1]),
                        "designs": int(inside.sum()),
                        "mae_x_bar": float(x),
                        "mae_y_bar": float(y),
                    }  # fmt: skip
                )
    return rows


def concentration(errors: Array) -> dict[str, float]:
    """What share of all error the worst half, tenth and hundredth of the designs have."""
    sizes = np.sort(np.abs(errors).mean(axis=1))[::-1]
    total = sizes.sum()
    return {
        f"share_of_worst_{100 * share:g}_percent": float(
            sizes[: max(1, round(share * len(sizes)))].sum() / total
        )
        for share in SHARES
    }
