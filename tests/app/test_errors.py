# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong input: the message or warning, the exit status, and no output file half written."""
import os

from geomesh_program import BAD_INPUT, CANNOT_MESH, USAGE, ProgramTest, box_surface, level, main, plane_ts, triangles_ts
from vtk_files import VtkFile

PROJECT = """name: model
box: {min: [0, 0, 0], max: [10, 10, 10]}
surfaces:
  - {name: top, kind: horizon, file: top.ts}
"""


class WrongProjects(ProgramTest):
    def test_three_mistakes_are_named_with_their_lines(self):
        self.write("top.ts", level("top", 5))
        project = self.write("model.yaml", """name: model
box: {min: [0, 0, 0], max: [10, 10, ten]}
surfaces:
  - {name: top, kind: horizon, file: top.ts}
  - {name: base, kind: horizon, file: absent.ts}
colunm: [upper, top, lower]
""")
        printed = self.run_program(project, status=USAGE)
        for mistake in ("model.yaml:2:", "model.yaml:5:", "model.yaml:6:", "absent.ts", "colunm", "column"):
            self.assertIn(mistake, printed)
        self.assert_nothing_written()

    def test_duplicate_key(self):
        self.write("top.ts", level("top", 5))
        printed = self.run_program(self.write("model.yaml", PROJECT + "name: again\n"), status=USAGE)
        self.assertIn("model.yaml:5:", printed)
        self.assertIn("name", printed)

    def test_column_names_an_unknown_surface(self):
        self.write("top.ts", level("top", 5))
        printed = self.run_program(self.write("model.yaml", PROJECT + "column: [upper, tpo, lower]\n"), status=USAGE)
        self.assertIn("tpo", printed)

    def test_refinement_that_is_not_offered(self):
        self.write("top.ts", level("top", 5))
        self.run_program(self.write("model.yaml", PROJECT + "mesh: {refine: perhaps}\n"), status=USAGE)
        self.assert_nothing_written()


    def test_settings_of_refinement_say_what_was_meant(self):
        self.write("top.ts", level("top", 5))
        for mesh, words in (("{size: {on_surface: false}}", "was 'on_surfaces' meant?"),
                            ("{on_surfaces: false}", "it belongs to mesh.size"),
                            ("{size: {global: 2, tolerance: 0.1}}", "it belongs to mesh"),
                            ("{size: {on_surfaces: top}}", "mesh.size.on_surfaces: true or false was expected, found 'top'"),
                            ("{size: {on_surfaces: false}, honour: tolerance, tolerance: 0.1}", "on_surfaces: false) contradicts it; leave out one of them"),
                            ("{honour: exact, tolerance: 0.1}", "give 'honour: tolerance' with it"),
                            ("{honour: tolerance, tolerance: 0}", "a number above zero was expected"),
                            ("{honour: tolerance, tolerance: 0.1, mode: conforming}", "mode conforming keeps the input's facets")):
            self.assertIn(words, self.run_program(self.write("model.yaml", PROJECT + "mesh: %s\n" % mesh), status=USAGE), mesh)
        printed = self.run_program(self.write("model.yaml", PROJECT + "mesh: {honour: tolerant, tolerance: 0.1}\n"), status=USAGE)
        self.assertIn("was 'tolerance' meant?", printed)
        self.assertNotIn("has no meaning", printed)  # one mistake, one message
        self.assert_nothing_written()


class WrongCommandLines(ProgramTest):
    def test_sizes_and_tolerances_that_are_none(self):
        mesh = ("mesh", self.write("top.ts", level("top", 5)), "-o", self.path("a.vtu"), "--box", "0,0,0,10,10,10")
        for option in ("--tolerance", "--size", "--gradation"):
            for value in ("0", "0.1%", "nan", "-1"):
                printed = self.run_program(*mesh, option, value, status=USAGE)
                self.assertIn("%s: a number above zero was expected, found '%s'" % (option, value), printed)
        self.assertIn("contradicts it; leave out one", self.run_program(*mesh, "--tolerance", "1", "--no-size-on-surfaces", status=USAGE))

    def test_unknown_option(self):
        self.assertIn("--frobnicate", self.run_program("mesh", "a.off", "-o", "a.vtu", "--frobnicate", status=USAGE))

    def test_misspelt_words_say_what_was_meant(self):
        surface = self.write("top.ts", level("top", 5))
        for words, meant in ((("mesh", surface, "-o", "a.vtu", "--sise", "389"), "--sise: no such option; was '--size' meant?"),
                             (("mesh", surface, "-o", "a.vtu", "--toleranse=3"), "--toleranse: no such option; was '--tolerance' meant?"),
                             (("mesh", surface, "--frobnicate"), "--frobnicate: no such option\n"),  # and not that -o is missing
                             (("chek", "a.vtu"), "no such command or file: chek; was 'check' meant?"),
                             (("info", self.path("tpo.ts")), "tpo.ts; was 'top.ts' meant?"),
                             (("mesh", surface, "-o", "a.vtu", "--stop-after", "recoverr"), "no such stage; was 'recover' meant?")):
            self.assertIn(meant, self.run_program(*words, status=USAGE))

    def test_nothing_given(self):
        self.run_program("mesh", status=USAGE)

    def test_missing_files(self):
        self.assertIn("absent.yaml", self.run_program("absent.yaml", status=USAGE))
        self.assertIn("absent.off", self.run_program("mesh", "absent.off", "-o", "a.vtu", status=USAGE))
        self.assertIn("absent.vtu", self.run_program("check", "absent.vtu", status=USAGE))
        self.assertIn("absent.ts", self.run_program("info", "absent.ts", status=USAGE))

    def test_help(self):
        for arguments in (["--help"], ["mesh", "--help"], ["check", "--help"], ["info", "--help"], ["init", "--help"], ["delaunay", "--help"]):
            self.assertIn("geomesh", self.run_program(*arguments))


class WrongSurfaces(ProgramTest):
    def run_with(self, top, status):
        self.write("top.ts", top)
        return self.run_program(self.write("model.yaml", PROJECT), status=status)

    def test_nan(self):
        printed = self.run_with(level("top", 5).replace("VRTX 3 11 11 5", "VRTX 3 11 nan 5"), BAD_INPUT)
        self.assertIn("top.ts", printed)
        self.assert_nothing_written()

    def test_empty_file(self):
        self.assertIn("top.ts", self.run_with("", BAD_INPUT))
        self.assert_nothing_written()

    def test_surface_without_triangles(self):
        self.assertIn("top.ts", self.run_with("GOCAD TSurf 1\nHEADER {\nname:top\n}\nTFACE\nEND\n", BAD_INPUT))
        self.assert_nothing_written()

    def test_binary_file_that_claims_to_be_ts(self):
        noise = bytes((i * 73 + 41) % 256 for i in range(5000))
        self.assertIn("top.ts", self.run_with(noise, BAD_INPUT))
        self.assert_nothing_written()

    def test_truncated_file(self):
        printed = self.run_with(level("top", 5).replace("TRGL 1 3 4", "TRGL 1 3 9"), BAD_INPUT)
        self.assertIn("top.ts", printed)

    def test_horizon_that_never_meets_the_box(self):
        self.write("top.ts", level("top", 5))
        self.write("high.ts", level("high", 50))
        project = self.write("model.yaml", PROJECT + "  - {name: high, kind: horizon, file: high.ts}\noutput: {directory: out}\n")
        self.run_program(project)
        report = self.report(self.path("out", "model.report.json"))
        self.assertTrue(any("high lies outside the box" in warning for warning in report["warnings"]), report["warnings"])
        check = self.check(self.path("out", "model.vtu"), "--project", project)
        self.assertEqual([region["volume"] for region in check["regions"]], [500, 500])

    def test_self_crossing_salt(self):
        """Two boxes through each other as one body: resolved by winding number, with a warning and the place."""
        points, triangles = box_surface((2, 2, 2), (6, 6, 6))
        more, others = box_surface((4.1, 4.2, 4.3), (8, 8, 8))
        triangles += [tuple(v + len(points) for v in t) for t in others]
        self.write("salt.ts", triangles_ts("salt", points + more, triangles))
        self.write("top.ts", level("top", 5))
        project = self.write("model.yaml", PROJECT + "  - {name: salt, kind: body, file: salt.ts, cuts: all}\n"
                                                     "column: [upper, top, lower]\noutput: {directory: out}\n")
        self.run_program(project)
        report = self.report(self.path("out", "model.report.json"))
        self.assertTrue(any("salt" in warning and "cross" in warning for warning in report["warnings"]), report["warnings"])
        check = self.check(self.path("out", "model.vtu"), "--project", project)
        salt = sum(region["volume"] for region in check["regions"] if region["name"].startswith("salt"))
        self.assertAlmostEqual(salt, 4 ** 3 + 3.9 * 3.8 * 3.7 - 1.9 * 1.8 * 1.7, delta=1e-9)
        self.assertAlmostEqual(check["volume"], 1000, delta=1e-9)


class NothingEnclosed(ProgramTest):
    def test_open_surface(self):
        self.write("sheet.ts", plane_ts("sheet", [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0.5)]))
        printed = self.run_program("mesh", "sheet.ts", "-o", "sheet.vtu", status=CANNOT_MESH)
        self.assertIn("add a box", printed)
        self.assert_nothing_written()

    def test_crossings_refused(self):
        points, triangles = box_surface((0, 0, 0), (4, 4, 4))
        self.write("one.ts", triangles_ts("one", points, triangles))
        points, triangles = box_surface((1.1, 1.2, 1.3), (5, 5, 5))
        self.write("two.ts", triangles_ts("two", points, triangles))
        printed = self.run_program("mesh", "one.ts", "two.ts", "-o", "out.vtu", "--intersect", "never", status=BAD_INPUT)
        self.assertIn("one", printed)
        self.assertIn("two", printed)
        self.assert_nothing_written()
        self.run_program("mesh", "one.ts", "two.ts", "-o", "out.vtu")
        check = self.check(self.path("out.vtu"), "--surfaces", self.path("one.ts"), self.path("two.ts"))
        self.assertEqual(len(check["regions"]), 3)
        self.assertAlmostEqual(check["volume"], 64 + 3.9 * 3.8 * 3.7 - 2.9 * 2.8 * 2.7, delta=1e-9)


def twisted_prism_of_few_ulps():
    """OFF: a prism whose top is turned against its bottom, after Schoenhardt 1928, a few doubles wide where doubles are one apart. It needs
    a point inside, and no double there sees all its faces."""
    points = [(1, 3, 0), (2, 0, 0), (3, 4, 0), (0, 1, 3), (2, 0, 3), (2, 4, 3)]
    triangles = [(0, 2, 1), (3, 4, 5), (0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4), (2, 0, 3), (2, 3, 5)]
    lines = ["OFF", "%d %d 0" % (len(points), len(triangles))]
    lines += ["%r %r %r" % tuple(2.0 ** 52 + x for x in p) for p in points] + ["3 %d %d %d" % t for t in triangles]
    return "\n".join(lines) + "\n"


class NoRoomForRecovery(ProgramTest):
    def test_the_place_is_written_when_asked_for(self):
        self.write("prism.off", twisted_prism_of_few_ulps())
        arguments = ["mesh", "prism.off", "-o", "prism.vtu", "--preserve-boundary"]
        self.assertIn("--stop-after recover", self.run_program(*arguments, status=CANNOT_MESH))
        self.assert_nothing_written()
        printed = self.run_program(*arguments, "--stop-after", "recover", status=CANNOT_MESH)
        for name in ("prism.failed.vtu", "prism.failed.vtp"):
            self.assertIn(name, printed)
            self.assertTrue(os.path.getsize(self.path(name)) > 500)
        self.assertFalse(os.path.exists(self.path("prism.vtu")))
        place = VtkFile.read(self.path("prism.failed.vtp"))
        n = [len(place[what, "offsets"].values) for what in ("Verts", "Lines", "Polys")]
        self.assertTrue(n[1] > 0 and n[2] > 0)
        self.assertEqual(place["CellData", "what"].values, [0] * n[0] + [1] * n[1] + [2] * n[2])
        self.assertEqual(place["CellData", "surface"].values, [-1] * (n[0] + n[1]) + [0] * n[2], "vertices and edges are of no one surface")


if __name__ == "__main__":
    main()
