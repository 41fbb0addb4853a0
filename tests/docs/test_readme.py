"""README and pages: their commands compose, their links lead somewhere."""

import importlib.util
import re
import shlex
from collections.abc import Iterator
from pathlib import Path

import pytest
from command_line import ROOT
from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.core.override_parser.types import Override
from hydra_config import hydra_config
from pages import FENCE, LAW_PAGE, LINK, blocks, text_of, without_blocks

from snapjump.checks import ParameterError
from snapjump.run.tasks.execute import check_run
from snapjump.run.tasks.registry import TASKS, find_task, is_study

PAGES = [ROOT / name for name in ("README.md", "CONTRIBUTING.md")]
PAGES += sorted((ROOT / "docs").rglob("*.md"))
INLINE = re.compile(r"`([^`]+)`")
# What only the reader's machine has: keys that a command may be refused for.
ELSEWHERE = ("dataset.path", "task.standard", "executor.scheduler", "backend")


def name(page: Path) -> str:
    return str(page.relative_to(ROOT))


def commands(page: Path) -> Iterator[list[str]]:
    """Every ``python`` command of a page, in blocks and in lines, as words without comments."""
    text = text_of(page)
    lines = "\n".join(blocks(text, "")).replace("\\\n", " ").splitlines()
    lines += [line.strip() for line in text.splitlines() if line.startswith("    ")]
    lines += [" ".join(line.split()) for line in INLINE.findall(without_blocks(page))]
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
        if words[:1] == ["run.py"] and whole(words) and not words[-1].startswith("record=")
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
    """What is found out before work begins accepts it, but for data that only a reader has."""
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
    links = LINK.findall(without_blocks(page))
    targets = [t.partition("#")[0] for t in links if "://" not in t]
    missing = [t for t in targets if t and not (page.parent / t).exists()]
    assert not missing


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_every_link_into_a_page_leads_to_a_heading(page):
    for target in LINK.findall(without_blocks(page)):
        file, _, anchor = target.partition("#")
        if anchor and "://" not in target:
            linked = without_blocks(page.parent / file if file else page)
            headings = re.findall(r"^#+ (.*)$", linked, re.MULTILINE)
            known = [re.sub(r"[^\w\- ]", "", h.lower()).replace(" ", "-") for h in headings]
            assert anchor in known


def test_every_target_of_make_exists():
    code = ""
    for page in PAGES:
        text = text_of(page)
        quoted = [content for _, content in FENCE.findall(text)]
        code += "\n".join([*quoted, *INLINE.findall(without_blocks(page)), text]) + "\n"
    named = set(re.findall(r"^(?:    )?make ([a-z]+)(?=  |$)", code, re.MULTILINE))
    assert {"jump", "test", "check"} <= named
    for target in named:
        assert re.search(rf"^{target}:", text_of("Makefile"), re.MULTILINE), target


def test_every_study_has_a_command():
    """Each task that can publish a page is named with its command."""
    named = {word for run in RUNS for word in run}
    assert {f"task={task}" for task in TASKS if is_study(task)} <= named
