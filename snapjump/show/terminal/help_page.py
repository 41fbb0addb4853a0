"""The page that ``--help`` prints, made from the files in ``conf`` alone."""

import re
from collections.abc import Sequence
from pathlib import Path

import yaml

from snapjump.checks import ParameterError
from snapjump.files.layout import PROGRAM
from snapjump.files.sources import PACKAGE

# Runge-Kutta methods, whose configurations belong to the library.
TABLEAUX = PACKAGE
GROUPS = {
    "task": "what to do",
    "sim": "the scene",
    "accuracy": "how exact, and how slow; chooses several of the modules below",
    "robot": "what is built once",
    "discretization": "how the beam is divided",
    "frame": "what holds the beam",
    "contact": "how the ground pushes back",
    "friction": "how the ground holds on",
    "damping": "how the material loses energy",
    "drive": "how clamps, or the span, are moved",
    "drag": "what the air does to a robot that moves",
    "integrator": "how time goes on",
    "stepping": "how long a step is",
    "backend": "how many robots at once",
    "plan": "which designs a dataset has; of task=dataset",
    "executor": "where a dataset's shards are made; of task=dataset",
    "surrogate": "what learns the map from designs to apexes; of task=train",
    "inverse": "how a design for a target is found; of task=inverse",
    "uncertainty": "what the robot may be off by, beside the numbers; of task=simulate",
    "tracking": "where MLflow records go",
    "cluster": "sweeps on many machines, added with +cluster=<name>",
    "experiment": "whole compositions, added with +experiment=<name>",
}

INTRODUCTION = f"""\
Snapjump simulates a robot that jumps by the snap-through of a beam.

  {PROGRAM} [group=member ...] [key=value ...]

Examples
  {PROGRAM}
      one jump: numbers, figures, film
  {PROGRAM} accuracy=draft design.delta_alpha=0.05
      another design, faster
  {PROGRAM} -m design.epsilon=0.1,0.2,0.3 hydra/launcher=joblib
      a sweep, several at a time"""

FLAGS = """\
Flags
  --help <group>=<member>
                    every key of a member, with its default, unit and range
  -m, --multirun    every combination of the values that are given with commas; a sweep that is
                    started again does only the cells that are not finished
  --cfg job         print every key of this run, with its value, and stop
  record=<folder>   record a run, which is done, from its files: after a server that did not answer

Results go to outputs/, one folder a run. Exit codes: 0 done, 1 a defect of this program, 2 bad
input, 3 a simulation that could not finish, 4 a target that is not reached, 5 done but not
recorded, 130 interrupted."""


def help_page(conf: Path, plugins: Sequence[Path] = ()) -> str:
    """The whole page, with members of yours."""
    config = yaml.safe_load((conf / "config.yaml").read_text(encoding="utf-8"))
    chosen = {key: value for entry in config["defaults"] if isinstance(entry, dict)
              for key, value in entry.items()}  # fmt: skip
    names = [*GROUPS, *sorted({path.name for path in conf.iterdir() if path.is_dir()} - {*GROUPS})]
    places = (conf, TABLEAUX, *plugins)
    groups = [_group([place / name for place in places], str(chosen.get(name))) for name in names]
    return "\n\n".join(
        [INTRODUCTION, "Groups (* is the default)\n" + "\n".join(groups), _keys(conf), FLAGS]
    )


def member_page(conf: Path, chosen: Sequence[str], plugins: Sequence[Path] = ()) -> str:
    """Every key of members that are named as ``group=member``, with its default, unit and range.
    Raises ParameterError for one that there is not."""
    pages = []
    for text in chosen:
        group, _, name = text.lstrip("+").partition("=")
        files = [place / group / f"{name}.yaml" for place in (conf, TABLEAUX, *plugins)]
        found = [file for file in files if file.is_file()]
        if not found:
            raise ParameterError("--help", text, "<group>=<member>, as --help lists them")
        lines = found[0].read_text(encoding="utf-8").splitlines()
        pages.append("\n".join([text, *(line for line in lines if "# @package" not in line)]))
    return "\n\n".join(pages)


def describe(member: Path) -> str:
    """The one line that a member's file says about it: its first comment."""
    for line in member.read_text(encoding="utf-8").splitlines():
        if line.startswith("#") and not line.startswith("# @package"):
            return line.lstrip("# ")
    return ""


def _group(folders: list[Path], default: str) -> str:
    name = folders[0].name
    lines = [f"  {name}: {GROUPS.get(name, '')}".rstrip(": ")]
    members = [member for folder in folders for member in folder.glob("*.yaml")]
    for member in sorted(members, key=lambda path: path.stem):
        star = "*" if member.stem == default else " "
        lines.append(f"   {star} {member.stem:<20}{describe(member)}")
    return "\n".join(lines)


def _keys(conf: Path) -> str:
    """Keys that belong to no member, with their defaults and comments; then where others are."""
    lines, section = [], ""
    for line in (conf / "config.yaml").read_text(encoding="utf-8").splitlines():
        top = re.match(r"(\w+):\s*([^#\s].*?)?\s*(?:#\s*(.*))?$", line)
        inner = re.match(r"  (\w+):\s*(\S+)\s*#\s*(.*)", line)
        if top:
            section = top[1]
            if top[2]:
                lines.append(f"  {f'{section}={top[2]}':<30}{top[3] or ''}")
        elif inner and section not in ("defaults", "hydra"):
            lines.append(f"  {f'{section}.{inner[1]}={inner[2]}':<30}{inner[3]}")
    return "Keys\n" + "\n".join(
        [*lines, "  <group>.<key>=...             keys of a member: see --help <group>=<member>"]
    )
