"""The energy ledger: energies that are stored, put in and lost, and their balance."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from snapjump.show.plots.motion import finite_samples

STORED = ("elastic_J", "kinetic_J", "gravitational_J", "contact_J")
LOST = ("friction_loss_J", "damping_loss_J", "numerical_loss_J")
LOST_IF_ANY = ("contact_loss_J", "drag_loss_J")  # which most compositions have none of
WORK = "clamp_work_J"


@dataclass(frozen=True)
class Ledger:
    """Energies in EI/L at K times; names as in the arrays, without unit."""

    time: np.ndarray  # (K,) ms since the clamps began to turn
    stored: dict[str, np.ndarray]  # each (K,)
    work: np.ndarray  # (K,) of the clamps
    lost: dict[str, np.ndarray]  # each (K,), added up
    unit_J: float  # EI/L

    @property
    def total(self) -> np.ndarray:
        return np.sum(list(self.stored.values()), axis=0)

    @property
    def balance(self) -> np.ndarray:
        """Stored less initial less work plus losses: zero if they balance."""
        losses = np.sum(list(self.lost.values()), axis=0) if self.lost else 0.0
        return self.total - self.total[0] - self.work + losses


def read_ledger(result: Any) -> Ledger | None:
    """The ledger of a result, without samples that are not finite; None if it keeps none."""
    arrays = result.arrays
    lost = (*LOST, *(name for name in LOST_IF_ANY if np.any(arrays.get(name, 0.0))))
    names = [name for name in (*STORED, WORK, *lost) if np.size(arrays.get(name, ())) > 0]
    if "time_s" not in arrays or not any(name in STORED for name in names):
        return None
    columns = finite_samples({name: arrays[name] for name in ("time_s", *names)})
    time = columns.pop("time_s")
    if len(time) < 2:
        return None
    robot = result.simulation.robot
    unit = float(robot.bending_stiffness_N_m2 / robot.length_m)
    columns = {name: column / unit for name, column in columns.items()}

    def pick(wanted: tuple[str, ...]) -> dict[str, np.ndarray]:
        return {name[:-2]: columns[name] for name in wanted if name in columns}

    work = columns.get(WORK, np.zeros(len(time)))
    return Ledger(1e3 * time, pick(STORED), work, pick(lost), unit)
