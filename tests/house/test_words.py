#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences of comments and documents have at most 25 words: one fact a sentence, the noun first.

A clause after a colon or a semicolon counts as a sentence of its own. One word are: a code span, a formula between two operators, a path,
the text of a link. Left aside: tables, code blocks, headings, licences, sources in parentheses (names with a year), and lists of short
items. docs/history is left as it was written: each page there is a record of its date.

Run with `--list` for all long sentences with their places, whatever the folder.
"""
import ast
import io
import os
import re
import sys
import tokenize
import unittest
from pathlib import Path

ROOT = Path(os.environ.get("GEOMESH_SOURCE_DIR", Path(__file__).resolve().parents[2]))
MOST_WORDS = 25
SOURCES = ("core", "geomodel", "app", "python")
RECORDS = ("docs/history/",)

FULL_LINE = re.compile(r"^\s*//(/?)(<?)[ \t]?(.*)$")
TRAILING = re.compile(r"""^(?:[^"'/]|"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*'|/(?!/))*?\s//(/?)(<?)[ \t]?(.*)$""")


def comments_of_cpp(text):
    """(line, text) of each comment; lines that follow each other are one."""
    block, start = [], 0
    for number, line in enumerate(text.split("\n"), 1):
        full, trailing = FULL_LINE.match(line), None
        if full:
            if block and full.group(2) == "" and block_is_trailing:
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
    if block:
        yield start, "\n".join(block)


def comments_of_python(text):
    """Comments, lines that follow each other as one, and the strings that document."""
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
    """The document without what is no prose, line for line."""
    text = re.sub(r"<!--.*?-->", lambda m: "\n" * m.group(0).count("\n"), text, flags=re.S)
    text = re.sub(r"^```.*?^```", lambda m: "\n" * m.group(0).count("\n"), text, flags=re.S | re.M)
    lines = []
    for line in text.split("\n"):
        is_prose = not re.match(r"\s*(\||#|!\[)|    (?! *(\d+\.|[-*]) )", line)
        lines.append(line if is_prose else "")
    yield 1, "\n".join(lines)


def paragraphs(start, text):
    """(line, text in one line) of paragraphs and items of lists."""
    block, first = [], start
    for number, line in enumerate(text.split("\n"), start):
        item = re.match(r"\s*(?:[-*]|\d+\.|\([a-z]\)|@\w+|:param \w+:)\s+(.*)$", line)
        is_formula = (re.match(r"\s{4,}\S", line) and not block) or re.search(r"\S {3,}\S", line)  # or a row of columns
        if not line.strip() or item or is_formula:
            if block:
                yield first, " ".join(block)
            block = []
        if item:
            block, first = [item.group(1)], number
        elif line.strip() and not is_formula:
            if not block:
                first = number
            block.append(line.strip())
    if block:
        yield first, " ".join(block)


ONE_WORD = re.compile(r"``[^`]*``|`[^`]*`|\[[^\]]*\]\([^)]*\)")
NO_WORD = re.compile(r"\([^()]*\b(?:1[89]|20)\d\d[^()]*\)")  # a source
FORMULA = re.compile(r"(?<=\w) ([-+*/=<>]|<=|>=|==|->|=>) (?=[\w(])")
ABBREVIATION = re.compile(r"\b(?:e\.g|i\.e|et al|cf|vs|Fig|Sec|No)\.")


def masked(paragraph):
    """The paragraph, each character in its place, with what is one word or none written over."""
    text = ONE_WORD.sub(lambda m: "x" * len(m.group(0)), paragraph)
    text = NO_WORD.sub(lambda m: "~" * len(m.group(0)), text)
    text = FORMULA.sub(lambda m: "x" * len(m.group(0)), text)
    return ABBREVIATION.sub(lambda m: "x" * len(m.group(0)), text)


def sentences(paragraph):
    """(as counted, as written) of each."""
    text, begin = masked(paragraph), 0
    for end in re.finditer(r"(?<=[.;:?!])[)\"*]*\s+|$", text):
        if text[begin:end.start()].strip():
            yield text[begin:end.start()], paragraph[begin:end.start()]
        begin = end.end()


def words(sentence):
    return [w for w in sentence.split() if re.search(r"\w", w)]


def is_list_of_short_items(sentence):
    items = re.split(r",| and | or ", sentence)
    return len(items) >= 6 and len(words(sentence)) / len(items) <= 3.2


def long_sentences(path):
    text = path.read_text(encoding="utf-8")
    parts = {".md": prose_of_document, ".py": comments_of_python}.get(path.suffix, comments_of_cpp)(text)
    for start, part in parts:
        if "SPDX-License-Identifier" in part:
            part = re.sub(r"SPDX-License-Identifier.*", "", part)
        for line, paragraph in paragraphs(start, part):
            for counted, written in sentences(paragraph):
                if len(words(counted)) > MOST_WORDS and not is_list_of_short_items(counted):
                    yield line, len(words(counted)), written


def files():
    for folder in SOURCES:
        yield from sorted(p for p in (ROOT / folder).rglob("*") if p.suffix in (".cpp", ".hpp", ".py"))
    yield from sorted((ROOT / "docs").rglob("*.md"))
    yield from sorted(ROOT.glob("*.md"))


def listing(paths):
    found = []
    for path in paths:
        name = path.relative_to(ROOT).as_posix()
        if not name.startswith(RECORDS):
            found += [f"{name}:{line}: ({count} words) {sentence}" for line, count, sentence in long_sentences(path)]
    return found


class Words(unittest.TestCase):
    def test_the_finder_sees_what_is_long_and_leaves_what_is_none(self):
        long = " ".join(["word"] * 26)
        cpp = f"int a;  ///< {long}\nint b;  ///< short\n// {long[:60]}\n// {long[60:]}\n/// | {long} |\nchar c = '\"';  // {long[:-5]}\n"
        self.assertEqual([line for line, part in comments_of_cpp(cpp) for _ in [0] if len(words(part)) > MOST_WORDS], [1, 3])
        self.assertEqual(len(list(sentences(f"{long}. {long}; {long}"))), 3)
        self.assertEqual([len(words(c)) for c, _ in sentences("by `a b c d e` (Shewchuk 1997, section 2) of x = y + z")], [4])
        self.assertTrue(is_list_of_short_items("horizons, faults, bodies, wells, named points, curves, borders and tips"))

    def test_no_sentence_of_a_comment_or_a_document_has_more_than_25_words(self):
        self.assertEqual(listing(files()), [])


if __name__ == "__main__":
    if "--list" in sys.argv:
        print("\n".join(listing(files())))
    else:
        unittest.main()
