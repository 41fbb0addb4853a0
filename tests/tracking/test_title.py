"""What runs are called: what they do, and what differs from the default."""

import pytest

from snapjump.tracking.parts.title import LONGEST, title_of

JUMP = {"task": {"name": "simulate"}, "sim": {"name": "jump"}}
TRAIN = {"task": {"name": "train"}, "sim": {"name": "jump"}}


@pytest.mark.parametrize(
    ("config", "command", "title"),
    [
        (JUMP, "python run.py", "jump"),
        (JUMP, "snapjump sim=jump figures=false tracking.path=x.db hydra.run.dir=a", "jump"),
        (JUMP, "snapjump design.mu=0.2 +contact=penalty", "jump mu=0.2 contact=penalty"),
        (TRAIN, "python run.py task=train surrogate=mlp seed=3", "train surrogate=mlp"),
        ({"task": {"name": "inverse"}}, "snapjump 'target=[3, 12]'", "inverse target=[3, 12]"),
        (JUMP, "python run.py 'design.epsilon=0.25", "jump"),
        ({}, "None", "run"),
    ],
)  # fmt: skip
def test_a_title(config, command, title):
    assert title_of(config, command) == title


def test_none_is_too_long():
    assert len(title_of(JUMP, "snapjump " + "contact.stiffness_N_m=1e4 " * 50)) == LONGEST
