"""Other processors, as far as the libraries can be told to take this one for them."""

import os
from collections.abc import Mapping
from importlib import import_module

AVX512 = "X86_V4 AVX512F AVX512CD AVX512_SKX AVX512_CLX AVX512_CNL AVX512_ICL AVX512_SPR"
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


def environment(name: str) -> dict[str, str]:
    """Variables of a child process that runs as that processor would."""
    return {**os.environ, **SETTINGS[name]}


def check_imitation(name: str) -> None:
    """Require that numpy, in this process, uses nothing that the processor lacks.

    numpy passes over names that it does not know in silence.
    """
    umath = import_module("numpy._core._multiarray_umath")
    features: Mapping[str, bool] = umath.__cpu_features__

    level, feature = FORBIDDEN[name]
    lacking = level if level in features else feature
    if features.get(lacking):
        raise SystemExit(f"numpy still uses {lacking}: this is no {name}")
