"""What a batch says of its progress."""

from snapjump.batch.progress import BatchProgress, duration


def test_durations():
    texts = {
        0.4: "0 s", 59.4: "59 s", 59.6: "1 min 0 s", 3599.0: "59 min 59 s", 3600.0: "1 h 0 min",
        90_061.0: "25 h 1 min",
    }  # fmt: skip
    assert {seconds: duration(seconds) for seconds in texts} == texts


def test_rate_and_remaining_time():
    """100 jumps in groups of 60 and 40; the rate counts from what was first told."""
    told, now = [], [1000.0]
    progress = BatchProgress(100, lambda *args: told.append(args), lambda: now[0])
    progress.starts(60)(0.5, "")
    now[0] = 1040.0
    march = progress.jumps(60)
    march(10 / 60, "")
    now[0] = 1045.0
    march(20 / 60, "")
    march(1.0, "")
    progress.finish(60)
    progress.starts(40)(1.0, "")
    now[0] = 1060.0
    progress.jumps(40)(1.0, "")
    assert told == [
        (0.0, "finding starts: 30 of 60"),
        (0.1, "10 of 100 jumps"),
        (0.2, "20 of 100 jumps, 2 jumps/s, 40 s left"),
        (0.6, "60 of 100 jumps, 10 jumps/s, 4 s left"),
        (0.6, "finding starts: 40 of 40"),
        (1.0, "100 of 100 jumps, 4.5 jumps/s, 0 s left"),
    ]
