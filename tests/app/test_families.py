# SPDX-License-Identifier: GPL-3.0-or-later
"""Models of the families whose unit is known at each place, as a new user gives them: at most one point in a thousand lies in the wrong unit.
tests/families/measure.py runs more of them."""
import json
import os
import sys

from geomesh_program import BAD_INPUT, NIGHTLY, PROGRAM, SOURCE, ProgramTest, main

sys.path.insert(0, os.path.join(SOURCE, "tests", "families"))
from families import FAMILIES  # noqa: E402
from measure import run  # noqa: E402

SEEDS = range(4) if NIGHTLY else range(1, 2)


class Families(ProgramTest):
    def assert_right(self, family, seeds=SEEDS, form="bare"):
        for seed in seeds:
            with self.subTest(family=family, seed=seed):
                folder = self.path("%s%d" % (family, seed))
                self.assertIn(" ok ", run(PROGRAM, family, seed, form, keep=folder))
                self.check(os.path.join(folder, "out", "model.vtu"), "--project", os.path.join(folder, "project.yaml"))

    def test_grids_that_end_before_the_sides_of_the_model(self):
        self.assert_right("short_grids")

    def test_salt_with_horizons_that_end_before_it(self):
        self.assert_right("salt_gaps")

    def test_thrusts_that_repeat_horizons(self):
        self.assert_right("thrust")

    def test_horizons_that_end_on_a_thrust_or_salt_at_a_low_angle(self):
        """Some metres from the thrust or salt, but hundreds of metres before it along themselves, horizons ended in the open."""
        self.assert_right("ramp_thrust", (4,))
        self.assert_right("salt_sheet", (5,))

    def test_faults_that_cross_and_meet_each_other(self):
        """Sheets of two blocks lie at one height in the second one: beyond the fault between them they were merged, which left a hole."""
        self.assert_right("conjugate")
        self.assert_right("conjugate", (5,))

    def test_faults_that_end_on_another_one_in_teeth(self):
        """Teeth that lie beyond the other fault left stubs and slits; in the first model teeth were taken for an upper border that a horizon truncates."""
        self.assert_right("conjugate", (3, 8, 21))

    def test_networks_of_faults_that_end_on_each_other_with_misfits(self):
        """In the second one horizons ended at a piece of a fault that was cut off later."""
        self.assert_right("network")
        self.assert_right("network", (0,))

    def test_networks_with_throw_are_as_quick(self):
        """Blocks that were continued each across all others had no mesh in 110 CPU s."""
        self.assert_right("network", (10,), "careful")

    def test_faulted_blocks_under_an_unconformity(self):
        """Faults end at it in teeth. In the second model a horizon is eroded in one block, which the region below the unconformity must tell."""
        for form in ("bare", "careful"):
            self.assert_right("unconformity", (2, 3), form)

    def test_a_fault_that_dies_out(self):
        """The last one is reverse: its sides overlap in the map, and the strip that is missing beyond its tip joins both."""
        self.assert_right("dying_fault")
        self.assert_right("dying_fault", (2,))

    def test_grids_with_noise_and_undefined_strips_along_faults(self):
        self.assert_right("noisy_grid", (4,))
        self.assert_right("noisy_grid", (4,), "careful")

    def test_noise_is_not_continued(self):
        """The slopes of single triangles at the border were, and the mesh had 195,000 elements."""
        self.assert_right("noisy_grid", (0,), "careful")
        self.assertLess(self.report(self.path("noisy_grid0", "out", "model.report.json"))["tetrahedra"], 60000)

    def test_noisy_grids_that_cross_and_stop_short_of_faults(self):
        """The stack was left as given, and there was no mesh in 100 CPU s."""
        self.assert_right("noisy_grid", (3,))

    def test_growth_faults_on_two_listric_faults(self):
        self.assert_right("growth_fault", (1,))
        self.assert_right("growth_fault", (1,), "careful")

    def test_growth_faults_that_die_out(self):
        """In the second model a triangle beside the tip belonged to no block: 63 % of the points lay in joined units."""
        self.assert_right("growth_fault", (4, 32), "careful")

    def test_picks_of_a_few_wells(self):
        """In all but the first there are faults: one plate over their blocks was a ramp at the fault."""
        self.assert_right("sparse_picks", (0, 1, 5, 22))

    def test_lenses_between_horizons_that_cross_and_as_a_body(self):
        self.assert_right("lens", (1, 2), "careful")

    def test_holes(self):
        """In the second model a high of the lowest horizon pierces two others."""
        self.assert_right("holes", (1, 5))
        self.assert_right("fault_holes", (4,))

    def test_a_channel_whose_base_is_given_over_the_whole_map(self):
        self.assert_right("channel", (1,), "careful")

    def test_horizons_that_stop_before_the_base_of_a_channel(self):
        """Settled up to the base as it was given, they no longer met it: 23 % of the points lay in joined units."""
        self.assert_right("channel", (3,), "careful")
        self.assert_right("channel", (10,))

    def test_the_base_of_a_channel_whose_border_weaves_through_the_horizon_above(self):
        self.assert_right("channel", (22,))

    def test_corners_of_a_grid_that_lie_in_the_salt(self):
        """A border edge between such a corner and one outside was looked at in its middle alone, which lies in the salt."""
        self.assert_right("salt_gaps", (21,))

    def test_the_checker_finds_units_that_are_joined_through_gaps(self):
        """Meshes of the same surfaces with their borders open, against the projects that close them."""
        for family, seed in (("short_grids", 2), ("salt_gaps", 2), ("thrust", 2)):
            with self.subTest(family=family):
                folder = self.path("open_" + family)
                os.makedirs(folder)
                project = FAMILIES[family](seed).write(folder, "bare")
                with open(project) as file:
                    text = file.read()
                self.assertNotIn("rules:", text)
                with open(os.path.join(folder, "open.yaml"), "w") as file:
                    file.write(text + "rules: {continue_within: 0}\n")
                self.run_program(os.path.join(folder, "open.yaml"), "--quiet")
                self.check(os.path.join(folder, "out", "model.vtu"), "--project", os.path.join(folder, "open.yaml"))
                with open(os.path.join(folder, "out", "model.report.json")) as file:
                    report = json.load(file)
                self.assertTrue(any(entry["joins_units"] for entry in report["open_borders"]), report["open_borders"])
                told = self.check(os.path.join(folder, "out", "model.vtu"), "--project", project, status=None)
                self.assertNotIn("units_joined_by_gap", [fault["id"] for fault in told["faults"]])
                self.assertTrue(any("of which the run warned" in text for text in told["checks_done"]), told["checks_done"])
                os.remove(os.path.join(folder, "out", "model.report.json"))
                found = self.check(os.path.join(folder, "out", "model.vtu"), "--project", project, status=BAD_INPUT)
                self.assertIn("units_joined_by_gap", [fault["id"] for fault in found["faults"]])

    def test_a_dyke_cut_by_a_later_fault(self):
        self.assert_right("intrusion", (1, 2, 40))


if __name__ == "__main__":
    main()
