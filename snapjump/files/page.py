"""A Markdown text as a page of HTML, its pictures included."""

import base64
import html
import re
from pathlib import Path

PICTURE = re.compile(r'src="([^"/]+\.png)"')

STYLE = """
body { max-width: 68rem; margin: 2rem auto; padding: 0 1rem; color: #1f2328;
       font: 16px/1.55 system-ui, sans-serif; }
h1, h2 { line-height: 1.2; margin-top: 2.2rem; }
img { max-width: 100%; height: auto; }
table { border-collapse: collapse; font-size: 0.86rem; display: block; overflow-x: auto; }
th, td { border-bottom: 1px solid #d5d9df; padding: 0.35rem 0.7rem; text-align: left;
         vertical-align: top; }
code { background: #f0f2f4; border-radius: 3px; padding: 0.1rem 0.25rem; }
"""


def page(title: str, markdown: str, folder: Path) -> str:
    """The whole page (HTML 5); tables as GitHub writes them, no raw HTML from the text.

    Pictures of the folder are put into it: stores show pages without what lies beside them.
    """
    from markdown_it import MarkdownIt

    body = MarkdownIt("commonmark", {"html": False}).enable("table").render(markdown)

    def included(match: re.Match[str]) -> str:
        picture = folder / match[1]
        if not picture.is_file():
            return match[0]
        return f'src="data:image/png;base64,{base64.b64encode(picture.read_bytes()).decode()}"'

    body = PICTURE.sub(included, body)
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{html.escape(title)}</title>\n<style>{STYLE}</style>\n</head>\n"
        f"<body>\n{body}</body>\n</html>\n"
    )
