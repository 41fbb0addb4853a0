"""Scenes by name."""

from collections.abc import Callable
from typing import Any

from snapjump.results import Result
from snapjump.scenes.cantilever import simulate_cantilever_scene
from snapjump.scenes.jump import simulate_jump_scene
from snapjump.scenes.mass import simulate_bounce_scene, simulate_slide_scene
from snapjump.scenes.snap import simulate_snap_scene
from snapjump.scenes.static import simulate_static_scene

SCENES: dict[str, Callable[[Any, Any], Result]] = {
    "jump": simulate_jump_scene,
    "snap": simulate_snap_scene,
    "static": simulate_static_scene,
    "cantilever": simulate_cantilever_scene,
    "bounce": simulate_bounce_scene,
    "slide": simulate_slide_scene,
}
