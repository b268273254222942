#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The rooms of core and geomodel: their order, their size, and the header of each source.

The list of rooms stands in docs/architecture.md, in the block after "rooms of core" and "rooms of geomodel": one room a line, its name
and what it is. A room may include headers of the rooms above it in the list, and its own.
"""
import os
import re
import unittest
from collections import Counter
from pathlib import Path

ROOT = Path(os.environ.get("GEOMESH_SOURCE_DIR", Path(__file__).resolve().parents[2]))
LIBRARIES = ("core", "geomodel")
MOST_FILES = 20


def listed_rooms(library):
    """The rooms of a library in the order of the list."""
    text = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    block = re.search(rf"<!-- rooms of {library} -->\s*```\n(.*?)```", text, re.S)
    if not block:
        raise AssertionError(f"docs/architecture.md has no list of the rooms of {library}")
    return [line.split()[0] for line in block.group(1).splitlines() if line.strip()]


def sources(library):
    """Paths below src/, with forward slashes."""
    src = ROOT / library / "src"
    return sorted(p.relative_to(src).as_posix() for p in src.rglob("*") if p.suffix in (".cpp", ".hpp"))


def included(library, source):
    return re.findall(r'#include "([^"]+)"', (ROOT / library / "src" / source).read_text(encoding="utf-8"))


def room(path):
    return os.path.dirname(path)


class Rooms(unittest.TestCase):
    def test_every_room_is_listed_once_and_every_listed_room_exists(self):
        for library in LIBRARIES:
            listed = listed_rooms(library)
            self.assertEqual(len(listed), len(set(listed)), f"{library}: a room is listed twice")
            found = {room(s) for s in sources(library)}
            self.assertEqual(sorted(found), sorted(listed), f"{library}: the list in docs/architecture.md is not what is there")

    def test_a_room_includes_only_rooms_listed_above_it(self):
        wrong = []
        for library in LIBRARIES:
            rank = {name: i for i, name in enumerate(listed_rooms(library))}
            files = set(sources(library))
            for source in sorted(files):
                for header in included(library, source):
                    if header in files and rank[room(header)] > rank[room(source)]:
                        wrong.append(f"{library}: {source} includes {header}")
        self.assertEqual(wrong, [])

    def test_no_room_has_more_than_twenty_files(self):
        for library in LIBRARIES:
            crowded = {r: n for r, n in Counter(room(s) for s in sources(library)).items() if n > MOST_FILES}
            self.assertEqual(crowded, {}, library)

    def test_every_source_has_a_header_of_its_name_or_says_first_what_it_is(self):
        wrong = []
        for library in LIBRARIES:
            public = ROOT / library / "include" / "geomesh" / library
            for source in (s for s in sources(library) if s.endswith(".cpp")):
                path = ROOT / library / "src" / source
                if path.with_suffix(".hpp").exists() or (public / (path.stem + ".hpp")).exists():
                    continue
                if not re.match(r"// SPDX[^\n]*\n///? ?\S", path.read_text(encoding="utf-8")):
                    wrong.append(f"{library}: {source}")
        self.assertEqual(wrong, [], "the first comment says what the file is, and which header declares it")

    def test_core_names_no_file_of_geomodel_and_no_third_party_library(self):
        allowed = re.compile(r"^(geomesh/core/|[a-z_/0-9]+\.hpp$)")
        for source in sources("core"):
            for header in included("core", source):
                self.assertRegex(header, allowed, source)
                self.assertFalse(header.startswith("geomesh/geomodel/"), source)
            text = (ROOT / "core" / "src" / source).read_text(encoding="utf-8")
            for header in re.findall(r"#include <([^>]+)>", text):
                of_the_compiler = header in ("immintrin.h", "sys/mman.h", "unistd.h")
                standard = re.fullmatch(r"[a-z_0-9]+", header) is not None
                self.assertTrue(standard or of_the_compiler or header.startswith(("tbb/", "oneapi/tbb")), f"{source}: <{header}>")


if __name__ == "__main__":
    unittest.main()
