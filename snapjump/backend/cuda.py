"""``backend=cuda``: one robot a thread of an NVIDIA card."""

from snapjump.backend.base import BackendOptions
from snapjump.checks import ParameterError
from snapjump.declare.fields import integer, number

WARP = 32  # threads of a card that march in step
LARGEST_BLOCK = 256  # whose threads still find registers


class CudaBackend(BackendOptions):
    """One robot a thread of an NVIDIA card: for batches, outcomes only.
    As many robots at once as fit ``memory_gib`` of the card's memory, the others follow."""

    processor = "cuda"
    differentiable = False

    device: int = integer(0, least=0, most=1023)
    memory_gib: float = number(4.0, above=0.0, most=1024.0, unit="GiB")
    threads_per_block: int = integer(64, least=WARP, most=LARGEST_BLOCK)

    def __post_init__(self) -> None:
        super().__post_init__()
        block = self.threads_per_block
        if block % WARP:
            raise ParameterError("backend.threads_per_block", block, f"a multiple of {WARP}")

    @property
    def width(self) -> int:
        """Robots side by side in a thread."""
        return 1
