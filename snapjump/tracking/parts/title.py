"""What a run is called among others: what it does, and what about it differs from the default."""

import shlex
from collections.abc import Mapping
from typing import Any

LONGEST = 120
# Keys that say where and how it is shown or recorded.
ABOUT = ("task", "sim", "tracking", "hydra", "figures", "publish", "plugins", "seed")


def title_of(config: Mapping[str, Any], command: str) -> str:
    """``jump epsilon=0.25 contact=penalty``, ``train surrogate=mlp``: of a configuration and the
    command that composed it."""
    task = str(config.get("task", {}).get("name", "run"))
    scene = str(config.get("sim", {}).get("name", ""))
    words = [scene if task == "simulate" and scene else task]
    try:
        told = shlex.split(command)
    except ValueError:  # a quote that is left open
        told = []
    for text in told:
        key, equals, value = text.lstrip("+").partition("=")
        if equals and not key.startswith("-") and key.partition(".")[0] not in ABOUT:
            words.append(f"{key.rpartition('.')[2]}={value}")
    return " ".join(words)[:LONGEST]
