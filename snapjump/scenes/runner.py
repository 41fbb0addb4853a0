"""Running a march from Python: slices of it, so that progress shows and Ctrl-C works."""

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.composition import Simulation
from snapjump.discretization.base import node_dofs
from snapjump.engine.clock import ROWS, TIME
from snapjump.engine.march import Limits, Queue, find_starts, march
from snapjump.engine.model import Model, numbers_of
from snapjump.engine.work import NO_MESH, Work, make_work
from snapjump.frame.base import frame_dofs
from snapjump.integrator.base import slots
from snapjump.number.announcement import load
from snapjump.recorder.none import NoRecorder

Array = NDArray[np.float64]
Progress = Callable[[float, str], None]
ITERATIONS_PER_STAGE = 25.0
MOST_ITERATIONS = 2.0e6
PASSES_PER_SLICE = 2000


@dataclass
class March:
    """Robots of one composition and one mesh of their frames, their beginnings, and the memory they
    are simulated in."""

    models: list[Model]
    masses: Array
    states: Array
    simulation: Simulation
    ending: Any
    recorder: Any = NoRecorder()
    lanes: int = 1
    velocities: Array | None = None
    accelerations: Array | None = None
    most_iterations: float = MOST_ITERATIONS
    mesh: NDArray[np.int64] = field(default_factory=lambda: NO_MESH)

    def __post_init__(self) -> None:
        robots, size = self.states.shape
        zeros = np.zeros((robots, size))
        self.numbers = np.array([numbers_of(m) for m in self.models])
        self.queue = Queue(
            numbers=self.numbers,
            state=self.states.copy(),
            velocity=zeros if self.velocities is None else self.velocities.copy(),
            acceleration=zeros.copy() if self.accelerations is None else self.accelerations.copy(),
            status=np.zeros(robots),
            outcome=np.zeros((robots, ROWS)),
            cursor=np.zeros(2, dtype=np.int64),
            carried=np.zeros(self.lanes, dtype=np.int64),
        )
        self.scheme = self.simulation.integrator.scheme()
        self.stepping = self.simulation.stepping.member(self.simulation.robot.scales)
        self.memory: Work = make_work(
            len(self.masses),
            frame_dofs(self.models[0].frame, self.mesh),
            slots(self.scheme),
            ROWS,
            self.numbers.shape[1],
            self.lanes,
            node_dofs(self.models[0].discretization),
            self.mesh,
        )
        self.kernel_seconds = 0.0

    def find_starts(self) -> None:
        """Replace the states by the equilibria that the march begins from."""
        arguments = (self.models[0], self.masses, self.memory)
        lanes = (0,) * self.lanes
        nobody = self.queue._replace(
            numbers=self.numbers[:0], status=self.queue.status[:0], outcome=self.queue.outcome[:0]
        )
        load(find_starts, *arguments, nobody, lanes)
        begun = time.perf_counter()
        find_starts(*arguments, self.queue, lanes)
        self.kernel_seconds += time.perf_counter() - begun

    def run(self, progress: Progress | None = None) -> Array:
        """Simulate all robots; returns the outcome (robots, ROWS).

        ``progress`` is told the share of the time limit that has been simulated.
        """
        arguments = (
            self.models[0],
            self.masses,
            self.scheme,
            self.stepping,
            self.ending,
            Limits(ITERATIONS_PER_STAGE, self.most_iterations),
            self.recorder,
            self.memory,
            self.queue,
            (0,) * self.lanes,
        )
        load(march, *arguments, 0)
        done = False
        while not done:
            begun = time.perf_counter()
            done = march(*arguments, PASSES_PER_SLICE)
            self.kernel_seconds += time.perf_counter() - begun
            if progress is not None:
                share = self.memory.clock[TIME, 0] / self.ending.duration
                progress(float(min(share, 1.0)), "marching")
        return self.queue.outcome
