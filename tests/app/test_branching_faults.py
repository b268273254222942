# SPDX-License-Identifier: GPL-3.0-or-later
"""Networks of faults as they are delivered: branches that end within centimetres of another fault, on either side of it or short of it, in
patches that share no points and lie on each other along their seams. By default each makes a mesh that is fit for solvers.

    GEOMESH_BRANCHING_FAULTS=100 ctest ... -R app.branching_faults     another number of them
"""
import math
import os
import random

from geomesh_program import NIGHTLY, ProgramTest, main, triangles_ts

COUNT = int(os.environ.get("GEOMESH_BRANCHING_FAULTS", "60" if NIGHTLY else "6"))
EAST, NORTH = 560000.0, 3810000.0
LENGTH, TOP, BOTTOM = 4000.0, 300.0, -3500.0


class Trunk:
    """A fault from side to side of the box, waved and inclined, in straight pieces."""

    def __init__(self, dice):
        self.dip = dice.uniform(-0.4, 0.4)
        self.wave, self.turn = dice.uniform(0, 250), dice.uniform(0, 2 * math.pi)
        self.alongs = [LENGTH * k / 9 - 200 for k in range(11)]
        self.heights = [TOP + (BOTTOM - TOP) * k / 4 for k in range(5)]

    def across(self, along):
        return LENGTH / 2 + self.wave * math.sin(self.turn + along / 900)

    def at(self, along, z, off=0.0):
        """On the straight pieces, or off them."""
        k = min(max(0, sum(a <= along for a in self.alongs) - 1), len(self.alongs) - 2)
        low, high = self.alongs[k], self.alongs[k + 1]
        t = (along - low) / (high - low)
        return (EAST + along, NORTH + (1 - t) * self.across(low) + t * self.across(high) + self.dip * z + off, z)

    def surface(self):
        n = len(self.alongs)
        points = [self.at(a, z) for z in self.heights for a in self.alongs]
        return points, grid_triangles(n, len(self.heights))


def grid_triangles(n, m, first=0):
    corners = ((a, a + 1, a + n + 1, a + n) for j in range(m - 1) for a in range(first + j * n, first + j * n + n - 1))
    return [t for a, b, c, d in corners for t in ((a, b, c), (a, c, d))]


def branch(dice, trunk, side):
    """From the trunk outwards; its first column lies on the trunk but for `noise`, or short of it."""
    start, angle = dice.uniform(600, LENGTH - 900), dice.uniform(0.3, 1.3)
    noise, short = 10 ** dice.uniform(-3, 0), dice.choice([0, 0, 10 ** dice.uniform(-2, 0)])
    heights = sorted({TOP, BOTTOM, *(dice.uniform(BOTTOM, TOP) for _ in range(4))})
    reach = dice.uniform(500, 1200)
    points, triangles = [], []

    def patch(low, high):
        first = len(points)
        for z in heights[low:high + 1]:
            off = side * short + dice.uniform(-noise, noise)
            x, y, _ = trunk.at(start, z, off)
            points.extend([(x, y, z), *((x + reach * t * math.cos(angle), y + side * reach * t * math.sin(angle), z) for t in (0.4, 1))])
        triangles.extend(grid_triangles(3, high - low + 1, first))

    cut = dice.randint(1, len(heights) - 2)
    if dice.random() < 0.5:
        patch(0, cut)
        patch(cut, len(heights) - 1)  # shares no points with the one below, and its own noise
    else:
        patch(0, len(heights) - 1)
    return points, triangles


class BranchingFaults(ProgramTest):
    def write_network(self, seed):
        dice = random.Random(seed)
        trunk = Trunk(dice)
        surfaces = [("trunk", *trunk.surface())] + [(f"branch_{k}", *branch(dice, trunk, dice.choice([-1, 1]))) for k in range(dice.randint(1, 4))]
        lines = []
        for name, points, triangles in surfaces:
            self.write(f"{name}.ts", triangles_ts(name, points, triangles))
            lines.append(f"  - {{name: {name}, kind: fault, file: {name}.ts}}\n")
        box = f"box: {{min: [{EAST}, {NORTH}, -3000], max: [{EAST + LENGTH}, {NORTH + LENGTH}, 0]}}\n"
        return self.write("project.yaml", f"name: network\nsurfaces:\n{''.join(lines)}{box}mesh: {{size: 400}}\noutput: {{directory: out, formats: [vtu]}}\n")

    def test_networks_are_fit_for_solvers_by_default(self):
        for seed in range(COUNT):
            with self.subTest(seed=seed):
                project = self.write_network(seed)
                self.run_program(project)
                mesh = self.path("out", "network.vtu")
                verdict = self.report(mesh.replace(".vtu", ".report.json"))["solver"]
                self.assertTrue(verdict["passes"], verdict)
                self.check(mesh, "--project", project)


if __name__ == "__main__":
    main()
