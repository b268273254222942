# SPDX-License-Identifier: GPL-3.0-or-later
"""No lambda captures a name of a structured binding: clang before 16, Debian 12's among them, does not compile that.

The sources are read as text. A name counts as captured where the body of a lambda with captures names it, in the block of the binding.
"""
import os
import re
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
ROOMS = ("core", "geomodel", "app", "tests", "python", "samples")

BINDING = re.compile(r"\bauto\s*(?:const\s*)?&{0,2}\s*\[([\w\s,]+)\]\s*([=:({])")
LAMBDA = re.compile(r"(?<![\w\])])\[([^\[\]]+)\]\s*([({])")
PAIRS = {"(": ")", "{": "}", "[": "]"}


def blank(text):
    """The text without comments, strings and characters, as long as before."""
    pattern = r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])\''
    return re.sub(pattern, lambda m: re.sub(r"[^\n]", " ", m.group()), text, flags=re.S)


def end_of(text, at):
    """Behind the bracket that closes the one at this place."""
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] in "([{") - (text[i] in ")]}")
        if depth == 0:
            return i + 1
    return len(text)


def end_of_block(text, at):
    """Of the block about this place."""
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] in "{") - (text[i] in "}")
        if depth < 0:
            return i
    return len(text)


def end_of_statement(text, at):
    """Of the block, or of the one statement, that begins at this place."""
    at += len(text[at:]) - len(text[at:].lstrip())
    if text[at:at + 1] == "{":
        return end_of(text, at)
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] in "([{") - (text[i] in ")]}")
        if depth == 0 and text[i] == ";":
            return i + 1
    return len(text)


def scope_of(text, binding):
    """From behind the binding to where its names end."""
    if binding.group(2) != ":":
        return binding.end(), end_of_block(text, binding.end())
    loop = text.rfind("for", 0, binding.start())
    return binding.end(), end_of_statement(text, end_of(text, text.index("(", loop)))


def lambdas_in(text, first, last):
    """Captures, parameters and body of each lambda that begins there."""
    for m in LAMBDA.finditer(text, first, last):
        at, parameters = m.end() - 1, ""
        if m.group(2) == "(":
            parameters, at = text[at:end_of(text, at)], text.find("{", end_of(text, at))
        if at >= 0 and not re.search(r"[;)]", text[m.end() - 1 + len(parameters):at]):
            yield m.group(1), parameters, at, end_of(text, at)


def captured(source):
    """(line, name) of each name of a binding that a lambda captures."""
    text, found = blank(source), set()
    for binding in BINDING.finditer(text):
        first, last = scope_of(text, binding)
        names = [n.strip() for n in binding.group(1).split(",")]
        for captures, parameters, begin, end in lambdas_in(text, first, last):
            for name in names:
                is_default = re.match(r"\s*[&=]\s*(,|$)", captures)
                is_named = re.search(rf"(^|,)\s*&?\s*{name}\s*(,|$)", captures)
                if not (is_default or is_named) or re.search(rf"\b{name}\b", parameters):
                    continue
                if re.search(rf"(^|,)\s*&?\s*{name}\s*=", captures):
                    continue
                for use in re.finditer(rf"(?<![\w.>:]){name}\b", text[begin:end]):
                    if not any(b.start() < begin + use.start() and re.search(rf"\b{name}\b", b.group(1)) for b in BINDING.finditer(text, begin, end)):
                        found.add((text.count("\n", 0, begin + use.start()) + 1, name))
    return sorted(found)


class Bindings(unittest.TestCase):
    def test_no_lambda_captures_a_structured_binding(self):
        found = []
        for room in ROOMS:
            for folder, _, files in os.walk(os.path.join(ROOT, room)):
                for name in files:
                    if name.endswith((".cpp", ".hpp")):
                        path = os.path.join(folder, name)
                        with open(path, encoding="utf-8") as file:
                            found += [f"{os.path.relpath(path, ROOT)}:{line}: {what}" for line, what in captured(file.read())]
        self.maxDiff = None
        self.assertEqual(found, [], "give the captured value a name of its own")

    def test_what_counts_as_captured(self):
        head = "void f() { const auto& [a, b] = pair; "
        self.assertEqual(captured(head + "g([&] { return a; }); }"), [(1, "a")])
        self.assertEqual(captured(head + "g([=](int x) -> int {\n return x + b; }); }"), [(2, "b")])
        self.assertEqual(captured(head + "g([&b] { return b; }); }"), [(1, "b")])
        self.assertEqual(captured("for (const auto& [a, b] : map) g([&](int x) { return x < a; });"), [(1, "a")])
        for own in ("g([&](int a) { return a; });", "g([&] { return x.a; });", "g([c = a] { return c; });", "g([&] { auto [a, x] = y; return a; });"):
            self.assertEqual(captured(head + own + " }"), [], own)
        self.assertEqual(captured("for (const auto& [a, b] : map) { g(a); } void h() { int a = 0; k([&] { return a; }); }"), [])
        self.assertEqual(captured("{ auto [a, b] = pair; } { int a = 0; k([&] { return a; }); }"), [])
        self.assertEqual(captured(head + "g([&] { return \"a\"; /* a */ }); }"), [])


if __name__ == "__main__":
    unittest.main()
