"""The closing block of a simulation: what it was, what came out, how good it is, what it cost."""

from collections.abc import Mapping
from typing import Any

from snapjump.terminal.block import number
from snapjump.tiers import TIERS

# Shown in lines of their own.
ELSEWHERE = (
    "status",
    "accuracy",
    "steps",
    "newton_iterations",
    "kernel_seconds",
    "wall_seconds",
)


def scene_report(config: Mapping[str, Any], summary: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Lines of (heading, text); numbers that a scene does not have are left out."""
    scene = config["sim"]["name"]
    if scene == "jump":
        title, results = _jump_title(config), _jump_results(config, summary)
    else:
        title, results = _title(config), _results(summary)
    return [
        (scene, title),
        *results,
        ("accuracy", accuracy_line(config, summary)),
        ("warning", _warning(config, summary)),
        ("cost", _cost(summary)),
    ]


def accuracy_line(config: Mapping[str, Any], summary: Mapping[str, Any]) -> str:
    """The tier, and its measured error if this is a jump with just what the tier chooses, else
    what the jump estimates itself."""
    accuracy = config["accuracy"]
    name = accuracy["name"]
    if config["sim"]["name"] != "jump":
        return str(name)
    changed = TIERS[name].departures(config)
    if changed:
        estimate = summary.get("error_estimate_percent")
        known = "its error is not known" if estimate is None else f"estimated {estimate:.2g} % off"
        return f"{name}, but for {', '.join(changed)}: {known}"
    return f"{name}: {accuracy['known_error']}"


def _warning(config: Mapping[str, Any], summary: Mapping[str, Any]) -> str:
    """A jump that says of itself that it is worse than its tier."""
    estimate = summary.get("error_estimate_percent")
    if estimate is None or summary.get("within_tier", True):
        return ""
    name = config["accuracy"]["name"]
    return (
        f"estimated error {estimate:.2g} %, more than the {TIERS[name].promise_percent:g} % that "
        f"{name} stands for"
    )


def _jump_title(config: Mapping[str, Any]) -> str:
    design, environment = config["design"], config["environment"]
    return (
        f"epsilon {number(design['epsilon'])}, delta_alpha {number(design['delta_alpha'])} rad, "
        f"mu {number(environment['mu'])}, m_bar {number(environment['mass_bar'])}"
    )


def _jump_results(config: Mapping[str, Any], summary: Mapping[str, Any]) -> list[tuple[str, str]]:
    x, y = summary.get("x_bar"), summary.get("y_bar")
    length_mm = 1e3 * config["robot"]["length_m"]
    lines = []
    if x is not None and y is not None:
        text = f"x {x:.4g} L ({x * length_mm:.4g} mm), y {y:.4g} L ({y * length_mm:.4g} mm)"
        lines.append(("apex", text + _at(summary.get("apex_time_s"))))
    vx, vy = summary.get("liftoff_vx_m_s"), summary.get("liftoff_vy_m_s")
    if vx is not None and vy is not None:
        text = f"v_x {vx:.4g} m/s, v_y {vy:.4g} m/s"
        lines.append(("lift-off", text + _at(summary.get("liftoff_time_s"))))
    return lines


def _at(time_s: float | None) -> str:
    return "" if time_s is None else f", {1e3 * time_s:.4g} ms after the clamps begin to turn"


def _title(config: Mapping[str, Any]) -> str:
    keys = {key: value for key, value in config["sim"].items() if key != "name"}
    if config["sim"]["name"] in ("static", "snap"):
        keys = {**config["design"], **keys}
    return ", ".join(f"{key} {number(value)}" for key, value in keys.items())


def _results(summary: Mapping[str, Any]) -> list[tuple[str, str]]:
    return [(key, number(value)) for key, value in summary.items() if key not in ELSEWHERE]


def _cost(summary: Mapping[str, Any]) -> str:
    texts = {
        "steps": "{} steps",
        "newton_iterations": "{} Newton iterations",
        "kernel_seconds": "{:.3g} s in kernels",
        "wall_seconds": "{:.3g} s wall",
    }
    return ", ".join(
        text.format(summary[key]) for key, text in texts.items() if summary.get(key) is not None
    )
