"""Servers that are slow in every way: a record ends in time, Ctrl-C ends it at once, and the next
attempt goes on with what was begun."""

import json
import signal
import threading
import time
from collections.abc import Iterator
from functools import cached_property
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest

from snapjump.checks import ParameterError
from snapjump.deadline import LateError, check_left, within
from snapjump.files.atomic import write_text
from snapjump.files.result_folder import ResultFolder
from snapjump.tracking.base import Record, TrackingError
from snapjump.tracking.off import Off
from snapjump.tracking.parts import mlflow_store
from snapjump.tracking.parts.tracked import record_folder, write_children
from snapjump.tracking.server import Server

pytestmark = pytest.mark.processes

DEADLINE_S = 1.5


def never(handler: Any) -> None:
    time.sleep(30.0)


def busy(handler: Any) -> None:
    handler.send_response(429)
    handler.send_header("Retry-After", "3600")
    handler.send_header("Content-Length", "0")
    handler.end_headers()


def drips(handler: Any) -> None:
    handler.send_response(200)
    handler.send_header("Content-Length", "100")
    handler.end_headers()
    for _ in range(100):
        handler.wfile.write(b" ")
        handler.wfile.flush()
        time.sleep(0.3)


def garbage(handler: Any) -> None:
    handler.wfile.write(b"\x1b[31m\x00\xff" * 100)


@pytest.fixture
def address(request, monkeypatch) -> Iterator[str]:
    """Of a server that answers so."""

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            with_patience(request.param, self)

        do_POST = do_GET

        def log_message(self, *given: Any) -> None:
            pass

    def with_patience(answer: Any, handler: Any) -> None:
        try:
            answer(handler)
        except OSError:  # the other side has gone
            handler.close_connection = True

    monkeypatch.setattr(mlflow_store, "NUMBERS_S", DEADLINE_S)
    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.daemon_threads = True
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}"
    server.shutdown()


def job(path: Path) -> ResultFolder:
    folder = ResultFolder(path)
    folder.begin()
    folder.write_config({"seed": 0})
    write_text(path / "a.txt", "a file")
    folder.write_provenance({"finished_at": "2026-01-01T00:00:01+00:00"})
    folder.write_result({"status": "ok", "x_bar": 1.0})
    return folder


@pytest.mark.parametrize("address", [never, busy, drips, garbage], indirect=True)
def test_a_record_ends_in_time(address, tmp_path):
    store = Server(uri=address)
    assert store.client  # imported, which takes seconds
    begun = time.monotonic()
    with pytest.raises(TrackingError) as caught:
        record_folder(store, job(tmp_path), "run", None)
    assert time.monotonic() - begun < DEADLINE_S + 1.0
    text = str(caught.value)
    assert text.startswith(address) and text.isprintable() and len(text) < 300
    if "within" in text:  # nobody waits for it a second time
        begun = time.monotonic()
        with pytest.raises(TrackingError, match="did not answer before"):
            record_folder(store, job(tmp_path), "run", None)
        assert time.monotonic() - begun < 0.5


@pytest.mark.parametrize("address", [never], indirect=True)
def test_ctrl_c_ends_it_at_once(address, tmp_path, monkeypatch):
    monkeypatch.setattr(mlflow_store, "NUMBERS_S", 20.0)
    store = Server(uri=address)
    assert store.client
    threading.Timer(0.5, lambda: signal.raise_signal(signal.SIGINT)).start()
    begun = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        record_folder(store, job(tmp_path), "run", None)
    assert time.monotonic() - begun < 3.0


class Failing(Off):
    """A store that fails at a step."""

    place = "memory"

    @cached_property
    def done(self) -> list[Any]:
        return []

    @cached_property
    def fails(self) -> set[str]:
        return set()

    def _do(self, step: str, *what: Any) -> None:
        if step in self.fails:
            raise TrackingError(f"no {step}")
        self.done.append((step, *what))

    def open(self, record: Record, run_id: str | None) -> str:
        self._do("open", record.name, run_id)
        return run_id or f"id of {record.name}"

    def write(self, run_id: str, record: Record) -> None:
        self._do("write", run_id)

    def send(self, run_id: str, record: Record) -> None:
        self._do("send", run_id)


def test_what_is_missing_is_recorded_and_nothing_twice(tmp_path):
    store, folder = Failing(), job(tmp_path)
    child = {
        "name": "cell", "status": "ok", "message": "", "params": {}, "metrics": {},
        "started_at": "2026-01-01T00:00:00+00:00", "finished_at": "2026-01-01T00:00:01+00:00",
    }  # fmt: skip
    write_children(folder, [child])
    for step in ("open", "write", "send"):
        store.fails.add(step)
        with pytest.raises(TrackingError, match=f"no {step}"):
            record_folder(store, folder, "run", None)
        store.fails.clear()
        if step == "open":
            assert not (tmp_path / "tracking.json").exists()
        else:
            assert json.loads((tmp_path / "tracking.json").read_text())["run_id"] == "id of run"
    assert record_folder(store, folder, "run", None) == "memory run id of run"
    runs = [run for step, name, run in (e for e in store.done if e[0] == "open") if name == "run"]
    assert runs == [None, "id of run"] and store.done.count(("send", "id of run")) == 1
    before = list(store.done)
    record_folder(store, folder, "run", None)
    assert store.done == before


def test_files_alone_are_said_to_be_missing(tmp_path):
    store = Failing()
    store.fails.add("send")
    with pytest.raises(TrackingError, match=r"all but the files \(no send\)"):
        record_folder(store, job(tmp_path), "run", None)


def test_work_that_nobody_waits_for_stops_between_two_requests():
    went_on = threading.Event()

    def work() -> None:
        time.sleep(0.3)
        check_left()
        went_on.set()

    with pytest.raises(LateError):
        within(0.1, work)
    time.sleep(0.5)
    assert not went_on.is_set()
    check_left()  # in a thread that nobody else waits for


def test_what_the_work_raises_and_returns():
    assert within(1.0, lambda: 3) == 3
    with pytest.raises(ZeroDivisionError):
        within(1.0, lambda: 1 / 0)


SECRET = "s3cret"
ADDRESSES = (
    f"http://alice:{SECRET}@host:5000", f"https://{SECRET}@host", f"http://host:5000?token={SECRET}",
    f"http://host/#{SECRET}", f"alice:{SECRET}@host", f"ftp://alice:{SECRET}@host",
    f"http://alice:{SECRET}@host:99999999", "http://", "host", "http://host:port", "",
)  # fmt: skip


@pytest.mark.parametrize("uri", ADDRESSES)
def test_an_address_with_a_secret_is_refused_without_a_word_of_it(uri):
    with pytest.raises(ParameterError, match="tracking.uri") as caught:
        Server(uri=uri)
    assert SECRET not in str(caught.value)
    if SECRET in uri and "//" in uri:
        assert "MLFLOW_TRACKING_USERNAME" in str(caught.value)
