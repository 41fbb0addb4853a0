"""Packages that only parts of Snapjump need, and the extra of ours that installs each.

Whoever lacks one is told in a line: ``pip install 'snapjump[learn]'``.
"""

from collections.abc import Iterator
from contextlib import contextmanager

EXTRAS = {
    "run": ("hydra", "hydra_plugins", "joblib", "omegaconf", "mlflow", "markdown_it"),
    "data": ("pandas", "pyarrow"),
    "learn": (
        *("torch", "pytorch_lightning", "safetensors", "onnx", "onnxscript", "onnxruntime"),
        *("shapely", "bayes_opt", "threadpoolctl"),
    ),
    "cluster": ("distributed", "dask", "cryptography", "submitit"),
    "cuda": ("numba_cuda",),
}
TORCH = "; torch without CUDA first: pip install torch==2.13.0 --index-url https://download.pytorch.org/whl/cpu"


class MissingExtraError(ModuleNotFoundError):
    """A package that an extra of ours installs is not there."""


def explained(error: ModuleNotFoundError) -> ModuleNotFoundError:
    """The error with the extra that helps; as it is where none does."""
    package = (error.name or "").partition(".")[0]
    for extra, packages in EXTRAS.items():
        if package in packages:
            build = TORCH if extra == "learn" else ""
            told = f"{package} is not installed: pip install 'snapjump[{extra}]'{build}"
            return MissingExtraError(told, name=error.name)
    return error


@contextmanager
def extras_named() -> Iterator[None]:
    """Have a package that is missing in the block told with its extra."""
    try:
        yield
    except MissingExtraError:
        raise
    except ModuleNotFoundError as error:
        told = explained(error)
        if told is error:
            raise
        raise told from None
