"""Tasks by name. A new one is a file here, a YAML in ``conf/task`` and a line in TASKS.

Studies live in ``experiments`` (:mod:`snapjump.run.studies`); all else is the same.
"""

from importlib import import_module

from snapjump.checks import check_choice
from snapjump.files.layout import STUDIES, importable
from snapjump.run.tasks.base import Task

TASKS = {
    "simulate": "snapjump.run.tasks.simulate:Simulate",
    "dataset": "snapjump.run.tasks.dataset:GenerateDataset",
    "train": "snapjump.run.tasks.train:Train",
    "export": "snapjump.run.tasks.export:Export",
    "inverse": "snapjump.run.tasks.inverse:InverseDesign",
    "compare_surrogates": "experiments.surrogates.study:CompareSurrogates",
    "inverse_benchmark": "experiments.inverse_benchmark.study:InverseBenchmark",
    "paper": "experiments.paper.study:Paper",
    "tradeoff": "experiments.tradeoff.study:Tradeoff",
    "convergence": "experiments.convergence.study:Convergence",
    "stability": "experiments.stability.study:Stability",
    "robustness": "experiments.robustness.study:Robustness",
    "scenes": "experiments.scenes.study:Scenes",
    "released": "experiments.released.study:Released",
    "benchmarks": "experiments.benchmarks.study:Benchmarks",
}


def find_task(name: str) -> Task:
    """A new instance of the task; its module is imported only now."""
    check_choice("task.name", name, tuple(TASKS))
    module, cls = TASKS[name].split(":")
    task: Task = getattr(import_module(importable(module)), cls)()
    return task


def is_study(name: object) -> bool:
    """Whether a task leaves a report that can be published."""
    return str(TASKS.get(str(name), "")).startswith(STUDIES)
