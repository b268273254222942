# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that are remeshed keep the area within their outline and the volume they enclose, because neither side of the input is preferred.

200 ellipses of 48 corners, turned at random and apart from each other, in one model: the area of each differs from that of its input by at
most a tenth of the tolerance times its perimeter, and the mean of the differences is a fifth of that at most. For 27 ellipsoids the same
holds with the volume and a fiftieth of the tolerance times the surface.
"""
import itertools
import math
import random

from geomesh_program import ProgramTest, main, triangles_ts

COUNT, CORNERS, CELL, IN_A_ROW = 200, 48, 300.0, 6
SIZE, TOLERANCE = 120.0, 6.0


def ellipse(dice, k):
    """Corners about a centre of its own, as a fan; and its area and perimeter."""
    centre = [CELL * (0.5 + k // IN_A_ROW ** i % IN_A_ROW) for i in range(3)]
    a, b = dice.uniform(40, 130), dice.uniform(40, 130)
    azimuth, dip = dice.uniform(0, 2 * math.pi), dice.uniform(0, math.pi / 2)
    u = (math.cos(azimuth), math.sin(azimuth), 0)
    v = (-math.sin(azimuth) * math.cos(dip), math.cos(azimuth) * math.cos(dip), math.sin(dip))
    angles = [2 * math.pi * j / CORNERS for j in range(CORNERS)]
    ring = [tuple(c + a * math.cos(t) * p + b * math.sin(t) * q for c, p, q in zip(centre, u, v)) for t in angles]
    area = 0.5 * CORNERS * a * b * math.sin(2 * math.pi / CORNERS)
    perimeter = sum(math.dist(ring[j - 1], ring[j]) for j in range(CORNERS))
    return [tuple(centre)] + ring, [(0, 1 + j, 1 + (j + 1) % CORNERS) for j in range(CORNERS)], area, perimeter


def octasphere(divisions):
    """Points of the octahedron |x| + |y| + |z| = 1, each face divided evenly, and its triangles, which face outwards."""
    rows, triangles = {}, []

    def row(*p):
        return rows.setdefault(p, len(rows))
    for sx, sy, sz in itertools.product((1, -1), repeat=3):
        def at(i, j):
            return row(sx * i, sy * j, sz * (divisions - i - j))
        for i in range(divisions):
            for j in range(divisions - i):
                found = [(at(i, j), at(i + 1, j), at(i, j + 1))]
                if i + j + 1 < divisions:
                    found.append((at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)))
                triangles += [t if sx * sy * sz > 0 else (t[0], t[2], t[1]) for t in found]
    return [tuple(x / divisions for x in p) for p in rows], triangles


def volume_and_area(points, triangles):
    volume = area = 0
    for t in triangles:
        a, b, c = (points[v] for v in t)
        u, v = ([q - p for p, q in zip(a, x)] for x in (b, c))
        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        volume += sum(p * q for p, q in zip(a, n)) / 6
        area += math.hypot(*n) / 2
    return volume, area


class Outlines(ProgramTest):
    def test_ellipses_keep_their_area(self):
        dice, listed, given = random.Random(8), "", {}
        for k in range(COUNT):
            points, triangles, area, perimeter = ellipse(dice, k)
            self.write(f"e{k}.ts", triangles_ts(f"e{k}", points, triangles))
            listed += f"  - {{name: e{k}, kind: fault, file: e{k}.ts}}\n"
            given[f"e{k}"] = area, perimeter
        side = CELL * IN_A_ROW
        project = self.write("m.yaml", f"name: m\nsurfaces:\n{listed}box: {{min: [0, 0, 0], max: [{side}, {side}, {side}]}}\n"
                             f"rules: {{continue_within: 0}}\nmesh: {{size: {SIZE}, surfaces_within: {TOLERANCE}}}\noutput: {{directory: out, formats: [vtu]}}\n")
        self.run_program(project)
        self.check(self.path("out", "m.vtu"), "--project", project)
        areas = {s["name"]: s["area"] for s in self.report(self.path("out", "m.report.json"))["surfaces"] if s["name"] in given}
        self.assertEqual(len(areas), COUNT)
        off = {name: (areas[name] - area) / (TOLERANCE * perimeter) for name, (area, perimeter) in given.items()}
        worst = max(off, key=lambda name: abs(off[name]))
        self.assertLess(abs(off[worst]), 0.1, worst)
        self.assertLess(abs(sum(off.values()) / COUNT), 0.02)

    def meshed_bodies(self, bodies, in_a_row, size):
        """Volumes by name of closed surfaces, each (points, triangles)."""
        listed, side = "", CELL * in_a_row
        for name, (points, triangles) in bodies.items():
            self.write(name + ".ts", triangles_ts(name, points, triangles))
            listed += f"  - {{name: {name}, kind: body, file: {name}.ts}}\n"
        project = self.write("m.yaml", f"name: m\nsurfaces:\n{listed}box: {{min: [0, 0, 0], max: [{side}, {side}, {side}]}}\n"
                             f"mesh: {{size: {size}, surfaces_within: {TOLERANCE}}}\noutput: {{directory: out, formats: [vtu]}}\n")
        self.run_program(project)
        self.check(self.path("out", "m.vtu"), "--project", project)
        return {r["name"]: r["volume"] for r in self.report(self.path("out", "m.report.json"))["regions"]}

    def test_ellipsoids_keep_their_volume(self):
        dice, bodies, in_a_row = random.Random(9), {}, 3
        corners, triangles = octasphere(12)
        for k in range(in_a_row ** 3):
            centre = [CELL * (0.5 + k // in_a_row ** i % in_a_row) for i in range(3)]
            axes = [dice.uniform(60, 130) for _ in range(3)]
            bodies[f"e{k}"] = [tuple(c + a * x / math.hypot(*p) for c, a, x in zip(centre, axes, p)) for p in corners], triangles
        volumes, off = self.meshed_bodies(bodies, in_a_row, 60), {}
        for name, body in bodies.items():
            volume, area = volume_and_area(*body)
            off[name] = (volumes[name] - volume) / (TOLERANCE * area)
        worst = max(off, key=lambda name: abs(off[name]))
        self.assertLess(abs(off[worst]), 0.02, worst)
        self.assertLess(abs(sum(off.values()) / len(off)), 0.004)

    def test_flat_faces_stay_flat(self):
        """A turned octahedron: faces are divided, and each is a plane."""
        corners, triangles = octasphere(12)
        turned = [((2 * x + 2 * y + z) / 3, (-2 * x + y + 2 * z) / 3, (x - 2 * y + 2 * z) / 3) for x, y, z in corners]
        body = [tuple(150 + 120 * q for q in p) for p in turned], triangles
        self.assertAlmostEqual(self.meshed_bodies({"e": body}, 1, 40)["e"] / volume_and_area(*body)[0], 1, delta=1e-12)


if __name__ == "__main__":
    main()
