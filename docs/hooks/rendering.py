"""Equations as MathML, which browsers show without a script, and Sphinx's roles as links."""

import html
import re
from typing import Any

from latex2mathml.converter import convert

INLINE = re.compile(r'<span class="arithmatex">\\\((.*?)\\\)</span>', re.DOTALL)
DISPLAY = re.compile(r'<div class="arithmatex">\s*\\\[(.*?)\\\]\s*</div>', re.DOTALL)
ROLE = re.compile(r":(?:mod|func|class|data|meth):<code>~?([\w.]+)</code>")


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
