"""The closing block of a simulation: what it was, what came out, how good it is, what it cost."""

from collections.abc import Mapping, Sequence
from typing import Any

from snapjump.declare.fields import construct, settings
from snapjump.declare.members import member_class
from snapjump.declare.outputs import Output
from snapjump.robot.other_units import in_other_units
from snapjump.robot.robot import Robot
from snapjump.show.terminal.block import number
from snapjump.show.terminal.build_line import build_line
from snapjump.show.terminal.uncertainty_report import uncertainty_lines
from snapjump.sim.base import SceneOptions
from snapjump.tiers import TIERS


def scene_report(config: Mapping[str, Any], summary: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Lines of (heading, text); numbers that a scene does not have are left out."""
    name = config["sim"]["name"]
    scene = member_class("sim", name)()
    lines = output_lines(scene.outputs.declared(), summary, 1e3 * config["robot"]["length_m"])
    cost = lines.pop("cost", "")
    design, mount = config["design"], summary.get("mount_height_bar")
    if mount is not None:
        lines["build"] = build_line(config, design["epsilon"], design["delta_alpha"], mount)
    return [
        (name, title(config, scene)),
        *lines.items(),
        ("accuracy", accuracy_line(config, summary)),
        ("warning", _warning(config, summary)),
        *uncertainty_lines(summary, 1e3 * config["robot"]["length_m"]),
        ("cost", cost),
    ]


def title(config: Mapping[str, Any], scene: SceneOptions) -> str:
    """The title of a simulation: the values that the scene tells."""
    told = []
    for path in scene.tells or [f"sim.{key}" for key in settings(scene)]:
        group, _, key = path.partition(".")
        value = config[group][key]
        other = in_other_units(path, value, construct("robot", Robot, config["robot"]))
        told.append(f"{key} {number(value)}" + (f" ({other})" if other else ""))
    return ", ".join(told)


def output_lines(
    outputs: Sequence[Output[Any]], summary: Mapping[str, Any], length_mm: float
) -> dict[str, str]:
    """The texts of outputs by their headings, as they are declared to be shown."""
    lines: dict[str, list[str]] = {}
    for each in outputs:
        value = summary.get(each.name)
        if each.show and value is not None and value == value:  # NaN is not
            heading, text = each.show.split(": ", 1)
            lines.setdefault(heading, []).append(text.format(quantity(value, each, length_mm)))
    return {heading: ", ".join(texts) for heading, texts in lines.items()}


def quantity(value: Any, declared: Output[Any], length_mm: float) -> str:
    """A value with its unit: lengths of L in mm as well, short times in ms."""
    if declared.unit == "L":
        return f"{number(value)} L ({number(value * length_mm)} mm)"
    if declared.unit == "s" and abs(value) < 1.0:
        return f"{number(1e3 * value)} ms"
    return f"{number(value)} {declared.unit}".removesuffix(" 1").rstrip()


def accuracy_line(config: Mapping[str, Any], summary: Mapping[str, Any]) -> str:
    """The tier; of a jump, its measured error if it knows that of itself and has just what the tier
    chooses, else what it estimates, or why it does not know."""
    accuracy = config["accuracy"]
    name = accuracy["name"]
    if not hasattr(member_class("sim", config["sim"]["name"])().outputs, "error_estimate_percent"):
        return str(name)
    changed = TIERS[name].departures(config)
    title = f"{name}, but for {', '.join(changed)}" if changed else str(name)
    estimate = summary.get("error_estimate_percent")
    if estimate is None:
        because = summary.get("error_unknown_because")
        return f"{title}: numerical error not known here" + (f" ({because})" if because else "")
    if changed or not summary.get("within_tier"):
        return f"{title}: numerical error estimated at {estimate:.2g} %"
    return f"{title}: {accuracy.get('known_error', TIERS[name].known_error)}"


def _warning(config: Mapping[str, Any], summary: Mapping[str, Any]) -> str:
    """A jump that is not sure to be as good as its tier."""
    estimate = summary.get("error_estimate_percent")
    if estimate is None or summary.get("within_tier", True):
        return ""
    name = config["accuracy"]["name"]
    promise = TIERS[name].promise_percent
    return (
        f"estimated error {estimate:.2g} %, which may be more than the {promise:g} % that {name} "
        "stands for"
    )
