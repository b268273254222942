# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the prose of the tree: comments of C++ and Python sources, and the text of Markdown documents without code.

`tests/house/test_words.py` searches it for words that are not to be used, `scripts/draw-sentences` draws from it at random.
"""
import ast
import io
import os
import re
import tokenize
from pathlib import Path

ROOT = Path(os.environ.get("GEOMESH_SOURCE_DIR", Path(__file__).resolve().parents[2]))
SOURCES = ("core", "geomodel", "app", "python")

FULL_LINE = re.compile(r"^\s*//(/?)(<?)[ \t]?(.*)$")
TRAILING = re.compile(r"""^(?:[^"'/]|(?<=\d)'(?=\d)|"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*'|/(?!/))*?\s//(/?)(<?)[ \t]?(.*)$""")


def comments_of_cpp(text):
    """Yields (line, text) of each comment. Consecutive lines are one comment, as are lines that continue a trailing one."""
    block, start, block_is_trailing, column = [], 0, False, 0
    for number, line in enumerate(text.split("\n"), 1):
        full = FULL_LINE.match(line)
        if full:
            if block and full.group(2) == "" and block_is_trailing and line.index("//") != column:
                yield start, "\n".join(block)
                block = []
            if not block:
                start, block_is_trailing = number, False
            block.append(full.group(3))
            continue
        if block:
            yield start, "\n".join(block)
            block = []
        trailing = TRAILING.match(line)
        if trailing:
            start, block, block_is_trailing = number, [trailing.group(3)], True
            column = trailing.start(1) - 2
    if block:
        yield start, "\n".join(block)


def comments_of_python(text):
    """Yields (line, text) of comments, of which consecutive lines are one, and of docstrings."""
    last, start, block = None, 0, []
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            if block and token.start[0] != last + 1:
                yield start, "\n".join(block)
                block = []
            start, last = (start if block else token.start[0]), token.start[0]
            block.append(token.string.lstrip("#!").strip())
    if block:
        yield start, "\n".join(block)
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node, clean=True):
            yield getattr(node, "lineno", 1), ast.get_docstring(node, clean=True)


def prose_of_document(text):
    """The document with code blocks and HTML comments blanked, so that line numbers are kept."""
    def blank(match):
        return "\n" * match.group(0).count("\n")
    text = re.sub(r"<!--.*?-->", blank, text, flags=re.S)
    text = re.sub(r"^ *(```+).*?^ *\1", blank, text, flags=re.S | re.M)
    yield 1, "\n".join("" if re.match(r"    (?! *(\d+\.|[-*]) )", line) else line for line in text.split("\n"))


LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')


def messages_of(path):
    """Yields (line, text) of each string literal that holds a blank, as messages do. Lines of comments alone are left out."""
    for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
        if not re.match(r"\s*(//|#)", line):
            yield from ((number, match.group(1)) for match in LITERAL.finditer(line) if " " in match.group(1))


CODE = re.compile(r"``[^`]*``|`[^`]*`|\]\([^)]*\)")


def without_code(text):
    """The text with code spans and targets of links replaced by as many blanks."""
    return CODE.sub(lambda m: re.sub(r"[^\n]", " ", m.group(0)), text)


def parts_of(path):
    """Yields (line, text) of each comment of a source, or of the prose of a document."""
    reader = {".md": prose_of_document, ".py": comments_of_python}.get(path.suffix, comments_of_cpp)
    for line, text in reader(path.read_text(encoding="utf-8")):
        yield line, re.sub(r"SPDX-License-Identifier.*", "", text)


def documents():
    """README, CONTRIBUTING, CHANGELOG and all pages below docs/."""
    return sorted((ROOT / "docs").rglob("*.md")) + sorted(ROOT.glob("*.md"))


def sources(folders=SOURCES):
    """C++ and Python sources below these folders."""
    return sorted(p for folder in folders for p in (ROOT / folder).rglob("*") if p.suffix in (".cpp", ".hpp", ".py"))


def sentences(text):
    """Yields (line from 0, sentence) of a text. Headings, rows of tables and items of lists end a sentence."""
    paragraph, first = [], 0
    for number, line in enumerate(text.split("\n") + [""]):
        begins = re.match(r"\s*(?:[-*]\s|\d+\.\s|#+\s|\||!\[)\s*", line)
        if (begins or not line.strip()) and paragraph:
            for sentence in re.split(r"(?<=[.!?])[)\"*]*\s+(?=[A-Z`\"(])", " ".join(paragraph)):
                yield first, sentence
            paragraph = []
        if line.strip() and not re.match(r"\s*(#|\||!\[)", line):
            if not paragraph:
                first = number
            paragraph.append((line[begins.end():] if begins else line).strip())
