import pytest

from snapjump.tasks.exit_codes import exit_code, sweep_exit_code


@pytest.mark.parametrize(
    ("status", "code"),
    [
        ("ok", 0),
        ("no_jump", 0),
        ("error", 1),
        ("bad_input", 2),
        ("any_failure_of_a_simulation", 3),
        ("not_finite", 3),
        ("unreachable", 4),
        ("interrupted", 130),
    ],
)
def test_of_one_job(status, code):
    assert exit_code(status) == code


@pytest.mark.parametrize(
    ("statuses", "code"),
    [
        (["ok", "no_jump"], 0),
        (["ok", "unreachable"], 0),
        (["ok", "bad_input"], 2),
        (["ok", "bad_input", "not_converged"], 3),
        (["ok", "not_started"], 3),
    ],
)
def test_of_a_sweep(statuses, code):
    assert sweep_exit_code(statuses) == code
