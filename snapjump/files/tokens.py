"""A hash of what a source says: Python by its tokens, YAML by its data, layout and comments not.

The same in every Python: since 3.12 ``tokenize`` takes f-strings apart, so that here each counts
as it is written.
"""

import hashlib
import io
import json
import re
import token
import tokenize
from collections.abc import Iterator

# Words that no token is, since these have no spaces at their beginnings.
LAYOUT = {tokenize.NEWLINE: " end", tokenize.INDENT: " in", tokenize.DEDENT: " out"}
SILENT = (tokenize.COMMENT, tokenize.NL, tokenize.ENDMARKER)
OPENING, CLOSING = (
    {getattr(token, f"{letter}STRING_{side}", None) for letter in "FT"} for side in ("START", "END")
)
FORMATTED = re.compile("r?f", re.IGNORECASE)  # which is a token of its own before 3.12


def content_hash(content: bytes, suffix: str) -> str:
    """A hash of a file's content, 64 hex digits: of its bytes where it cannot be understood."""
    try:
        if suffix == ".py":
            encoding, _ = tokenize.detect_encoding(io.BytesIO(content).readline)
            return token_hash(content.decode(encoding))
        if suffix == ".yaml":
            return data_hash(content.decode())
    except (SyntaxError, ValueError, tokenize.TokenError):
        pass
    return hashlib.sha256(content).hexdigest()


def token_hash(text: str) -> str:
    """A hash of Python's tokens without comments, docstrings, blank lines and layout.
    Raises SyntaxError or tokenize.TokenError for what is no Python."""
    return hashlib.sha256("\0".join(_words(text)).encode()).hexdigest()


def data_hash(text: str) -> str:
    """A hash of what YAML says. Raises ValueError for what is no plain YAML."""
    import yaml  # which kernels need not wait for

    try:
        canonical = json.dumps(yaml.safe_load(text), sort_keys=True)
    except (yaml.YAMLError, TypeError) as error:
        raise ValueError("no plain YAML") from error
    return hashlib.sha256(canonical.encode()).hexdigest()


def _words(text: str) -> Iterator[str]:
    """The tokens; a statement of nothing but strings, as a docstring is, does nothing."""
    text = text.replace("\r\n", "\n").replace("\r", "\n")
    rows = text.split("\n")
    statement: list[str] = []
    does_nothing = True
    depth, begun = 0, (0, 0)  # in f-strings that are taken apart
    for kind, word, start, end, _ in tokenize.generate_tokens(io.StringIO(text).readline):
        if kind == tokenize.ERRORTOKEN:  # before 3.12; later it is an error
            raise SyntaxError(f"no Python: {word!r}")
        if kind in OPENING:
            begun = begun if depth else start
            depth += 1
        elif kind in CLOSING:
            depth -= 1
            word = _between(rows, begun, end)
        if depth or kind in SILENT:
            continue
        if kind == tokenize.NEWLINE:
            if not does_nothing:
                yield from (*statement, LAYOUT[kind])
            statement, does_nothing = [], True
        elif kind in LAYOUT:
            yield LAYOUT[kind]
        else:
            statement.append(word)
            does_nothing &= kind == tokenize.STRING and not FORMATTED.match(word)


def _between(rows: list[str], start: tuple[int, int], end: tuple[int, int]) -> str:
    """The text from a row and column to others; rows count from 1."""
    taken = rows[start[0] - 1 : end[0]]
    taken[-1] = taken[-1][: end[1]]
    taken[0] = taken[0][start[1] :]
    return "\n".join(taken)
