"""Equations as MathML, which browsers show without a script, and Sphinx's roles as links."""

import html
import re
from importlib.metadata import distribution
from typing import Any

from latex2mathml.converter import convert
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

# A font with the tables that fractions, roots and brackets are built by; not every system has one.
FONT = "STIXTwoMath-Regular.ttf"

INLINE = re.compile(r'<span class="arithmatex">\\\((.*?)\\\)</span>', re.DOTALL)
DISPLAY = re.compile(r'<div class="arithmatex">\s*\\\[(.*?)\\\]\s*</div>', re.DOTALL)
ROLE = re.compile(r":(?:mod|func|class|data|meth):<code>~?([\w.]+)</code>")


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the font for equations, which comes with ziamath."""
    font = distribution("ziamath").locate_file(f"ziamath/fonts/{FONT}")
    files.append(File.generated(config, FONT, abs_src_path=str(font)))
    return files


def role(match: re.Match[str]) -> str:
    """A link to what has a place in the reference; a bare name stays one."""
    name = match[1]
    code = f"<code>{name}</code>"
    if not name.startswith("snapjump."):
        return code
    return f'<autoref identifier="{name}" optional>{code}</autoref>'


def on_page_content(content: str, **others: Any) -> str:
    """Turn what arithmatex has marked into MathML; an equation that cannot be is an error."""

    def equation(display: str) -> Any:
        return lambda match: convert(html.unescape(match[1]).strip(), display=display)

    content = DISPLAY.sub(equation("block"), INLINE.sub(equation("inline"), content))
    return ROLE.sub(role, content)
