"""Programs that count what they do: the operations of compiled code, and the lines it touches.

A program is linked and optimised as ever. Then each of its blocks is made to count how often it
runs, and each load and store of numbers to note its address. So what is counted is what LLVM left
of the source; numbers that its code generator parks on the stack are not.
"""

import re
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from types import FunctionType
from typing import Any, NamedTuple

import llvmlite.binding as llvm
import numpy as np
from numba import njit

from snapjump.number.linking import Program, compiler

from ..gpu_traffic import Cache

CACHE = Path("/sys/devices/system/cpu/cpu0/cache/index0/size")
LINE_BYTES = 64
ROOM = 2**23  # for addresses, of the accesses of one count
NUMBERS = r"(?:double|<\d+ x double>)"
LABEL = re.compile(r'^(?:[\w.$-]+|"[^"]*"):')
OPERATION = re.compile(rf" = (fadd|fsub|fmul|fdiv) {NUMBERS}|@llvm\.(fma|sqrt)\.\w+\(")
ACCESS = re.compile(rf"^ +(?:\S+ = load {NUMBERS}|(store) {NUMBERS} .+), ptr (.+), align")
SUFFIX = "_with_ledger"
KINDS = {
    "fadd": "sums", "fsub": "sums", "fmul": "products", "fma": "fused", "fdiv": "quotients",
    "sqrt": "roots",
}  # fmt: skip


class Operations(NamedTuple):
    """Operations on numbers, or on lanes of them, and lines that come into the fastest cache,
    which forgets what was used longest ago: those that leave it as they came, and those that are
    written back."""

    sums: float
    products: float
    fused: float
    quotients: float
    roots: float
    lines_read: float
    lines_written: float


def cache_lines() -> int:
    """Lines of this processor's fastest cache of data, as Linux tells; elsewhere 512, which every
    processor of today has."""
    told = CACHE.read_text() if CACHE.exists() else "32K"
    return 1024 * int(told.strip().removesuffix("K")) // LINE_BYTES


class Ledger:
    """What one program has done since it was last asked."""

    def __init__(self) -> None:
        self.blocks: list[Counter[str]] = []
        self.runs = np.zeros(0, dtype=np.int64)  # of every block
        self.accesses = np.zeros(ROOM, dtype=np.int64)  # an address, and 1 more if it is written
        self.noted = np.zeros(1, dtype=np.int64)
        self.cache = Cache(cache_lines())

    def instrument(self, text: str) -> str:
        """The program, in LLVM's language, with its books kept."""
        lines: list[str] = []
        self.runs = np.zeros(text.count("\n"), dtype=np.int64)
        inside = begins = False
        for line in text.splitlines():
            if line.startswith("define "):
                inside = begins = True
            elif line == "}":
                inside = False
            elif inside and LABEL.match(line):
                begins = True
            elif inside and line:
                if begins and " = phi " not in line:
                    begins = False
                    lines += self._block()
                lines += self._noted(line, len(lines))
            lines.append(line)
        return "\n".join(lines)

    def _block(self) -> list[str]:
        """Another block, which counts how often it runs."""
        number = len(self.blocks)
        self.blocks.append(Counter())
        return added(self.runs[number:], f"%runs.{number}")

    def _noted(self, line: str, name: int) -> list[str]:
        """What notes the access of an instruction, if it is one; its operation is entered."""
        operation = OPERATION.search(line)
        if operation:
            self.blocks[-1][KINDS[operation[1] or operation[2]]] += 1
        access = ACCESS.match(line)
        if not access:
            return []
        written, pointer = access.groups()
        return [
            *added(self.noted, f"%noted.{name}"),
            f"  %place.{name} = and i64 %noted.{name}, {ROOM - 1}",
            f"  %entry.{name} = getelementptr i64, {address(self.accesses)}, i64 %place.{name}",
            f"  %number.{name} = ptrtoint ptr {pointer} to i64",
            f"  %marked.{name} = or i64 %number.{name}, {int(bool(written))}",
            f"  store i64 %marked.{name}, ptr %entry.{name}",
        ]

    def operations(self, count: int) -> Operations:
        """What was done since the last time, over ``count``."""
        total: Counter[str] = Counter()
        for block, runs in zip(self.blocks, self.runs.tolist(), strict=False):
            total.update({kind: runs * number for kind, number in block.items()})
        if self.noted[0] > ROOM:
            raise RuntimeError(f"{self.noted[0]} accesses, with room for {ROOM}")
        cache = self.cache
        misses, written = cache.misses, cache.writes
        for access in self.accesses[: self.noted[0]].tolist():
            cache.touch(access // LINE_BYTES, bool(access & 1))
        written = cache.writes - written
        read = cache.misses - misses - written
        self.runs[:] = self.noted[:] = 0
        done = [total[kind] for kind in Operations._fields[:-2]]
        return Operations(*[number / count for number in (*done, read, written)])


def address(array: Any) -> str:
    """Where an array's first number is, in LLVM's language."""
    return f"ptr inttoptr (i64 {array.ctypes.data} to ptr)"


def added(counter: Any, name: str) -> list[str]:
    """Add one to a counter; ``name``: of what it was before."""
    place = address(counter)
    return [
        f"  {name} = load i64, {place}",
        f"  {name}.more = add i64 {name}, 1",
        f"  store i64 {name}.more, {place}",
    ]


def with_ledger(function: Callable[..., Any]) -> tuple[Any, Ledger]:
    """A function that is compiled, for its first arguments, with a ledger of its own."""
    ledger = Ledger()

    class Instrumented(Program):
        """A program whose books are kept."""

        def _optimize_final_module(self) -> None:
            super()._optimize_final_module()
            module = llvm.parse_assembly(ledger.instrument(self.get_llvm_str()))
            for part in module.functions:
                if not part.is_declaration and SUFFIX not in part.name:
                    part.linkage = "internal"  # else the one of any other program would be called
            self._final_module = module

    # Under a name of its own: numba finds programs by their names, those on disk too.
    named = FunctionType(function.__code__, function.__globals__)
    named.__qualname__ = f"{function.__qualname__}{SUFFIX}"
    pipeline = compiler(Instrumented)
    return njit(error_model="numpy", pipeline_class=pipeline)(named), ledger
