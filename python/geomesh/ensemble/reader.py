# SPDX-License-Identifier: GPL-3.0-or-later
"""YAML with positions: all mistakes are collected with line and column, and reported at once."""
import difflib
import math

import yaml

from ..core.errors import UsageError


def composed(file):
    """Returns the node of a YAML file, or None if it is empty."""
    try:
        with open(file, encoding="utf-8") as text:
            return yaml.compose(text.read(), Loader=yaml.SafeLoader)
    except FileNotFoundError:
        raise UsageError("no such file: %s" % file) from None
    except (OSError, UnicodeDecodeError) as error:
        raise UsageError("%s: %s" % (file, error)) from None
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark
        place = ":%d:%d" % (mark.line + 1, mark.column + 1) if mark else ""
        raise UsageError("%s%s: %s" % (file, place, error.problem)) from None


class Problems:
    """Collects the mistakes found in one YAML file."""

    def __init__(self, file):
        self._file, self._found = file, []

    def add(self, node, text):
        mark = node.start_mark
        self._found.append((mark.line, mark.column, "%s:%d:%d: %s" % (self._file, mark.line + 1, mark.column + 1, text)))

    def tell(self):
        if self._found:
            raise UsageError("\n".join(text for _, _, text in sorted(self._found)))


class Entry:
    """A node of a YAML file, with its path there, such as surfaces.salt.shift."""

    def __init__(self, node, path, problems):
        self.node, self.path, self.problems = node, path, problems

    def mistake(self, text):
        self.problems.add(self.node, "%s: %s" % (self.path, text) if self.path else text)

    def is_map(self):
        return isinstance(self.node, yaml.MappingNode)

    def is_list(self):
        return isinstance(self.node, yaml.SequenceNode)

    def items(self, known=None, what="key"):
        """Returns (key, entry) pairs of a map; unknown keys are reported."""
        if not self.is_map():
            self.mistake("a map was expected")
            return []
        found, seen = [], set()
        for key_node, value in self.node.value:
            key = str(key_node.value)
            at = Entry(key_node, (self.path + "." if self.path else "") + key, self.problems)
            if key in seen:
                at.mistake("duplicate")
            elif known is not None and key not in known:
                at.mistake("no such %s%s" % (what, meant(key, known)))
            else:
                found.append((key, Entry(value, at.path, self.problems)))
            seen.add(key)
        return found

    def elements(self):
        return [Entry(node, "%s[%d]" % (self.path, row), self.problems) for row, node in enumerate(self.node.value)]

    def text(self):
        if isinstance(self.node, yaml.ScalarNode):
            return self.node.value
        self.mistake("a word was expected")
        return None

    def number(self):
        """Returns the entry's value as a finite number, or None after reporting the mistake."""
        value = as_number(self.node)
        if value is None:
            self.mistake("a number was expected")
        return value

    def whole(self, least):
        value = as_number(self.node)
        if value is None or value != int(value) or value < least:
            self.mistake("a whole number from %d was expected" % least)
            return None
        return int(value)

    def numbers(self, count):
        if not self.is_list() or len(self.node.value) != count:
            self.mistake("a list of %d numbers was expected" % count)
            return None
        values = [entry.number() for entry in self.elements()]
        return None if None in values else values

    def plain(self):
        """Returns the entry's value as a plain Python object: a number, text, list or dict."""
        constructor = yaml.SafeLoader("")
        try:
            return constructor.construct_document(self.node)
        finally:
            constructor.dispose()


def as_number(node):
    if not isinstance(node, yaml.ScalarNode):
        return None
    try:
        value = float(node.value)
    except ValueError:
        return None
    return value if math.isfinite(value) else None


def meant(word, known):
    """Returns "; did you mean ...?" if a known word is similar, else the known words."""
    close = difflib.get_close_matches(word, list(known), 1)
    if close:
        return "; did you mean %s?" % close[0]
    return "; known are " + ", ".join(known) if known else "; there is none"
