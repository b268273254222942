# SPDX-License-Identifier: GPL-3.0-or-later
"""Grids in a volume whose sides run along their rows: a turned box, a polygon of the map, a box along the axes.

The sides and the grid are computed apart from each other, as users do. So the rows are on the sides but for rounding. Each model must be
meshed in the time that its number of elements asks for, pass the checker, and have no element too flat that nothing forces.

So must be models with a fault past an upright edge of the volume, or with two that cross where both have vertices.

    GEOMESH_TURNED_GRIDS=300 ctest ... -R app.turned_grids     another number of models
"""
import math
import os
import random
import resource

from geomesh_program import CANNOT_MESH, NIGHTLY, SLOWNESS, ProgramTest, main, triangles_ts

COUNT = int(os.environ.get("GEOMESH_TURNED_GRIDS", "200" if NIGHTLY else "12"))
MOST_SECONDS = 60 * SLOWNESS  # of CPU; without the joining to sides such models took more than ten minutes
# Where needles of both faults and edges of a horizon stand in one place, elements as low as rounding are left, and the run says so
# (docs/reliability.md). The first beyond COUNT are of nightly.
CROSSINGS_LEFT_FLAT = (33, 79, 139, 146, 180)


class Model:
    """Two horizons on one grid, at times a fault along one of its rows; the grid ends at the sides or some cells beyond them."""

    def __init__(self, seed, decimals=None):
        dice = self.dice = random.Random(seed)
        self.shape = dice.choice(("box", "box", "polygon", "aligned"))
        self.azimuth = 0 if self.shape == "aligned" else dice.choice((30, 45, dice.uniform(-90, 90), dice.randint(-90, 90)))
        self.step = dice.choice((50.0, 33.3, 25.1, dice.uniform(20, 60)))
        self.origin = dice.choice(((1000.1, 5000.7), (0, 0), (500123.45, 6712345.6), (dice.uniform(0, 1e4), dice.uniform(0, 1e4))))
        self.cells = dice.randint(10, 40), dice.randint(8, 20)
        self.beyond = dice.choice((0, 1, 2))
        self.decimals = decimals
        self.east, self.north = (self.step * n for n in self.cells)
        self.unit = self.east / 20
        self.surfaces = [("top", "horizon", *self.horizon(0)), ("base", "horizon", *self.horizon(1))]
        if dice.random() < 0.4:
            self.surfaces.append(("f", "fault", *self.fault()))

    def place(self, x, y):
        c, s = math.cos(math.radians(self.azimuth)), math.sin(math.radians(self.azimuth))
        return self.origin[0] + c * x - s * y, self.origin[1] + s * x + c * y

    def given(self, point):
        return point if self.decimals is None else tuple(round(x, self.decimals) for x in point)

    def horizon(self, k):
        phase, cut = self.dice.uniform(0, 6), self.dice.random() < 0.5
        xs, ys = (range(-self.beyond, n + self.beyond + 1) for n in self.cells)
        height = lambda i, j: 0.6 * self.unit * math.sin(6 * i / self.cells[0] + phase) * math.cos(9 * j / self.cells[1])  # noqa: E731
        points = [self.given((*self.place(self.step * i, self.step * j), -(8 + 6 * k) * self.unit + height(i, j))) for j in ys for i in xs]
        n = len(xs)
        corners = [(a, a + 1, a + 1 + n, a + n) for j in range(len(ys) - 1) for a in range(j * n, j * n + n - 1)]
        return points, [t for a, b, c, d in corners for t in (((a, b, c), (a, c, d)) if cut else ((a, b, d), (b, c, d)))]

    def fault(self):
        """Through a row of the grid at half depth; it dips along the rows across."""
        x, more, off = self.step * (self.cells[0] // 3), self.step * self.beyond, 3 * self.unit
        corners = ((x - off, -more, 1), (x - off, self.north + more, 1), (x + off, self.north + more, -21), (x + off, -more, -21))
        return [self.given((*self.place(x, y), z * self.unit)) for x, y, z in corners], [(0, 1, 2), (0, 2, 3)]

    def upright(self, name, ends, off, cells):
        """A fault from end to end (along the grid), beside them by `off`, from above the volume to below it, in so many cells each way."""
        (ax, ay), (bx, by) = ends
        length = math.hypot(bx - ax, by - ay)
        nx, ny = -off * (by - ay) / length, off * (bx - ax) / length
        places = [(ax + (bx - ax) * i / cells + nx, ay + (by - ay) * i / cells + ny) for i in range(cells + 1)]
        points = [self.given((*self.place(x, y), (1 - 22 * j / cells) * self.unit)) for j in range(cells + 1) for x, y in places]
        n = cells + 1
        corners = [(a, a + 1, a + 1 + n, a + n) for j in range(cells) for a in range(j * n, j * n + cells)]
        return name, "fault", points, [t for a, b, c, d in corners for t in ((a, b, c), (a, c, d))]

    def without_faults(self):
        return [s for s in self.surfaces if s[1] != "fault"]

    def take_crossing_faults(self):
        """From corner to corner, so that both have vertices at the middle, apart by nothing to 30 mm. Each is cut into cells of its own number."""
        dice, before = self.dice, self.dice.choice((0, 0.03, 0.1))
        low, (e, n) = -before, ((1 + before) * x for x in (self.east, self.north))
        off = dice.choice((0, 1, 1, -1)) * 10 ** dice.uniform(-6, -1.5)
        ends = ((low * self.east, low * self.north), (e, n)), ((e, low * self.north), (low * self.east, n))
        self.surfaces = self.without_faults() + [self.upright(name, at, by, dice.choice((2, 4, 6))) for name, at, by in (("f", ends[0], off), ("g", ends[1], -off))]

    def take_fault_by_corner(self):
        """An upright fault past the first upright edge of the volume, by nothing to 30 mm, to the edge across or to a place inside."""
        dice, diagonal = self.dice, math.degrees(math.atan2(self.north, self.east))
        across = self.shape != "polygon" and 15 < diagonal < 75 and dice.random() < 0.5
        angle = math.radians(diagonal if across else dice.uniform(15, 75))
        length = math.hypot(self.east, self.north) if across else 0.6 * min(self.east, self.north)
        off, cells, before = dice.choice((0, 0, 1, -1)) * 10 ** dice.uniform(-6, -1.5), dice.choice((1, 1, 2, 5, 9)), dice.choice((0, 0.03, 0.1))
        ends = [(x * math.cos(angle), x * math.sin(angle)) for x in (-before * length, length * (1 + before if across else 1))]
        self.surfaces = self.without_faults() + [self.upright("f", ends, off, cells)]

    def box(self):
        bottom = f"bottom: {-20 * self.unit!r}, top: 0"
        if self.shape == "aligned":
            (x, y), low = self.origin, -20 * self.unit
            return f"{{min: [{x!r}, {y!r}, {low!r}], max: [{x + self.east!r}, {y + self.north!r}, 0]}}"
        if self.shape == "box":
            x, y = self.given(self.place(self.east / 2, self.north / 2))
            return f"{{center: [{x!r}, {y!r}], size: [{self.east!r}, {self.north!r}], azimuth: {-self.azimuth!r}, {bottom}}}"
        corners = ((0, 0), (self.east, 0), (self.east, self.north), (0.5 * self.east, 0.7 * self.north), (0, self.north))
        return "{polygon: [" + ", ".join("[%r, %r]" % self.given(self.place(x, y)) for x, y in corners) + f"], {bottom}}}"

    def project(self, mesh):
        listed = "".join(f"  - {{name: {name}, kind: {kind}, file: {name}.ts}}\n" for name, kind, _, _ in self.surfaces)
        return (f"name: m\nbox: {self.box()}\nsurfaces:\n{listed}column: [a, top, b, base, c]\nmesh: {mesh}\n"
                "output: {directory: out, formats: [vtu]}\n")


class TurnedGrids(ProgramTest):
    timeout = 4 * MOST_SECONDS

    def write_model(self, model, mesh):
        for name, _, points, triangles in model.surfaces:
            self.write(name + ".ts", triangles_ts(name, points, triangles))
        return self.write("m.yaml", model.project(mesh))

    def mesh_and_check(self, model, mesh, is_left_flat=False):
        project = self.write_model(model, mesh)
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        self.run_program(project)
        if not is_left_flat:
            self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, MOST_SECONDS)
        self.check(self.path("out", "m.vtu"), "--project", project)
        report = self.report(self.path("out", "m.report.json"))
        flat = report["quality"]["below_8_degrees"]
        if not is_left_flat:
            self.assertEqual(flat["tetrahedra"], flat["forced"], report["quality"]["worst"])
        self.assertFalse([w for w in report["warnings"] if "stops short" in w])
        return report

    def test_rows_on_the_sides_but_for_rounding(self):
        for seed in range(COUNT):
            model = Model(seed)
            mesh = random.Random(seed).choice(("{}", "{honour: exact}", f"{{size: {2 * model.step:g}}}", f"{{tolerance: 2, size: {3 * model.step:g}}}"))
            with self.subTest(seed=seed, mesh=mesh):
                self.mesh_and_check(model, mesh)

    def test_rows_on_the_sides_but_for_what_files_round_to(self):
        """Horizons that end there reach the sides within the tolerance, as those in a box along the axes do."""
        for seed in range(COUNT):
            for decimals in (2, 6):
                with self.subTest(seed=seed, decimals=decimals):
                    self.mesh_and_check(Model(seed, decimals), "{}")

    def test_faults_past_an_upright_edge_are_drawn_to_it(self):
        """Beside the edge such a fault leaves no room for an element, so none may be flat, and nothing is left to tell of."""
        for seed in range(COUNT):
            model = Model(1000 + seed, random.Random(seed).choice((None, 6, 3, 2)))
            model.take_fault_by_corner()
            with self.subTest(seed=seed, decimals=model.decimals):
                report = self.mesh_and_check(model, "{}")
                self.assertEqual(report["quality"]["below_8_degrees"]["tetrahedra"], 0, report["quality"]["worst"])
                self.assertFalse([w for w in report["warnings"] if "falls into" not in w])

    def test_faults_that_cross_where_both_have_vertices(self):
        """Needles stand along the curve where they cross, on both. No place there is a gap, so all is remeshed within the tolerance."""
        for seed in range(COUNT):
            model = Model(2000 + seed, random.Random(seed).choice((None, 6, 3, 2)))
            model.take_crossing_faults()
            with self.subTest(seed=seed, decimals=model.decimals):
                report = self.mesh_and_check(model, "{}", is_left_flat=seed in CROSSINGS_LEFT_FLAT)
                if seed in CROSSINGS_LEFT_FLAT:
                    self.assertFalse(report["solver"]["passes"], "mended: take it off the list")
                else:
                    self.assertFalse([w for w in report["warnings"] if "falls into" not in w])

    def test_a_fault_and_horizons_at_an_upright_edge_exactly(self):
        """Turned by 45 degrees about zero, doubles lie on the edges. The fault takes these, horizons end there, and it must not cross itself."""
        model = Model(8)
        self.assertEqual((model.azimuth, model.origin, model.beyond), (45, (0, 0), 0))
        east, north = 0.1 * model.east, 0.1 * model.north
        ends = ((-east, -north, 1), (model.east + east, model.north + north, 1), (model.east + east, model.north + north, -21), (-east, -north, -21))
        model.surfaces[2:] = [("f", "fault", [(*model.place(x, y), z * model.unit) for x, y, z in ends], [(0, 1, 2), (0, 2, 3)])]
        report = self.mesh_and_check(model, "{}")
        self.assertFalse([w for w in report["warnings"] if "falls into" not in w])

    def test_needles_that_ask_for_most_elements_are_told_before_the_work(self):
        """In exact mode rows some millimetres off the sides stay there. Rows on the sides leave no needle to tell of."""
        words = "for short edges of the input"
        for decimals in (3, None):
            with self.subTest(decimals=decimals):
                project = self.write_model(Model(2, decimals), "{honour: exact, max_elements: 1000}")
                told = self.run_program(project, status=CANNOT_MESH)
                self.assertIn(words, told)
                count = float(told.split("elements to come: about ")[1].split(", of which")[0].replace(",", ""))
                self.assertEqual(count > 250_000, decimals == 3, told)


if __name__ == "__main__":
    main()
