# SPDX-License-Identifier: GPL-3.0-or-later
"""Random whole models (tests/fuzz/random_models.py) meshed and judged: six in every run of the tests, more by night.

    GEOMESH_RANDOM_MODELS=1000 GEOMESH_RANDOM_SEED=5000 ctest ... -R app.random_models     another number, other seeds
"""
import os
import re
import shutil
import sys

from geomesh_program import CANNOT_MESH, NIGHTLY, PROGRAM, SOURCE, ProgramTest, main, triangles_ts

sys.path.insert(0, os.path.join(SOURCE, "tests", "fuzz"))
from random_models import RandomModel  # noqa: E402
from run_random_models import outcome_of, run  # noqa: E402

COUNT = int(os.environ.get("GEOMESH_RANDOM_MODELS", "100" if NIGHTLY else "6"))
FIRST = int(os.environ.get("GEOMESH_RANDOM_SEED", "1"))


def sheet_of_two_blocks(gap):
    """The sheet of tests/corpus/cracked_sheet, the second block above the first by `gap` where they meet."""
    points, triangles = [], []
    for rows in ((0, 1, 2), (2, 3, 4)):
        first = len(points)
        points += [(6e6 + 100 * i, 6e6 + 100 * j, -500 + 20 * ((7 * i + 3 * j) % 5) + (gap if first and j == 2 else 0)) for j in rows for i in range(5)]
        for a in (first + 5 * j + i for j in range(2) for i in range(4)):
            triangles += [(a, a + 1, a + 6), (a, a + 6, a + 5)]
    return triangles_ts("h1", points, triangles)


class RandomModels(ProgramTest):
    def assert_pass(self, *seeds, limit=60, light=False):
        """Each model is meshed within so many seconds of CPU, and the judge finds nothing."""
        for seed in seeds:
            with self.subTest(seed=seed):
                self.assertEqual(outcome_of(seed, self.path(str(seed)), PROGRAM, limit, light=light), ("passes", ""))

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

    def assert_within_estimate(self, seed, limit):
        """A light model passes, and no more elements come than the estimate allows, which is right within 30 %."""
        self.assert_pass(seed, limit=limit, light=True)
        report = self.report(os.path.join(self.path(str(seed)), "out", "model.report.json"))
        self.assertLess(report["tetrahedra"], 1.3 * report["refinement"]["estimated_tetrahedra"])

    def test_random_whole_models_pass_the_judge_or_are_refused_with_a_reason(self):
        outcomes = {}
        for seed in range(FIRST, FIRST + COUNT):
            with self.subTest(seed=seed):
                outcome, why = outcome_of(seed, self.path(str(seed)), PROGRAM, 120)
                outcomes.setdefault(outcome, []).append(seed)
                self.assertIn(outcome, ("passes", "refused"), why)
        self.assertLess(len(outcomes.get("refused", [])), max(1, COUNT // 4), outcomes)

    def test_added_points_in_stars_thinner_than_an_ulp_find_doubles(self):
        self.assert_pass(20007, 20144, 100052, 100183, 100329, 200084, limit=120)

    def test_surfaces_that_cross_in_narrow_strips_share_no_edge_that_no_curve_lists(self):
        project = os.path.join(SOURCE, "tests", "corpus", "touching_strips", "project.yaml")
        self.run_program(project, "-o", self.folder)
        self.check(self.path("model.vtu"), "--project", project)

    def test_crossings_as_shallow_as_the_tolerance_are_judged_by_their_depth(self):
        """Overshoots (200068), grazed kinks (20201), small angles (200016), and surfaces that lie in one another (200149)."""
        self.assert_pass(20201, 200016, 200068, 200149, limit=120)

    def test_points_stay_on_strips_that_are_as_thin_as_rounding(self):
        """Strips beyond a fault, an ulp wide, have no plane that doubles can tell: points were put 36 m off them (100338), 3 m (200419)."""
        self.assert_pass(100338, 200419, limit=120)

    def test_long_edges_of_thin_strips_are_flipped_before_they_are_halved(self):
        """Halves of the edges across such a strip made a million cells for a model of 624 triangles (200092)."""
        self.assert_pass(200092)

    def test_slivers_as_thin_as_rounding_do_not_multiply(self):
        """Facets some units in the last place wide kept surfaces from being sampled. What points on their sides left was too flat:
        96,244 elements of 537,065, where 336,736 were asked for (200157), and 36,897 of 133,124 (700032)."""
        for seed in (200157, 700032):
            with self.subTest(seed=seed):
                folder = self.path("slivers%d" % seed)
                self.assertEqual(outcome_of(seed, folder, PROGRAM, 120), ("passes", ""))
                report = self.report(os.path.join(folder, "out", "model.report.json"))
                self.assertLess(report["tetrahedra"], 1.3 * report["refinement"]["estimated_tetrahedra"])
                self.assertLess(report["solver"]["fail_implicit"], 0.005 * report["tetrahedra"])

    def test_surfaces_that_were_given_twice_are_meshed_as_one_by_default(self):
        """Faults 0.3 to 2 mm apart asked for edges of a metre, or took minutes (500020, 500026, 500035)."""
        for seed in (500020, 500035):
            folder = self.path("twins%d" % seed)
            self.assertEqual(outcome_of(seed, folder, PROGRAM, 60, as_default=True), ("passes", ""))
            report = self.report(os.path.join(folder, "out", "model.report.json"))
            self.assertTrue(any("meshed as one where they do" in w for w in report["warnings"]), report["warnings"])
            self.assertLess(sum(r["tetrahedra"] for r in report["regions"]), 40000)

    def test_a_unit_of_a_coarse_stack_keeps_its_region_in_each_block(self):
        """A unit with 0.8 elements of volume in its block joined another unit without a word (200080)."""
        self.assert_pass(200080, limit=120)

    def test_faces_that_touch_a_body_within_rounding_are_not_inside_it(self):
        self.assert_pass(200202, limit=120)

    def test_a_needle_beside_a_salt_leaves_no_slit(self):
        """A vertex came to lie on the long edge of a needle. The salt's facet beside it did not follow, since its corners were on a line as seen."""
        self.assert_pass(1443053, light=True)

    def test_cracks_as_thin_as_rounding_are_judged_open_or_closed(self):
        """Found by seed 20100: a crack between two blocks, an ulp wide, is closed in part, and the judge took its open part for a fault."""
        project = os.path.join(SOURCE, "tests", "corpus", "cracked_sheet", "project.yaml")
        self.run_program(project, "-o", self.folder)
        report = self.check(self.path("model.vtu"), "--project", project)
        self.assertTrue(any(done.startswith("surfaces end where their input ends") for done in report["checks_done"]), report["checks_done"])
        # What ends where the input has neither border nor crack is a fault still.
        self.assertIn("borders_off", self.judged_against(project, sheet_of_two_blocks(0)))

    def judged_against(self, project, sheet):
        """What the check says of the mesh where the project's surface is another one."""
        os.makedirs(self.path("other"), exist_ok=True)
        self.write("other/h1.ts", sheet)
        shutil.copy(project, self.path("other", "project.yaml"))
        return self.run_program("check", self.path("model.vtu"), "--project", self.path("other", "project.yaml"), status=None)

    def test_borders_nearer_to_each_other_than_the_tolerance_may_be_joined(self):
        """Found by seed 20113: a throw of 1 m within a tolerance of 8 m, closed where a border meets the box."""
        with open(os.path.join(SOURCE, "tests", "corpus", "cracked_sheet", "project.yaml")) as file:
            project = self.write("project.yaml", file.read())
        self.write("h1.ts", sheet_of_two_blocks(0))
        self.run_program(project, "-o", self.folder)
        self.check(self.path("model.vtu"), "--project", project)
        self.assertNotIn("FAULT", self.judged_against(project, sheet_of_two_blocks(4)))
        self.assertIn("borders_off", self.judged_against(project, sheet_of_two_blocks(12)))

    def test_a_horizon_thrown_to_the_height_of_the_next_is_not_clipped_as_if_it_crossed(self):
        """Found by seed 20187: the far block of h2 goes on where the near block of h1 ends, and rises. It crosses nothing."""
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

    def test_a_horizon_that_meets_another_beyond_its_end_is_judged_by_its_area(self):
        """Found by seed 823132: half of a horizon went. It ran through the gap between two blocks of the older one, and met the far one from below."""
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
        """Found by seed 1300759: most of the upper block of h2 went. It lies over the lower block of h1, and its own h1 is above the volume."""
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

    def test_a_piece_that_a_rule_takes_is_judged_as_a_whole(self):
        """h1 dives below h2, and rises again where h2 has ended. clip_younger takes all of h1 beyond the edge where both meet (810236, 881594)."""
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

    def test_a_region_is_named_by_none_of_the_small_ones_that_joined_it(self):
        self.assert_pass(840117, light=True)

    def test_a_piece_that_reaches_further_than_trim_overshoot_in_its_middle_stays(self):
        self.assert_pass(820320, 825174, light=True)

    def test_needles_are_split_as_their_border_is_seen_or_stay_whole(self):
        """Facets that could not be split left slits beside neighbours that were (871136, 820502, 840171, 850554), and models refused (840347, 825556)."""
        self.assert_pass(871136, 820502, 840171, 850554, 840347, 825556, light=True)

    def test_all_doubles_of_stars_are_looked_through_within_an_attempt(self):
        """13,944 facets at coordinates of 12,000 km, where points have no double near their places (912956)."""
        project = RandomModel(912956, light=True).write(self.path("orders"))
        status, printed = run(PROGRAM, [project, "--stop-after", "recover", "--quiet", "--threads", "1"], 120)
        self.assertEqual(status, 0, printed)

    def test_strips_that_rounding_turned_over_tell_no_side(self):
        """Of a horizon between twin faults 1e-9 m apart, at coordinates of 12,000 km. They exchanged the names of what lies above and below (1005689)."""
        project = RandomModel(1005689, light=True).write(self.path("turned"))
        with open(project) as file:
            text = file.read()
        self.write("turned/project.yaml", re.sub("(?m)^mesh: .*", "mesh: {mode: constrained, refine: none}", text))
        self.run_program(project, "--quiet")
        self.check(self.path("turned", "out", "model.vtu"), "--project", project)

    def test_the_judge_leaves_small_parts_out(self):
        """A small part of u2 had joined u3, whose name was judged by the part's upper horizon."""
        self.assert_pass(1006825, light=True)

    def test_both_facets_of_a_triangle_that_rounding_made_one_are_sampled_otherwise(self):
        """Sampled surfaces got a triangle that two of them had. One was left whole, which changed nothing. Points put one by one made 2.6 times
        as many elements as were estimated (825080), or took more than two minutes (900345)."""
        self.assert_within_estimate(825080, 60)

    def test_facets_in_each_other_get_no_points_inside(self):
        """Points on two faults that lie in each other to rounding made these cross. Points put one by one took 136 CPU s, and made half as many
        elements again as were estimated (890362)."""
        self.assert_within_estimate(890362, 120)

    def test_facets_that_multiply_as_surfaces_are_brought_together_end_the_try(self):
        """They were split without end, for over 400 CPU s (825922). It is tried within half the distance then."""
        project = RandomModel(825922, light=True).write(self.path("multiply"))
        status, printed = run(PROGRAM, [project, "--preview", "--quiet", "--threads", "1"], 60)
        self.assertEqual(status, 0, printed)

    def test_edges_that_cross_in_one_plane_at_small_angles_are_joined(self):
        """Their crossing was off along them, by rounding, and they seemed to pass each other. A horizon and a fault that lie in each other were
        refused (901481, 930281), or kept pockets of an ulp (825922 took more than 107 CPU s)."""
        self.assert_pass(901481, 930281, light=True)
        self.assert_within_estimate(825922, 60)

    def test_a_point_beside_a_facet_that_was_added_on_it_is_told_as_inside(self):
        """Two faults 0.5 mm apart in conforming mode (821076)."""
        self.assert_pass(821076, light=True)

    def test_a_refusal_names_surfaces_and_the_way_out(self):
        """Slits that are too thin in either way; that points may be added on surfaces is said where they may not."""
        model = os.path.join(SOURCE, "tests", "corpus", "thin_slits", "thin_slits.off")
        for option, hint in (((), self.assertNotIn), (("--preserve-boundary",), self.assertIn)):
            printed = self.run_program("mesh", model, "-o", self.path("slits.vtu"), *option, status=CANNOT_MESH)
            self.assertIn("leave all cells positive", printed)
            self.assertIn("(surfaces: thin_slits)", printed)
            hint("without preserve_boundary", printed)

    def test_surfaces_that_lie_in_each_other_are_brought_together_as_wholes(self):
        """Blocks and continuations in the plane of a fault, to rounding. Between them were pockets of an ulp: no doubles for what had to be added
        (20007, 20144, 100183, 200084), cracks (100215, 200029), units that ran into one another through gaps of an ulp (20007, 20071; there a fault reaches a horizon above it)."""
        for seed, n_regions in ((20007, 8), (20144, 10), (100183, 10), (200084, 13), (100215, 11), (200029, 6), (20071, 14)):
            with self.subTest(seed=seed):
                folder = self.path("joined%d" % seed)
                self.assertEqual(outcome_of(seed, folder, PROGRAM, 120), ("passes", ""))
                regions = self.report(os.path.join(folder, "out", "model.report.json"))["regions"]
                self.assertEqual(len(regions), n_regions)
                self.assertGreater(min(r["volume"] for r in regions), 1)


if __name__ == "__main__":
    main()
