"""Scenes by name."""

from collections.abc import Callable
from typing import Any

from snapjump.results import Result
from snapjump.scenes.jump import simulate_jump_scene

SCENES: dict[str, Callable[[Any, Any], Result]] = {"jump": simulate_jump_scene}
