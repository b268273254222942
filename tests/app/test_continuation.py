# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that stop a little short of what bounds them are continued to it without being asked. Every volume is known. In a box of 10 by 10
by 10 the distance is a twentieth of its side, 0.5."""
import os
import re
import sys

from geomesh_program import SOURCE, main, triangles_ts
from plane_models import RulesTest, patch, sheets

sys.path[:0] = [os.path.join(SOURCE, "tests", "families")]

HORIZON = "surfaces:\n  - {name: h, kind: horizon, file: h.ts%s}\n"
COLUMN = "column: [upper, h, lower]\n"


def joined(*parts):
    points, triangles = [], []
    for more, others in parts:
        triangles += [tuple(v + len(points) for v in t) for t in others]
        points += more
    return points, triangles


def level(z):
    return lambda y: z


class Continuation(RulesTest):
    def mesh(self, text, status=0):
        """As in RulesTest, with volumes by unit: faults part units into regions `UNIT__1`, `UNIT__2`."""
        report, found = super().mesh(text, status)
        volumes = {}
        for name, volume in found.items():
            unit = re.sub(r"__\d+$", "", name)
            volumes[unit] = volumes.get(unit, 0) + volume
        return report, volumes

    def given(self, name, *parts):
        self.write(name + ".ts", triangles_ts(name, *joined(*parts)))

    def fault_at(self, x, low=-1.0, high=11.0):
        return [(x, y, z) for y in (low, high) for z in (-1.0, 11.0)], [(0, 1, 3), (0, 3, 2)]

    def test_a_grid_that_ends_before_the_sides_reaches_them(self):
        self.given("h", patch((0.3, 9.8), (0.4, 9.6), level(5.0), 0.46))
        report, volumes = self.mesh(HORIZON % "" + COLUMN)
        self.assert_volumes(volumes, {"upper": 500, "lower": 500})
        (entry,) = report["continued"]
        self.assertEqual(entry["surface"], "h")
        self.assertIn("sides of the model", entry["to"])
        self.assertAlmostEqual(entry["farthest"], 0.5, delta=1e-6)  # from the corners of the grid to those of the model

    def test_triangles_with_two_equal_corners_at_the_border_change_nothing(self):
        """Modelling programs write them where points were snapped together. Such a horizon was not continued, which joined both units."""
        points, triangles = patch((0.3, 9.8), (0.4, 9.6), level(5.0), 0.46)
        edges = [e for t in triangles for e in zip(t, t[1:] + t[:1])]
        for a, b in [(a, b) for a, b in edges if (b, a) not in edges]:
            points.append(points[a])
            triangles.append((b, a, len(points) - 1))
        self.given("h", (points, triangles))
        report, volumes = self.mesh(HORIZON % "" + COLUMN)
        self.assert_volumes(volumes, {"upper": 500, "lower": 500})
        self.told(report, "warnings", "h", "without area were left out")

    def test_a_horizon_of_half_the_model_is_not_continued_along_its_sides(self):
        """A rim along the sides, narrower than the places of the grid are apart, was filled however far from the data."""
        self.given("h", patch((0.3, 5.0), (0.4, 9.63), level(5.0), 0.46))
        report, volumes = self.mesh(HORIZON % "" + COLUMN)
        self.assertEqual(list(volumes), ["upper+lower"])
        self.assertLess(report["continued"][0]["farthest"], 0.75)
        self.told(report, "warnings", "h", "stops short")

    def test_extend_none_keeps_the_border_open(self):
        self.given("h", patch((0.3, 9.8), (0.4, 9.6), level(5.0), 0.46))
        report, volumes = self.mesh(HORIZON % ", extend: none" + COLUMN)
        self.assertEqual(list(volumes), ["upper+lower"])
        self.assertNotIn("continued", report)

    def test_a_border_farther_than_the_distance_stays_open_and_the_rest_reaches_the_sides(self):
        """The border at x = 9 is 1 before the side."""
        self.given("h", patch((0.3, 9.0), (-1.0, 11.0), level(5.0)))
        report, volumes = self.mesh(HORIZON % "" + COLUMN)
        self.assertEqual(list(volumes), ["upper+lower"])
        self.told(report, "warnings", "h", "stops short")
        report, volumes = self.mesh(HORIZON % "" + COLUMN + "rules: {continue_within: 1.2}\n")
        self.assert_volumes(volumes, {"upper": 500, "lower": 500})

    def test_blocks_that_stop_before_their_fault_reach_it(self):
        self.write("h.ts", triangles_ts("h", *sheets([(-1, 4), (2, 4), (4.7, 4)], [(5.2, 6), (8, 6), (11, 6)])))
        self.given("f", self.fault_at(5.0))
        _, volumes = self.mesh(HORIZON % "" + "  - {name: f, kind: fault, file: f.ts}\n" + COLUMN)
        self.assert_volumes(volumes, {"upper": 500, "lower": 500})

    def test_blocks_go_on_with_their_slope(self):
        """h rises by 0.2 on x in the left block and by 0.1 in the right one; 0.3 and 0.2 of it are missing at the fault."""
        self.write("h.ts", triangles_ts("h", *sheets([(-1, 3.8), (2, 4.4), (4.7, 4.94)], [(5.2, 6.02), (8, 6.3), (11, 6.6)])))
        self.given("f", self.fault_at(5.0))
        _, volumes = self.mesh(HORIZON % "" + "  - {name: f, kind: fault, file: f.ts}\n" + COLUMN)
        lower = 50 * (4 + 5) / 2 + 50 * (6 + 6.5) / 2
        self.assert_volumes(volumes, {"upper": 1000 - lower, "lower": lower})

    def test_a_hole_about_a_body_closes_at_the_body(self):
        """A block of 2.1 by 2.1 with a gap of 0.15 about it."""
        points, triangles = patch((-1, 11), (-1, 11), level(5.0), 0.4)
        def is_in_hole(t):
            return all(3.75 < points[v][k] < 6.25 for v in t for k in (0, 1))
        self.given("h", (points, [t for t in triangles if not is_in_hole(t)]))
        corners = [(x, y, z) for z in (-1.0, 7.0) for y in (3.95, 6.05) for x in (3.95, 6.05)]
        faces = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]
        self.given("block", (corners, faces))
        _, volumes = self.mesh(HORIZON % "" + "  - {name: block, kind: body, file: block.ts}\n" + COLUMN)
        self.assert_volumes(volumes, {"upper": 500 - 2 * 2.1 ** 2, "lower": 500 - 5 * 2.1 ** 2, "block": 7 * 2.1 ** 2})

    def test_a_narrow_gap_without_a_fault_is_filled(self):
        """A strip of undefined nodes through a grid. What lies outside of the box is left as it is."""
        self.given("h", patch((-1, 4.0), (-1, 11), level(5.0)), patch((4.5, 11), (-1, 11), level(5.0)))
        _, volumes = self.mesh(HORIZON % "" + COLUMN)
        self.assert_volumes(volumes, {"upper": 500, "lower": 500})

    def with_hole(self, low, high):
        """A level grid without the triangles whose corners lie between `low` and `high` in x and in y."""
        points, triangles = patch((-1, 11), (-1, 11), level(5.0), 0.3)
        return points, [t for t in triangles if not all(low < points[v][k] < high for v in t for k in (0, 1))]

    def test_a_hole_within_the_distance_is_filled(self):
        """The hole is 0.9 by 0.9. Its places are at most 0.45 from the data."""
        self.given("h", self.with_hole(4.6, 5.7))
        report, volumes = self.mesh(HORIZON % "" + COLUMN)
        self.assert_volumes(volumes, {"upper": 500, "lower": 500})
        (entry,) = report["continued"]
        self.assertAlmostEqual(entry["area_filled"], 0.81, delta=1e-6)

    def test_a_wider_hole_and_one_of_a_horizon_that_keeps_its_border_stay_open(self):
        self.given("h", self.with_hole(3.4, 6.8))
        report, volumes = self.mesh(HORIZON % "" + COLUMN)
        self.assertEqual(list(volumes), ["upper+lower"])
        self.told(report, "warnings", "h", "has a hole")
        self.given("h", self.with_hole(4.6, 5.7))
        _, volumes = self.mesh(HORIZON % ", extend: none" + COLUMN)
        self.assertEqual(list(volumes), ["upper+lower"])

    def test_a_notch_in_a_side_of_the_model_is_closed(self):
        """Both edges of the notch have their middle outside of the model, and its end 0.1 inside."""
        corners = [(-1, -1), (11, -1), (11, 4), (9.9, 5), (11, 6), (11, 11), (-1, 11)]
        self.given("h", ([(x, y, 5.0) for x, y in corners], [(0, 1, 3), (1, 2, 3), (0, 3, 6), (3, 5, 6), (3, 4, 5)]))
        _, volumes = self.mesh(HORIZON % "" + COLUMN)
        self.assert_volumes(volumes, {"upper": 500, "lower": 500})

    def test_beyond_the_tip_of_a_fault_a_gap_is_filled_up_to_the_tip(self):
        """The fault at x = 5 ends at y = 6. The horizon has a slit of 0.3 along it and beyond its tip, as gridding by block leaves it."""
        self.given("h", patch((-1, 4.9), (-1, 11), level(5.0)), patch((5.2, 11), (-1, 11), level(5.0)))
        self.given("f", self.fault_at(5.0, -1.0, 6.0))
        _, volumes = self.mesh(HORIZON % "" + "  - {name: f, kind: fault, file: f.ts}\n" + COLUMN)
        self.assert_volumes(volumes, {"upper": 500, "lower": 500})

    def test_a_fault_that_ends_before_another_one_and_before_the_sides_reaches_them(self):
        """The fault g at y = 5 ends 0.3 before f and 0.4 before xmax; blocks of h end exactly at f and g."""
        self.given("f", self.fault_at(5.0))
        self.given("g", ([(x, 5.0, z) for x in (5.3, 9.6) for z in (-0.5, 10.5)], [(0, 1, 3), (0, 3, 2)]))
        self.given("h", patch((-1, 5), (-1, 11), level(5.0)), patch((5, 11), (-1, 5), level(4.0)), patch((5, 11), (5, 11), level(7.0)))
        text = HORIZON % "" + "  - {name: f, kind: fault, file: f.ts}\n  - {name: g, kind: fault, file: g.ts}\n"
        report, volumes = self.mesh(text + COLUMN)
        self.assert_volumes(volumes, {"upper": 1000 - 250 - 100 - 175, "lower": 250 + 100 + 175})
        self.assertFalse(any("ends inside" in note for note in report["notes"]), report["notes"])

    def test_a_fault_as_given_keeps_its_end(self):
        self.given("h", patch((-1, 11), (-1, 11), level(5.0)))
        self.given("f", self.fault_at(5.0, -1.0, 9.7))
        report, _ = self.mesh(HORIZON % "" + "  - {name: f, kind: fault, file: f.ts, extent: as_given}\n" + COLUMN)
        self.told(report, "notes", "f", "ends inside")


if __name__ == "__main__":
    main()
