# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that touch, cross or miss each other by about an ulp, at coordinates of a map grid: each model is meshed and passes the checker.

    GEOMESH_THIN_CONTACTS=200 ctest ... -R app.thin_contacts     another number of each kind

Seed 0 of the horizons that end on a fault needs all doubles of a star (docs/theory.md, "What recovery guarantees", step 6).
"""
import math
import os
import random

from geomesh_program import NIGHTLY, ProgramTest, main, triangles_ts

COUNT = int(os.environ.get("GEOMESH_THIN_CONTACTS", "100" if NIGHTLY else "4"))
EAST, NORTH = 432000.0, 6512000.0
DEPTH = -1500.0


def sheet(dice, n, height):
    """A grid of n by n points over the box and beyond, with uneven spacing."""
    xs, ys = (sorted([-200, 1200] + [dice.uniform(-200, 1200) for _ in range(n - 2)]) for _ in "xy")
    return [(EAST + x, NORTH + y, height(x, y)) for y in ys for x in xs], triangles_of_grid(dice, n, n)


def triangles_of_grid(dice, n, m):
    """Of m rows of n points; each cell is cut along one diagonal or the other."""
    corners = ((a, a + 1, a + n + 1, a + n) for j in range(m - 1) for a in range(j * n, j * n + n - 1))
    return [t for a, b, c, d in corners for t in (((a, b, c), (a, c, d)) if dice.random() < 0.5 else ((a, b, d), (b, c, d)))]


class Fault:
    """A plane through the middle of the box."""

    def __init__(self, dice):
        azimuth, self.dip = dice.uniform(0, 2 * math.pi), dice.uniform(0.5, 1.4)
        self.c, self.s = math.cos(azimuth), math.sin(azimuth)
        self.normal = (self.c * math.sin(self.dip), self.s * math.sin(self.dip), -math.cos(self.dip))

    def at(self, along, z, across=0):
        """On the plane but for rounding; or so far before it."""
        w = (z - DEPTH) / math.tan(self.dip) + across
        return (EAST + 500 - self.s * along + self.c * w, NORTH + 500 + self.c * along + self.s * w, z)

    def surface(self, dice):
        alongs, heights = (sorted([low, high] + [dice.uniform(low, high) for _ in range(3)]) for low, high in ((-1200, 1200), (-2600, -400)))
        return [self.at(u, z) for z in heights for u in alongs], triangles_of_grid(dice, 5, 5)


def crossing(dice):
    """Two plane horizons that cross at 1e-9 to 1e-3 rad, and a fault."""
    angle, slope = 10 ** dice.uniform(-9, -3), dice.uniform(-0.3, 0.3)
    return [("h1", "horizon", *sheet(dice, 5, lambda x, y: DEPTH + slope * x)),
            ("h2", "horizon", *sheet(dice, 4, lambda x, y: DEPTH + slope * x + angle * (y - 500))), ("f1", "fault", *Fault(dice).surface(dice))]


def twins(dice):
    """A horizon, the same some 1e-9 m above, and a fault."""
    points, triangles = sheet(dice, 5, lambda x, y: DEPTH + 0.2 * x + 0.1 * y)
    above = 10 ** dice.uniform(-9, -7)
    return [("h1", "horizon", [(x, y, z + above) for x, y, z in points], triangles), ("h2", "horizon", points, triangles),
            ("f1", "fault", *Fault(dice).surface(dice))]


def kissing(dice):
    """A salt body whose pole is less than 1e-8 m before or behind a fault."""
    fault, radius, n = Fault(dice), 150, 10
    along = (-fault.s, fault.c, 0)
    up = tuple(fault.normal[i - 2] * along[i - 1] - fault.normal[i - 1] * along[i - 2] for i in range(3))
    gap = dice.choice((-1, 0, 1)) * 10 ** dice.uniform(-12, -8)

    def on_body(k, j):
        ring, around = math.pi * k / 6, 2 * math.pi * j / n
        way = [-math.cos(ring) * fault.normal[i] + math.sin(ring) * (math.cos(around) * along[i] + math.sin(around) * up[i]) for i in range(3)]
        return tuple(middle + (radius + gap) * fault.normal[i] + radius * way[i] for i, middle in enumerate((EAST + 500, NORTH + 500, DEPTH)))

    points = [on_body(0, 0), on_body(6, 0)] + [on_body(k, j) for k in range(1, 6) for j in range(n)]
    row = lambda k, j: 2 + (k - 1) * n + j % n  # noqa: E731
    triangles = [t for j in range(n) for t in ((0, row(1, j), row(1, j + 1)), (1, row(5, j + 1), row(5, j)))]
    for k in range(1, 5):
        triangles += [t for j in range(n) for t in ((row(k, j), row(k + 1, j), row(k + 1, j + 1)), (row(k, j), row(k + 1, j + 1), row(k, j + 1)))]
    return [("h1", "horizon", *sheet(dice, 5, lambda x, y: DEPTH + dice.uniform(-20, 20))), ("h2", "horizon", *sheet(dice, 4, lambda x, y: DEPTH - 300)),
            ("f1", "fault", *fault.surface(dice)), ("salt", "body", points, triangles)]


def ending(dice):
    """Horizons with throw, which end on a fault but for rounding."""
    fault, surfaces, n = Fault(dice), [], 7
    alongs = sorted([-1200, 1200] + [dice.uniform(-1100, 1100) for _ in range(n - 2)])
    for name, z in (("h1", -1300), ("h2", -1600)):
        points, triangles = [], []
        for side in (-1, 1):
            first, throw = len(points), dice.uniform(-60, 60)
            ends = [z + throw + 0.05 * u + dice.uniform(-15, 15) for u in alongs]
            for k in range(4):
                points += [fault.at(u, end, side * 400 * k)[:2] + (end + (dice.uniform(-15, 15) if k else 0),) for u, end in zip(alongs, ends)]
            triangles += [tuple(first + v for v in t) for t in triangles_of_grid(dice, n, 4)]
        surfaces.append((name, "horizon", points, triangles))
    return surfaces + [("f1", "fault", *fault.surface(dice))]


class ThinContacts(ProgramTest):
    def mesh_and_check(self, make):
        for seed in range(COUNT):
            with self.subTest(seed=seed):
                surfaces = make(random.Random(seed))
                for name, _, points, triangles in surfaces:
                    self.write(name + ".ts", triangles_ts(name, points, triangles))
                listed = "\n".join("  - {name: %s, kind: %s, file: %s.ts}" % (name, kind, name) for name, kind, _, _ in surfaces)
                project = self.write("project.yaml", """
name: m
box: {min: [%r, %r, -2500], max: [%r, %r, -500]}
surfaces:
%s
column: [u1, h1, u2, h2, u3]
output: {directory: out, formats: [vtu]}
""" % (EAST, NORTH, EAST + 1000, NORTH + 1000, listed))
                self.run_program(project)
                self.check(self.path("out", "m.vtu"), "--project", project)

    def test_horizons_that_cross_at_tiny_angles(self):
        self.mesh_and_check(crossing)

    def test_twins_a_billionth_of_a_metre_apart(self):
        self.mesh_and_check(twins)

    def test_salt_that_kisses_a_fault(self):
        self.mesh_and_check(kissing)

    def test_horizons_that_end_on_a_fault_but_for_rounding(self):
        self.mesh_and_check(ending)


if __name__ == "__main__":
    main()
