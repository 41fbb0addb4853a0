"""Four jumps, two at a time, recorded on a real tracking server."""

import os
import shutil
import socket
import subprocess
import sys
import time
import urllib.request
from collections.abc import Iterator
from pathlib import Path

import pytest

from .conftest import SWEEP, TWO_AT_A_TIME

START_TIMEOUT_S = 120.0


@pytest.fixture
def server(tables, tmp_path) -> Iterator[str]:
    """The address of an ``mlflow server`` without records on loopback."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    uri, store = f"http://127.0.0.1:{port}", tmp_path / "server"
    store.mkdir()
    shutil.copy(tables, store / "store.db")
    with open(store / "log", "wb") as log:
        process = subprocess.Popen(
            [sys.executable, "-m", "mlflow", "server", "--host", "127.0.0.1", "--port", str(port)]
            + ["--workers", "1", "--backend-store-uri", f"sqlite:///{store}/store.db"]
            + ["--artifacts-destination", str(store / "artifacts")],
            stdout=log,
            stderr=log,
            cwd=store,
            env={**os.environ, "MLFLOW_DISABLE_TELEMETRY": "true"},
            start_new_session=True,
        )
    try:
        wait_until_it_answers(process, uri, store / "log")
        yield uri
    finally:
        # The server's workers are its children: the whole session goes.
        os.killpg(process.pid, 9)
        process.wait()


def wait_until_it_answers(process: "subprocess.Popen[bytes]", uri: str, log: Path) -> None:
    end = time.monotonic() + START_TIMEOUT_S
    while time.monotonic() < end:
        assert process.poll() is None, log.read_text()
        try:
            urllib.request.urlopen(f"{uri}/health", timeout=1)
        except OSError:
            time.sleep(0.2)
        else:
            return
    raise AssertionError(f"no answer from {uri}: {log.read_text()}")


def test_a_sweep_on_a_server(process, server, check_sweep, tmp_path):
    done = process(*SWEEP, *TWO_AT_A_TIME, "tracking=server", f"tracking.uri={server}")
    assert done.returncode == 0, done.stderr + done.stdout
    assert "4 cells: 4 ok" in done.stdout
    check_sweep(server, tmp_path)
    assert not (tmp_path / "mlruns.db").exists() and not (tmp_path / "mlruns").exists()


def test_a_server_that_is_not_there_is_bad_input(command):
    with socket.socket() as unused:
        unused.bind(("127.0.0.1", 0))
        uri = f"http://127.0.0.1:{unused.getsockname()[1]}"
        done = command("tracking=server", f"tracking.uri={uri}")
        sweep = command(*SWEEP, "tracking=server", f"tracking.uri={uri}")
    for process in (done, sweep):
        assert process.returncode == 2
        assert process.stderr.startswith(f"tracking.uri = '{uri}' is not allowed")
        assert process.stderr.count("\n") == 1
