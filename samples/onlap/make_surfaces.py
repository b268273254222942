#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/*.ts and expected.json of this sample: flat layers that end against a rising basin floor (onlap). The horizons end
exactly on it. All lines of the section are straight, so that volumes are known."""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import section_area, section_strip, write_expected, write_ts  # noqa: E402

EAST, WIDTH, DEPTH = 6000.0, 4000.0, 3000.0


def floor(x):
    return -2200.0 + 0.25 * x


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    lines = {"top_silt": [(-130.0, -1200.0), (4000.0, -1200.0)],
             "top_sand": [(-130.0, -1700.0), (2000.0, -1700.0)],
             "basin_floor": [(-200.0, floor(-200.0)), (EAST + 200.0, floor(EAST + 200.0))]}
    for name, line in lines.items():
        write_ts(os.path.join(folder, name + ".ts"), name, *section_strip(line, (-70.0, WIDTH + 90.0)))
    sections = {"mud": [(0, 0), (EAST, 0), (EAST, floor(EAST)), (4000.0, -1200.0), (0, -1200.0)],
                "silt": [(0, -1200.0), (4000.0, -1200.0), (2000.0, -1700.0), (0, -1700.0)],
                "sand": [(0, -1700.0), (2000.0, -1700.0), (0, floor(0))],
                "basement": [(0, floor(0)), (EAST, floor(EAST)), (EAST, -DEPTH), (0, -DEPTH)]}
    write_expected(os.path.join(HERE, "expected.json"), {name: [WIDTH * section_area(s)] for name, s in sections.items()})


if __name__ == "__main__":
    main()
