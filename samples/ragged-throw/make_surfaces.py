#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/*.ts and expected.json of this sample: the model of normal-fault, with blocks of horizons that end somewhere near the
fault, and a fault that ends within the box."""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import section_area, section_strip, write_expected, write_ts  # noqa: E402

EAST, WIDTH, DEPTH = 6000.0, 4000.0, 3000.0
THROW = 400.0


def fault(z):
    """Dips east at 63 degrees: x at height z."""
    return 2500.0 - 0.5 * z


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    write_ts(os.path.join(folder, "fault.ts"), "fault", *section_strip([(fault(-300.0), -300.0), (fault(-2600.0), -2600.0)], (350.0, 3700.0)))
    ends = {"top_sand": (-800.0, -170.0, 240.0), "top_basement": (-1700.0, 130.0, -90.0)}  # short of the fault, or beyond it
    for name, (z, west_end, east_start) in ends.items():
        west = section_strip([(-130.0, z), (fault(z) + west_end, z)], (-70.0, WIDTH + 90.0))
        east = section_strip([(fault(z - THROW) + east_start, z - THROW), (EAST + 110.0, z - THROW)], (-60.0, WIDTH + 80.0))
        write_ts(os.path.join(folder, name + ".ts"), name, west[0] + east[0], west[1] + [tuple(v + len(west[0]) for v in t) for t in east[1]])

    def west_of(high, low):
        return [(0, high), (fault(high), high), (fault(low), low), (0, low)]

    def east_of(high, low):
        return [(EAST, high), (fault(high), high), (fault(low), low), (EAST, low)]
    sections = {"cover": [west_of(0, -800.0), east_of(0, -1200.0)], "sand": [west_of(-800.0, -1700.0), east_of(-1200.0, -2100.0)],
                "basement": [west_of(-1700.0, -DEPTH), east_of(-2100.0, -DEPTH)]}
    write_expected(os.path.join(HERE, "expected.json"),
                   {"%s__B%d" % (name, i + 1): [WIDTH * section_area(s)] for name, two in sections.items() for i, s in enumerate(two)})


if __name__ == "__main__":
    main()
