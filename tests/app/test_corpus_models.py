# SPDX-License-Identifier: GPL-3.0-or-later
"""Whole models of tests/corpus: each failed once, and is meshed and passes the check now. What failed is in tests/corpus/models/README.md, and
in the README of the other folders."""
import json
import os
import shutil

from geomesh_program import CANNOT_MESH, SOURCE, ProgramTest, main, triangles_ts

CORPUS = os.path.join(SOURCE, "tests", "corpus")
MODELS = os.path.join(CORPUS, "models")


def sheet_of_two_blocks(gap):
    """The sheet of tests/corpus/cracked_sheet, the second block above the first by `gap` where they meet."""
    points, triangles = [], []
    for rows in ((0, 1, 2), (2, 3, 4)):
        first = len(points)
        points += [(6e6 + 100 * i, 6e6 + 100 * j, -500 + 20 * ((7 * i + 3 * j) % 5) + (gap if first and j == 2 else 0)) for j in rows for i in range(5)]
        for a in (first + 5 * j + i for j in range(2) for i in range(4)):
            triangles += [(a, a + 1, a + 6), (a, a + 6, a + 5)]
    return triangles_ts("h1", points, triangles)


class CorpusModels(ProgramTest):
    def test_each_model_is_meshed_and_passes_the_check(self):
        names = sorted(name for name in os.listdir(MODELS) if os.path.isdir(os.path.join(MODELS, name)))
        self.assertGreater(len(names), 1)
        for name in names:
            with self.subTest(model=name):
                project = os.path.join(MODELS, name, "project.yaml")
                self.run_program(project, "-o", self.path(name), "--quiet")
                self.check(self.path(name, "model.vtu"), "--project", project)
                self.assert_regions(name)

    def assert_regions(self, name):
        """A model with regions.json has the regions that are there, by name and volume."""
        expected = os.path.join(MODELS, name, "regions.json")
        if not os.path.exists(expected):
            return
        volumes = {region["name"]: region["volume"] for region in self.report(self.path(name, "model.report.json"))["regions"]}
        with open(expected, encoding="utf-8") as file:
            for region, volume in json.load(file).items():
                self.assertAlmostEqual(volumes.pop(region) / volume, 1, delta=0.001)
        self.assertEqual(volumes, {})

    def test_surfaces_that_cross_in_narrow_strips_share_no_edge_that_no_curve_lists(self):
        project = os.path.join(CORPUS, "touching_strips", "project.yaml")
        self.run_program(project, "-o", self.folder)
        self.check(self.path("model.vtu"), "--project", project)

    def test_cracks_as_thin_as_rounding_are_open_or_closed(self):
        """A crack between two blocks, an ulp wide, is closed in part; the check took its open part for a fault."""
        project = os.path.join(CORPUS, "cracked_sheet", "project.yaml")
        self.run_program(project, "-o", self.folder)
        report = self.check(self.path("model.vtu"), "--project", project)
        self.assertTrue(any(done.startswith("surfaces end where their input ends") for done in report["checks_done"]), report["checks_done"])
        # What ends where the input has neither border nor crack is a fault still.
        self.assertIn("borders_off", self.faults_against(project, sheet_of_two_blocks(0)))

    def faults_against(self, project, sheet):
        """What the check says of the mesh where the project's surface is another one."""
        os.makedirs(self.path("other"), exist_ok=True)
        self.write("other/h1.ts", sheet)
        shutil.copy(project, self.path("other", "project.yaml"))
        return self.run_program("check", self.path("model.vtu"), "--project", self.path("other", "project.yaml"), status=None)

    def test_borders_nearer_to_each_other_than_the_tolerance_may_be_joined(self):
        """A throw of 1 m within a tolerance of 8 m, closed where a border meets the box."""
        with open(os.path.join(CORPUS, "cracked_sheet", "project.yaml")) as file:
            project = self.write("project.yaml", file.read())
        self.write("h1.ts", sheet_of_two_blocks(0))
        self.run_program(project, "-o", self.folder)
        self.check(self.path("model.vtu"), "--project", project)
        self.assertNotIn("FAULT", self.faults_against(project, sheet_of_two_blocks(4)))
        self.assertIn("borders_off", self.faults_against(project, sheet_of_two_blocks(12)))

    def test_a_refusal_names_surfaces_and_the_way_out(self):
        """Slits that are too thin in either way; that points may be added on surfaces is said where they may not."""
        model = os.path.join(CORPUS, "thin_slits", "thin_slits.off")
        for option, hint in (((), self.assertNotIn), (("--preserve-boundary",), self.assertIn)):
            printed = self.run_program("mesh", model, "-o", self.path("slits.vtu"), *option, status=CANNOT_MESH)
            self.assertIn("leave all cells positive", printed)
            self.assertIn("(surfaces: thin_slits)", printed)
            hint("without preserve_boundary", printed)


if __name__ == "__main__":
    main()
