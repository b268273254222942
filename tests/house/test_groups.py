#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sources compiled in one group mean what each means alone (cmake/group_sources.py): what would be seen by another file keeps the two apart."""
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(os.environ.get("GEOMESH_SOURCE_DIR", Path(__file__).resolve().parents[2]))
SCRIPT = ROOT / "cmake" / "group_sources.py"


def sources_of(path):
    """Those that a file of a group includes; the file itself where it is a source."""
    included = re.findall(r'#include ".*/(\w+\.cpp)"', Path(path).read_text(encoding="utf-8"))
    return set(included or [os.path.basename(path)])


def groups_of(files):
    """The sources among `files` (name: text), as sets of names in one group each."""
    with tempfile.TemporaryDirectory() as top:
        rooms = Path(top) / "core" / "src"
        rooms.mkdir(parents=True)
        for name, text in files.items():
            (rooms / name).write_text(text, encoding="utf-8")
        sources = [str(rooms / name) for name in files if name.endswith(".cpp")]
        told = subprocess.run([sys.executable, str(SCRIPT), os.path.join(top, "out"), "16", *sources], check=True, stdout=subprocess.PIPE, text=True).stdout
        return sorted((sources_of(path) for path in told.splitlines()), key=sorted)


class Groups(unittest.TestCase):
    def expect_apart(self, first, second, **headers):
        files = {"a.cpp": first, "b.cpp": second, **{name + ".hpp": text for name, text in headers.items()}}
        self.assertEqual(groups_of(files), [{"a.cpp"}, {"b.cpp"}])

    def test_files_without_names_in_common_are_one_group(self):
        self.assertEqual(groups_of({"a.cpp": "namespace { int one() { return 1; } }\nint a() { return one(); }\n",
                                    "b.cpp": "namespace { int two() { return 2; } }\nint b() { return two(); } // one\n"}), [{"a.cpp", "b.cpp"}])

    def test_a_private_function_that_another_file_names(self):
        self.expect_apart("namespace x { namespace { int length(int a) { return a; } } }\n", "namespace x { int b() { return length(2.0); } }\n")

    def test_private_types_constants_and_macros(self):
        for text in ("namespace { struct Edge { int a; }; }", "namespace { using Edge = int; }", "namespace { constexpr int most = 1, Edge = 2; }",
                     "namespace { template <typename T> T Edge(T a) { return a; } }", "namespace { enum Kind { Face, Edge }; }", "static int Edge(int a) { return a; }",
                     "#define Edge 3", "namespace { void (*Edge)(int) = nullptr; }", "namespace { const int Edge[2]{1, 2}; }", "namespace { const std::map<int, int> Edge = {{1, 2}}; }"):
            self.expect_apart(text + "\n", "namespace { int b() { return Edge(1); } }\n")

    def test_headers_come_before_private_names(self):
        self.assertEqual(groups_of({"a.cpp": "namespace { int length(int a) { return a; } }\n", "b.cpp": '#include "h.hpp"\n',
                                    "h.hpp": "#pragma once\ninline int twice() { return length(2); }\n"}), [{"a.cpp", "b.cpp"}])

    def test_a_name_of_a_header_that_the_other_file_does_not_include(self):
        self.expect_apart('#include "h.hpp"\n', "namespace { int length(int a) { return a; } }\n", h="#pragma once\nint length(double a);\n")

    def test_a_name_of_a_header_that_the_headers_of_the_other_file_use(self):
        self.expect_apart('#include "h.hpp"\n', '#include "k.hpp"\n', h="#pragma once\nint length(double a);\n", k="#pragma once\ninline int b() { return length(1); }\n")

    def test_headers_that_one_source_includes_bear_each_other(self):
        files = {"a.cpp": '#include "h.hpp"\n', "b.cpp": '#include "k.hpp"\n', "c.cpp": '#include "h.hpp"\n#include "k.hpp"\n',
                 "h.hpp": "#pragma once\nint length(double a);\n", "k.hpp": "#pragma once\ninline int b() { return length(1); }\n"}
        self.assertEqual(groups_of(files), [{"a.cpp", "b.cpp", "c.cpp"}])

    def test_members_locals_and_texts_are_no_calls(self):
        self.assertEqual(groups_of({"a.cpp": "namespace { int length(int a) { return a; } }\n",
                                    "b.cpp": 'int b(P p) { double length = p.length(); return q->length("length"); }  // length\n'}), [{"a.cpp", "b.cpp"}])


if __name__ == "__main__":
    unittest.main()
