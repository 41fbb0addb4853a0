"""Scenes by name, and what they report."""

from collections.abc import Callable
from typing import Any

from snapjump.declare.outputs import Outputs
from snapjump.results import Result
from snapjump.scenes.cantilever import CantileverOutputs, simulate_cantilever_scene
from snapjump.scenes.jump import simulate_jump_scene
from snapjump.scenes.jump_outputs import RecordedJump
from snapjump.scenes.mass import (
    BounceOutputs,
    SlideOutputs,
    simulate_bounce_scene,
    simulate_slide_scene,
)
from snapjump.scenes.snap import SnapOutputs, simulate_snap_scene
from snapjump.scenes.static import StaticOutputs, simulate_static_scene

SCENES: dict[str, Callable[[Any, Any], Result]] = {
    "jump": simulate_jump_scene,
    "snap": simulate_snap_scene,
    "static": simulate_static_scene,
    "cantilever": simulate_cantilever_scene,
    "bounce": simulate_bounce_scene,
    "slide": simulate_slide_scene,
}

OUTPUTS: dict[str, type[Outputs]] = {
    "jump": RecordedJump,
    "snap": SnapOutputs,
    "static": StaticOutputs,
    "cantilever": CantileverOutputs,
    "bounce": BounceOutputs,
    "slide": SlideOutputs,
}
