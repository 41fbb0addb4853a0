"""The result of a simulation: figures, trajectory, and pictures that it draws of itself."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from snapjump.composition import Simulation
from snapjump.files.extras import extras_named
from snapjump.views.base import Shown

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True, repr=False)
class Result(Shown):
    """Status, flat figures and arrays of one simulation.

    ``status``: ``ok``, ``no_jump`` or the name of a failure (:mod:`snapjump.engine.status`);
    ``message``: for failures, at what time and why. ``summary``: the figures of ``result.json``,
    keys with their unit, which are attributes too. ``arrays``: the trajectory, SI units in the
    names.
    """

    status: str
    message: str
    summary: dict[str, Any]
    arrays: dict[str, NDArray[Any]]
    simulation: Simulation = field(repr=False)

    @property
    def succeeded(self) -> bool:
        """Whether the simulation ended as the scene foresees."""
        return self.status in ("ok", "no_jump")

    def __getattr__(self, name: str) -> Any:
        try:
            return self.__dict__["summary"][name]
        except KeyError:
            raise AttributeError(name) from None

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self.summary})

    def nodes_m(self) -> NDArray[np.float64]:
        """Node positions, shape (samples, nodes, 2), in metres."""
        return np.stack([self.arrays["node_x_m"], self.arrays["node_y_m"]], axis=-1)

    def to_frame(self) -> "pd.DataFrame":
        """The trajectory as a table: a row a sample, a column for each array of one number a
        sample (those of nodes and corners are in ``arrays``)."""
        with extras_named():
            import pandas as pd
        samples = len(next(iter(self.arrays.values()), ()))
        columns = {
            name: values for name, values in self.arrays.items() if values.shape == (samples,)
        }
        return pd.DataFrame(columns)


class JumpResult(Result):
    """One jump. Its figures are declared in :mod:`snapjump.scenes.jump_outputs`, where each is
    explained: lengths over L (``_bar``), times since the clamps began to turn."""

    x_bar: float
    y_bar: float
    x_world_bar: float
    y_world_bar: float
    apex_time_s: float
    liftoff_vx_m_s: float
    liftoff_vy_m_s: float
    liftoff_time_s: float
    liftoff_x_bar: float
    liftoff_y_bar: float
    mount_height_bar: float
    start_angle_rad: float
    error_sum_bar: float
    coarsest_contact_step: float
    x_error_estimate_percent: float
    y_error_estimate_percent: float
    error_estimate_percent: float
    within_tier: bool | None
    error_unknown_because: str
    takeoff_angle_rad: float
    spin_rad_s: float
    landing_x_bar: float
    peak_ground_force_N: float
    ground_impulse_N_s: float
    efficiency: float
    max_strain: float
    max_strain_at_bar: float
    max_strain_time_s: float
    max_stress_Pa: float
    safety_factor: float
    peak_clamp_torque_N_m: float
    clamp_work_J: float
    peak_clamp_power_W: float
    damping_ratio_1: float
    damping_ratio_2: float
    min_gap_m: float
    numerical_loss_share: float
    max_residual: float
    steps: int
    rejected_steps: int
    newton_iterations: int
    kernel_seconds: float
    accuracy: str
    wall_seconds: float
