#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/*.ts and expected.json of this sample: a salt plug that reaches the ground through flat layers."""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import closed_of_rings, rectangles, rounded, smooth_curve, volume_between, write_expected, write_ts  # noqa: E402

X, Y, BOTTOM = 6000.0, 5000.0, -3000.0
CENTRE = (3000.0, 2600.0)
LEVELS = {"relief": 60.0, "top_sand": -700.0, "top_basement": -1900.0}
FOOT, CROWN = -2600.0, 340.0


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    for name, z in LEVELS.items():
        corners = [(-90.0, -80.0, z), (X + 70.0, -80.0, z), (X + 70.0, Y + 60.0, z), (-90.0, Y + 60.0, z)]
        write_ts(os.path.join(folder, name + ".ts"), name, *rectangles([corners]))
    radius = smooth_curve([(0.0, 250.0), (0.2, 700.0), (0.5, 480.0), (0.8, 820.0), (1.0, 420.0)])

    def place(s, angle):
        r = radius(s) * (1 + 0.12 * math.cos(2 * angle + 0.7))
        return CENTRE[0] + r * math.cos(angle), CENTRE[1] + r * math.sin(angle), FOOT + 30 + s * (CROWN - FOOT - 60)
    points, triangles = closed_of_rings(36, 22, (CENTRE[0], CENTRE[1], FOOT), (CENTRE[0], CENTRE[1], CROWN), place, seed=41)
    write_ts(os.path.join(folder, "salt.ts"), "salt", points, triangles)
    points = rounded(points)
    levels = [LEVELS["relief"], LEVELS["top_sand"], LEVELS["top_basement"], BOTTOM]
    salt = [volume_between(points, triangles, low, high) for high, low in zip(levels, levels[1:])]
    volumes = {unit: [X * Y * (levels[i] - levels[i + 1]) - salt[i]] for i, unit in enumerate(["cover", "sand", "basement"])}
    volumes["salt"] = [sum(salt)]
    write_expected(os.path.join(HERE, "expected.json"), volumes)


if __name__ == "__main__":
    main()
