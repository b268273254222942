# SPDX-License-Identifier: GPL-3.0-or-later
"""Horizons with throw in whole projects of plane surfaces, where every volume is known; what became of a block is told, and the mesh passes
`geomesh check` against the project."""
from geomesh_program import BAD_INPUT, main, plane_ts, triangles_ts
from plane_models import RulesTest, patch, strip


class Throw(RulesTest):
    SURFACES = """surfaces:
  - {name: h, kind: horizon, file: h.ts, throw_at: [f]}
  - {name: f, kind: fault, file: f.ts}
column: [upper, h, lower]
"""
    def fault(self, low=-1.0, high=11.0):
        """Dips east: x = 5 - 0.1 z. West of it h lies at 6, east of it at 4."""
        self.surface("f", [(5 - 0.1 * low, low), (5 - 0.1 * high, high)])

    def expected(self):
        def block(low, high, east):
            mean = 5 - 0.05 * (low + high)
            return 10 * (high - low) * (10 - mean if east else mean)
        return {"upper__1": block(6, 10, False), "lower__1": block(0, 6, False), "upper__2": block(4, 10, True), "lower__2": block(0, 4, True)}

    def test_blocks_that_stop_short_of_the_fault(self):
        self.fault()
        self.surface("h", [(-1, 6), (4.0, 6)], [(5.2, 4), (11, 4)])
        report, volumes = self.mesh(self.SURFACES)
        self.assert_volumes(volumes, self.expected())
        self.told(report, "notes", "horizon h, block 1", "ended at its faults")
        self.assertFalse(any("stops short" in text for text in report["warnings"]), report["warnings"])

    def test_blocks_that_overshoot_the_fault(self):
        self.fault()
        self.surface("h", [(-1, 6), (5.1, 6)], [(4.1, 4), (11, 4)])
        report, volumes = self.mesh(self.SURFACES)
        self.assert_volumes(volumes, self.expected())
        self.told(report, "notes", "overshoot on the wrong side")

    def test_one_short_one_beyond_through_two_faults(self):
        """Three blocks, the middle one lower."""
        self.surface("f", [(3, -1), (3, 11)])
        self.surface("g", [(7, -1), (7, 11)])
        self.surface("h", [(-1, 6), (3.5, 6)], [(3.3, 4), (7.2, 4)], [(7.5, 6), (9, 6)])
        report, volumes = self.mesh(self.SURFACES.replace("[f]", "[f, g]").replace("column", "  - {name: g, kind: fault, file: g.ts}\ncolumn"))
        self.assert_volumes(volumes, {"upper__1": 120, "upper__2": 240, "upper__3": 120, "lower__1": 180, "lower__2": 160, "lower__3": 180})

    def test_faults_that_end_on_the_sides_of_the_box(self):
        """Nothing inside goes round their ends, though the one that leans is continued to part the blocks."""
        self.write("f.ts", triangles_ts("f", *strip([(5, -1), (5, 11)], 0, 10)))
        self.write("g.ts", triangles_ts("g", *strip([(5, -1), (5, 11)], 0, 10)))
        lattice = [(x, y, z) for z, columns in ((6, (0, 2, 5)), (4, (5, 7, 10))) for y in (0, 3, 6, 10) for x in columns]
        cells = [12 * block + 3 * j + i for block in (0, 1) for j in range(3) for i in range(2)]
        self.write("h.ts", triangles_ts("h", lattice, [t for c in cells for t in ((c, c + 1, c + 4), (c, c + 4, c + 3))]))
        report, volumes = self.mesh(self.SURFACES.replace("[f]", "[f, g]").replace("column", "  - {name: g, kind: fault, file: g.ts, extent: to_horizon h}\ncolumn"))
        self.assert_volumes(volumes, {"upper__1": 200, "upper__2": 300, "lower__1": 300, "lower__2": 200})
        self.assertFalse(any("not applied" in text or "stops short" in text for text in report["warnings"]), report["warnings"])

    def test_a_fault_that_does_not_divide_is_told(self):
        self.fault(low=4.5, high=5.5)
        self.surface("h", [(-1, 6), (4.0, 6)], [(5.2, 4), (11, 4)])
        report, volumes = self.mesh(self.SURFACES)
        self.told(report, "warnings", "horizon h is not divided", "extent: to_box")
        self.assertEqual(len(volumes), 1)

    def test_a_horizon_of_which_all_crosses_a_fault_stays(self):
        """Two triangles cover the model; the fault ends inside, and both cross it."""
        self.write("f.ts", triangles_ts("f", *strip([(5, -1), (5, 11)], 3, 7)))
        self.write("h.ts", triangles_ts("h", [(-1, -1, 5), (11, -1, 5), (11, 11, 5), (-1, 11, 5)], [(0, 1, 2), (0, 2, 3)]))
        report, volumes = self.mesh(self.SURFACES)
        self.assert_volumes(volumes, {"upper": 500, "lower": 500})
        self.told(report, "warnings", "horizon h", "is kept as given")

    def test_a_fault_that_ends_below_the_horizon_does_not_part_it(self):
        self.fault(high=4.0)
        self.write("h.ts", triangles_ts("h", *patch((-1, 11), (-1, 11), lambda y: 6, step=2)))
        report, volumes = self.mesh(self.SURFACES)
        self.assert_volumes(volumes, {"upper": 400, "lower": 600})
        self.told(report, "warnings", "horizon h: fault f of its throw_at ends below it", "extent: to_box")

    def test_a_sheet_that_runs_on_across_one_of_the_faults(self):
        """Throw at g alone: parting the sheet at f, too, would take what lies between the faults."""
        self.surface("f", [(3, -1), (3, 11)])
        self.surface("g", [(7, -1), (7, 11)])
        self.surface("h", [(-1, 6), (2, 6), (7, 6)], [(7, 4), (11, 4)])
        report, volumes = self.mesh(self.SURFACES.replace("[f]", "[f, g]").replace("column", "  - {name: g, kind: fault, file: g.ts}\ncolumn"))
        self.assert_volumes(volumes, {"upper__1": 120, "upper__2": 160, "upper__3": 180, "lower__1": 180, "lower__2": 240, "lower__3": 120})
        self.told(report, "warnings", "horizon h: it runs on across f as one sheet")

    def test_a_sheet_of_two_triangles_that_runs_on_across_one_of_the_faults(self):
        """A fifth of the eastern sheet lies west of g, though the middles of both its triangles lie east of it."""
        self.surface("f", [(3, -1), (3, 11)])
        self.surface("g", [(4.6, -1), (4.6, 11)])
        self.surface("h", [(-1, 6), (3, 6)], [(3, 4), (11, 4)])
        report, volumes = self.mesh(self.SURFACES.replace("[f]", "[f, g]").replace("column", "  - {name: g, kind: fault, file: g.ts}\ncolumn"))
        self.assert_volumes(volumes, {"upper__1": 120, "upper__2": 96, "upper__3": 324, "lower__1": 180, "lower__2": 64, "lower__3": 216})
        self.told(report, "warnings", "horizon h: it runs on across g as one sheet")

    def test_one_sheet_over_a_fault_that_ends_on_the_sides_of_the_box(self):
        """The fault is continued beyond them, where nothing of the horizon goes round it."""
        self.write("f.ts", triangles_ts("f", *strip([(5, -1), (5, 11)], 0, 10)))
        self.write("h.ts", triangles_ts("h", *patch((-1, 11), (-1, 11), lambda y: 6, step=1)))
        report, volumes = self.mesh(self.SURFACES)
        self.assert_volumes(volumes, {"upper__1": 200, "upper__2": 200, "lower__1": 300, "lower__2": 300})
        self.told(report, "warnings", "horizon h: it runs on across f as one sheet", "is kept as given")

    def test_a_block_that_leaves_the_box_and_comes_back(self):
        """East of the fault h rises through the top of the box, and lies below it at the fault and at the side."""
        self.surface("f", [(5, -1), (5, 11)])
        self.surface("h", [(-1, 6), (5, 6)], [(5, 9), (6, 9), (7, 11), (8, 11), (9, 7), (11, 7)])
        report, volumes = self.mesh(self.SURFACES)
        above = 10 * (1 + 0.25 + 0.75 * 1.5 + 3)  # by the trapezoids of its polyline
        self.assert_volumes(volumes, {"upper__1": 200, "lower__1": 300, "upper__2": 10 * (1 + 0.25), "upper__3": above - 12.5, "lower__2": 500 - above})

    def test_a_block_in_two_sheets_loses_neither(self):
        """No fault parts them: they overlap, and each is on its side of the fault that is named."""
        self.surface("f", [(3, -1), (3, 11)])
        self.surface("h", [(-1, 6), (3, 6)], [(3, 4), (7.2, 4)], [(6.8, 5), (11, 5)])
        report, volumes = self.mesh(self.SURFACES)
        self.told(report, "warnings", "its border crosses itself in the map")
        self.assertAlmostEqual(sum(v for name, v in volumes.items() if name.split("__")[0] == "lower"), 180, delta=1e-8)

    def test_a_fault_that_cuts_a_corner_off_takes_nothing(self):
        """g crosses f, between the same sheets, and cuts a corner off each."""
        self.surface("f", [(5, -1), (5, 11)])
        self.write("g.ts", plane_ts("g", [(4.2, -1, -1), (5.8, 11, -1), (5.8, 11, 11), (4.2, -1, 11)]))
        self.surface("h", [(-1, 6), (4, 6), (4.5, 6), (5, 6)], [(5, 4), (5.5, 4), (6, 4), (11, 4)])
        report, volumes = self.mesh(self.SURFACES.replace("[f]", "auto").replace("column", "  - {name: g, kind: fault, file: g.ts}\ncolumn"))
        self.assertFalse(any("stops short" in text for text in report["warnings"]), report["warnings"])
        by_unit = {}
        for name, volume in volumes.items():
            by_unit[name.split("__")[0]] = by_unit.get(name.split("__")[0], 0) + volume
        self.assert_volumes(by_unit, {"upper": 500, "lower": 500})

    def test_a_younger_horizon_ends_at_the_step_of_the_one_that_it_onlaps(self):
        """East of f the older horizon is above the younger one, which meets it nowhere else."""
        self.surface("f", [(5, -1), (5, 11)])
        self.surface("old", [(-1, 3), (5, 3)], [(5, 7), (11, 7)])
        self.surface("young", [(-1, 5), (11, 5)])
        report, volumes = self.mesh("""surfaces:
  - {name: young, kind: horizon, file: young.ts}
  - {name: old, kind: horizon, file: old.ts, base: onlap, throw_at: [f]}
  - {name: f, kind: fault, file: f.ts}
column: [upper, young, middle, old, lower]
""")
        self.assert_volumes(volumes, {"upper__1": 250, "middle": 100, "lower__1": 150, "upper__2": 150, "lower__2": 350})
        self.told(report, "warnings", "by the horizons as they were deposited")

    def test_the_checker_misses_a_block_that_went(self):
        """The mesh of one block held against a project with two."""
        self.fault()
        self.surface("h", [(-1, 6), (4.0, 6)])
        self.mesh(self.SURFACES)
        self.surface("h", [(-1, 6), (4.0, 6)], [(5.2, 4), (11, 4)])
        found = self.check(self.path("out", "model.vtu"), "--project", self.project, status=BAD_INPUT)
        self.assertIn("horizon_lost_beyond_faults", [fault["id"] for fault in found["faults"]])

    def test_a_horizon_without_a_block_between_two_faults_stays(self):
        """All of its triangles between the faults cross one of them, or where it goes on."""
        for name, x in (("f", 4), ("g", 6)):
            self.write(name + ".ts", plane_ts(name, [(x, -1, -1), (x, 4, -1), (x, 4, 11), (x, -1, 11)]))
        columns, rows = (-1, 2, 7.7, 11), (-1, 3, 7, 11)
        cells = [4 * j + i for j in range(3) for i in range(3)]
        self.write("h.ts", triangles_ts("h", [(x, y, 5) for y in rows for x in columns], [t for c in cells for t in ((c, c + 1, c + 5), (c, c + 5, c + 4))]))
        report, volumes = self.mesh(self.SURFACES.replace("[f]", "[f, g]").replace("column", "  - {name: g, kind: fault, file: g.ts}\ncolumn"))
        self.assert_volumes(volumes, {"upper": 500, "lower": 500})
        self.told(report, "warnings", "horizon h", "no block is given between", "is kept as given")

    def test_a_fault_that_is_none(self):
        self.fault()
        self.surface("h", [(-1, 6), (4.0, 6)], [(5.2, 4), (11, 4)])
        printed = self.mesh(self.SURFACES.replace("[f]", "[ff]"), status=2)
        self.assertIn("which is no fault; faults are f", printed)


class ThrowThatDiesOut(RulesTest):
    """A fault x = 5 with an end inside, at y = 6. West of it h lies at 6; east of it the throw grows by a third of the distance from y = 6.5."""

    SURFACES = """surfaces:
  - {name: h, kind: horizon, file: h.ts, throw_at: [f]}
  - {name: f, kind: fault, file: f.ts}
column: [upper, h, lower]
"""

    def fault(self, low=-1, high=6):
        self.write("f.ts", plane_ts("f", [(5, low, -1), (5, high, -1), (5, high, 11), (5, low, 11)]))

    @staticmethod
    def lowered(y):
        return 6 - max(0, 6.5 - y) / 3

    def horizon(self, *patches):
        points, triangles = [], []
        for more, others in patches:
            triangles += [tuple(v + len(points) for v in t) for t in others]
            points += more
        self.write("h.ts", triangles_ts("h", points, triangles))

    def assert_throw_dies_out(self, lost_east):
        report, volumes = self.mesh(self.SURFACES)
        # Round the end of the fault a strip as wide as the gap is filled by rule.
        self.assertEqual(sorted(volumes), ["lower", "upper"])
        self.assertAlmostEqual(volumes["lower"], 600 - lost_east, delta=0.2)
        self.assertAlmostEqual(volumes["lower"] + volumes["upper"], 1000, delta=1e-9)
        self.assertFalse(any("stops short" in text or "not divided" in text or "open" in text for text in report["warnings"]), report["warnings"])
        area = {surface["name"]: surface["area"] for surface in report["surfaces"]}
        self.assertAlmostEqual(area["f"], 60, delta=1e-9)
        self.assertTrue(any(curve["name"] == "f.tip" for curve in report["curves"]))
        self.assertFalse(any(curve["name"] == "h.border" for curve in report["curves"]), "the horizon has no free border")
        cut = [curve["length"] for curve in report["curves"] if curve["name"] == "f*h"]
        self.assertAlmostEqual(sum(cut), 6 + 6 * (1 + 1 / 9) ** 0.5, delta=1)  # a spacing of the points on each side at the end
        return report

    def test_blocks_in_two_sheets(self):
        """Both stop short of the fault and of each other beyond it."""
        self.fault()
        self.horizon(patch((-1, 4.5), (-1, 11), lambda y: 6), patch((5.5, 11), (-1, 11), self.lowered))
        report = self.assert_throw_dies_out(5 * 6.5 * 6.5 / 6)
        self.told(report, "notes", "h: its blocks are joined beyond the end of its faults", "throw left there")

    def test_one_sheet_round_the_end(self):
        self.fault()
        self.horizon(patch((-1, 4.5), (-1, 6.5), lambda y: 6), patch((5.5, 11), (-1, 6.5), self.lowered),
                     patch((-1, 4.5), (6.5, 11), lambda y: 6), patch((4.5, 5.5), (6.5, 11), lambda y: 6), patch((5.5, 11), (6.5, 11), lambda y: 6))
        self.assert_throw_dies_out(5 * 6.5 * 6.5 / 6)

    def test_one_side_runs_through_the_fault(self):
        """What is given beyond the fault goes; the block is continued to the fault anew."""
        self.fault()
        self.horizon(patch((-1, 5.3), (-1, 11), lambda y: 6), patch((5.5, 11), (-1, 11), self.lowered))
        report = self.assert_throw_dies_out(5 * 6.5 * 6.5 / 6)
        self.told(report, "notes", "overshoot on the wrong side")

    def test_both_ends_inside(self):
        """The throw dies out to both ends, at y = 2 and y = 8, from 1 in the middle."""
        self.fault(2, 8)
        def sag(y):
            return 6 - max(0, 1 - abs(y - 5) / 3)
        self.horizon(patch((-1, 4.5), (-1, 11), lambda y: 6), patch((5.5, 11), (-1, 11), sag))
        report, volumes = self.mesh(self.SURFACES)
        self.assertAlmostEqual(volumes["lower"], 600 - 5 * 3, delta=0.08)
        self.assertEqual(len(volumes), 2)
        self.assertFalse(any(curve["name"] == "h.border" for curve in report["curves"]))
        cut = [curve["length"] for curve in report["curves"] if curve["name"] == "f*h"]
        self.assertAlmostEqual(sum(cut), 6 + 6 * (1 + 1 / 9) ** 0.5, delta=1)  # a spacing of the points at each end

    def test_throw_that_does_not_die_out_is_told(self):
        """The blocks lie at different heights where the fault has ended: joined by a steep strip, and said."""
        self.fault()
        self.horizon(patch((-1, 4.5), (-1, 11), lambda y: 6), patch((5.5, 11), (-1, 11), lambda y: 4))
        report, volumes = self.mesh(self.SURFACES)
        self.assertEqual(sorted(volumes), ["lower", "upper"])
        self.told(report, "warnings", "throw left there: at most 2 m", "does not die out", "extent: to_box")


if __name__ == "__main__":
    main()
