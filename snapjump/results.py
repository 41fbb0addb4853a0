"""The result of a simulation."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Result:
    """Status, flat figures and arrays of one simulation.

    ``status``: ``ok``, ``no_jump`` or the name of a failure (:mod:`snapjump.engine.status`);
    ``message``: for failures, at what time and why. ``summary``: the figures of ``result.json``,
    keys with their unit. ``arrays``: the trajectory, SI units in the names.
    """

    status: str
    message: str
    summary: dict[str, Any]
    arrays: dict[str, NDArray[Any]]
    simulation: Any = field(repr=False)

    @property
    def succeeded(self) -> bool:
        """Whether the simulation ended as the scene foresees."""
        return self.status in ("ok", "no_jump")

    def __getattr__(self, name: str) -> Any:
        try:
            return self.__dict__["summary"][name]
        except KeyError:
            raise AttributeError(name) from None

    def nodes_m(self) -> NDArray[np.float64]:
        """Node positions, shape (samples, nodes, 2), in metres."""
        return np.stack([self.arrays["node_x_m"], self.arrays["node_y_m"]], axis=-1)
