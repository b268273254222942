# SPDX-License-Identifier: GPL-3.0-or-later
"""Horizons that cross or seem to cross, small enough to know the volume of each unit: what `on_crossing` removes of them, and what the check
requires."""
from geomesh_program import ProgramTest, main, triangles_ts


class ClippedHorizons(ProgramTest):
    def crossing_horizons(self, top, rule, fault=True):
        """A project of h1.ts over h2.ts, and of f.ts, in the box from zero to `top`."""
        with_fault = ", {name: f, kind: fault, file: f.ts}" if fault else ""
        return self.write("project.yaml", f"""name: m
box: {{min: [0, 0, 0], max: {top}}}
surfaces: [{{name: h1, kind: horizon, file: h1.ts}}, {{name: h2, kind: horizon, file: h2.ts}}{with_fault}]
column: [u1, h1, u2, h2, u3]
rules: {{stack: keep, on_crossing: {rule}}}
mesh: {{mode: constrained, refine: none}}
output: {{directory: out, formats: [vtu]}}
""")

    def test_a_horizon_thrown_to_the_height_of_the_next_is_not_clipped_as_if_it_crossed(self):
        """The far block of h2 goes on where the near block of h1 ends, and rises. It crosses nothing."""
        def blocks(near, far):
            points = [(x, y, z) for x, z in ((-10, near), (100, near), (100, far), (210, far + 11)) for y in (-10, 110)]
            return points, [(0, 2, 3), (0, 3, 1), (4, 6, 7), (4, 7, 5)]
        for name, near, far in (("h1", 60, 90), ("h2", 30, 60)):
            self.write(name + ".ts", triangles_ts(name, *blocks(near, far)))
        self.write("f.ts", triangles_ts("f", [(100, -10, -10), (100, 110, -10), (100, 110, 160), (100, -10, 160)], [(0, 1, 2), (0, 2, 3)]))
        for rule in ("clip_older", "clip_younger", "error"):
            project = self.crossing_horizons([200, 100, 150], rule)
            self.run_program(project)
            self.check(self.path("out", "m.vtu"), "--project", project)
            volumes = {r["name"]: r["volume"] for r in self.report(self.path("out", "m.report.json"))["regions"]}
            unit = {u: sum(v for name, v in volumes.items() if name.split("__")[0] == u) for u in ("u1", "u2", "u3")}
            self.assertAlmostEqual(unit["u2"], 2 * 100 * 100 * 30, delta=1)
            self.assertAlmostEqual(unit["u3"], 100 * 100 * 30 + 100 * 100 * 65, delta=1)

    def test_a_horizon_that_meets_another_beyond_its_end_is_clipped_by_its_area(self):
        """Half of a horizon was lost: it ran through the gap between two blocks of the older one, and met the far one from below."""
        strips = [(x, y, z) for x, z in ((-10, 90), (95.5, 90), (104.5, 10), (210, 60)) for y in (-10, 110)]
        self.write("h1.ts", triangles_ts("h1", strips, [t for k in (0, 2, 4) for t in ((k, k + 2, k + 3), (k, k + 3, k + 1))]))
        blocks = [(x, y, z) for x, z in ((-10, 60), (95, 60), (105, 30), (210, 30)) for y in (-10, 110)]
        self.write("h2.ts", triangles_ts("h2", blocks, [(0, 2, 3), (0, 3, 1), (4, 6, 7), (4, 7, 5)]))
        leaning = [(95 + (60 - z) / 3, y, z) for y, z in ((-10, -10), (110, -10), (110, 160), (-10, 160))]
        self.write("f.ts", triangles_ts("f", leaning, [(0, 1, 2), (0, 2, 3)]))
        for rule in ("clip_younger", "error"):
            project = self.crossing_horizons([200, 100, 150], rule)
            self.run_program(project)
            self.check(self.path("out", "m.vtu"), "--project", project)
            between = [r["volume"] for r in self.report(self.path("out", "m.report.json"))["regions"] if r["name"].split("__")[0] == "u2"]
            self.assertGreater(max(between), 80 * 100 * 30)

    def test_a_horizon_over_another_across_a_reverse_fault_is_not_above_it(self):
        """Most of the upper block of h2 was lost: it lies over the lower block of h1, and its own h1 is above the volume."""
        def strip(*line, first=0):
            points = [(x, y, z) for x, z in line for y in (-10, 110)]
            ends = range(first, first + 2 * len(line) - 2, 2)
            return points, [t for k in ends for t in ((k, k + 2, k + 3), (k, k + 3, k + 1))]
        for name, near, far in (("h1", 40, ((70, 120), (170, 120), (180, 80), (190, 120), (310, 120))), ("h2", 20, ((100, 90), (320, 90)))):
            points, triangles = strip((-10, near), (190 - near, near))
            more_points, more_triangles = strip(*far, first=4)
            self.write(name + ".ts", triangles_ts(name, points + more_points, triangles + more_triangles))
        leaning = [(190 - z, y, z) for y, z in ((-10, -10), (110, -10), (110, 130), (-10, 130))]
        self.write("f.ts", triangles_ts("f", leaning, [(0, 1, 2), (0, 2, 3)]))
        for rule in ("clip_younger", "clip_older"):
            project = self.crossing_horizons([300, 100, 110], rule)
            self.run_program(project)
            self.check(self.path("out", "m.vtu"), "--project", project)
            volumes = [r["volume"] for r in self.report(self.path("out", "m.report.json"))["regions"] if r["name"].split("__")[0] == "u2"]
            self.assertEqual(len(volumes), 3)  # the lower block, and the upper one on both sides of the dip
        # A mesh without most of the upper block of h2, as it was made before. Only what is above h1 may be away.
        points, triangles = strip((-10, 20), (170, 20))
        more_points, more_triangles = strip((177.5, 90), (320, 90), first=4)
        self.write("short.ts", triangles_ts("h2", points + more_points, triangles + more_triangles))
        with open(project, encoding="utf-8") as file:
            short = self.write("short.yaml", file.read().replace("file: h2.ts", "file: short.ts"))
        self.run_program(short, "-o", self.path("short"))
        self.assertIn("uncovered_triangles", self.run_program("check", self.path("short", "m.vtu"), "--project", project, status=None))

    def test_a_piece_that_a_rule_removes_is_checked_as_a_whole(self):
        """h1 dives below h2, and rises again where h2 has ended. clip_younger removes all of h1 beyond the edge where both meet."""
        def strip(name, *line):
            points = [(x, y, z) for x, z in line for y in (-10, 110)]
            ends = range(0, 2 * len(line) - 2, 2)
            self.write(name + ".ts", triangles_ts(name, points, [t for k in ends for t in ((k, k + 2, k + 3), (k, k + 3, k + 1))]))
        strip("h2", (-10, 30), (100, 30))
        project = self.crossing_horizons([140, 100, 150], "clip_younger", fault=False)
        for end in ((100, 10), (110, 40), (150, 40)), ((30, 50 - 40 / 110 * 40),):  # the second is short of the edge where they meet
            strip("h1", (-10, 50), *end)
            self.run_program(project)
            self.check(self.path("out", "m.vtu"), "--project", project)
        strip("h1", (-10, 50), (100, 10), (110, 40), (150, 40))
        self.assertIn("uncovered_triangles", self.run_program("check", self.path("out", "m.vtu"), "--project", project, status=None))


if __name__ == "__main__":
    main()
