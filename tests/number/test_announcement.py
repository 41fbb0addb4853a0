import time

from snapjump.number import announcement


class Kernel:
    """Takes its time; ``compiles`` says whether a signature appears meanwhile."""

    def __init__(self, seconds):
        self.signatures = []
        self.seconds = seconds
        self.calls = []

    def __call__(self, *args):
        self.calls.append(args)
        time.sleep(self.seconds)


def test_only_a_long_compilation_is_announced(monkeypatch, capsys):
    monkeypatch.setattr(announcement, "PATIENCE_SECONDS", 0.05)
    quick, slow, running = Kernel(0.0), Kernel(0.3), Kernel(0.3)
    announcement.load(quick, 1)
    assert capsys.readouterr().err == ""
    announcement.load(slow, 1, 2)
    assert "compiling kernels, once" in capsys.readouterr().err
    assert slow.calls == [(1, 2)]

    def starts_at_once(*args):
        running.signatures.append(args)
        time.sleep(0.3)

    starts_at_once.signatures = running.signatures
    announcement.load(starts_at_once, 1)
    assert capsys.readouterr().err == ""
