# SPDX-License-Identifier: GPL-3.0-or-later
"""Rules of model building in whole projects of plane surfaces, where every volume is known; what a rule did is told, and the mesh passes
`geomesh check` against the project."""
import math

from geomesh_program import BAD_INPUT, USAGE, box_surface, level, main, plane_ts, triangles_ts
from plane_models import RulesTest, strip


class TurnedBox(RulesTest):
    """A box turned by some degrees, and a horizon that ends a little beyond its sides: nearer than surfaces are merged."""

    def horizon(self, azimuth, beyond):
        turn, nx, ny = math.radians(azimuth), 9, 25
        points = []
        for j in range(ny):
            for i in range(nx):
                u, v = (2 + beyond) * (2 * i / (nx - 1) - 1), (6 + beyond) * (2 * j / (ny - 1) - 1)
                points.append((5 + u * math.cos(turn) + v * math.sin(turn), 5 - u * math.sin(turn) + v * math.cos(turn),
                               5 + 0.3 * math.sin(v) + 0.2 * u))
        corners = [j * nx + i for j in range(ny - 1) for i in range(nx - 1)]
        self.write("h.ts", triangles_ts("h", points, [t for k in corners for t in ((k, k + 1, k + nx + 1), (k, k + nx + 1, k + nx))]))

    def test_sides_keep_their_planes(self):
        for azimuth, beyond, merged in ((30, 0.003, ""), (30, 0.0005, ""), (17, 0.002, ""), (75, 0.01, ""),
                                        (30, 0.003, "tolerance: 0.01\n")):
            with self.subTest(azimuth=azimuth, beyond=beyond, merged=merged):
                self.horizon(azimuth, beyond)
                project = self.write("turned.yaml", "name: turned\n"
                                     f"box: {{center: [5, 5], size: [4, 12], azimuth: {azimuth}, bottom: 0, top: 10}}\n"
                                     "surfaces:\n  - {name: h, kind: horizon, file: h.ts}\n" + merged
                                     + "mesh: {size: 0.8, tolerance: 0.1}\noutput: {directory: turned}\n")
                self.run_program(project)
                check = self.check(self.path("turned", "turned.vtu"), "--project", project)
                self.assertEqual(len(check["regions"]), 2)


class Faults(RulesTest):
    CUTS = """surfaces:
  - {name: a, kind: horizon, file: a.ts}
  - {name: b, kind: horizon, file: b.ts}
  - {name: f, kind: fault, file: f.ts, cuts: %s}
column: [young, a, middle, b, old]
"""

    def three_layers_and_a_fault(self):
        self.surface("a", [(-1, 7), (11, 7)])
        self.surface("b", [(-1, 3), (11, 3)])
        self.surface("f", [(5, -1), (5, 11)])

    def test_units_that_a_fault_cannot_cut(self):
        self.three_layers_and_a_fault()
        self.assertIn("do not follow each other", self.mesh(self.CUTS % "[young, old]", status=2))
        self.assertIn("units are young, middle or old", self.mesh(self.CUTS % "[base]", status=2))

    def test_a_fault_cuts_only_the_units_that_it_is_said_to(self):
        self.three_layers_and_a_fault()
        text = self.CUTS
        report, volumes = self.mesh(text % "[middle]")
        self.assert_volumes(volumes, {"young": 300, "middle__1": 200, "middle__2": 200, "old": 300})
        self.told(report, "notes", "fault f cuts middle alone", "above a")
        report, volumes = self.mesh(text % "[middle, old]")
        self.assert_volumes(volumes, {"young": 300, "middle__1": 200, "middle__2": 200, "old__1": 150, "old__2": 150})

    def test_faults_end_on_each_other_in_order(self):
        """third ends at second, which itself ends at first: what is left of second does not stop third."""
        self.surface("first", [(5, -1), (5, 11)])
        self.write("second.ts", plane_ts("second", [(6, 5, 2), (9, 5, 2), (9, 5, 8), (6, 5, 8)]))
        self.write("third.ts", plane_ts("third", [(7, 6, 2), (7, 9, 2), (7, 9, 8), (7, 6, 8)]))
        report, volumes = self.mesh("""surfaces:
  - {name: third, kind: fault, file: third.ts, extent: to_fault second}
  - {name: second, kind: fault, file: second.ts, extent: to_fault first}
  - {name: first, kind: fault, file: first.ts}
column: [rock]
""")
        self.assert_volumes(volumes, {"rock__1": 500, "rock__2": 250, "rock__3": 100, "rock__4": 150})
        self.told(report, "notes", "third ends at second")
        self.told(report, "notes", "second ends at first")


class ThinLayers(RulesTest):
    TEXT = """surfaces:
  - {name: a, kind: horizon, file: a.ts}
  - {name: b, kind: horizon, file: b.ts}
column: [young, a, middle, b, old]
rules: {min_thickness: 0.5, thin_layers: %s}
"""

    def layers(self):
        """The middle layer wedges from 2 at x = 0 to 0.25 from x = 7 on."""
        self.surface("a", [(-1, 6.25), (7, 4.25), (11, 4.25)])
        self.surface("b", [(-1, 4), (3.3, 4), (11, 4)])

    def test_keep_warns(self):
        self.layers()
        report, volumes = self.mesh(self.TEXT % "keep")
        self.assert_volumes(volumes, {"young": 513.75, "middle": 86.25, "old": 400})
        self.told(report, "warnings", "unit middle is thinner than 0.5 m", "kept")

    def test_error_refuses(self):
        self.layers()
        printed = self.mesh(self.TEXT % "error", status=BAD_INPUT)
        self.assertIn("unit middle is thinner than 0.5 m", printed)
        self.assertIn("thin_layers: collapse", printed)

    def test_collapse_lets_the_layer_pinch_out(self):
        self.layers()
        report, volumes = self.mesh(self.TEXT % "collapse")
        # Points of the common triangulation at x = 3.3, where it is 1.175 thick, and x = 7, from which on nothing is left.
        middle = 10 * (3.3 * (2 + 1.175) / 2 + 3.7 * 1.175 / 2)
        self.assert_volumes(volumes, {"young": 600 - middle, "middle": middle, "old": 400})
        self.told(report, "notes", "unit middle collapsed", "laid onto b", "moved by at most 0.25")

    def test_horizons_that_overhang_are_not_collapsed(self):
        """What stands twice over a place cannot be laid onto another: the layer stays as it is, and that is told."""
        self.surface("a", [(-1, 4.2), (6, 4.2), (5, 5), (11, 5)])
        self.surface("b", [(-1, 4), (11, 4)])
        report, volumes = self.mesh(self.TEXT % "collapse")
        self.told(report, "warnings", "min_thickness not applied to horizons a to b", "a overhangs in the map")
        self.assertGreater(volumes["middle"], 10 * 0.2 * 5)

    def test_collapse_takes_crossings_by_noise_along(self):
        """Horizons that should coincide and cross by a few centimetres leave no pockets."""
        self.surface("a", [(-1, 5), (2, 4.98), (4, 5.03), (6, 4.97), (11, 5.01)])
        self.surface("b", [(-1, 5.01), (3, 5.02), (5, 4.99), (11, 5)])
        report, volumes = self.mesh(self.TEXT % "collapse")
        self.assertEqual(sorted(volumes), ["old", "young"])
        self.assertAlmostEqual(sum(volumes.values()), 1000, delta=1e-9)


class Order(RulesTest):
    COLUMN = "column: [u0, h0, u1, h1, u2, h2, u3]\nrules: {on_crossing: %s}\n"

    def test_what_was_eroded_before_a_horizon_came_cuts_nothing_of_it(self):
        """East of x = 5 the old horizon rises above the others. The middle one has eroded it; then the young one was laid down."""
        self.surface("h0", [(-1, 6), (11, 6)])
        self.surface("h1", [(-1, 4), (11, 4)])
        self.surface("h2", [(-1, 3), (4, 3), (5, 4), (8, 7), (11, 7)])
        surfaces = "surfaces:\n" + "".join("  - {name: h%d, kind: horizon, file: h%d.ts%s}\n" % (k, k, ", base: erode" if k == 1 else "") for k in range(3))
        _, volumes = self.mesh(surfaces + self.COLUMN % "clip_younger")
        self.assert_volumes(volumes, {"u0": 400, "u1": 200, "u2": 45, "u3": 355})

    def test_a_horizon_is_cut_beyond_the_end_of_another_one(self):
        """h0 lies below h1, which ends on h2 in the middle; beyond that h0 lies above h2 first, then below it."""
        self.surface("h0", [(-1, 4), (5, 4), (6, 7), (7, 7), (8, 4), (11, 4)])
        self.surface("h1", [(-1, 6), (4, 6), (6, 2), (11, 2)])
        self.surface("h2", [(-1, 1), (4, 1), (5, 5), (11, 5)])
        surfaces = "surfaces:\n" + "".join("  - {name: h%d, kind: horizon, file: h%d.ts, base: onlap}\n" % (k, k) for k in range(3))
        _, volumes = self.mesh(surfaces + self.COLUMN % "leave")
        def below(heights):  # of a polyline over x = 0 to 10
            return 10 * sum((b[0] - a[0]) * (a[1] + b[1]) / 2 for a, b in zip(heights, heights[1:]))
        meet = 4 + 5 / 6  # h1 = 14 - 2 x, h2 = 4 x - 15
        h2 = [(0, 1), (4, 1), (5, 5), (10, 5)]
        h1 = [(0, 6), (4, 6), (meet, 14 - 2 * meet), (5, 5), (10, 5)]
        leaves, comes = 5 + 1 / 3, 7 + 2 / 3  # h0 = 5
        h0 = [(0, 6), (4, 6), (meet, 14 - 2 * meet), (5, 5), (leaves, 5), (6, 7), (7, 7), (comes, 5), (10, 5)]
        by_unit = {}
        for name, volume in volumes.items():
            by_unit[name.split("__")[0]] = by_unit.get(name.split("__")[0], 0) + volume
        self.assert_volumes(by_unit, {"u0": 1000 - below(h0), "u1": below(h0) - below(h1), "u2": below(h1) - below(h2), "u3": below(h2)})


class Ends(RulesTest):
    def test_topography_with_outcropping_layers_and_salt_through_it(self):
        """What other surfaces have above the topography goes; a body that reaches beyond it ends on it."""
        self.write("relief.ts", level("relief", 8))
        self.surface("h", [(-1, 4), (11, 10)])                   # crops out at x = 7
        self.surface("high", [(-1, 9), (11, 9.5)])               # was eroded everywhere
        self.write("salt.ts", triangles_ts("salt", *box_surface((1, 1, -1), (2, 2, 12))))
        report, volumes = self.mesh("""surfaces:
  - {name: relief, kind: horizon, file: relief.ts}
  - {name: high, kind: horizon, file: high.ts}
  - {name: h, kind: horizon, file: h.ts}
  - {name: salt, kind: body, file: salt.ts}
column: [eroded, high, upper, h, lower]
rules: {topography: relief}
""")
        self.assertEqual(sorted(volumes), ["lower", "salt", "upper"])
        self.assertAlmostEqual(volumes["salt"], 8, delta=1e-9)
        self.assertAlmostEqual(sum(volumes.values()), 800, delta=1e-9)
        upper = 10 * 7 * 3.5 / 2 - (8 - 4.5 - 0.5 * 1.5)
        self.assertAlmostEqual(volumes["upper"], upper, delta=1e-9)
        self.told(report, "notes", "nothing is kept above the topography", "pieces of h above relief")
        self.told(report, "notes", "pieces of salt above relief")

    SCARP = """surfaces:
  - {name: relief, kind: horizon, file: relief.ts}
  - {name: f, kind: fault, file: f.ts}
  - {name: g, kind: fault, file: g.ts}
rules: {topography: relief}
"""

    def scarp(self, low, high, end):
        """The relief at `low` west of f up to `end`, at `high` east of it from 10 - end on; g crosses f."""
        self.surface("f", [(5, -1), (5, 11)])
        self.write("g.ts", triangles_ts("g", [(-1, 4, -1), (11, 4, -1), (11, 4, 11), (-1, 4, 11)], [(0, 1, 2), (0, 2, 3)]))
        self.surface("relief", [(-1, low), (end, low)], [(10 - end, high), (11, high)])

    def assert_all_is_kept(self, text):
        report, volumes = self.mesh(text)
        self.assertAlmostEqual(sum(volumes.values()), 700, delta=1e-8)
        self.assertFalse(any("hole" in text or "stops short" in text for text in report["warnings"]), report["warnings"])

    def test_a_scarp_of_the_topography_along_a_fault_keeps_what_is_below(self):
        for low, high in ((8, 6), (6, 8)):
            self.scarp(low, high, 5)
            self.assert_all_is_kept(self.SCARP)

    def test_a_scarp_whose_foot_is_longer_than_its_edge(self):
        """West of f the relief goes up and down along it, by half a metre each 3 m."""
        self.scarp(6, 8, 5)
        ridges = [(x, y, 6 + 0.5 * (k % 2)) for k, y in enumerate((-1, 2, 5, 8, 11)) for x in (-1, 5)]
        block = [(5, -1, 8), (11, -1, 8), (5, 11, 8), (11, 11, 8)]
        self.write("relief.ts", triangles_ts("relief", ridges + block, [t for k in (0, 2, 4, 6, 10) for t in ((k, k + 1, k + 3), (k, k + 3, k + 2))]))
        report, volumes = self.mesh(self.SCARP)
        west = 5 * (12 * 6.25 - 2 * (6 + 0.5 / 6))
        self.assertAlmostEqual(sum(volumes.values()), west + 400, delta=1e-8)
        self.assertFalse(any("hole" in text or "stops short" in text for text in report["warnings"]), report["warnings"])

    def test_a_topography_given_in_blocks_that_overshoot_a_fault(self):
        for low, high in ((8, 6), (6, 8)):
            self.scarp(low, high, 6)
            self.assert_all_is_kept(self.SCARP.replace("relief.ts}", "relief.ts, throw_at: [f]}"))

    def test_a_bottom_that_stops_short_leaves_nothing_out(self):
        """Most of the model lies about the bottom, which ends inside; under the salt that passes it, it parts the rest from the salt."""
        points, triangles = strip([(1, 4), (9, 4)], 1, 9)
        self.write("base.ts", triangles_ts("base", points, triangles))
        self.write("salt.ts", triangles_ts("salt", *box_surface((4, 4, 2), (6, 6, 9))))
        text = """surfaces:
  - {name: base, kind: horizon, file: base.ts}
  - {name: salt, kind: body, file: salt.ts}
"""
        self.project = self.write("model.yaml", "name: model\nbox: {min: [0, 0, 0], max: [10, 10, 10], bottom: base}\n".replace("min: [0, 0, 0], max: [10, 10, 10]", "center: [5, 5], size: [10, 10], top: 10") + text + "output: {directory: out}\n")
        self.run_program(self.project)
        report = self.report(self.path("out", "model.report.json"))
        self.told(report, "warnings", "bottom base has a hole or stops short")
        check = self.check(self.path("out", "model.vtu"), "--project", self.project)
        self.assertEqual(len(check["regions"]), 2)

    def test_polygon_between_two_horizons(self):
        self.write("roof.ts", plane_ts("roof", [(-1, -1, 8), (11, -1, 8), (11, 11, 8), (-1, 11, 8)]))
        self.write("floor.ts", plane_ts("floor", [(-1, -1, 1), (11, -1, 3), (11, 11, 3), (-1, 11, 1)]))
        project = self.write("model.yaml", """name: model
box: {polygon: [[0, 0], [6, 0], [6, 3], [3, 3], [3, 6], [0, 6]], bottom: floor, top: roof}
surfaces:
  - {name: roof, kind: horizon, file: roof.ts}
  - {name: floor, kind: horizon, file: floor.ts}
column: [air, roof, rock, floor, below]
output: {directory: out, formats: [vtu, inp]}
""")
        self.run_program(project)
        check = self.check(self.path("out", "model.vtu"), "--project", project)
        self.assertEqual([region["name"] for region in check["regions"]], ["rock"])
        # What lies above the top and below the bottom is no unit that the model lacks.
        self.assertFalse([w for w in self.report(self.path("out", "model.report.json"))["warnings"] if "no region" in w])
        # Distance of the planes at the centroids of [0,6]x[0,3] and [0,3]x[3,6].
        self.assertAlmostEqual(check["volume"], 18 * (8 - 1 - 4 / 6) + 9 * (8 - 1 - 2.5 / 6), delta=1e-9)
        with open(self.path("out", "model.inp")) as file:
            text = file.read()
        for name in ("side_1.faces", "side_6.faces", "roof.faces", "floor.faces"):
            self.assertIn("*SURFACE, NAME=%s," % name, text)


class Overshoot(RulesTest):
    def test_a_strip_between_two_horizons_is_no_overshoot(self):
        """The fault ends half a metre short of the box; its strip between the horizons is 3 high, its corners are all on them."""
        self.write("top.ts", level("top", 6))
        self.write("base.ts", level("base", 3))
        self.write("f.ts", plane_ts("f", [(5, -1, -1), (5, 9.5, -1), (5, 9.5, 11), (5, -1, 11)]))
        report, _ = self.mesh("""surfaces:
  - {name: top, kind: horizon, file: top.ts}
  - {name: base, kind: horizon, file: base.ts}
  - {name: f, kind: fault, file: f.ts, extent: as_given}
column: [u1, top, u2, base, u3]
rules: {trim_overshoot: 1}
""")
        area = {surface["name"]: surface["area"] for surface in report["surfaces"]}
        self.assertAlmostEqual(area["f"], 95, delta=1e-9)

    def test_what_another_fault_ends_on_is_no_overshoot(self):
        """f is 0.5 above h, and g ends on it at 0.3. What is above g goes, and what is below it stays."""
        self.write("h.ts", level("h", 5))
        self.surface("f", [(5, -1), (5, 5.5)])
        self.surface("g", [(5, 5.3), (11, 5.8)])
        _, volumes = self.mesh("""surfaces:
  - {name: h, kind: horizon, file: h.ts}
  - {name: f, kind: fault, file: f.ts}
  - {name: g, kind: fault, file: g.ts}
column: [upper, h, lower]
rules: {trim_overshoot: 1}
""")
        below_g = 50 * (0.3 + 0.5 * 5 / 12)
        self.assert_volumes(volumes, {"upper__1": 500 - below_g, "upper__2": below_g, "lower__1": 250, "lower__2": 250})


class Dykes(RulesTest):
    DYKE = """surfaces:
  - {name: top, kind: horizon, file: top.ts}
  - {name: f, kind: fault, file: f.ts}
  - {name: dyke, kind: body, file: dyke.ts, thickness: 0.5%s}
column: [upper, top, lower]
"""

    def setUp(self):
        super().setUp()
        self.write("top.ts", level("top", 6))
        self.write("f.ts", plane_ts("f", [(-1, 2, -1), (11, 3, -1), (11, 3, 11), (-1, 2, 11)]))

    def test_a_dyke_through_the_box_cuts_horizons_and_faults_and_has_its_volume(self):
        self.surface("dyke", [(4, -1), (5, 4), (5, 11)])
        report, volumes = self.mesh(self.DYKE % "")
        self.assertEqual(sorted(r["name"].split("__")[0] for r in report["regions"] if r["name"] != "dyke"), ["lower"] * 4 + ["upper"] * 4)
        self.told(report, "notes", "body dyke", "thickness 0.5")
        # Between two walls that are parallel to the sheet in each of its two parts; the bend's mitre is the same on both sides.
        self.assertAlmostEqual(volumes["dyke"], 0.5 * 10 * (4 * 26 ** 0.5 / 5 + 6), delta=0.05)
        self.assertAlmostEqual(sum(volumes.values()), 1000, delta=1e-9)
        areas = {s["name"]: s["area"] for s in report["surfaces"]}
        self.assertAlmostEqual(areas["top"], 100 - 10 * 0.5, delta=0.01)

    def test_a_sill_ends_where_its_sheet_ends_or_goes_on_to_the_box(self):
        self.write("dyke.ts", plane_ts("dyke", [(2, 2, 3), (8, 2, 3), (8, 8, 3), (2, 8, 3)]))
        _, volumes = self.mesh(self.DYKE % "")
        self.assertAlmostEqual(volumes["dyke__1"] + volumes["dyke__2"] if "dyke__1" in volumes else volumes["dyke"], 36 * 0.5, delta=1e-9)
        _, volumes = self.mesh(self.DYKE % ", extend: flat")
        self.assertAlmostEqual(volumes["dyke"], 50, delta=1e-9)

    def test_what_is_no_sheet_with_a_thickness_is_refused(self):
        self.surface("dyke", [(4, -1), (4.2, 5), (4, 11)])
        self.assertIn("only a body has a thickness", self.mesh((self.DYKE % "").replace("kind: body", "kind: fault"), status=USAGE))
        self.assertIn("above zero", self.mesh((self.DYKE % "").replace("0.5", "0"), status=USAGE))
        self.surface("dyke", [(4, -1), (5, 5), (5.4, 5), (6.4, -1)])
        self.assertIn("bends more tightly", self.mesh((self.DYKE % "").replace("0.5", "1.5"), status=BAD_INPUT))



if __name__ == "__main__":
    main()
