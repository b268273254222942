#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The site of documents is built without a warning, with its pages made of the program, the schemas and the Python package."""
import os
import re
import shutil
import subprocess
import unittest

from geomesh_program import NIGHTLY, PROGRAM, SOURCE, ProgramTest

PACKAGE = os.path.join(os.path.dirname(os.path.dirname(PROGRAM)), "python", "geomesh", "_geomodel.pyi")


@unittest.skipUnless(shutil.which("mkdocs"), "skipped: mkdocs is not installed")
@unittest.skipUnless(os.path.exists("/usr/share/mkdocs/themes/material"), "skipped: mkdocs-material is not installed")
@unittest.skipUnless(os.path.exists(PACKAGE), "skipped: built without the Python package")
class Site(ProgramTest):
    def build(self, *options):
        environment = {**os.environ, "GEOMESH_BUILD": os.path.dirname(os.path.dirname(PROGRAM))}
        if environment.get("GEOMESH_BEFORE_PYTHON"):  # the package was built with a sanitizer, Python was not
            environment.update(LD_PRELOAD=environment["GEOMESH_BEFORE_PYTHON"], ASAN_OPTIONS="detect_leaks=0")
        done = subprocess.run([os.path.join(SOURCE, "scripts", "site"), "-o", self.path("site"), *options], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=self.timeout, env=environment)
        self.assertEqual(done.returncode, 0, done.stdout)

    def html_of(self, page):
        with open(self.path("site", page, "index.html"), encoding="utf-8") as file:
            return file.read()

    def test_code_is_highlighted_pictures_are_there_and_pages_lead_on(self):
        self.build()
        self.assertRegex(self.html_of("."), r'<img [^>]*src="pictures/')
        self.assertIn('data-md-color-scheme="slate"', self.html_of(".").replace("data-md-color-scheme=slate", 'data-md-color-scheme="slate"'))
        tutorial = self.html_of("tutorials/faulted-field")
        self.assertRegex(tutorial, r'<span class="nt">')  # a key of YAML
        self.assertRegex(tutorial, r"md-footer__link--next")
        self.assertRegex(self.html_of("reference/python-calls"), r"<th>type</th>")
        self.assertRegex(self.html_of("model-building"), r'<img [^>]*src="[^"]*rules/extend.svg"')

    def text_of(self, page):
        with open(self.path("site", page, "index.html"), encoding="utf-8") as file:
            return re.sub(r"<[^>]+>", "", file.read())

    def test_the_site_has_every_key_every_command_and_every_call(self):
        self.build()
        keys = self.text_of("reference/project-keys")
        for key in ("surfaces[].throw_at", "mesh.honour", "rules.min_thickness", "output.formats"):
            self.assertIn(key, keys)
        options = self.text_of("reference/command-line")
        for words in ("geomesh picture", "--quality", "--solver"):
            self.assertIn(words, options)
        calls = self.text_of("reference/python-calls")
        for call in ("add_surface", "from_gempy", "delaunay", "to_meshio", "Examples", "model.add_grid"):
            self.assertIn(call, calls)
        self.assertNotRegex(calls, r"Parameters\s+-{3,}")  # sections of docstrings become tables and lists
        front = self.text_of(".")
        for words in ("Install", "./geomesh samples/salt-dome/project.yaml", "Python"):
            self.assertIn(words, front)
        self.assertIn("from_gempy(geo_model)", self.text_of("tutorials/gempy-arrays"))

    @unittest.skipUnless(NIGHTLY, "skipped: pages of the C++ interface are made in the nightly preset")
    @unittest.skipUnless(shutil.which("doxygen"), "skipped: doxygen is not installed")
    def test_the_site_has_the_cpp_interface(self):
        self.build("--cpp")
        self.assertTrue(os.path.exists(self.path("site", "cpp", "index.html")))
        with open(self.path("site", "cpp", "files.html"), encoding="utf-8") as file:
            self.assertIn("tetrahedralize.hpp", file.read())


if __name__ == "__main__":
    unittest.main()
