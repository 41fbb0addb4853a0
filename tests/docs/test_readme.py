"""README and pages: their commands compose, their links lead somewhere."""

import importlib.util
import re
import shlex
from collections.abc import Iterator
from pathlib import Path

import pytest
from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.core.override_parser.types import Override
from hydra_config import hydra_config

from snapjump.checks import ParameterError
from snapjump.run.tasks.execute import check_run
from snapjump.run.tasks.registry import TASKS, find_task, is_study

ROOT = Path(__file__).resolve().parents[2]
PAGES = [ROOT / name for name in ("README.md", "CONTRIBUTING.md")]
PAGES += sorted((ROOT / "docs").rglob("*.md"))
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
INLINE = re.compile(r"`([^`]+)`")
LINK = re.compile(r"\]\(([^)\s]+)\)")
# What only the reader's machine has: keys that a command may be refused for.
ELSEWHERE = ("dataset.path", "task.standard", "executor.scheduler", "backend")
LAW_PAGE = (ROOT / "docs" / "adding_a_contact_law.md").read_text(encoding="utf-8")


def name(page: Path) -> str:
    return str(page.relative_to(ROOT))


def commands(page: Path) -> Iterator[list[str]]:
    """Every ``python`` command of a page, in blocks and in lines, as words without comments."""
    text = page.read_text(encoding="utf-8")
    shell = [content for kind, content in FENCE.findall(text) if kind == ""]
    lines = "\n".join(shell).replace("\\\n", " ").splitlines()
    lines += [line.strip() for line in text.splitlines() if line.startswith("    ")]
    lines += [" ".join(line.split()) for line in INLINE.findall(FENCE.sub("", text))]
    for line in lines:
        words = shlex.split(line.removeprefix("$ "), comments=True) if "python" in line else []
        if words and words[0].rpartition("/")[2] == "python":
            yield words[1:]


def whole(words: list[str]) -> bool:
    """Whether a command is one, and not the beginning or the pattern of one."""
    return not any("..." in word or word.startswith("<") for word in words)


RUNS = sorted(
    {
        tuple(words[1:])
        for page in PAGES
        for words in commands(page)
        if words[:1] == ["run.py"] and whole(words)
    }
)
MODULES = sorted({w[1] for page in PAGES for w in commands(page) if w[:1] == ["-m"]})


def plain(override: Override) -> str:
    """An override as it is, the first of its values if it sweeps."""
    if not override.is_sweep_override():
        return str(override.input_line)
    first = next(iter(override.sweep_string_iterator()))
    return f"{override.get_key_element()}={first}"


def test_commands_are_found():
    assert len(RUNS) > 40
    assert {"experiments.grid", "experiments.start", "experiments.speed"} <= set(MODULES)


@pytest.mark.parametrize("run", RUNS, ids=" ".join)
def test_every_command_is_accepted(run, tmp_path, monkeypatch):
    """As far as it is found out before work begins, without the data that only a reader has."""
    if "--help" in run:
        return
    if "contact=cone" in run:
        assert "contact=cone" in LAW_PAGE  # which is followed by a test of its own
        return
    monkeypatch.chdir(tmp_path)
    overrides = OverridesParser.create().parse_overrides([w for w in run if w != "-m"])
    given = [plain(o) for o in overrides if not o.key_or_group.startswith("hydra")]
    config = hydra_config(*given)
    config.pop("hydra", None)
    check_run(config)
    try:
        find_task(config["task"]["name"]).prepare(config)
    except ParameterError as error:
        assert error.key in ELSEWHERE, error


@pytest.mark.parametrize("module", MODULES)
def test_every_module_exists(module):
    assert importlib.util.find_spec(module) is not None


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_every_link_leads_to_a_file(page):
    text = FENCE.sub("", page.read_text(encoding="utf-8"))
    targets = [t.partition("#")[0] for t in LINK.findall(text) if "://" not in t]
    missing = [t for t in targets if t and not (page.parent / t).exists()]
    assert not missing


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_every_link_into_a_page_leads_to_a_heading(page):
    text = FENCE.sub("", page.read_text(encoding="utf-8"))
    for target in LINK.findall(text):
        file, _, anchor = target.partition("#")
        if anchor and "://" not in target:
            linked = (page.parent / file if file else page).read_text(encoding="utf-8")
            headings = re.findall(r"^#+ (.*)$", FENCE.sub("", linked), re.MULTILINE)
            known = [re.sub(r"[^\w\- ]", "", h.lower()).replace(" ", "-") for h in headings]
            assert anchor in known


def test_every_target_of_make_exists():
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    code = ""
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        blocks = [content for _, content in FENCE.findall(text)]
        code += "\n".join([*blocks, *INLINE.findall(FENCE.sub("", text)), text]) + "\n"
    named = set(re.findall(r"^(?:    )?make ([a-z]+)(?=  |$)", code, re.MULTILINE))
    assert {"jump", "test", "check"} <= named
    for target in named:
        assert re.search(rf"^{target}:", makefile, re.MULTILINE), target


def test_every_study_has_a_command():
    """Each task that can publish a page is named with its command."""
    named = {word for run in RUNS for word in run}
    assert {f"task={task}" for task in TASKS if is_study(task)} <= named
