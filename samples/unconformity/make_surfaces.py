#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/*.ts and expected.json of this sample: tilted layers under an erosive unconformity. The tilted horizons end exactly on
it. All lines of the section are straight, so that volumes are known."""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import section_area, section_strip, write_expected, write_ts  # noqa: E402

EAST, WIDTH, DEPTH, EROSION = 6000.0, 4000.0, 3000.0, -1000.0


def tilted(outcrop, x):
    """Height at x of the horizon that is eroded at x = outcrop."""
    return EROSION - 0.25 * (x - outcrop)


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    lines = {"erosion": [(-120.0, EROSION), (EAST + 80.0, EROSION)],
             "top_marl": [(4000.0, EROSION), (EAST + 200.0, tilted(4000.0, EAST + 200.0))],
             "top_lime": [(1500.0, EROSION), (EAST + 200.0, tilted(1500.0, EAST + 200.0))]}
    for name, line in lines.items():
        write_ts(os.path.join(folder, name + ".ts"), name, *section_strip(line, (-70.0, WIDTH + 90.0)))
    a, b = tilted(4000.0, EAST), tilted(1500.0, EAST)
    sections = {"cover": [(0, 0), (EAST, 0), (EAST, EROSION), (0, EROSION)],
                "clay": [(4000.0, EROSION), (EAST, EROSION), (EAST, a)],
                "marl": [(1500.0, EROSION), (4000.0, EROSION), (EAST, a), (EAST, b)],
                "lime": [(0, EROSION), (1500.0, EROSION), (EAST, b), (EAST, -DEPTH), (0, -DEPTH)]}
    write_expected(os.path.join(HERE, "expected.json"), {name: [WIDTH * section_area(s)] for name, s in sections.items()})


if __name__ == "__main__":
    main()
