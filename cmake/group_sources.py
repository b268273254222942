#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes files that include several sources each, for a target to compile instead, without a change to what any of their names means.

    group_sources.py OUT MOST SOURCE...     MOST: sources in a group at most. Writes OUT/GROUP.cpp and prints its path, or that of a source left alone.

Most of the time of compiling a small file is that of reading the headers it shares with its neighbours. A group includes the headers of all its sources
first and then the sources, so a name that is private to a source (in an unnamed namespace, static, a macro) is seen by those after it, and the names of a
header by sources that do not include it. Sources share a group only where nothing of that kind is named in them: a function counts where it is called.
The script reads words and knows no C++: it keeps more sources apart than it must. What it would overlook mostly does not compile.
"""
import os
import re
import sys

WORD = re.compile(r"(?<![\w.])(?<!->)(?<!std::)([A-Za-z_]\w*)\s*([(<]?)")  # not a member of something; the sign tells a call
COMMENT_OR_TEXT = re.compile(r'R"(\w*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Fa-f])\'(?:\\.|[^\'\\\n])+\'', re.S)
DIRECTIVE = re.compile(r"^[ \t]*#(?:.*\\\n)*.*$", re.M)
MACRO = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(\w+)", re.M)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.M)
TYPE = re.compile(r"(?:typedef .*?|using |(?:struct|class|union|enum class|enum|concept) +(?:alignas\(.*?\) *)?)(\w+)(?: final)? *(?:$|=|:[^:])", re.S)
TOP = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FOLDERS = [os.path.join(TOP, part, kind) for part in ("core", "geomodel") for kind in ("src", "include")]
FOLDERS += [os.path.join(TOP, "tests", part, "support") for part in ("core", "geomodel")]


def end_of(text, at, opening, closing):
    """The place behind what closes the bracket at `at`."""
    depth = 0
    for place in range(at, len(text)):
        depth += (text[place] == opening) - (text[place] == closing)
        if depth == 0:
            return place + 1
    return len(text)


def declared(statement, body=""):
    """(name, whether a function) of what a statement at the scope of a namespace declares; nothing where it is a member of something."""
    statement = statement.strip()
    if re.match(r"(namespace|static_assert|using namespace)\b", statement):
        return []  # another name for a namespace: two that differ do not compile
    while statement.startswith("template"):
        statement = statement[end_of(statement, statement.find("<"), "<", ">"):].strip()
    kind = TYPE.match(statement)
    if kind:
        return [(kind.group(1), False)] + [(word, False) for word, _ in (WORD.findall(body) if re.match(r"enum(?! class)", statement) else [])]
    depth = end = 0
    for end, sign in enumerate(statement + ";"):
        depth += (sign == "<") - (sign == ">")
        if depth <= 0 and sign in "(=[;":
            break
    pointer = re.match(r"\(\s*[*&]\s*(\w+)\s*\)", statement[end:])  # to a function
    name = pointer or re.search(r"([\w:]+)\s*$", statement[:end])
    if name is None or "::" in name.group(1):
        return []
    is_function = pointer is None and statement[end:].startswith("(")
    return [(name.group(1), is_function)] + [(word, False) for word in re.findall(r",\s*[*&]?(\w+)\s*=", statement[end:])]  # several constants


def namespace_names(text):
    """(name, whether a function, whether private) of what a text without comments declares at the scope of namespaces."""
    names = [(name, False, True) for name in MACRO.findall(text)]
    text = DIRECTIVE.sub("", text)
    scopes, start, at = [], 0, 0
    while at < len(text):
        sign = text[at]
        if sign == "(":
            at = end_of(text, at, "(", ")")
            continue
        if sign == "{" and re.match(r"\s*(inline\s+)?namespace\b[\s\w:]*$|\s*extern \"\"\s*$", text[start:at]):
            scopes.append(re.match(r"\s*namespace\s*$", text[start:at]) is not None)
        elif sign in "{;":
            end = end_of(text, at, "{", "}") if sign == "{" else at + 1
            private = any(scopes) or text[start:at].lstrip().startswith("static ")
            names += [(name, is_function, private) for name, is_function in declared(text[start:at], text[at:end])]
            at = end - 1
        elif sign == "}" and scopes:
            scopes.pop()
        if sign in "{};":
            start = at + 1
        at += 1
    return names


class File:
    """A source or a header: what it names, calls and declares, and the headers it includes."""
    known = {}

    def __init__(self, path):
        self.known[path] = self
        with open(path, encoding="utf-8") as file:
            text = file.read()
        self.included = [self.header(path, name) for name in INCLUDE.findall(text)]
        self.included = [header for header in self.included if header is not None]
        self.headers = set().union(self.included, *(self.known[header].headers for header in self.included))
        text = COMMENT_OR_TEXT.sub(lambda found: "" if found.group().startswith("/") else '""', text)
        words = WORD.findall(DIRECTIVE.sub("", text))
        self.words = {word for word, _ in words}
        self.called = {word for word, sign in words if sign}
        names = namespace_names(text)
        self.functions = {name for name, is_function, _ in names if is_function}
        self.private = {name for name, _, private in names if private}
        self.names = {name for name, _, _ in names}

    @staticmethod
    def header(path, name):
        found = next((p for p in (os.path.join(f, name) for f in [os.path.dirname(path), *FOLDERS]) if os.path.exists(p)), None)
        if found is not None:
            found = os.path.normpath(found)
            if found not in File.known:
                File(found)
        return found

    def means_else_beside(self, names, functions):
        """Whether something of these names is named here; functions are among them."""
        return bool((names - functions) & self.words or functions & (self.called | self.names))


class Group:
    def __init__(self):
        self.sources, self.headers = [], set()

    def takes(self, source, together):
        new = File.known[source]
        for other in map(File.known.get, self.sources):
            if new.means_else_beside(other.private, other.functions & other.private) or other.private & new.names:
                return False
            for one, two in ((new, other), (other, new)):
                if any(one.means_else_beside(File.known[h].names, File.known[h].functions) for h in two.headers - one.headers):
                    return False
        # Two headers that some source includes both are known to bear each other.
        return not any((a, b) not in together and (File.known[a].names & File.known[b].words or File.known[b].names & File.known[a].words)
                       for a in self.headers - new.headers for b in new.headers - self.headers)

    def add(self, source):
        self.sources.append(source)
        self.headers |= File.known[source].headers


def write(path, group):
    headers = dict.fromkeys(header for source in group.sources for header in File.known[source].included)
    text = "".join('#include "%s"\n' % os.path.abspath(name) for name in [*headers, *group.sources])
    if not os.path.exists(path) or open(path, encoding="utf-8").read() != text:
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)


def main():
    out, most, sources = sys.argv[1], int(sys.argv[2]), sorted(sys.argv[3:])
    together = set()
    for source in sources:
        File(source)
        together |= {(a, b) for a in File.known[source].headers for b in File.known[source].headers}
    groups = []
    for source in sources:
        group = next((g for g in groups if len(g.sources) < most and g.takes(source, together)), None)
        if group is None:
            groups.append(group := Group())
        group.add(source)
    os.makedirs(out, exist_ok=True)
    for number, group in enumerate(groups):
        path = group.sources[0]
        if len(group.sources) > 1:
            path = os.path.join(out, "group_%d.cpp" % number)
            write(path, group)
        print(path)


if __name__ == "__main__":
    main()
