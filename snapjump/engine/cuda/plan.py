"""Division of a card's memory: how many robots are simulated at once, and in how many chunks."""

from typing import NamedTuple

from snapjump.checks import ParameterError

GIB = 2.0**30
# A chunk of the queue that much longer than there are threads keeps most of them busy to its end.
ROBOTS_A_THREAD = 8


class Plan(NamedTuple):
    """Blocks of threads with memory for one robot each, and robots of the queue at a time."""

    blocks: int
    threads_per_block: int
    robots: int

    @property
    def threads(self) -> int:
        """Robots under way at once."""
        return self.blocks * self.threads_per_block

    def chunks(self, robots: int) -> list[slice]:
        """Parts of a queue that are on the card at a time."""
        return [slice(k, min(k + self.robots, robots)) for k in range(0, robots, self.robots)]


def make_plan(
    robots: int, bytes_a_thread: int, bytes_a_robot: int, memory_gib: float, threads_per_block: int
) -> Plan:
    """The plan for so many robots within a bound on memory.

    ``bytes_a_thread``: memory to simulate in; ``bytes_a_robot``: a row of the queue. Raises
    ParameterError where not even one block fits.
    """
    block = threads_per_block * (bytes_a_thread + ROBOTS_A_THREAD * bytes_a_robot)
    most = int(memory_gib * GIB / block)
    if most == 0:
        raise ParameterError(
            "backend.memory_gib",
            memory_gib,
            f"at least {block / GIB:.3g} GiB for a block of {threads_per_block} robots of this "
            "mesh (backend.threads_per_block)",
        )
    blocks = min(most, -(-robots // threads_per_block))
    return Plan(blocks, threads_per_block, ROBOTS_A_THREAD * blocks * threads_per_block)
