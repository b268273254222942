# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs what a document prints: commands, project files and snippets of them, Python.

A fenced block with a title is a file of that name. `sh` blocks are run by bash and `python` blocks by Python, in the order of the page and in one
folder. A `yaml` block without a title is a project, or a part of one: the part is put into the project of the tutorial
`faulted-field.md` (top-level keys replace its keys, entries of surfaces and wells replace those of the same name). A list has entries of
surfaces. The folder has the data of that tutorial, the samples and docs/.
"""
import os
import re
import shutil
import subprocess
import textwrap
from typing import NamedTuple

import yaml

from geomesh_program import PROGRAM, SOURCE, ProgramTest

BLOCK = re.compile(r"^( *)```(\w+)([^\n]*)\n(.*?)^\1```[ ]*$", re.M | re.S)
PACKAGE = os.path.join(os.path.dirname(os.path.dirname(PROGRAM)), "python")


class Block(NamedTuple):
    language: str
    title: str
    text: str


def read(page):
    with open(os.path.join(SOURCE, page), encoding="utf-8") as file:
        return file.read()


def blocks_of(page):
    """Fenced blocks of a page below the root, in order."""
    found = []
    for match in BLOCK.finditer(read(page)):
        title = re.search(r'title="([^"]+)"', match.group(3))
        found.append(Block(match.group(2), title.group(1) if title else "", textwrap.dedent(match.group(4))))
    return found


def base_project():
    """The project of the tutorial, without restored throw: it takes longest, and the snippets that are about it say so themselves."""
    project = next(yaml.safe_load(b.text) for b in blocks_of("docs/tutorials/faulted-field.md") if b.title == "field.yaml")
    for surface in project["surfaces"]:
        surface.pop("throw_at", None)
    return project


def merged_by_name(entries, others):
    named = {entry["name"]: entry for entry in entries}
    named.update((entry["name"], entry) for entry in others)
    return list(named.values())


def whole_project(snippet):
    """The project that a snippet stands for."""
    if isinstance(snippet, list):
        snippet = {"surfaces": snippet}
    if "surfaces" in snippet and "box" in snippet:
        return snippet
    project = base_project()
    for key, value in snippet.items():
        project[key] = merged_by_name(project.get(key, []), value) if key in ("surfaces", "wells") else value
    return project


def can_draw():
    has_display = bool(os.environ.get("DISPLAY")) or shutil.which("xvfb-run") is not None
    return has_display and os.path.exists(os.path.join(os.path.dirname(PROGRAM), "geomesh-picture"))


def has_python_package():
    folder = os.path.join(PACKAGE, "geomesh")
    return os.path.isdir(folder) and any(name.startswith("_geomodel") and name.endswith(".so") for name in os.listdir(folder))


class PageTest(ProgramTest):
    """A page is run in the test's folder."""

    bare = False
    first_commands = set()  # the first commands of pages that have been run: several pages begin alike, in like folders

    def setUp(self):
        super().setUp()
        for name in os.listdir(os.path.join(SOURCE, "docs", "tutorials", "data", "field")):
            shutil.copy(os.path.join(SOURCE, "docs", "tutorials", "data", "field", name), self.folder)
        os.symlink(os.path.join(SOURCE, "docs"), self.path("docs"))
        shutil.copytree(os.path.join(SOURCE, "samples", "salt-dome"), self.path("samples", "salt-dome"), ignore=shutil.ignore_patterns("out"))
        os.symlink(PROGRAM, self.path("geomesh"))

    def run_words(self, words, what):
        path = os.pathsep.join([os.path.dirname(PROGRAM), "/usr/bin", os.environ["PATH"]])  # the system's Python has the distribution's modules
        environment = {**os.environ, "PATH": path, "PYTHONPATH": PACKAGE, "GEOMESH_PROGRAM": PROGRAM}
        if words[0] == "/usr/bin/python3" and environment.get("GEOMESH_BEFORE_PYTHON"):  # the package was built with a sanitizer, Python was not
            environment.update(LD_PRELOAD=environment["GEOMESH_BEFORE_PYTHON"], ASAN_OPTIONS="detect_leaks=0")
        done = subprocess.run(words, cwd=self.folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              errors="replace", timeout=self.timeout)
        self.assertEqual(done.returncode, 0, "%s\n%s" % (what, done.stdout))
        return done.stdout

    def run_snippet(self, text, number):
        project = whole_project(yaml.safe_load(text))
        name = "snippet_%d.yaml" % number
        with open(self.path(name), "w", encoding="utf-8") as file:
            yaml.safe_dump(project, file, sort_keys=False, allow_unicode=True)
        return self.run_words([PROGRAM, name, "--stop-after", "build"], text)

    def run_block(self, block, number):
        """What it printed."""
        if block.title:
            os.makedirs(os.path.dirname(self.path(block.title)) or self.folder, exist_ok=True)
            with open(self.path(block.title), "w", encoding="utf-8") as file:
                file.write(block.text)
        elif block.language == "yaml":
            return self.run_snippet(block.text, number)
        elif block.language == "sh":
            lines = [line for line in block.text.splitlines() if can_draw() or not line.startswith("geomesh picture")]
            return self.run_words(["bash", "-eu", "-o", "pipefail", "-c", "\n".join(lines)], block.text)
        elif block.language == "python" and has_python_package():
            lines = [line for line in block.text.splitlines() if can_draw() or ".picture(" not in line]
            return self.run_words(["/usr/bin/python3", "-c", "\n".join(lines)], block.text)
        return ""

    def run_page(self, page):
        """All that the page prints, in order. Commands with which another page began too are run once."""
        blocks, printed = blocks_of(page), ""
        first = next((b for b in blocks if not b.title), None)
        for number, block in enumerate(blocks, 1):
            if block is first and block.language == "sh" and len(block.text.splitlines()) == 1:
                if block.text in PageTest.first_commands:
                    continue
                PageTest.first_commands.add(block.text)
            printed += self.run_block(block, number)
        return printed
