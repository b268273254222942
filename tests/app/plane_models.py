# SPDX-License-Identifier: GPL-3.0-or-later
"""Projects of plane surfaces in a box of 10 by 10 by 10, where every volume is known."""
from geomesh_program import ProgramTest, triangles_ts

BOX = "box: {min: [0, 0, 0], max: [10, 10, 10]}\n"


def strip(line, low=-1.0, high=11.0):
    """Points and triangles of a surface that strikes along y: the polyline of (x, z) swept from low to high."""
    points = [(x, y, z) for y in (low, high) for x, z in line]
    n = len(line)
    return points, [t for i in range(n - 1) for t in ((i, i + 1, n + i + 1), (i, n + i + 1, n + i))]


def sheets(*parts):
    """Several strips as one surface."""
    points, triangles = [], []
    for line in parts:
        more, others = strip(line)
        triangles += [tuple(v + len(points) for v in t) for t in others]
        points += more
    return points, triangles


class RulesTest(ProgramTest):
    def surface(self, name, *parts):
        self.write(name + ".ts", triangles_ts(name, *sheets(*parts)))

    def mesh(self, text, status=0):
        """Runs a project; gives its report and the volumes by region, checked."""
        self.project = self.write("model.yaml", "name: model\n" + BOX + text + "output: {directory: out}\n")
        printed = self.run_program(self.project, status=status)
        if status:
            self.assert_nothing_written()
            return printed
        report = self.report(self.path("out", "model.report.json"))
        check = self.check(self.path("out", "model.vtu"), "--project", self.project)
        return report, {region["name"]: region["volume"] for region in check["regions"]}

    def assert_volumes(self, found, wanted):
        self.assertEqual(sorted(found), sorted(wanted))
        for name, volume in wanted.items():
            self.assertAlmostEqual(found[name], volume, delta=1e-8, msg=name)

    def told(self, report, key, *words):
        self.assertTrue(any(all(word in text for word in words) for text in report[key]), (words, report[key]))


def patch(x_range, y_range, height, step=0.5):
    """A lattice over a rectangle of the map, with heights by y alone."""
    nx, ny = round((x_range[1] - x_range[0]) / step), round((y_range[1] - y_range[0]) / step)
    points = [(x_range[0] + (x_range[1] - x_range[0]) * i / nx, y_range[0] + step * j, height(y_range[0] + step * j))
              for j in range(ny + 1) for i in range(nx + 1)]
    corners = [(j * (nx + 1) + i, j * (nx + 1) + i + 1) for j in range(ny) for i in range(nx)]
    return points, [t for a, b in corners for t in ((a, b, b + nx + 1), (a, b + nx + 1, a + nx + 1))]
