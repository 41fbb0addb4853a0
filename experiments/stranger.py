"""A stranger's walk through Snapjump, from a wheel: ``python -m experiments.stranger``.

In an empty folder with an environment of its own, and no repository: a jump, a sweep and its
comparison in MLflow, a forward model of 64 drafts, a design for a target, a contact law of one's
own. Prints one JSON object with the seconds of each step; ends with what a step said that fails.
``--cache``: a folder whose compiled kernels are used; by default all are compiled, as a stranger
must.
"""

import os
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from .command import measured

ROOT = Path(__file__).resolve().parents[1]
LAW_PAGE = ROOT / "docs" / "adding_a_contact_law.md"
TORCH, TORCH_CPU = "torch==2.13.0", "https://download.pytorch.org/whl/cpu"
DRAFT = ("accuracy=draft", "figures=false")
COMPARE = """
from mlflow.tracking import MlflowClient
client = MlflowClient("sqlite:///mlruns.db")
experiment = client.get_experiment_by_name("snapjump")
assert experiment.tags["mlflow.experimentKind"] == "custom_model_development"
parents = client.search_runs([experiment.experiment_id], "tags.task = 'sweep'")
children = [run for run in client.search_runs([experiment.experiment_id])
            if run.data.tags.get("mlflow.parentRunId") == parents[0].info.run_id]
for run in children:
    print(run.info.run_name, run.data.metrics["y_bar"])
"""
SHOW = """
import snapjump
jump = snapjump.simulate_jump(accuracy="draft", design={{"delta_alpha_deg": 5}})
print(repr(jump))
jump.plot().save("mine.png")
assert snapjump.__file__.startswith({prefix!r}), snapjump.__file__
"""


class Walk:
    """An empty folder, an environment, and what has been done there."""

    def __init__(self, folder: Path, cache: str):
        self.folder, self.home = folder / "work", folder / "environment"
        self.folder.mkdir()
        self.seconds: dict[str, float] = {}
        self.environment = {**os.environ, "XDG_CACHE_HOME": cache or str(folder / "cache")}
        for name in ("NUMBA_CACHE_DIR", "VIRTUAL_ENV", "PYTHONPATH", "MLFLOW_TRACKING_URI"):
            self.environment.pop(name, None)

    @property
    def bin(self) -> Path:
        """Where the environment's programs are."""
        return self.home / "bin"

    def call(self, *command: str | Path) -> str:
        """What a command prints; ends the walk where it fails."""
        done = subprocess.run(
            list(map(str, command)),
            cwd=self.folder,
            env=self.environment,
            capture_output=True,
            text=True,
        )
        if done.returncode != 0:
            sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
        return done.stdout

    def snapjump(self, *arguments: str) -> str:
        """What the command prints."""
        return self.call(self.bin / "snapjump", *arguments)

    def step(self, name: str, work: Callable[[], Any]) -> None:
        """Do a part of the walk, and keep its time."""
        begun = time.perf_counter()
        work()
        self.seconds[name] = round(time.perf_counter() - begun, 1)
        print(f"{name}: {self.seconds[name]} s", file=sys.stderr, flush=True)

    def install(self) -> None:
        """The wheel, with what a command line and training need."""
        self.call(sys.executable, "-m", "venv", self.home)
        pip = (self.bin / "python", "-m", "pip", "install", "--quiet")
        self.call(*pip, "uv")
        self.call(*pip, "wheel")
        wheels = self.folder.parent / "wheels"
        self.call(*pip[:3], "wheel", "--quiet", "--no-deps", "--wheel-dir", wheels, ROOT)
        (wheel,) = wheels.glob("snapjump-*.whl")
        self.call(*pip, TORCH, *(("--index-url", TORCH_CPU) if answers() else ()))
        place = ("--python", self.bin / "python")
        self.call(self.bin / "uv", "pip", "install", "--quiet", *place, f"{wheel}[run,learn]")

    def jump(self) -> None:
        """One, from the command line and from Python."""
        assert "apex" in self.snapjump()
        self.call(self.bin / "python", "-c", SHOW.format(prefix=str(self.home)))
        assert (self.folder / "mine.png").stat().st_size > 10_000

    def sweep(self) -> None:
        """Three jumps, and one more."""
        self.snapjump("-m", "design.epsilon=0.15,0.2,0.25", *DRAFT)
        told = self.snapjump("-m", "design.epsilon=0.15,0.2,0.25,0.3", *DRAFT)
        assert told.count("(kept)") == 3

    def compare(self) -> None:
        """The cells of the sweep, in MLflow."""
        lines = self.call(self.bin / "python", "-c", COMPARE).splitlines()
        found = dict(line.split() for line in lines)
        heights = [float(found[f"epsilon={value}"]) for value in ("0.15", "0.2", "0.25", "0.3")]
        assert heights == sorted(heights)

    def train(self) -> None:
        """A forward model of few jumps."""
        self.snapjump("task=dataset", "plan=sobol", "plan.count=64", "dataset.path=drafts", *DRAFT)
        few = ("training.validation_share=0.2", "training.epochs=120")
        told = self.snapjump("task=train", "dataset.path=drafts", *few, "figures=false")
        assert "MAE" in told

    def design(self) -> None:
        """What reaches a target, by that model and simulations."""
        (checkpoint,) = self.folder.glob("outputs/training/*/forward_model.safetensors")
        what = ("task=inverse", "target_mm=[60,240]", f"checkpoint={checkpoint}")
        told = self.snapjump(*what, *DRAFT)
        assert "build" in told and "clear span" in told

    def law(self) -> None:
        """One's own contact law, as the documentation has it."""
        python, numbers = law_blocks()
        place = self.folder / "mine" / "contact"
        place.mkdir(parents=True)
        (place / "cone.py").write_text(python, encoding="utf-8")
        (place / "cone.yaml").write_text(numbers, encoding="utf-8")
        told = self.snapjump("plugins=mine", "sim=bounce", "contact=cone", "figures=false")
        assert "restitution" in told


def law_blocks() -> tuple[str, str]:
    """The two files of the page on contact laws."""
    page = LAW_PAGE.read_text(encoding="utf-8")
    (python,) = [text for text in blocks(page, "python") if "class Cone" in text]
    (numbers,) = blocks(page, "yaml")
    return python, numbers


def blocks(page: str, language: str) -> list[str]:
    """Fenced code of a language."""
    return re.findall(rf"```{language}\n(.*?)```", page, re.DOTALL)


def answers() -> bool:
    """Whether torch's own index does, within ten seconds."""
    from urllib.error import URLError
    from urllib.request import urlopen

    try:
        with urlopen(f"{TORCH_CPU}/torch/", timeout=10.0):
            return True
    except (URLError, TimeoutError):
        return False


def report(cache: str = "") -> dict[str, float]:
    """Walk all of it; ``cache``: the folder of a cache to use."""
    with tempfile.TemporaryDirectory() as folder:
        walk = Walk(Path(folder), cache)
        for name in ("install", "jump", "sweep", "compare", "train", "design", "law"):
            walk.step(name, getattr(walk, name))
        return {**walk.seconds, "total": round(sum(walk.seconds.values()), 1)}


if __name__ == "__main__":
    measured(report)
