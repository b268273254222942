# SPDX-License-Identifier: GPL-3.0-or-later
"""Outlines of open surfaces that are remeshed: each surface keeps its area, since no chord of its outline has a preferred side.

200 ellipses of 48 corners, turned at random and apart from each other, in one model: the area of each differs from that of its input by at
most a tenth of the tolerance times its perimeter, and the mean of the differences is a fifth of that at most.
"""
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


if __name__ == "__main__":
    main()
