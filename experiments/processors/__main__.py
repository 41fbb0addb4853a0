"""The same bits on every processor: ``python -m experiments.processors``.

Computes hashes here and in child processes that take this processor for others, as far as the
libraries can be told to, side by side, and prints them as one JSON object; exit code 1 if any
differ.
"""

import argparse
import json
import os
import subprocess
import sys
from collections.abc import Mapping
from importlib import import_module

from .hashes import HASHES

AVX512 = "X86_V4 AVX512F AVX512CD AVX512_SKX AVX512_CLX AVX512_CNL AVX512_ICL AVX512_SPR"
# Variables of a child process that runs as that processor would.
SETTINGS: Mapping[str, Mapping[str, str]] = {
    # The kernels are compiled for it too.
    "avx2": {
        "OPENBLAS_CORETYPE": "Haswell",
        "NPY_DISABLE_CPU_FEATURES": AVX512,
        "NUMBA_CPU_NAME": "haswell",
        "NUMBA_CPU_FEATURES": "",
    },
    # numpy, OpenBLAS and the C library without fused multiply-adds; kernels stay as they are.
    "sse": {
        "OPENBLAS_CORETYPE": "Nehalem",
        "NPY_DISABLE_CPU_FEATURES": f"X86_V3 AVX2 FMA3 {AVX512}",
        "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-AVX2_Usable,-FMA_Usable",
    },
}
# What numpy must then lack, by its own list: of levels since 2.4, of single features before.
FORBIDDEN = {"avx2": ("X86_V4", "AVX512F"), "sse": ("X86_V3", "AVX2")}


def check_imitation(name: str) -> None:
    """Require that numpy, in this process, uses nothing that the processor lacks.
    numpy passes over names that it does not know in silence."""
    umath = import_module("numpy._core._multiarray_umath")
    features: Mapping[str, bool] = umath.__cpu_features__

    level, feature = FORBIDDEN[name]
    lacking = level if level in features else feature
    if features.get(lacking):
        raise SystemExit(f"numpy still uses {lacking}: this is no {name}")


def main() -> int:
    """Compute or compare."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", choices=list(SETTINGS), help="hashes of this process alone")
    asked = parser.parse_args().only
    if asked:
        check_imitation(asked)
        print(json.dumps({name: compute() for name, compute in HASHES.items()}))
        return 0
    command = [sys.executable, "-m", "experiments.processors", "--only"]
    children = {
        name: subprocess.Popen(
            [*command, name], env={**os.environ, **variables}, stdout=subprocess.PIPE, text=True
        )
        for name, variables in SETTINGS.items()
    }
    found = {"here": {name: compute() for name, compute in HASHES.items()}}
    for name, child in children.items():
        told, _ = child.communicate()
        if child.returncode != 0:
            return 1
        found[name] = json.loads(told)
    print(json.dumps(found, indent=2))
    return int(any(hashes != found["here"] for hashes in found.values()))


if __name__ == "__main__":
    sys.exit(main())
