#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Elements of second order on curved input: volume, tolerance, Jacobians, the order of nodes in each format, and the checker."""
import itertools
import math

import format_readers as readers
from geomesh_program import ProgramTest, has_module, level, main, triangles_ts
from vtk_files import VtkFile

RADIUS, CENTRE, TOLERANCE = 3.0, (5.0, 5.0, 5.0), 0.15
EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))


def ball(depth):
    """An icosahedron's faces cut in four `depth` times, on the sphere."""
    t = (1 + math.sqrt(5)) / 2
    points = [(-1, t, 0), (1, t, 0), (-1, -t, 0), (1, -t, 0), (0, -1, t), (0, 1, t), (0, -1, -t), (0, 1, -t), (t, 0, -1), (t, 0, 1), (-t, 0, -1), (-t, 0, 1)]
    triangles = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6),
                 (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    points = [tuple(x / math.hypot(*p) for x in p) for p in points]
    for _ in range(depth):
        middle, cut = {}, []
        for t3 in triangles:
            m = []
            for a, b in zip(t3, t3[1:] + t3[:1]):
                key = (min(a, b), max(a, b))
                if key not in middle:
                    p = [x + y for x, y in zip(points[a], points[b])]
                    middle[key] = len(points)
                    points.append(tuple(x / math.hypot(*p) for x in p))
                m.append(middle[key])
            cut += [(t3[0], m[0], m[2]), (t3[1], m[1], m[0]), (t3[2], m[2], m[1]), tuple(m)]
        triangles = cut
    return [tuple(c + RADIUS * x for c, x in zip(CENTRE, p)) for p in points], triangles


def minus(p, q):
    return [a - b for a, b in zip(p, q)]


def det(a, b, c):
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])


def bezier(nodes):
    """The 20 Bezier coefficients of six times the Jacobian's determinant, with the volume under them."""
    at = {}
    for i in range(4):
        at[i, i] = nodes[i]
    for e, (i, j) in enumerate(EDGES):
        at[i, j] = at[j, i] = [2 * m - (a + b) / 2 for m, a, b in zip(nodes[4 + e], nodes[i], nodes[j])]
    found, volume = [], 0
    for corners in itertools.combinations_with_replacement(range(4), 3):
        value = sum(det(*(minus(at[d + 1, c], at[0, c]) for d, c in enumerate(order))) for order in itertools.permutations(corners)) / 6
        found.append(8 * value)
        volume += 8 * value / 6 / 20
    return found, volume


class Curved(ProgramTest):
    def model(self, formats="vtu", order=2, extra="", tolerance=TOLERANCE, kind="body"):
        points, triangles = ball(4)
        self.write("ball.ts", triangles_ts("ball", points, triangles))
        self.write("project.yaml", "name: model\nbox: {min: [0, 0, 0], max: [10, 10, 10]}\nsurfaces:\n  - {name: ball, kind: %s, file: ball.ts}\n%s"
                   "mesh: {size: 1.6, tolerance: %g}\noutput: {directory: ., formats: [%s], order: %d}\n" % (kind, extra, tolerance, formats, order))
        self.run_program("project.yaml")
        wanted = sum(det(*(points[v] for v in t)) for t in triangles) / 6
        return abs(wanted)

    def cells(self):
        """Points of each cell of the ball, and of all."""
        grid = VtkFile.read(self.path("model.vtu"))
        xyz, nodes = grid["Points", "Points"].values, grid["Cells", "connectivity"].values
        points = [tuple(xyz[3 * i:3 * i + 3]) for i in range(len(xyz) // 3)]
        inside = grid["FieldData", "region:ball"].values[0]
        cells = [[points[v] for v in nodes[10 * c:10 * c + 10]] for c in range(len(nodes) // 10)]
        return [c for c, r in zip(cells, grid["CellData", "region"].values) if r == inside], cells

    def test_the_volume_is_better_by_an_order_and_all_jacobians_are_positive(self):
        wanted = self.model()
        own, everything = self.cells()
        straight = sum(det(minus(c[1], c[0]), minus(c[2], c[0]), minus(c[3], c[0])) for c in own) / 6
        curved = 0
        for c in own:
            curved += bezier(c)[1]
        for c in everything:
            self.assertGreater(min(bezier(c)[0]), 0)
        self.assertGreater(abs(straight - wanted) / wanted, 1e-3)
        self.assertLess(abs(curved - wanted), 0.1 * abs(straight - wanted))
        total = sum(bezier(c)[1] for c in everything)
        self.assertAlmostEqual(total, 1000, delta=1e-8)
        self.check(self.path("model.vtu"), "--project", self.path("project.yaml"))

    def test_midpoints_are_on_the_input_within_the_tolerance(self):
        self.model()
        faces = VtkFile.read(self.path("model.faces.vtp"))
        ids, nodes, rows = faces["CellData", "surface"].values, faces["Polys", "connectivity"].values, faces["PointData", "mesh_point"].values
        ball_id = faces["FieldData", "surface:ball"].values[0]
        grid = VtkFile.read(self.path("model.vtu"))
        xyz, cells = grid["Points", "Points"].values, grid["Cells", "connectivity"].values
        middle = {}
        for c in range(len(cells) // 10):
            for e, (i, j) in enumerate(EDGES):
                middle[frozenset((cells[10 * c + i], cells[10 * c + j]))] = cells[10 * c + 4 + e]
        off, straight_off = [], []
        for f, surface in enumerate(ids):
            if surface != ball_id:
                continue
            corners = [rows[n] for n in nodes[3 * f:3 * f + 3]]
            for a, b in itertools.combinations(corners, 2):
                m = middle[frozenset((a, b))]
                off.append(abs(math.dist(xyz[3 * m:3 * m + 3], CENTRE) - RADIUS))
                straight_off.append(abs(math.dist([(p + q) / 2 for p, q in zip(xyz[3 * a:3 * a + 3], xyz[3 * b:3 * b + 3])], CENTRE) - RADIUS))
        self.assertLessEqual(max(off), TOLERANCE)
        of_input = 0.0045  # the input's triangles lie this far inside the sphere at most
        self.assertGreater(sum(d <= of_input for d in off), 0.9 * len(off))
        self.assertGreater(sum(d > 2 * of_input for d in straight_off), 0.5 * len(off))

    def test_every_format_has_its_own_order_of_nodes(self):
        self.model(", ".join(["vtu", "msh", "inp"] + [name for name in ("exodus", "med") if has_module(name)]))
        try:
            meshio = readers.need("meshio")
        except readers.ReaderMissing:
            self.skipTest("skipped: python3-meshio is not installed")
        wanted = self.places(meshio.read(self.path("model.vtu")))
        self.assertGreater(len(wanted), 100)
        self.assertTrue(self.places(meshio.read(self.path("model.msh"))) == wanted, "the order of nodes in model.msh")
        for ending in (".vtu", ".msh", ".inp", ".e", ".med"):
            if has_module({".e": "exodus", ".med": "med"}.get(ending, "")):
                check = self.check(self.path("model" + ending), status=None)
                self.assertTrue(any("Bezier" in text for text in check["checks_done"]), ending)

    def places(self, mesh):
        cells = [cell for block in mesh.cells if block.type == "tetra10" for cell in block.data.tolist()]
        found = set()
        for cell in cells:
            at = {i: tuple(round(float(x), 9) for x in mesh.points[v]) for i, v in enumerate(cell)}
            edges = frozenset((frozenset((at[i], at[j])), at[4 + e]) for e, (i, j) in enumerate(EDGES))
            found.add(edges)
        return found

    def test_the_checker_names_a_midpoint_that_is_off_and_one_that_turns_an_element(self):
        self.model()
        grid = VtkFile.read(self.path("model.vtu"))
        at, nodes = grid["Points", "Points"], grid["Cells", "connectivity"].values
        original = list(at.values)
        m = nodes[4]
        for k in range(3):
            at.values[3 * m + k] += 3
        grid.write(self.path("model.vtu"))
        self.assertIn("jacobian_not_positive", {f["id"] for f in self.check(self.path("model.vtu"), status=3)["faults"]})
        at.values = original
        kinds = VtkFile.read(self.path("model.faces.vtp"))
        ball_id = kinds["FieldData", "surface:ball"].values[0]
        face = next(f for f, s in enumerate(kinds["CellData", "surface"].values) if s == ball_id)
        a, b = (kinds["PointData", "mesh_point"].values[n] for n in kinds["Polys", "connectivity"].values[3 * face:3 * face + 2])
        m = next(nodes[10 * c + 4 + e] for c in range(len(nodes) // 10) for e, (i, j) in enumerate(EDGES) if {nodes[10 * c + i], nodes[10 * c + j]} == {a, b})
        for k in range(3):
            at.values[3 * m + k] = CENTRE[k] + (at.values[3 * m + k] - CENTRE[k]) * (1 + 1.2 * TOLERANCE / RADIUS)
        grid.write(self.path("model.vtu"))
        self.assertIn("midpoints_off", {f["id"] for f in self.check(self.path("model.vtu"), "--project", self.path("project.yaml"), status=3)["faults"]})

    def test_edges_of_two_surfaces_stay_on_both_and_sides_stay_plane(self):
        """A level through the ball: the circle where they meet is followed, heights on the level and on sides do not change."""
        self.write("mid.ts", level("mid", 5))
        self.model(extra="  - {name: mid, kind: fault, file: mid.ts}\n")
        self.check(self.path("model.vtu"), "--project", self.path("project.yaml"))
        grid = VtkFile.read(self.path("model.vtu"))
        xyz, nodes = grid["Points", "Points"].values, grid["Cells", "connectivity"].values
        curves = VtkFile.read(self.path("model.curves.vtp"))
        circle = next(a.values[0] for a in curves.arrays if a.section == "FieldData" and a.name == "curve:ball*mid")
        rows, lines = curves["PointData", "mesh_point"].values, curves["Lines", "connectivity"].values
        ids = curves["CellData", "curve"].values[-(len(lines) // 2):]
        middle = {frozenset((nodes[10 * c + i], nodes[10 * c + j])): nodes[10 * c + 4 + e] for c in range(len(nodes) // 10) for e, (i, j) in enumerate(EDGES)}
        on = [middle[frozenset((rows[lines[2 * k]], rows[lines[2 * k + 1]]))] for k, curve in enumerate(ids) if curve == circle]
        self.assertGreater(len(on), 6)
        for m in on:
            self.assertAlmostEqual(xyz[3 * m + 2], 5, delta=1e-9)
            self.assertAlmostEqual(math.dist(xyz[3 * m:3 * m + 3], CENTRE), RADIUS, delta=0.01)

    def curved_faces(self, name="ball", stem="model"):
        """Six nodes of each face of a surface."""
        faces, grid = VtkFile.read(self.path(stem + ".faces.vtp")), VtkFile.read(self.path(stem + ".vtu"))
        ids, nodes, rows = faces["CellData", "surface"].values, faces["Polys", "connectivity"].values, faces["PointData", "mesh_point"].values
        own = faces["FieldData", "surface:" + name].values[0]
        xyz, cells = grid["Points", "Points"].values, grid["Cells", "connectivity"].values
        middle = {frozenset((cells[10 * c + i], cells[10 * c + j])): cells[10 * c + 4 + e] for c in range(len(cells) // 10) for e, (i, j) in enumerate(EDGES)}
        for f, surface in enumerate(ids):
            if surface == own:
                v = [rows[n] for n in nodes[3 * f:3 * f + 3]]
                v += [middle[frozenset((v[i], v[(i + 1) % 3]))] for i in range(3)]
                yield [tuple(xyz[3 * n:3 * n + 3]) for n in v]

    def test_whole_faces_are_within_the_tolerance_not_their_midpoints_alone(self):
        """The tolerance is so small that faces of curved edges pass it in places where their nodes do not."""
        self.model(tolerance=0.03)
        farthest, n_curved = 0, 0
        n = 8
        for nodes in self.curved_faces():
            n_curved += any(math.dist(nodes[3 + i], [(a + b) / 2 for a, b in zip(nodes[i], nodes[(i + 1) % 3])]) > 1e-9 for i in range(3))
            for i in range(n + 1):
                for j in range(n + 1 - i):
                    at = (i / n, j / n, (n - i - j) / n)
                    p = [sum(at[k] * (2 * at[k] - 1) * nodes[k][x] + 4 * at[k] * at[(k + 1) % 3] * nodes[3 + k][x] for k in range(3)) for x in range(3)]
                    farthest = max(farthest, abs(math.dist(p, CENTRE) - RADIUS))
        self.assertGreater(n_curved, 100)
        self.assertLessEqual(farthest, 0.03 + 0.0045)  # the input's triangles lie this far inside the sphere at most

    def test_edges_on_slanting_sides_are_curved_within_their_planes(self):
        """The ball is cut by two sides of a turned box."""
        points, triangles = ball(4)
        self.write("ball.ts", triangles_ts("ball", points, triangles))
        self.write("project.yaml", "name: model\nbox: {center: [5, 5], size: [4, 12], azimuth: 30, bottom: 0, top: 10}\n"
                   "surfaces:\n  - {name: ball, kind: body, file: ball.ts}\nmesh: {size: 1.2, tolerance: 0.1}\noutput: {directory: ., order: 2}\n")
        self.run_program("project.yaml")
        self.check(self.path("model.vtu"), "--project", self.path("project.yaml"))
        # The sides that cut the ball are two from the centre, across the box: x at 30 degrees clockwise.
        across = (math.cos(math.radians(30)), -math.sin(math.radians(30)))
        on_side, curved = 0, 0
        for nodes in self.curved_faces():
            for i in range(3):
                a, b, m = nodes[i], nodes[(i + 1) % 3], nodes[3 + i]
                off = [abs(sum(across[x] * (p[x] - 5) for x in range(2))) - 2 for p in (a, b, m)]
                if abs(off[0]) < 1e-9 and abs(off[1]) < 1e-9:
                    on_side += 1
                    self.assertAlmostEqual(off[2], 0, delta=1e-9)
                    curved += math.dist(m, [(p + q) / 2 for p, q in zip(a, b)]) > 1e-5
                    self.assertLess(abs(math.dist(m, CENTRE) - RADIUS), 0.02)
        self.assertGreater(on_side, 10)
        self.assertGreater(curved, 0.8 * on_side)

    def test_convert_keeps_the_order_and_every_midpoint(self):
        """Through each format that holds them, to the last bit; what holds no second order says so."""
        self.model()
        wanted = self.exact_places("model")
        formats = ["msh", "msh-binary", "msh22", "msh22-binary"] + [name for name in ("exodus", "med") if has_module(name)]
        ending = {"exodus": ".e", "med": ".med"}
        for name in formats:
            there = "there_" + name.replace("-", "_") + ending.get(name, ".msh")
            self.run_program("convert", "model.vtu", "-o", there, "--format", name)
            self.run_program("convert", there, "-o", "back.vtu")
            self.assertTrue(self.exact_places("back") == wanted, name)
        self.run_program("convert", "model.vtu", "-o", "there.inp")
        self.run_program("convert", "there.inp", "-o", "back.vtu")
        self.assertEqual(len(self.exact_places("back")), len(wanted))
        self.run_program("convert", "model.vtu", "--order", "1", "-o", "first.vtu")
        self.assertEqual(set(VtkFile.read(self.path("first.vtu"))["Cells", "types"].values), {10})
        self.assertIn("first order", self.run_program("convert", "model.vtu", "-o", "model.mesh"))

    def test_convert_keeps_values_at_midpoints(self):
        """A quadratic function of the place, of another tool, without faces: at midpoints it is not the mean of the ends."""
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        places = corners + [tuple((p + q) / 2 for p, q in zip(corners[i], corners[j])) for i, j in ((0, 1), (1, 2), (2, 0), (0, 3), (2, 3), (1, 3))]
        value = {p: p[0] ** 2 + 3 * p[1] * p[2] - 0.1 * p[1] + 7 for p in places}
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", "10"] + ["%d %g %g %g" % (i + 1, *p) for i, p in enumerate(places)]
        lines += ["$EndNodes", "$Elements", "1", "1 11 2 1 1 1 2 3 4 5 6 7 8 9 10", "$EndElements", "$NodeData", "1", '"heat"', "1", "0", "3", "0", "1", "10"]
        self.write("other.msh", "\n".join(lines + ["%d %.17g" % (i + 1, value[p]) for i, p in enumerate(places)] + ["$EndNodeData"]) + "\n")
        self.run_program("convert", "other.msh", "-o", "model.vtu")
        self.assertEqual(self.values_by_place("model", "heat"), value)
        for name, there in (("msh", "t.msh"), ("msh-binary", "tb.msh"), ("msh22", "t22.msh"), ("exodus", "t.e")):
            self.run_program("convert", "model.vtu", "-o", there, "--format", name)
            self.run_program("convert", there, "-o", "back.vtu")
            self.assertEqual(self.values_by_place("back", "heat"), value, name)

    def values_by_place(self, stem, array):
        grid = VtkFile.read(self.path(stem + ".vtu"))
        xyz = grid["Points", "Points"].values
        return {tuple(xyz[3 * i:3 * i + 3]): v for i, v in enumerate(grid["PointData", array].values)}

    def exact_places(self, stem):
        grid = VtkFile.read(self.path(stem + ".vtu"))
        self.assertEqual(set(grid["Cells", "types"].values), {24})
        xyz, cells = grid["Points", "Points"].values, grid["Cells", "connectivity"].values
        at = lambda v: tuple(xyz[3 * v:3 * v + 3])
        return {(frozenset((at(cells[10 * c + i]), at(cells[10 * c + j]))), at(cells[10 * c + 4 + e])) for c in range(len(cells) // 10) for e, (i, j) in enumerate(EDGES)}

    def test_a_zone_opened_later_has_straight_walls(self):
        self.model(kind="fault")
        self.run_program("convert", "model.vtu", "--fault-zone", "ball=0.04,1", "-o", "zone.vtu")
        self.check(self.path("zone.vtu"))
        for wall in ("ball.minus", "ball.plus"):
            faces = list(self.curved_faces(wall, "zone"))
            self.assertGreater(len(faces), 50)
            for nodes in faces:
                for i in range(3):
                    self.assertLess(math.dist(nodes[3 + i], [(p + q) / 2 for p, q in zip(nodes[i], nodes[(i + 1) % 3])]), 1e-12)


if __name__ == "__main__":
    main()
