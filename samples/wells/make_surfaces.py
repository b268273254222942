#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/*.ts, surfaces/*.pl and expected.json of this sample: two horizons and two wells that cross them, one vertical and one deviated."""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import horizon, rounded, write_expected, write_polyline, write_ts  # noqa: E402
from region_volumes import Graph, box_layers  # noqa: E402


def deviated(n):
    """Vertical to 600 m, then building angle towards the east."""
    path = [(1210.0, 1830.0, 0.0), (1210.0, 1830.0, -600.0)]
    for i in range(1, n + 1):
        t = i / n
        path.append((1210.0 + 900 * (1 - math.cos(t * 1.2)), 1830.0 + 120 * t, -600.0 - 900 * math.sin(t * 1.2)))
    return path


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    heights = {"top_reservoir": lambda x, y: -1010.0 + 40 * math.sin(x / 500.0) - 0.02 * y,
               "base_reservoir": lambda x, y: -1290.0 + 35 * math.sin(x / 560.0 + 0.4) - 0.03 * y}
    graphs = []
    for seed, (name, height) in enumerate(heights.items(), start=51):
        points, triangles = horizon((-80.0, 3110.0), (-60.0, 3070.0), 14, 14, height, seed)
        write_ts(os.path.join(folder, name + ".ts"), name, points, triangles)
        graphs.append(Graph(rounded(points), triangles, 2))
    write_polyline(os.path.join(folder, "w1.pl"), "w1", [(2040.0, 960.0, 0.0), (2040.0, 960.0, -1450.0)])
    write_polyline(os.path.join(folder, "w2.pl"), "w2", deviated(9))
    volumes = box_layers((0.0, 0.0, -2000.0), (3000.0, 3000.0, 0.0), graphs)
    write_expected(os.path.join(HERE, "expected.json"), {unit: [v] for unit, v in zip(("overburden", "reservoir", "underburden"), volumes)})


if __name__ == "__main__":
    main()
