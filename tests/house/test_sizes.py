#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions have at most six parameters; no class over 150 lines is a long function in disguise (a member run()).

EXCEPTIONS lists what is over either limit today. It can only shrink: an entry that is no longer needed fails the test, as a new one does.
Run with `--list` for what is over the limits.
"""
import os
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(os.environ.get("GEOMESH_SOURCE_DIR", Path(__file__).resolve().parents[2]))
MOST_PARAMETERS = 6
MOST_LINES_WITH_RUN = 150
FOLDERS = ("core", "geomodel", "app", "python")

NO_FUNCTION = {"if", "for", "while", "switch", "catch", "return", "sizeof", "alignof", "decltype", "static_assert", "constexpr", "requires",
               "noexcept", "defined", "throw", "new", "delete", "operator"}


def without_comments_and_strings(text):
    """The text, each character in its place."""
    pattern = re.compile(r'R"(\w*)\(.*?\)\1"|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)+\'|//[^\n]*|/\*.*?\*/|^[ \t]*#(?:[^\n\\]|\\.|\\\n)*', re.S | re.M)
    return pattern.sub(lambda m: re.sub(r"[^\n]", " ", m.group(0)), text)


def closing(text, at):
    """Where the bracket at `at` closes."""
    pairs, depth = {"(": ")", "{": "}", "[": "]"}, 0
    for i in range(at, len(text)):
        if text[i] in pairs:
            depth += 1
        elif text[i] in pairs.values():
            depth -= 1
            if depth == 0:
                return i
    return len(text)


def n_parameters(inside):
    """Commas outside of brackets; of < and > only those of templates are in a list of parameters."""
    if not inside.strip() or inside.strip() == "void":
        return 0
    depth, commas = 0, 0
    for character in re.sub(r"->|<=|>=|<<|&&", "  ", inside):
        depth += (character in "([{<") - (character in ")]}>")
        commas += character == "," and depth == 0
    return commas + 1


AFTER_PARAMETERS = re.compile(r"\s*(?:const\b|noexcept\b|override\b|final\b|&&?|->\s*[\w:<>,&* ]+?|requires\b[^{;]*)*\s*(\{|:(?!:))")


def functions(text):
    """(line, name, number of parameters) of every function that is defined."""
    for match in re.finditer(r"([~\w]+)\s*\(", text):
        name = match.group(1)
        if name in NO_FUNCTION or not re.match(r"[A-Za-z_~]", name):
            continue
        end = closing(text, match.end() - 1)
        after = AFTER_PARAMETERS.match(text, end + 1)
        if not after:
            continue
        before = text[:match.start()].rstrip()
        last = re.search(r"(\w+|\S)$", before)
        is_member_definition = before.endswith("::")
        is_typed = last is not None and re.match(r"[\w>&*\]]", last.group(1)) and last.group(1) not in NO_FUNCTION | {"else", "do", "co_return"}
        is_constructor = last is None or last.group(1) in "{};:)>"
        if is_member_definition or is_typed or is_constructor:
            yield text.count("\n", 0, match.start()) + 1, name, n_parameters(text[match.end():end])


def classes_with_run(text):
    """(line, name, number of lines) of every class or struct with a member run()."""
    for match in re.finditer(r"\b(?:class|struct)\s+(\w+)[^;{}()]*\{", text):
        end = closing(text, match.end() - 1)
        if re.search(r"\brun\(\)\s*(?:const\s*)?[{;]", text[match.end():end]):
            yield text.count("\n", 0, match.start()) + 1, match.group(1), text.count("\n", match.start(), end) + 1


def over_the_limits():
    found = {}
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix not in (".cpp", ".hpp"):
                continue
            text = without_comments_and_strings(path.read_text(encoding="utf-8"))
            name = path.relative_to(ROOT).as_posix()
            for line, function, count in functions(text):
                if count > MOST_PARAMETERS:
                    found[f"{name}: {function}() has {count} parameters"] = line
            for line, kind, count in classes_with_run(text):
                if count > MOST_LINES_WITH_RUN:
                    found[f"{name}: class {kind} with run() is over {MOST_LINES_WITH_RUN} lines"] = line
    return found


EXCEPTIONS = {
    "core/src/classify/classify.cpp: class Classifier with run() is over 150 lines",
    "core/src/recover/model/facet_trace.cpp: class Tracer with run() is over 150 lines",
    "core/src/recover/operations/polyhedron_filling.cpp: class Filler with run() is over 150 lines",
    "core/src/recover/steiner_removal/boundary_points_inward.cpp: class PointRemoval with run() is over 150 lines",
    "core/src/tetrahedralize/canonical_form.cpp: class Builder with run() is over 150 lines",
    "geomodel/src/arrangement/arrange.cpp: class Arrangement with run() is over 150 lines",
    "geomodel/src/arrangement/diagnosis/validate_soup.cpp: class Validator with run() is over 150 lines",
    "geomodel/src/arrangement/model/arranged.cpp: class Round with run() is over 150 lines",
    "geomodel/src/arrangement/snap/cluster.cpp: class Cluster with run() is over 150 lines",
    "geomodel/src/arrangement/snap/snap.cpp: class Snapper with run() is over 150 lines",
    "geomodel/src/rules/trim_soup.cpp: class Trimmer with run() is over 150 lines",
    "geomodel/src/stack/sheets/sheet_approximation.cpp: class Approximation with run() is over 150 lines",
}


class Sizes(unittest.TestCase):
    def test_the_finder_counts_parameters_and_lines(self):
        text = without_comments_and_strings("""
int seven(int a, std::map<int, int> b, int (&c)[3], int d = f(1, 2), int e, const char* g = "a, b", int h) { return 0; }
struct S { S(int a, int b) : a_(a) {} void run() { call(1, 2, 3, 4, 5, 6, 7, 8); } };
void declared(int, int, int, int, int, int, int, int);  // int more(int, int, int, int, int, int, int, int, int);
""")
        counts = {name: count for _, name, count in functions(text)}
        self.assertEqual({k: v for k, v in counts.items() if k in ("seven", "S", "run", "declared", "more")},
                         {"seven": 7, "S": 2, "run": 0})
        self.assertEqual([(name, n) for _, name, n in classes_with_run(text)], [("S", 1)])

    def test_nothing_but_the_listed_exceptions_is_over_the_limits(self):
        found = over_the_limits()
        self.assertEqual(sorted(set(found) - EXCEPTIONS), [], "give these fewer parameters, or parts with names")
        self.assertEqual(sorted(EXCEPTIONS - set(found)), [], "these are mended: take them out of EXCEPTIONS")


if __name__ == "__main__":
    if "--list" in sys.argv:
        for what, line in over_the_limits().items():
            print(f"{what} (line {line})")
    else:
        unittest.main()
