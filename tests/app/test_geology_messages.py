# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes wrong in earth models, and how the program answers: by the rule that was asked for, or by a message that names the surfaces,
the place, and what can be done."""
from geomesh_program import BAD_INPUT, USAGE, ProgramTest, level, main, plane_ts

BOX = "box: {min: [0, 0, 0], max: [10, 10, 10]}\n"
UTM_BOX = "box: {min: [500000, 7500000, -3000], max: [510000, 7510000, 0]}\n"


class GeologyMessages(ProgramTest):
    def mesh(self, text, status=0):
        printed = self.run_program(self.write("model.yaml", "name: model\n" + text + "output: {directory: out}\n"), status=status)
        if status:
            self.assert_nothing_written()
            return printed, None
        return printed, self.report(self.path("out", "model.report.json"))

    def assert_told(self, texts, *words):
        self.assertTrue(any(all(word in text for word in words) for text in texts), (words, texts))

    def crossing(self, rules):
        self.write("a.ts", plane_ts("a", [(-1, -1, 7), (11, -1, 4), (11, 11, 4), (-1, 11, 7)]))
        self.write("b.ts", level("b", 5))
        return BOX + """surfaces:
  - {name: a, kind: horizon, file: a.ts}
  - {name: b, kind: horizon, file: b.ts}
column: [young, a, middle, b, old]
""" + rules

    def test_horizons_that_cross_are_told(self):
        _, report = self.mesh(self.crossing(""))
        self.assert_told(report["warnings"], "horizon a crosses horizon b", "near")

    def test_horizons_that_cross_are_refused_on_wish(self):
        printed, _ = self.mesh(self.crossing("rules: {on_crossing: error}\n"), status=BAD_INPUT)
        for words in ("horizon a runs below the older horizon b", "area of", "near (", "on_crossing: clip_younger"):
            self.assertIn(words, printed)

    def test_horizons_that_cross_are_clipped_by_rule(self):
        _, report = self.mesh(self.crossing("rules: {on_crossing: clip_older}\n"))
        self.assert_told(report["notes"], "pieces of b above a removed (area 30")
        check = self.check(self.path("out", "model.vtu"), "--project", self.path("model.yaml"))
        self.assertEqual(self.region_names(check), ["middle", "old", "young"])

    def test_a_horizon_missing_in_a_block(self):
        self.write("f.ts", plane_ts("f", [(5, -1, -1), (5, 11, -1), (5, 11, 11), (5, -1, 11)]))
        self.write("a.ts", level("a", 7))
        self.write("b.ts", plane_ts("b", [(-1, -1, 4), (5, -1, 4), (5, 11, 4), (-1, 11, 4)]))
        _, report = self.mesh(BOX + """surfaces:
  - {name: a, kind: horizon, file: a.ts}
  - {name: b, kind: horizon, file: b.ts}
  - {name: f, kind: fault, file: f.ts}
column: [young, a, middle, b, old]
""")
        self.assert_told(report["warnings"], "could be middle to old: no face of b divides it; it is named middle", "near (8.75")
        check = self.check(self.path("out", "model.vtu"), "--project", self.path("model.yaml"))
        self.assertEqual(len(check["regions"]), 5)

    def test_a_column_with_an_unknown_surface(self):
        self.write("top.ts", level("top_chalk", 5))
        printed, _ = self.mesh(BOX + """surfaces:
  - {name: top_chalk, kind: horizon, file: top.ts}
column: [tertiary, top_chlak, chalk]
""", status=USAGE)
        self.assertIn("no surface is named 'top_chlak'; was 'top_chalk' meant?", printed)

    def test_mixed_units_are_converted(self):
        """One horizon in feet, one in metres, both say so: 1 m is 3.28 ft."""
        feet = plane_ts("a", [(x / 0.3048, y / 0.3048, 7 / 0.3048) for x, y in ((-1, -1), (11, -1), (11, 11), (-1, 11))])
        axes = 'GOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME Default\nAXIS_NAME "X" "Y" "Z"\nAXIS_UNIT "ft" "ft" "ft"\nZPOSITIVE Elevation\n' \
               "END_ORIGINAL_COORDINATE_SYSTEM\n"
        self.write("a.ts", feet.replace("TFACE", axes + "TFACE"))
        self.write("b.ts", level("b", 4))
        self.mesh(BOX + """surfaces:
  - {name: a, kind: horizon, file: a.ts}
  - {name: b, kind: horizon, file: b.ts}
column: [young, a, middle, b, old]
""")
        check = self.check(self.path("out", "model.vtu"))
        self.assertAlmostEqual({r["name"]: r["volume"] for r in check["regions"]}["middle"], 300, delta=1e-9)

    def test_a_file_in_feet_that_does_not_say_so(self):
        self.write("a.ts", level("a", -3000 / 0.3048 + 100, size=1e4))
        printed, _ = self.mesh("box: {min: [0, 0, -3000], max: [10000, 10000, 0]}\nsurfaces: [{name: a, kind: horizon, file: a.ts}]\n",
                               status=BAD_INPUT)
        self.assertIn("no surface of the project lies in the box", printed)
        self.assertIn("feet where metres were understood", printed)

    def test_depths_that_do_not_say_so(self):
        self.write("a.ts", level("a", 1500, size=1e4))
        printed, _ = self.mesh("box: {min: [0, 0, -3000], max: [10000, 10000, 0]}\nsurfaces: [{name: a, kind: horizon, file: a.ts}]\n",
                               status=BAD_INPUT)
        self.assertIn("no surface of the project lies in the box", printed)
        self.assertIn("counted downwards?", printed)

    def test_longitude_and_latitude_in_a_utm_project(self):
        self.write("a.ts", plane_ts("a", [(117.0, -22.6, -900), (117.1, -22.6, -900), (117.1, -22.5, -900), (117.0, -22.5, -900)]))
        self.write("model.yaml", "crs: {horizontal: utm 50S}\n" + UTM_BOX + "surfaces: [{name: a, kind: horizon, file: a.ts}]\n")
        printed = self.run_program("model.yaml", status=BAD_INPUT)
        for words in ("a: ", "longitude and latitude", "utm 50S", "add 'crs: geographic' to this entry"):
            self.assertIn(words, printed)

    def test_a_fault_with_no_extent_ends_where_it_was_given(self):
        self.write("f.ts", plane_ts("f", [(5, 2, 2), (5, 8, 2), (5, 8, 8), (5, 2, 8)]))
        text = BOX + "surfaces: [{name: f, kind: fault, file: f.ts%s}]\ncolumn: [rock]\n"
        _, report = self.mesh(text % "")
        self.assert_told(report["notes"], "fault f ends inside the model along a tip of length 24", "extent: to_box")
        self.assertEqual(self.region_names(report), ["rock"])
        _, report = self.mesh(text % ", extent: to_box")
        self.assertEqual(self.region_names(report), ["rock__1", "rock__2"])
        self.assertFalse(any("ends inside" in note for note in report["notes"]), report["notes"])


class TypicalMistakes(ProgramTest):
    """Of a new user, in the project file."""

    def printed(self, text):
        self.write("top.ts", level("top", 5))
        printed = self.run_program(self.write("model.yaml", text), status=USAGE)
        self.assert_nothing_written()
        return printed

    def test_a_tab(self):
        printed = self.printed("name: model\nsurfaces:\n\t- {name: top, kind: horizon, file: top.ts}\n")
        self.assertIn("model.yaml:3:", printed)
        self.assertIn("tab", printed)
        self.assertIn("blanks", printed)

    def test_wrong_indentation(self):
        printed = self.printed("name: model\nsurfaces:\n  - name: top\n   kind: horizon\n    file: top.ts\n")
        self.assertIn("model.yaml:4:", printed)
        self.assertIn("not valid YAML", printed)
        self.assertIn("begin in the same column", printed)

    def test_no_blank_after_the_colon(self):
        self.assertIn("blank after the colon", self.printed("name:model\nsurfaces: []\n"))

    def test_a_missing_file_with_the_nearest_one_there(self):
        printed = self.printed(BOX + "surfaces:\n  - {name: top, kind: horizon, file: tpo.ts}\n")
        self.assertIn("there is no file 'tpo.ts'", printed)
        self.assertIn("'top.ts'", printed)

    def test_a_key_of_another_place(self):
        printed = self.printed(BOX + "surfaces:\n  - {name: top, kind: horizon, file: top.ts, on_crossing: error}\n")
        self.assertIn("unknown key 'on_crossing' in surfaces[1]", printed)
        self.assertIn("it belongs to rules", printed)

    def test_box_as_a_list(self):
        self.assertIn("min and max", self.printed("box: [0, 0, 0, 10, 10, 10]\nsurfaces: [{name: top, kind: horizon, file: top.ts}]\n"))

    def test_a_single_surface_without_a_list(self):
        self.assertIn("- {name", self.printed(BOX + "surfaces: {name: top, kind: horizon, file: top.ts}\n"))


class ColumnOrder(ProgramTest):
    def test_a_column_from_the_oldest_to_the_youngest_is_told(self):
        self.write("a.ts", level("a", 7))
        self.write("b.ts", level("b", 3))
        text = ("box: {min: [0, 0, 0], max: [10, 10, 10]}\nsurfaces:\n  - {name: a, kind: horizon, file: a.ts}\n"
                "  - {name: b, kind: horizon, file: b.ts}\ncolumn: [%s]\n")
        said = "is listed before"
        printed = self.run_program(self.write("wrong.yaml", text % "old, b, middle, a, young"), "-o", self.folder)
        self.assertIn("horizon b is listed before a in the column, as the younger one, but lies below it everywhere", printed)
        self.assertIn("from the youngest to the oldest", printed)
        self.assertNotIn(said, self.run_program(self.write("right.yaml", text % "young, a, middle, b, old"), "-o", self.folder))


if __name__ == "__main__":
    main()
