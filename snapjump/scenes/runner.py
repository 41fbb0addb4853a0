"""Running a march from Python: slices of it, so that progress shows and Ctrl-C works."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.composition import Simulation
from snapjump.engine.clock import TIME
from snapjump.engine.march import find_starts, march
from snapjump.engine.model import Model
from snapjump.engine.models import Models
from snapjump.engine.outcome import COLUMNS
from snapjump.engine.queue import Queue
from snapjump.engine.recorder.none import NoRecorder
from snapjump.engine.step import Method
from snapjump.engine.work import Sizes, make_memory, sizes_of
from snapjump.frame.base import NO_MESH
from snapjump.number.announcement import announce_end
from snapjump.number.once import load
from snapjump.scenes.crew import Worker, run_crew
from snapjump.units import Scales

Array = NDArray[np.float64]
Progress = Callable[[float, str], None]
ITERATIONS_PER_STAGE = 25.0
MOST_ITERATIONS = 2.0e6
PASSES_PER_SLICE = 2000
BLOCKS_PER_SLICE = 10


@dataclass
class March:
    """Robots of one composition and one mesh of their frames, their beginnings, and the memory they
    are simulated in: ``lanes`` at a time in each of ``threads``, which take them from one queue.

    ``units``: of all its numbers, the robot's if None; ``after_slice``: called when a slice of a
    single thread's march is over. ``memory`` and ``queue`` are those of the first thread.
    """

    models: Sequence[Model]
    masses: Array
    states: Array
    simulation: Simulation
    termination: Any
    recorder: Any = NoRecorder()
    lanes: int = 1
    threads: int = 1
    velocities: Array | None = None
    accelerations: Array | None = None
    most_iterations: float = MOST_ITERATIONS
    mesh: NDArray[np.int64] = field(default_factory=lambda: NO_MESH)
    units: Scales | None = None
    after_slice: Callable[[], None] | None = None

    def __post_init__(self) -> None:
        robots, size = self.states.shape
        zeros = np.zeros((robots, size))
        self.numbers = Models.of(self.models).numbers.copy()
        shared = Queue(
            numbers=self.numbers,
            state=self.states.copy(),
            velocity=zeros if self.velocities is None else self.velocities.copy(),
            acceleration=np.zeros((robots, size))
            if self.accelerations is None
            else self.accelerations.copy(),
            status=np.zeros(robots),
            outcome=np.zeros((robots, COLUMNS)),
            cursor=np.zeros(2, dtype=np.int64),
            counts=np.zeros(2, dtype=np.int64),
            carried=np.zeros(self.lanes, dtype=np.int64),
        )
        self.model = self.models[0]
        self.scheme = self.simulation.integrator.scheme()
        self.stepping = self.simulation.stepping.control(self.scales)
        threads = max(1, min(self.threads, -(-robots // self.lanes)))
        self.crew = [self._worker(shared) for _ in range(threads)]
        self.memory, self.queue = self.crew[0].memory, self.crew[0].queue

    def sizes(self, lanes: int) -> Sizes:
        """Of the memory of so many robots side by side."""
        return sizes_of(self.model, len(self.masses), self.scheme.slots(), lanes, self.mesh)

    def _worker(self, shared: Queue) -> Worker:
        """A thread's share of the queue and memory of its own."""
        memory = make_memory(self.sizes(self.lanes), self.mesh)
        counts = np.array([-1, 0], dtype=np.int64)
        carried = np.full(self.lanes, -1, dtype=np.int64)
        return Worker(memory, shared._replace(counts=counts, carried=carried), self.recorder)

    @property
    def scales(self) -> Scales:
        """The units of its numbers."""
        return self.units or self.simulation.robot.scales

    @property
    def kernel_seconds(self) -> float:
        """Seconds of a core that the kernels have taken so far, all threads added up."""
        return sum(worker.kernel_seconds for worker in self.crew)

    @property
    def passes(self) -> int:
        """Newton iterations of all lanes of a thread, idle ones too; all threads added up."""
        return int(sum(worker.queue.counts[1] for worker in self.crew))

    def _done(self) -> float:
        """Share of the robots that have left the queue and their lanes; of one, its time's."""
        robots = len(self.models)
        if robots == 1:
            limit = self.termination.time_limit(self.model)
            return float(min(self.memory.clock[TIME, 0] / limit, 1.0))
        under_way = sum(max(0, int(worker.queue.counts[0])) for worker in self.crew)
        return (min(int(self.queue.cursor[1]), robots) - under_way) / robots

    def find_starts(self, progress: Progress | None = None) -> None:
        """Replace the states by the equilibria that the march begins from.

        ``progress`` is told the share of the robots whose start is found, or being looked for.
        """
        model, masses = self.model, self.masses
        lanes = (0,) * self.lanes
        robots = len(self.models)
        load(find_starts, model, masses, self.memory, self.queue, lanes, 0)

        def advance(worker: Worker) -> bool:
            return find_starts(model, masses, worker.memory, worker.queue, lanes, BLOCKS_PER_SLICE)

        def report() -> None:
            if progress is not None:
                progress(min(int(self.queue.cursor[0]), robots) / robots, "finding starts")

        run_crew(self.crew, advance, report)

    def run(self, progress: Progress | None = None) -> Array:
        """Simulate all robots; returns the outcome (robots, COLUMNS).

        ``progress`` is told the share of the robots that are done, or of one robot's time limit.
        """

        def advance(worker: Worker) -> bool:
            return march(*self.arguments(worker), PASSES_PER_SLICE)

        def report() -> None:
            if self.after_slice is not None:
                self.after_slice()
            if progress is not None:
                progress(self._done(), "marching")

        load(march, *self.arguments(self.crew[0]), 0)
        announce_end()
        run_crew(self.crew, advance, report)
        return self.queue.outcome

    @property
    def method(self) -> Method:
        """How its robots are stepped and their marches ended."""
        limits = (ITERATIONS_PER_STAGE, self.most_iterations)
        return Method(self.scheme, self.stepping, self.termination, *limits)

    def arguments(self, worker: Worker) -> tuple[Any, ...]:
        """What a march of a thread's lanes is called with, less the number of passes."""
        return (
            self.model,
            self.masses,
            self.method,
            worker.recorder,
            worker.memory,
            worker.queue,
            (0,) * self.lanes,
        )
