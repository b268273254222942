#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Documents, comments and messages use the words of the field and none of the home-made ones.

WORDS has each word that is not to be used, with what to write in its place. Code blocks, code spans and targets of links are not searched.
Length and order of sentences are left to an editor: `scripts/draw-sentences` draws some to read.

Run with `--list [FOLDER...]` for the words found in the comments of other folders.
"""
import re
import sys
import unittest

import prose

WORDS = {
    r"brought together|bring(s|ing)? together|(go|goes|went|come|came) together": "merged; of vertices, snapped",
    r"l(ie|ies|ay|ying) (in|on) each other": "coincide, nearly coincide",
    r"twins?|given twice": "duplicate",
    r"pockets?": "thin void, sliver gap",
    r"flaps?|fins?": "dangling face",
    r"slits?|notch(es)?": "crack; hole",
    r"specks?": "tiny feature",
    r"creases?": "feature edge",
    r"guard(s|ed)?|held within": "envelope; kept within the tolerance",
    r"judge[sd]?|judging|claim(s|ed)?": "checker, specification; checked",
    r"laid down": "deposited; in depositional order",
    r"forced": "imposed by the input",
    r"throw (that is|is|was) smeared": "a fault smeared into a ramp",
    r"tells?|told|asked|ask(s|ing)? for": "reports, reported; requested, requests",
    r"goes|went|stays|stayed": "is removed, was removed; is kept",
}

# Beginnings of a comment that need the code beneath to be understood.
BEGINNINGS = re.compile(r"(Of|What|Where|That|Those|The same|So|And|Not)\b(?! only\b)")


def words_found(text):
    """Yields (line from 0, word, what to write) of each word that is not to be used."""
    text = prose.without_code(text)
    for pattern, instead in WORDS.items():
        for match in re.finditer(rf"\b(?:{pattern})\b".replace(" ", r"\s+"), text, re.I):
            yield text.count("\n", 0, match.start()), match.group(0), instead


def listing(paths, are_comments):
    found = []
    for path in paths:
        name = path.relative_to(prose.ROOT).as_posix()
        for start, text in prose.parts_of(path):
            found += [f"{name}:{start + line}: '{word}': write {instead}" for line, word, instead in words_found(text)]
            begins = BEGINNINGS.match(text.lstrip("*/!< \n")) if are_comments else None
            if begins:
                found.append(f"{name}:{start}: begins with '{begins.group(0)}': a comment stands alone")
    return found


class Words(unittest.TestCase):
    maxDiff = None

    def test_the_finder_sees_words_in_prose_and_none_in_code(self):
        def found(text):
            return [word for _, word, _ in words_found(next(prose.prose_of_document(text))[1])]
        self.assertEqual(found("Surfaces are brought\ntogether. The Twin goes."), ["brought\ntogether", "Twin", "goes"])
        self.assertEqual(found("`forced`, [a page](forced.md#told)\n```\nflap\n```\n    speck = 1\n"), [])
        self.assertEqual(found("It is retold; fine, finally, foregoes, holds."), [])
        self.assertTrue(BEGINNINGS.match("Of the faces") and not BEGINNINGS.match("Often") and not BEGINNINGS.match("Not only"))

    def test_documents_use_the_words_of_the_field(self):
        self.assertGreater(len(prose.documents()), 20)
        self.assertEqual(listing(prose.documents(), are_comments=False), [])

    def test_descriptions_in_schemas_use_the_words_of_the_field(self):
        schemas = sorted((prose.ROOT / "docs").glob("*.schema.json"))
        self.assertEqual(len(schemas), 3)
        found = []
        for path in schemas:
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                for description in re.findall(r'"description": "((?:[^"\\]|\\.)*)"', line):
                    found += [f"{path.name}:{number}: '{word}': write {instead}" for _, word, instead in words_found(description)]
        self.assertEqual(found, [])

    def test_comments_use_the_words_of_the_field(self):
        sources = prose.sources(prose.SOURCES)
        self.assertGreater(len(sources), 1000)
        self.assertEqual(listing(sources, are_comments=True), [])

    def test_messages_use_the_words_of_the_field(self):
        found, n_messages = [], 0
        for path in prose.sources(prose.SOURCES):
            if "tests" in path.relative_to(prose.ROOT).parts:
                continue
            for line, text in prose.messages_of(path):
                n_messages += 1
                found += [f"{path.relative_to(prose.ROOT)}:{line}: '{word}': write {instead}" for _, word, instead in words_found(text)]
        self.assertGreater(n_messages, 3000)
        self.assertEqual(found, [])


if __name__ == "__main__":
    if "--list" in sys.argv:
        folders = sys.argv[sys.argv.index("--list") + 1:] or prose.SOURCES
        print("\n".join(listing(prose.sources(folders), are_comments=True)))
    else:
        unittest.main()
