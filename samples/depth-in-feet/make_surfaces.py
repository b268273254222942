#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/*.ts and expected.json of this sample: two tilted horizons in feet, depth positive downwards. They are planes, so that
volumes are known."""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import section_area, section_strip, write_expected, write_ts  # noqa: E402

FOOT = 0.3048
EAST, WIDTH, DEPTH = 12000.0, 9000.0, 8000.0  # of the box, in feet


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    lines = {"top_gas": [(-500.0, 2450.0), (12500.0, 3100.0)], "top_water": [(-500.0, 5000.0), (12500.0, 5000.0)]}
    for name, line in lines.items():
        points, triangles = section_strip(line, (-400.0, WIDTH + 400.0))
        write_ts(os.path.join(folder, name + ".ts"), name, points, triangles, "ft", "Depth")
    gas_west, gas_east = 2450.0 + 0.05 * 500, 2450.0 + 0.05 * (500 + EAST)
    sections = {"overburden": [(0, 0), (EAST, 0), (EAST, gas_east), (0, gas_west)],
                "gas": [(0, gas_west), (EAST, gas_east), (EAST, 5000.0), (0, 5000.0)],
                "water": [(0, 5000.0), (EAST, 5000.0), (EAST, DEPTH), (0, DEPTH)]}
    write_expected(os.path.join(HERE, "expected.json"),
                   {name: [FOOT ** 3 * WIDTH * section_area(s)] for name, s in sections.items()})


if __name__ == "__main__":
    main()
