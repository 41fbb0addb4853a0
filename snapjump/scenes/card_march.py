"""A march on a graphics card: the same queue, sent there in chunks and fetched back."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from snapjump.backend.cuda import CudaBackend
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.engine.cuda.availability import check_card
from snapjump.engine.cuda.plan import make_plan
from snapjump.engine.queue import Queue
from snapjump.engine.recorder.none import NoRecorder
from snapjump.engine.work import FIELDS, count_of, make_memory
from snapjump.scenes.runner import March, Progress

Array = NDArray[np.float64]
PASSES_PER_LAUNCH = 250  # about a quarter of a second for a full card
SHARED = ("numbers", "state", "velocity", "acceleration", "status", "outcome")


def check_backend(simulation: Simulation) -> None:
    """Raises ParameterError where the backend lacks what it runs on."""
    if isinstance(simulation.backend, CudaBackend):
        check_card(simulation.backend.device)


def march_on(simulation: Simulation) -> type[March]:
    """The kind of march that the simulation's backend runs."""
    return CardMarch if isinstance(simulation.backend, CudaBackend) else March


@dataclass
class CardMarch(March):
    """Robots that are simulated on a card, one in each of its threads.

    Here are the queue of all of them and the memory of one, whose shapes the card's have.
    """

    def __post_init__(self) -> None:
        from snapjump.engine.cuda.card import Card

        if not isinstance(self.recorder, NoRecorder):
            raise ParameterError(
                "backend", "cuda", "scalar or lanes for more than outcomes, which need a recorder"
            )
        self.lanes = self.threads = 1
        super().__post_init__()
        self.passes_of_threads: list[NDArray[np.int64]] = []  # of every chunk
        backend = self.simulation.backend
        self.plan = make_plan(
            len(self.models),
            self.bytes_a_thread(),
            sum(getattr(self.queue, name)[:1].nbytes for name in SHARED),
            backend.memory_gib,
            backend.threads_per_block,
        )
        self.card = Card(backend.device, self.plan)
        self.card.check_room(backend.memory_gib)

    def bytes_a_thread(self) -> int:
        """Memory that a robot is simulated in."""
        return 8 * count_of(FIELDS, self.sizes(1))

    def memory_on_card(self) -> Any:
        """Memory for all threads of the plan."""

        def allocate(shape: tuple[int, int]) -> Any:
            return self.card.zeros(shape[0] * shape[1]).reshape(shape)

        memory = make_memory(self.sizes(self.plan.threads), self.mesh, allocate)
        return memory._replace(mesh=self.card.send(self.mesh))

    def queues_on_card(self) -> Iterator[tuple[slice, Queue]]:
        """The queue in parts that fit the card, each with fresh counts."""
        threads = self.plan.threads
        for part in self.plan.chunks(len(self.models)):
            counts = np.zeros((threads, 2), dtype=np.int64)
            counts[:, 0] = -1
            yield (
                part,
                self.card.send(
                    self.queue._replace(
                        **{name: getattr(self.queue, name)[part] for name in SHARED},
                        cursor=np.zeros(2, dtype=np.int64),
                        counts=counts,
                        carried=np.full(threads, -1, dtype=np.int64),
                    )
                ),
            )

    def find_starts(self, progress: Progress | None = None) -> None:
        """Replace the states by the equilibria that the march begins from."""
        from snapjump.engine.cuda import kernels

        robots = len(self.models)
        begun = self.card.kernel_seconds
        common = self.card.send((self.model, self.masses)) + (self.memory_on_card(),)
        for part, queue in self.queues_on_card():
            if part.start == 0:
                self.card.compile(kernels.find_starts, *common, queue, 0)
            for first in range(part.start, part.stop, self.plan.threads):
                self.card.run(kernels.find_starts, *common, queue, 1)
                if progress is not None:
                    done = min(first + self.plan.threads, part.stop)
                    progress(done / robots, "finding starts")
            for name in ("state", "velocity", "acceleration", "status"):
                getattr(self.queue, name)[part] = self.card.fetch(getattr(queue, name))
        self.crew[0].kernel_seconds += self.card.kernel_seconds - begun

    def run(self, progress: Progress | None = None) -> Array:
        """Simulate all robots; returns the outcome (robots, COLUMNS).

        ``progress`` is told the share of the robots that are done.
        """
        from snapjump.engine.cuda import kernels

        robots = len(self.models)
        begun = self.card.kernel_seconds
        fixed = (self.model, self.masses, self.method, self.recorder)
        common = self.card.send(fixed) + (self.memory_on_card(),)
        for part, queue in self.queues_on_card():
            if part.start == 0:
                self.card.compile(kernels.march, *common, queue, 0)
            under_way = 1
            while under_way > 0:
                self.card.run(kernels.march, *common, queue, PASSES_PER_LAUNCH)
                counts = self.card.fetch(queue.counts)
                under_way = int(counts[:, 0].sum())
                if progress is not None:
                    taken = min(int(self.card.fetch(queue.cursor)[1]), part.stop - part.start)
                    progress((part.start + taken - under_way) / robots, "marching")
            self.queue.outcome[part] = self.card.fetch(queue.outcome)
            self.queue.counts[1] += int(counts[:, 1].sum())
            self.passes_of_threads.append(counts[:, 1])
        self.crew[0].kernel_seconds += self.card.kernel_seconds - begun
        return self.queue.outcome
