import io

from snapjump.show.terminal.progress import ProgressBar


def drawn(bar: ProgressBar, stream: io.StringIO) -> str:
    bar(0.5, "striking")
    text = stream.getvalue()
    bar.close()
    return text


def test_it_shows_share_and_word_where_asked_to(monkeypatch):
    monkeypatch.setenv("SNAPJUMP_PROGRESS", "1")
    stream = io.StringIO()
    text = drawn(ProgressBar(stream, show_after_s=0.0), stream)
    assert " 50 % striking" in text
    assert stream.getvalue().endswith("\r")


def test_it_is_silent_before_two_seconds_off_a_terminal_and_when_hidden(monkeypatch):
    stream = io.StringIO()
    monkeypatch.delenv("SNAPJUMP_PROGRESS", raising=False)
    assert drawn(ProgressBar(stream, show_after_s=0.0), stream) == ""
    monkeypatch.setenv("SNAPJUMP_PROGRESS", "1")
    assert drawn(ProgressBar(stream), stream) == ""
    assert drawn(ProgressBar(stream, show_after_s=0.0, visible=False), stream) == ""
