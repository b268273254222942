#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every command, project snippet and Python block of the documents runs as it is printed; links lead somewhere; the site lists every page.

The tutorials are run by test_tutorials.py, which looks at their results too.
"""
import glob
import os
import re
import unittest

from document_pages import BLOCK, PageTest, blocks_of, read
from geomesh_program import SOURCE

# Blocks of commands that a test cannot run, by page. They are of the language `text`.
NOT_RUN = {
    "docs/install.md": "installs packages and builds",
    "docs/building.md": "installs packages and builds",
    "docs/library.md": "builds the core alone: tests/package does that",
    "docs/command-line.md": "the forms of all commands, with words in capitals",
    "docs/ensemble.md": "needs GNU parallel or a cluster: tests/app/test_slurm.py",
    "docs/parallel.md": "needs MPI: tests/app/test_ranks.py",
    "docs/contributing.md": "builds and runs all tests",
}
COMMAND = re.compile(r"^(\./|scripts/|geomesh |cmake |ctest |ninja |apt |cpack |mpirun |samples/)", re.M)
LANGUAGES = {"sh", "yaml", "python", "text", "cmake", "cpp", "json"}


def pages():
    found = [name for name in sorted(os.listdir(SOURCE)) if name.endswith(".md")]
    for folder, _, names in os.walk(os.path.join(SOURCE, "docs")):
        found += sorted(os.path.relpath(os.path.join(folder, name), SOURCE) for name in names if name.endswith(".md"))
    return found


def slug(heading):
    """The anchor of a heading, as Python-Markdown makes it."""
    text = re.sub(r"[`*]|\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[-\s]+", "-", re.sub(r"[^\w\s-]", "", text).strip().lower())


def anchors(page):
    text = re.sub(r"^ *```.*?^ *```", "", read(page), flags=re.M | re.S)
    return {slug(heading) for heading in re.findall(r"^#+ (.*)$", text, re.M)}


class Documents(PageTest):
    maxDiff = None

    def test_each_block_says_its_language_and_commands_that_are_not_run_are_listed(self):
        wrong, unused = [], set(NOT_RUN)
        for page in pages():
            wrong += ["%s: a block of %s" % (page, b.language) for b in blocks_of(page) if b.language not in LANGUAGES]
            if "```" in BLOCK.sub("", read(page)) and page != "docs/architecture.md":  # whose lists of rooms a test reads
                wrong.append("%s: a block without a language" % page)
            for block in blocks_of(page):
                if block.language == "text" and not block.title and COMMAND.search(block.text):
                    unused.discard(page)
                    if page not in NOT_RUN:
                        wrong.append("%s: commands in a block of text: %s" % (page, block.text.splitlines()[0]))
        self.assertEqual(wrong, [])
        self.assertEqual(unused, set(), "these pages have no commands that are not run: take them out of NOT_RUN")

    def test_links_lead_to_pages_and_headings_that_exist(self):
        wrong = []
        for page in pages():
            for target in re.findall(r"\]\(([^)#\s]*)(?:#([^)]*))?\)", re.sub(r"`[^`]*`", "", read(page))):
                path, anchor = target
                if path.startswith(("http:", "https:", "reference/", "../reference/")):
                    continue  # scripts/site makes the pages of reference/
                file = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
                if file.endswith("gempy-arrays.md"):
                    file = file[:-3] + ".ipynb"
                if not os.path.exists(os.path.join(SOURCE, file)):
                    wrong.append("%s: %s" % (page, path))
                elif anchor and file.endswith(".md") and anchor not in anchors(file):
                    wrong.append("%s: %s#%s" % (page, path, anchor))
        self.assertEqual(wrong, [])

    def test_the_navigation_of_the_site_has_every_page_and_every_page_exists(self):
        listed = re.findall(r": ([a-z0-9/._-]+\.md)$", read("mkdocs.yml"), re.M)
        self.assertGreater(len(listed), 25)
        written = {page[len("docs/"):] for page in pages() if page.startswith("docs/")} | {"tutorials/gempy-arrays.md"}
        self.assertEqual(sorted(page for page in listed if page not in written and not page.startswith("reference/")), [])
        self.assertEqual(sorted(written - set(listed)), [], "pages that the site does not lead to")

    def test_files_of_the_tree_that_are_named_exist(self):
        missing = []
        for page in pages():
            for path in re.findall(r"`((?:scripts|tests|docs|samples|packaging|core|geomodel|app|python)/[\w./*-]+)", read(page)):
                if "/out/" not in path and "NAME" not in path and not glob.glob(os.path.join(SOURCE, path.rstrip("/"))):
                    missing.append("%s: %s" % (page, path))
        self.assertEqual(missing, [])

    def test_messages_that_are_quoted_are_those_of_the_program(self):
        sources = ""
        for folder in ("core/src", "geomodel/src", "app"):
            for where, _, names in os.walk(os.path.join(SOURCE, folder)):
                sources += "".join(read(os.path.join(where, name)) for name in names if name.endswith((".cpp", ".hpp")))
        sources = re.sub(r'"\s*\n\s*"', "", sources)  # adjacent literals are one text
        quoted = re.findall(r'(?m)^\| "([^"]+)"', read("docs/messages.md"))
        self.assertGreater(len(quoted), 2)
        self.assertEqual([text for text in quoted if text not in sources], [], "the program says it otherwise")

    def test_all_documents_together_have_at_most_35000_words(self):
        words = {page: len(re.findall(r"\S*\w\S*", read(page))) for page in pages() if page.startswith("docs/")}  # not the bars of tables
        self.assertLessEqual(sum(words.values()), 35_000, sorted(words.items(), key=lambda item: -item[1])[:10])


def test_of(page):
    def test(self):
        self.run_page(page)
    return test


for each in pages():
    if "/tutorials/" not in each and any(b.language in ("sh", "yaml", "python") for b in blocks_of(each)):
        setattr(Documents, "test_runs_%s" % re.sub(r"\W+", "_", each[:-3].replace("docs/", "")).lower(), test_of(each))

if __name__ == "__main__":
    unittest.main()
