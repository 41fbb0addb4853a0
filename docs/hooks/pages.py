"""The navigation, and pages that are made while the site is built: README, CONTRIBUTING, reference.

A page of the reference is a package of ``snapjump`` with the docstrings of its modules; neither
these nor guides and studies are listed by hand. Links to files of the repository lead to their
page, or are left out where they have none.
"""

import posixpath
import re
from collections.abc import Iterator
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

import snapjump

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
PACKAGE = ROOT / "snapjump"
FROM_ROOT = {"README.md": "index.md", "CONTRIBUTING.md": "contributing.md"}
API = "reference/api.md"
PAPER = "paper.md"  # a study in a place of its own, which may not be there yet
LINK = re.compile(r"(?<!!)\[(?P<text>[^\]]*)\]\((?P<target>[^)\s:#]+)(?P<place>#[^)\s]*)?\)")
IMAGE = re.compile(r"(!\[[^\]]*\])\(docs/")


def packages() -> list[str]:
    """The top modules, then every package with a module, by their dotted names."""
    folders = sorted(path.parent for path in PACKAGE.glob("*/**/__init__.py"))
    names = (".".join(folder.relative_to(ROOT).parts) for folder in folders if modules(folder))
    return ["snapjump", *names]


def modules(folder: Path) -> list[str]:
    """Dotted names of a package's modules."""
    names = sorted(path.stem for path in folder.glob("*.py") if path.stem != "__init__")
    dotted = ".".join(folder.relative_to(ROOT).parts)
    return [f"{dotted}.{name}" for name in names]


def front_page() -> str:
    """Markdown of the names that ``import snapjump`` has, with links to where they live."""
    rows = []
    for name in snapjump.__all__:
        thing = getattr(snapjump, name)
        first = (thing.__doc__ or "").strip().partition("\n\n")[0]
        rows.append(f"| [{name}][{thing.__module__}.{name}] | {' '.join(first.split())} |")
    title = f"# What `import snapjump` has\n\n{snapjump.__doc__}"
    return "\n".join([title, "| name | what it is |", "|---|---|", *rows])


def reference_page(package: str) -> str:
    """Markdown of a package's page, for mkdocstrings."""
    folder = ROOT.joinpath(*package.split("."))
    # A package of mkdocstrings has its modules as members, too: what follows lists them.
    own = f"::: {package}\n    options:\n      show_root_heading: false\n      members: false"
    return "\n\n".join([f"# {package}", own, *(f"::: {name}" for name in modules(folder))])


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    """Fill the sections of the navigation that are lists of files."""
    nav = config.nav or []
    named = {entry for entry in nav if isinstance(entry, str)}
    pages = sorted(path.name for path in DOCS.glob("*.md"))
    studies = sorted(f"studies/{path.name}" for path in (DOCS / "studies").glob("*.md"))
    sections = {
        "Guides": [page for page in pages if page not in {*named, PAPER}],
        "Studies": [page for page in pages if page == PAPER] + studies,
        "Reference": [API, *(f"reference/{name}.md" for name in packages())],
    }
    config.nav = [
        {title: sections[title] for title in entry} if isinstance(entry, dict) else entry
        for entry in nav
    ]
    return config


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the pages that are not in ``docs``."""
    for name, page in FROM_ROOT.items():
        files.append(File.generated(config, page, abs_src_path=str(ROOT / name)))
    files.append(File.generated(config, API, content=front_page()))
    for package in packages():
        page = f"reference/{package}.md"
        files.append(File.generated(config, page, content=reference_page(package)))
    return files


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Lead links to files of the repository to their pages."""
    source = page.file.src_uri
    home = ROOT if source in FROM_ROOT.values() else (DOCS / source).parent
    if home == ROOT:
        markdown = IMAGE.sub(r"\1(", markdown)

    def link(match: re.Match[str]) -> str:
        path = (home / match["target"]).resolve()
        if path == DOCS / PAPER and not path.exists():
            return match["text"]
        if not path.exists() or not path.is_relative_to(ROOT):
            return match[0]
        place = place_of(path)
        if place is None:
            return match["text"]
        target = posixpath.relpath(place, posixpath.dirname(source) or ".")
        return f"[{match['text']}]({target}{match['place'] or ''})"

    return "".join(
        part if fenced else LINK.sub(link, part) for fenced, part in in_and_out_of_code(markdown)
    )


def in_and_out_of_code(markdown: str) -> Iterator[tuple[bool, str]]:
    """Stretches of the text, and whether they are fenced code."""
    for k, part in enumerate(re.split(r"(?m)(^```.*?^```$)", markdown, flags=re.DOTALL)):
        yield k % 2 == 1, part


def place_of(path: Path) -> str | None:
    """Where in the site a file of the repository is, None if nowhere."""
    if path.is_relative_to(DOCS):
        page = path.with_suffix(".md") if path.suffix == ".ipynb" else path
        return page.relative_to(DOCS).as_posix()
    inside = path.relative_to(ROOT)
    if inside.as_posix() in FROM_ROOT:
        return FROM_ROOT[inside.as_posix()]
    if inside.parts[0] != "snapjump":
        return None
    if path.is_dir():
        package = ".".join(inside.parts)
        return f"reference/{package}.md" if package in packages() else None
    if path.suffix != ".py":
        return None
    package = ".".join(inside.parent.parts)
    return f"reference/{package}.md#{package}.{path.stem}"
