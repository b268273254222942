#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/*.ts and expected.json of this sample: a salt stock rooted below the box that ends inside, a salt wall that reaches from
below the box through its top, and two gentle horizons that run uncut through both."""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import closed_of_rings, horizon, rounded, smooth_curve, volume_between, write_expected, write_ts  # noqa: E402
from region_volumes import Graph, box_layers, volume_above  # noqa: E402

BOX = (0.0, 0.0, -4000.0), (8000.0, 5000.0, 0.0)
LOW, HIGH = BOX[0][2], BOX[1][2]


def stock(centre, radius, low, high, stretch):
    """place(s, angle) of a closed body about a vertical axis: radius against height, wider along x by `stretch`."""
    def place(s, angle):
        z = low + s * (high - low)
        r = radius(z) * (1 + 0.08 * math.cos(2 * angle + 1.1) + 0.05 * math.sin(3 * angle + z / 800.0))
        return centre[0] + stretch * r * math.cos(angle), centre[1] + r * math.sin(angle), z
    return place


def volumes(salt, horizons):
    """Each layer is that of the box without the salt in it."""
    layers = box_layers(*BOX, horizons)
    expected = {}
    for name, (points, triangles) in salt.items():
        whole = volume_between(points, triangles, LOW, HIGH)
        outside = volume_between(points, triangles, HIGH, 1e9)  # above the box
        above = [volume_above([[points[v] for v in t] for t in triangles], h) - outside for h in horizons] + [whole]
        layers = [v - (below - over) for v, over, below in zip(layers, [0.0] + above, above)]
        expected[name] = [whole]
    return {**expected, **{unit: [v] for unit, v in zip(("cover", "sand", "basement"), layers)}}


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    bodies = {
        "rooted_stock": closed_of_rings(24, 17, (2300.0, 2500.0, -4700.0), (2300.0, 2500.0, -900.0),
                                        stock((2300.0, 2500.0), smooth_curve([(-4700.0, 0.0), (-4600.0, 900.0), (-3600.0, 650.0),
                                                                              (-2400.0, 800.0), (-1300.0, 950.0), (-900.0, 0.0)]),
                                              -4700.0, -900.0, 1.0), 3),
        "salt_wall": closed_of_rings(30, 19, (5900.0, 2600.0, -4600.0), (5900.0, 2600.0, 420.0),
                                     stock((5900.0, 2600.0), smooth_curve([(-4600.0, 0.0), (-4500.0, 800.0), (-2000.0, 560.0),
                                                                           (-200.0, 690.0), (300.0, 640.0), (420.0, 0.0)]),
                                           -4600.0, 420.0, 1.7), 4)}
    salt = {}
    for name, (points, triangles) in bodies.items():
        write_ts(os.path.join(folder, name + ".ts"), name, points, triangles)
        salt[name] = rounded(points), triangles
    heights = {"top_sand": lambda x, y: -1620.0 + 70 * math.sin(x / 1100.0) + 0.03 * y,
               "top_basement": lambda x, y: -2890.0 + 90 * math.cos(x / 1400.0 + 0.3) - 0.02 * y}
    graphs = []
    for seed, (name, height) in enumerate(heights.items(), start=41):
        points, triangles = horizon((-160.0, 8210.0), (-120.0, 5130.0), 20, 13, height, seed)
        write_ts(os.path.join(folder, name + ".ts"), name, points, triangles)
        graphs.append(Graph(rounded(points), triangles, 2))
    write_expected(os.path.join(HERE, "expected.json"), volumes(salt, graphs))


if __name__ == "__main__":
    main()
