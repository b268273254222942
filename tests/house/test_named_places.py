#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What docs/theory.md and docs/architecture.md name exists: each file, each folder, and each symbol of a file.

A name counts where it stands between backquotes and has a slash, or ends as a source file does. Paths are below the root, core/src/ or the
folder of the name before it on the same line. `path:symbol` asks that the file holds the symbol as a word.
"""
import os
import re
import unittest
from pathlib import Path

ROOT = Path(os.environ.get("GEOMESH_SOURCE_DIR", Path(__file__).resolve().parents[2]))
DOCUMENTS = ("docs/theory.md", "docs/architecture.md")
ENDINGS = (".cpp", ".hpp", ".py", ".md", ".off", ".poly", ".yaml", ".json")


def is_path(word):
    return bool(re.fullmatch(r"[\w/][\w./\-]*(:\w+)?", word)) and ("/" in word or word.split(":")[0].endswith(ENDINGS))


def named_places(document):
    """(line, path, symbol or "", folder of the path before it on the line) of each name."""
    places = []
    for number, line in enumerate((ROOT / document).read_text(encoding="utf-8").splitlines(), 1):
        folder = ""
        for word in re.findall(r"`([^`]+)`", line):
            if not is_path(word):
                continue
            path, _, symbol = word.partition(":")
            places.append((number, path, symbol, folder))
            if "/" in path:
                folder = path if path.endswith("/") else os.path.dirname(path)
    return places


def find(path, folder):
    for base in (ROOT, ROOT / "core" / "src", ROOT / folder, ROOT / "core" / "src" / folder, ROOT / "core" / "include",
                 ROOT / "docs", ROOT / "geomodel" / "src"):
        if (base / path).exists():
            return base / path
    # A header named without its folder: one of that name, anywhere in the public headers or the rooms.
    if "/" not in path:
        return next((p for top in ("core", "geomodel") for p in (ROOT / top).rglob(path)), None)
    return None


class NamedPlaces(unittest.TestCase):
    def test_each_path_named_exists(self):
        for document in DOCUMENTS:
            places = named_places(document)
            self.assertGreater(len(places), 10, f"{document}: the reader of paths finds too few")
            missing = [f"{document}:{number}: {path}" for number, path, _, folder in places if find(path, folder) is None]
            self.assertEqual(missing, [])

    def test_each_symbol_named_stands_in_its_file(self):
        missing = []
        for document in DOCUMENTS:
            for number, path, symbol, folder in named_places(document):
                file = find(path, folder)
                if not symbol or file is None:
                    continue
                if not re.search(rf"\b{symbol}\b", file.read_text(encoding="utf-8")):
                    missing.append(f"{document}:{number}: {path}:{symbol}")
        self.assertEqual(missing, [])

    def test_a_path_that_does_not_exist_is_found_out(self):
        self.assertIsNone(find("recover/model/no_such_file.hpp", ""))


if __name__ == "__main__":
    unittest.main()
