# SPDX-License-Identifier: GPL-3.0-or-later
"""Horizons that cross at 0.1 to 2 degrees, with noise of their own, on grids that share no points. No element of a good shape fits between them
where they cross. By default each makes a mesh that is fit for solvers.

    GEOMESH_SHALLOW_CROSSINGS=100 ctest ... -R app.shallow_crossings     another number of them
"""
import math
import os
import random

from geomesh_program import NIGHTLY, ProgramTest, main, triangles_ts

COUNT = int(os.environ.get("GEOMESH_SHALLOW_CROSSINGS", "40" if NIGHTLY else "5"))
EAST, NORTH = 520000.0, 7490000.0
LENGTH, DEPTH, SIZE = 6000.0, 2000.0, 400.0


class Field:
    """Smooth noise: a few waves of different lengths and directions."""

    def __init__(self, dice, amplitude):
        self.waves = [(amplitude * dice.uniform(0.2, 1), dice.uniform(0, 2 * math.pi), 2 * math.pi / dice.uniform(500, 4000), dice.uniform(0, 6))
                      for _ in range(5)]

    def at(self, x, y):
        return sum(a * math.sin(k * (x * math.cos(t) + y * math.sin(t)) + p) for a, t, k, p in self.waves)


def horizon(dice, slope, towards, level):
    """A grid turned at random, an inclined plane with noise."""
    turn, spacing = dice.uniform(0, 1.5), dice.uniform(60, 500)
    waves, rough = Field(dice, 10 ** dice.uniform(-1, 0.8)), dice.choice([0, 10 ** dice.uniform(-3, 0)])
    n = int(1.6 * LENGTH / spacing) + 2
    points = []
    for j in range(n):
        for i in range(n):
            u, v = (i - n / 2) * spacing, (j - n / 2) * spacing
            x, y = u * math.cos(turn) - v * math.sin(turn), u * math.sin(turn) + v * math.cos(turn)
            z = level + slope * (x * math.cos(towards) + y * math.sin(towards)) + waves.at(x, y) + dice.uniform(-rough, rough)
            points.append((EAST + LENGTH / 2 + x, NORTH + LENGTH / 2 + y, z))
    squares = ((a, a + 1, a + n + 1, a + n) for j in range(n - 1) for a in range(j * n, j * n + n - 1))
    return points, [t for a, b, c, d in squares for t in ((a, b, c), (a, c, d))]


class ShallowCrossings(ProgramTest):
    def write_model(self, seed):
        dice = random.Random(seed)
        angle, dip, towards = math.radians(10 ** dice.uniform(-1, 0.3)), dice.uniform(-0.1, 0.1), dice.uniform(0, 6)
        surfaces = [("base", *horizon(dice, dip, towards, 0)), ("top", *horizon(dice, dip + math.tan(angle), towards, 0))]
        if dice.random() < 0.4:
            surfaces.append(("third", *horizon(dice, dip - math.tan(angle), towards + dice.uniform(-1, 1), dice.uniform(-20, 20))))
        lines = []
        for name, points, triangles in surfaces:
            self.write(f"{name}.ts", triangles_ts(name, points, triangles))
            lines.append(f"  - {{name: {name}, kind: horizon, file: {name}.ts}}\n")
        box = f"box: {{min: [{EAST}, {NORTH}, {-DEPTH / 2}], max: [{EAST + LENGTH}, {NORTH + LENGTH}, {DEPTH / 2}]}}\n"
        return self.write("project.yaml",
                          f"name: crossing\nsurfaces:\n{''.join(lines)}{box}mesh: {{size: {SIZE}}}\noutput: {{directory: out, formats: [vtu]}}\n")

    def test_shallow_crossings_are_fit_for_solvers_by_default(self):
        for seed in range(COUNT):
            with self.subTest(seed=seed):
                project = self.write_model(seed)
                self.run_program(project)
                mesh = self.path("out", "crossing.vtu")
                verdict = self.report(mesh.replace(".vtu", ".report.json"))["solver"]
                self.assertTrue(verdict["passes"], verdict)
                self.check(mesh, "--project", project)


if __name__ == "__main__":
    main()
