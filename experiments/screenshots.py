"""MLflow as a reader of the records sees it: ``python -m experiments.screenshots`` makes pictures.

In an empty folder a few jumps, a sweep, a dataset and a training are recorded; MLflow's own server
shows them, and a real browser takes docs/mlflow-runs.png (the list), docs/mlflow-compare.png (the
cells of the sweep) and docs/mlflow-training.png (the curves of a training). Needs
``pip install playwright`` and Chromium, from the system's packages (``--browser``).
"""

import os
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from .command import measured

ROOT = Path(__file__).resolve().parents[1]
DOCS = ROOT / "docs"
DRAFT = ("accuracy=draft", "figures=false")
COMMANDS = (
    ("design.epsilon=0.25", "accuracy=draft"),
    ("environment.mu=0.5", "contact=penalty", *DRAFT),
    ("-m", "design.epsilon=0.1,0.15,0.2,0.25,0.3", "environment.mu=0.2,0.4", *DRAFT),
    ("task=dataset", "plan=sobol", "plan.count=512", "dataset.path=drafts", *DRAFT),
    ("task=train", "dataset.path=drafts", "training.epochs=400", "figures=false"),
    ("task=inverse", "target_mm=[60,240]", *DRAFT),
)
START_S, SETTLE_MS = 60.0, 4000
WIDTH, HEIGHT = 1900, 800
COLUMNS = ("x_bar", "y_bar", "mae_bar", "tier")
CURVES = "train_loss|validation_mae|learning"  # of a training, by their names
FLAGS = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--no-first-run"]


def report(browser: str = "/usr/bin/chromium") -> dict[str, int]:
    """Record, serve, look; returns the bytes of each picture."""
    with tempfile.TemporaryDirectory() as folder:
        for command in COMMANDS:
            call = [sys.executable, str(ROOT / "run.py"), *command]
            subprocess.run(call, cwd=folder, check=True, stdout=subprocess.DEVNULL)
        with served(Path(folder)) as address:
            pictures = taken(address, runs_of(Path(folder)), browser)
    return {path.name: path.stat().st_size for path in pictures}


def runs_of(folder: Path) -> dict[str, list[str]]:
    """Ids of the experiment, of the sweep's cells, and of the training."""
    from mlflow.tracking import MlflowClient

    client = MlflowClient(f"sqlite:///{folder / 'mlruns.db'}")
    experiment = client.get_experiment_by_name("snapjump")
    assert experiment is not None
    runs = client.search_runs([experiment.experiment_id])
    by_task = {run.data.tags["task"]: run.info.run_id for run in runs}
    cells = [r for r in runs if r.data.tags.get("mlflow.parentRunId") == by_task["sweep"]]
    return {
        "experiment": [experiment.experiment_id],
        "cells": [run.info.run_id for run in cells],
        "training": [by_task["train"]],
    }


@contextmanager
def served(folder: Path) -> Iterator[str]:
    """The address of MLflow's server over the records of a folder."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    command = [sys.executable, "-m", "mlflow", "server", "--port", str(port)]
    command += ["--backend-store-uri", f"sqlite:///{folder / 'mlruns.db'}"]
    quiet: Any = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    environment = {**os.environ, "MLFLOW_DISABLE_TELEMETRY": "true"}
    server = subprocess.Popen(command, cwd=folder, env=environment, start_new_session=True, **quiet)
    try:
        end = time.monotonic() + START_S
        while time.monotonic() < end:
            try:
                urllib.request.urlopen(f"http://127.0.0.1:{port}/health", timeout=1.0).close()
                break
            except OSError:
                time.sleep(0.5)
        yield f"http://127.0.0.1:{port}"
    finally:
        os.killpg(server.pid, 15)
        server.wait()


def taken(address: str, ids: dict[str, list[str]], browser: str) -> list[Path]:
    """The pictures."""
    from playwright.sync_api import sync_playwright

    (experiment,), (training,) = ids["experiment"], ids["training"]
    cells = ",".join(f'"{run}"' for run in ids["cells"])
    pages = {
        "mlflow-runs": f"#/experiments/{experiment}/runs",
        "mlflow-compare": f'#/compare-runs?runs=[{cells}]&experiments=["{experiment}"]',
        "mlflow-training": f"#/experiments/{experiment}/runs/{training}/model-metrics",
    }
    written = []
    with sync_playwright() as play:
        window = play.chromium.launch(executable_path=browser, args=FLAGS)
        page = window.new_page(viewport={"width": WIDTH, "height": HEIGHT})
        page.goto(address)
        page.get_by_text("Model training", exact=True).first.click()
        for name, place in pages.items():
            page.goto(f"{address}/{place}")
            page.wait_for_timeout(SETTLE_MS)
            for button in page.get_by_role("button", name="Close").all():
                button.click()  # what would explain itself beside it
            if name == "mlflow-runs":
                choose_columns(page)
            if name == "mlflow-training":
                page.get_by_placeholder("Search metric charts").fill(CURVES)
            page.wait_for_timeout(SETTLE_MS)
            written.append(DOCS / f"{name}.png")
            page.screenshot(path=str(written[-1]))
        window.close()
    return written


def choose_columns(page: Any) -> None:
    """Show numbers and tags that runs are compared by."""
    page.get_by_role("button", name="Columns", exact=True).click()
    for name in COLUMNS:
        page.get_by_placeholder("Search columns").fill(name)
        page.get_by_text(name, exact=True).last.click()
    page.keyboard.press("Escape")


if __name__ == "__main__":
    measured(report)
