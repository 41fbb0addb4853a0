"""Memory that lanes can be loaded from."""

import numpy as np
from numpy.typing import NDArray

ALIGNMENT_BYTES = 256  # of eight lanes with four slopes each


def aligned_zeros(shape: tuple[int, ...]) -> NDArray[np.float64]:
    """Zeros of the given shape, C-contiguous, that start on a 256-byte boundary."""
    count = int(np.prod(shape))
    spare = ALIGNMENT_BYTES // 8
    buffer = np.zeros(count + spare)
    offset = (-buffer.ctypes.data % ALIGNMENT_BYTES) // 8
    return buffer[offset : offset + count].reshape(shape)
