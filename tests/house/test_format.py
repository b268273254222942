#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every C++ source is laid out as .clang-format says. The version of clang-format matters: Debian 12's is 14."""
import os
import re
import shutil
import subprocess
import unittest
from pathlib import Path

ROOT = Path(os.environ.get("GEOMESH_SOURCE_DIR", Path(__file__).resolve().parents[2]))
VERSION = 14
FOLDERS = ("core", "geomodel", "app", "tests", "python")


def formatter():
    """The program of the version that the tree is laid out with, or nothing."""
    for name in (f"clang-format-{VERSION}", "clang-format"):
        path = shutil.which(name)
        if path:
            said = subprocess.run([path, "--version"], capture_output=True, text=True, check=True).stdout
            if re.search(rf"version {VERSION}\.", said):
                return path
    return None


class Format(unittest.TestCase):
    def test_every_source_is_laid_out_as_the_file_in_the_root_says(self):
        program = formatter()
        if program is None:
            self.skipTest(f"clang-format {VERSION} is not installed")
        files = [p for folder in FOLDERS for p in sorted((ROOT / folder).rglob("*")) if p.suffix in (".cpp", ".hpp")]
        self.assertGreater(len(files), 100)
        said = subprocess.run([program, "--dry-run", *map(str, files)], capture_output=True, text=True, cwd=ROOT, check=False).stderr
        wrong = sorted({m.group(1) for m in re.finditer(r"^(.*?):\d+:\d+: ", said, re.M)})
        self.assertEqual([os.path.relpath(w, ROOT) for w in wrong], [], "run clang-format -i on these")


if __name__ == "__main__":
    unittest.main()
