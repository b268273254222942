#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Named numbers of the rooms that build a model, name it and check it: each stands in a table with its unit, its meaning and its evidence.

tests/geomodel/constants/table.txt has one line a number: file, name, value | unit | what it decides | which test, family or bound needs
it. `scripts/constants-table` writes files, names and values anew and marks what is still to be said with a question mark.
"""
import os
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(os.environ.get("GEOMESH_SOURCE_DIR", Path(__file__).resolve().parents[2]))
TABLE = ROOT / "tests" / "geomodel" / "constants" / "table.txt"
ROOMS = ("rules", "stack", "naming", "check")
MOST = 116  # numbers in all; a change that adds one takes one away
HEAD = "file name = value | unit | what it decides | evidence"
TYPE = r"(?:double|float|int|unsigned|(?:std::)?size_t|Index|std::u?int\d+_t)"
DECLARATION = re.compile(rf"\bconstexpr\s+{TYPE}\s+(\w+ = [^;]*);")


def numbers():
    """Of each named number: file below geomodel/src, name, value as written."""
    found = []
    for room in ROOMS:
        for path in sorted((ROOT / "geomodel" / "src" / room).rglob("*.?pp")):
            text = re.sub(r"//.*", "", path.read_text(encoding="utf-8"))
            for declared in DECLARATION.findall(text):
                for one in re.split(r",\s*(?=\w+ = )", declared):
                    name, value = (re.sub(r"\s+", " ", part).strip() for part in one.split(" = ", 1))
                    if re.search(r"\d", value):
                        found.append((path.relative_to(ROOT / "geomodel" / "src").as_posix(), name, value))
    return found


def rows():
    """What the table says: by file and name, the value, the unit, the meaning and the evidence."""
    table = {}
    for line in TABLE.read_text(encoding="utf-8").splitlines()[1:]:
        number, *said = (part.strip() for part in line.split(" | "))
        file, name, value = re.fullmatch(r"(\S+) (\w+) = (.*)", number).groups()
        if (file, name) in table:
            raise AssertionError(f"{file} {name} has two rows")
        table[file, name] = (value, *said)
    return table


def write():
    known = rows() if TABLE.exists() else {}
    lines = [HEAD]
    for file, name, value in numbers():
        said = known.get((file, name), ("", "?", "?", "?"))[1:]
        lines.append(" | ".join((f"{file} {name} = {value}", *said)))
    TABLE.write_text("\n".join(lines) + "\n", encoding="utf-8")


class Constants(unittest.TestCase):
    def test_each_number_has_its_row_and_each_row_its_number(self):
        table = {place: row[0] for place, row in rows().items()}
        self.assertEqual(table, {(file, name): value for file, name, value in numbers()}, "scripts/constants-table writes the table anew")

    def test_each_row_has_a_unit_a_meaning_and_evidence(self):
        lacking = [place for place, row in rows().items() if len(row) != 4 or any(part in ("", "?") for part in row)]
        self.assertEqual(lacking, [])

    def test_there_are_no_more_numbers(self):
        self.assertLessEqual(len(numbers()), MOST)


if __name__ == "__main__":
    if "--write" in sys.argv:
        write()
    else:
        unittest.main()
