"""Hashes of what sources say: of their tokens, the same in every Python, and kept on disk."""

import itertools
import json
import shutil
import subprocess

import pytest

from snapjump.files import kept_hashes as kept
from snapjump.files import tokens
from snapjump.files.kept_hashes import FILE, kept_hashes
from snapjump.files.tokens import content_hash, data_hash, token_hash

BASE = '''"""A module."""

def area(width: float, height: float = 2.0) -> float:
    """Of a rectangle."""
    if width > 0:
        height += 1
    return sum([width * height, 0.5])
'''
ALIKE = {
    "comments": BASE.replace("height += 1", "height += 1  # why").replace("def", "# what\ndef"),
    "docstrings": BASE.replace("Of a", "The area of a").replace('"""A module."""\n', ""),
    "a raw docstring": BASE.replace('"""Of a', 'r"""Of \\a'),
    "docstrings in two pieces": BASE.replace('"""A module."""', '\'A\' \\\n  """\nmodule"""'),
    "another string that does nothing": BASE.replace("    return", "    'now'\n    return"),
    "blank lines": BASE.replace("\n", "\n\n").replace("'''", "'''\n"),
    "breaks in brackets": BASE.replace("[width", "[\n  width").replace("0.5]", "0.5  # half\n]"),
    "continued lines": BASE.replace("return sum", "return \\\n  sum"),
    "spaces": BASE.replace(" * ", "*").replace(" = ", "="),
    "tabs": BASE.replace("    ", "\t"),
    "CRLF": BASE.replace("\n", "\r\n"),
    "no last line break": BASE.rstrip("\n"),
}
OTHERS = {
    "a number": BASE.replace("0.5", "0.25"),
    "how it is written": BASE.replace("0.5", "0.50"),
    "an operator": BASE.replace("> 0", ">= 0"),
    "a name": BASE.replace("area", "areas"),
    "a hint": BASE.replace("width: float", "width: int"),
    "indentation": BASE.replace("    return", "        return"),
    "two lines for one": BASE.replace("height += 1", "height\n        +1"),
    "a string": BASE.replace("[width", "['w', width"),
    "another string": BASE.replace("[width", "['v', width"),
    "an f-string that is alone": BASE.replace('"""Of', 'f"""Of'),
    "a string that is given away": BASE.replace('    """Of', '    return """Of'),
}


@pytest.mark.parametrize("what", ALIKE)
def test_layout_does_not_count(what):
    assert ALIKE[what] != BASE
    assert token_hash(ALIKE[what]) == token_hash(BASE)


def test_everything_else_counts():
    hashes = {what: token_hash(text) for what, text in {**OTHERS, "nothing": BASE}.items()}
    for (one, a), (other, b) in itertools.combinations(hashes.items(), 2):
        assert a != b, (one, other)


AWKWARD = r'''# -*- coding: utf-8 -*-
"""Docstring with 'quotes' and a # that is no comment."""
from __future__ import annotations
class Räuber[T]: ...
x = f"{a!r:>{width}} {{braces}} é {b['#']}" 'and' rf"\d{c}" F"" b"bytes" u'old'
y = f"""{
    a  # is there
    :.3f} on
  three lines {f'{f"{1}"}'} ü"""; z = 0x_ff + 1_000j - 1e-3 + .5 + 1if x else 2
"""no docstring"""; "nor this"
f"""{print()}"""
def g(a, /, b: "int" = 1, *args: int, c=lambda *_, **k: (yield), **kw) -> "str":
    'one' "piece"

    match a:
        case {"k": [1, *rest], **more} if rest: pass
        # between
        case str() | None as text:
            async def h(): return [await i async for i in a @ b if not i <= -1]
  # less indented
    if (n := len(a)) > 3 \
       and n << 2: return ~n ** -2 // 3 != 4
    def i():
        """Only this."""
    @ decorated . by(it)
    class C: 'stays'
    return a[..., ::2] ; assert x is not None, "why"
print(f"{'a' 'b'}" "c", end='\N{DASH}\
')'''

RECORDED = "b0a58a5840fb7fe1d63d80d69396f4176c642f7f0110ebba3ecd06cad5886a6a"


def test_every_python_finds_what_was_written_down():
    assert token_hash(AWKWARD) == RECORDED


@pytest.mark.parametrize("python", [f"python3.{minor}" for minor in range(11, 15)])
def test_pythons_agree(python):
    if shutil.which(python) is None:
        pytest.skip(f"no {python}")
    script = f"import runpy, sys; t = runpy.run_path({tokens.__file__!r})\n"
    script += "sys.stdout.write(t['token_hash'](sys.stdin.buffer.read().decode()))"
    done = subprocess.run([python, "-I", "-c", script], input=AWKWARD.encode(), capture_output=True)
    if done.returncode == 127:
        pytest.skip(f"{python} is a name without a Python behind it")
    assert done.stdout.decode() == RECORDED, done.stderr


def test_a_file_that_is_no_python_counts_by_its_bytes():
    for broken in (b"a = (1\n", b"a = '\n", b"a = '\xff'\n", b"# coding: klingon\n", b"a = \0\n"):
        assert content_hash(broken, ".py") == content_hash(broken, "")
        assert content_hash(broken + b"# 2\n", ".py") != content_hash(broken, ".py")
    latin = "# coding: latin-1\na = 'é'\n".encode("latin-1")
    assert content_hash(latin, ".py") == token_hash("a = 'é'")
    assert content_hash(b"\xef\xbb\xbfa = 1\n", ".py") == token_hash("a = 1")


def test_yaml_counts_by_its_data():
    base = "# A method.\nname: one\nrows: [[0.0], [0.5, 1.0]]\n"
    same = "rows:\n  - [0.0]  # explicit\n  - [0.5, 1.0]\nname: 'one'\n"
    assert data_hash(base) == data_hash(same) == content_hash(base.encode(), ".yaml")
    assert data_hash(base) != data_hash(base.replace("0.5", "0.25"))
    for broken in (b"a: [1\n", b"a: 2020-01-01\n", b"a: \xff\n", b"1: 2\nb: 3\n"):
        assert content_hash(broken, ".yaml") == content_hash(broken, "")


@pytest.fixture
def source(tmp_path, monkeypatch):
    """A source file beside a place for kept hashes that is empty."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "cache"))
    path = tmp_path / "a.py"
    path.write_text("a = 1\n")
    return path


def hashed(path):
    with kept_hashes() as file_hash:
        return file_hash(path)


def count_tokenised(monkeypatch):
    calls = []
    whole = tokens.content_hash
    monkeypatch.setattr(tokens, "content_hash", lambda *a: calls.append(a) or whole(*a))
    return calls


def test_the_same_bytes_are_tokenised_once(source, monkeypatch):
    calls = count_tokenised(monkeypatch)
    first = hashed(source)
    assert hashed(source) == first == tokens.token_hash("a = 1") and len(calls) == 1
    source.write_text("a = 2\n")
    assert hashed(source) != first and len(calls) == 2
    yaml = source.rename(source.with_suffix(".yaml"))
    assert hashed(yaml) == tokens.data_hash("a = 2") and len(calls) == 3


@pytest.mark.parametrize("damage", ["", "{", "[]", '{"rule": 1}', '{"rule": "x", "hashes": 3}'])
def test_a_damaged_file_counts_for_nothing(source, damage):
    first = hashed(source)
    file = kept.cache_root() / FILE
    file.write_text(damage)
    assert hashed(source) == first
    assert list(json.loads(file.read_text())["hashes"].values()) == [first]


def test_hashes_of_another_rule_count_for_nothing(source):
    first = hashed(source)
    file = kept.cache_root() / FILE
    file.write_text(file.read_text().replace(first, "0" * 64))
    assert hashed(source) == "0" * 64
    content = json.loads(file.read_text())
    file.write_text(json.dumps({**content, "rule": "another"}))
    assert hashed(source) == first


def test_there_are_not_ever_more(source, monkeypatch):
    monkeypatch.setattr(kept, "MOST", 3)
    for k in range(5):
        source.write_text(f"a = {k}\n")
        hashed(source)
    assert len(json.loads((kept.cache_root() / FILE).read_text())["hashes"]) == 2


def test_nothing_needs_to_be_kept(source, monkeypatch):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(source / "below a file"))
    assert hashed(source) == tokens.token_hash("a = 1")
