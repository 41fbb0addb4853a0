"""The page on architecture is true: rooms, floors and walks; and the house keeps its rules."""

import ast
import re
import tomllib

import pytest
from command_line import ROOT
from pages import text_of

PAGE = text_of("docs/architecture.md")
LIBRARY = ROOT / "snapjump"
ROOMS = {folder.name for folder in LIBRARY.iterdir() if (folder / "__init__.py").exists()}
CONTRACT = tomllib.loads(text_of("pyproject.toml"))["tool"]["importlinter"]
LAYERS = [re.split(r" [|:] ", layer) for layer in CONTRACT["contracts"][0]["layers"]]
WALKS = re.findall(r"\n`([\w.]+)`\n\n((?:\d\. .*\n)+)", PAGE)
# Folders of tests that are no folder of the library.
OF_NO_ROOM = {"docs", "experiments", "experiments/benchmarks", "experiments/paper", "physics"}
MOST_ARGUMENTS, MOST_LINES, MOST_STATIONS = 8, 250, 9


def section(title: str) -> str:
    return PAGE.split(f"\n## {title}\n")[1].split("\n## ")[0]


def picture() -> list[list[str]]:
    """Rooms of the picture, floor by floor."""
    drawn = section("Floors").split("```")[1]
    floors = [[word for word in line.split() if word in ROOMS] for line in drawn.splitlines()]
    return [floor for floor in floors if floor]


def test_every_room_has_its_paragraph_and_its_place_in_the_picture():
    told = re.findall(r"^\| `(\w+)` \|", section("Floors"), re.M)
    assert sorted(told) == sorted(ROOMS)
    assert sorted(room for floor in picture() for room in floor) == sorted(ROOMS)


def test_the_picture_has_the_floors_that_imports_are_held_to():
    height = {room: k for k, layer in enumerate(LAYERS) for room in layer}
    drawn = {room: k for k, floor in enumerate(picture()) for room in floor}
    for one in ROOMS:
        for other in ROOMS:
            if drawn[one] < drawn[other]:
                assert height[one] <= height[other], f"{one} is drawn above {other}"


@pytest.mark.parametrize(("number", "stations"), WALKS)
def test_a_walk_goes_by_what_is_there(number, stations):
    lines = stations.splitlines()
    assert len(lines) <= MOST_STATIONS
    assert re.fullmatch(r"\d\. `.*` `flight`: the apex", lines[-1])
    field = number.rsplit(".", 1)[1]
    declared = 0
    for line in lines:
        path, name = re.findall(r"`([^`]+)`", line)[:2]
        tree = ast.parse((ROOT / path).read_text())
        found = [n for n in ast.walk(tree) if name == getattr(n, "name", getattr(n, "id", None))]
        assert found, f"{path} has no {name}"
        declared += any(
            isinstance(n, ast.AnnAssign) and getattr(n.target, "id", "") == field
            for cls in found
            if isinstance(cls, ast.ClassDef)
            for n in cls.body
        )
    assert declared >= 1, f"{number} is declared at none of its stations"


def test_three_numbers_walk():
    assert [number for number, _ in WALKS] == [
        "contact.stiffness_N_m",
        "design.epsilon",
        "stepping.tolerance",
    ]


def test_every_folder_of_tests_is_a_room_of_the_library():
    tests = ROOT / "tests"
    folders = {file.parent.relative_to(tests).as_posix() for file in tests.rglob("test_*.py")}
    assert OF_NO_ROOM < folders
    assert not {name for name in folders - OF_NO_ROOM if not (LIBRARY / name).is_dir()}


SOURCES = [
    p for d in ("snapjump", "experiments", "tests") for p in sorted((ROOT / d).rglob("*.py"))
]


def test_no_function_takes_too_many_arguments():
    too_many = []
    for path in SOURCES:
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.FunctionDef):
                a = node.args
                names = [x.arg for x in (*a.posonlyargs, *a.args, *a.kwonlyargs)]
                if len([n for n in names if n not in ("self", "cls")]) > MOST_ARGUMENTS:
                    too_many.append(f"{path.relative_to(ROOT)}: {node.name}")
    assert not too_many


def test_a_long_file_says_why():
    for path in SOURCES:
        text = path.read_text()
        if text.count("\n") > MOST_LINES:
            assert f"more than {MOST_LINES} lines" in ast.get_docstring(ast.parse(text)), path
