"""The card as a march sees it: memory, programs, their time, and what is carried to and fro."""

from typing import Any

import numpy as np
from numba import cuda
from numpy.typing import NDArray

from snapjump.checks import ParameterError
from snapjump.engine.cuda.availability import simulated
from snapjump.engine.cuda.kernels import clear
from snapjump.engine.cuda.plan import GIB, Plan
from snapjump.engine.cuda.rounding import rounded_as_written
from snapjump.number.announcement import announce


class Program:
    """A kernel with its grid: called like a function, it is queued and runs by itself."""

    def __init__(self, kernel: Any, plan: Plan):
        self.kernel = kernel
        self.grid = plan.blocks, plan.threads_per_block

    @property
    def signatures(self) -> Any:
        """What it has been compiled for."""
        return self.kernel.overloads

    def __call__(self, *arguments: Any) -> None:
        if not simulated():
            from snapjump.engine.cuda.methods import register_methods

            register_methods()
        with rounded_as_written():
            self.kernel[self.grid](*arguments)


class Card:
    """One device and what has been asked of it: seconds of kernels, bytes to and from it."""

    def __init__(self, device: int, plan: Plan):
        cuda.select_device(device)
        self.plan = plan
        self.kernel_seconds = 0.0
        self.bytes_sent = 0
        self.bytes_fetched = 0

    def check_room(self, memory_gib: float) -> None:
        """Raises ParameterError where the device has less memory."""
        total = cuda.current_context().get_memory_info().total / GIB
        if memory_gib > total:
            raise ParameterError(
                "backend.memory_gib", memory_gib, f"at most {total:.3g} GiB, which the card has"
            )

    def zeros(self, count: int) -> Any:
        """So many doubles. Raises ParameterError where other programs left no room for them."""
        try:
            numbers = cuda.device_array(count)
        except Exception as error:  # the driver's own class is another one in the simulator
            if "OUT_OF_MEMORY" not in str(error):
                raise
            needed = f"{8 * count / GIB:.3g} GiB"
            raise ParameterError(
                "backend.memory_gib", needed, "what other programs leave free of the card's memory"
            ) from error
        Program(clear, self.plan)(numbers)
        return numbers

    def send(self, value: Any) -> Any:
        """A copy of an array there, or of a tuple with all arrays in it; numbers as they are."""
        if isinstance(value, tuple):
            parts = [self.send(part) for part in value]
            return type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
        if not isinstance(value, np.ndarray):
            return value
        self.bytes_sent += value.nbytes
        return cuda.to_device(np.ascontiguousarray(value))

    def fetch(self, array: Any) -> NDArray[Any]:
        """A copy of an array from there."""
        values: NDArray[Any] = array.copy_to_host()
        self.bytes_fetched += values.nbytes
        return values

    def compile(self, kernel: Any, *arguments: Any) -> None:
        """Call a kernel that has nothing to do, telling the user if it is compiled first."""
        program = Program(kernel, self.plan)
        if not program.signatures:
            announce("cuda")
        program(*arguments)
        cuda.synchronize()

    def run(self, kernel: Any, *arguments: Any) -> None:
        """Call a compiled kernel, wait for its end and add its time."""
        begun, ended = cuda.event(), cuda.event()
        begun.record()
        Program(kernel, self.plan)(*arguments)
        ended.record()
        ended.synchronize()
        self.kernel_seconds += 1e-3 * begun.elapsed_time(ended)
