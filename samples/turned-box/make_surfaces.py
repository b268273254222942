#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/ and expected.json of this sample: two tilted planes and a well in a turned box. The volume between two planes over a
centrally symmetric area is that area times their distance at its centre."""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import rectangles, write_expected, write_polyline, write_ts  # noqa: E402

CENTER, SIZE, DEPTH = (3000.0, 2500.0), (3000.0, 2000.0), 3000.0


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    planes = {"top_sand": lambda x, y: -700.0 - 0.125 * x + 0.0625 * y, "top_basement": lambda x, y: -1500.0 - 0.125 * x - 0.0625 * y}
    corners = [(0.0, 0.0), (6400.0, 0.0), (6400.0, 5600.0), (0.0, 5600.0)]
    for name, height in planes.items():
        write_ts(os.path.join(folder, name + ".ts"), name, *rectangles([[(x, y, height(x, y)) for x, y in corners]]))
    write_polyline(os.path.join(folder, "w1.pl"), "w1", [(3000.0, 2500.0, 100.0), (3000.0, 2500.0, -900.0), (5500.0, 2500.0, -1300.0)])
    heights = [0.0] + [height(*CENTER) for height in planes.values()] + [-DEPTH]
    area = SIZE[0] * SIZE[1]
    write_expected(os.path.join(HERE, "expected.json"), {unit: [area * (heights[i] - heights[i + 1])]
                                                         for i, unit in enumerate(["cover", "sand", "basement"])})


if __name__ == "__main__":
    main()
