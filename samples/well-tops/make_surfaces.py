#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/*.ts, *.pl, tops.csv and expected.json of this sample: two horizons of a survey that miss the tops of three wells.

What the rule does to the horizons is computed here once more, by elimination: the volumes expected are those of the moved horizons.
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import horizon, rounded, write_expected, write_polyline, write_ts  # noqa: E402
from region_volumes import Graph, box_layers  # noqa: E402

REACH = 1200.0
WELLS = {"w1": [(900.0, 900.0, 0.0), (900.0, 900.0, -1600.0)],
         "w2": [(1500.0, 2100.0, 0.0), (1500.0, 2100.0, -600.0), (2100.0, 2100.0, -1600.0)],
         "w3": [(2300.0, 700.0, 0.0), (2300.0, 700.0, -1600.0)]}
# Depth along the well, in metres: the horizons are up to 24 m off.
TOPS = [("w1", "top_sand", 968.0), ("w2", "top_sand", 1065.0), ("w3", "top_sand", 1010.0), ("w1", "base_sand", 1240.0),
        ("w3", "base_sand", 1301.5)]


def place_of(well, depth):
    for a, b in zip(WELLS[well], WELLS[well][1:]):
        length = math.dist(a, b)
        if depth <= length:
            return tuple(p + depth / length * (q - p) for p, q in zip(a, b))
        depth -= length
    raise ValueError(well)


def shares_of(points, triangles, x, y):
    for t in triangles:
        (ax, ay, _), (bx, by, _), (cx, cy, _) = (points[i] for i in t)
        whole = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        second = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / whole
        third = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / whole
        if min(1 - second - third, second, third) >= 0:
            return list(zip(t, (1 - second - third, second, third)))
    raise ValueError((x, y))


def bell(distance):
    r = distance / REACH
    return (1 - r) ** 4 * (4 * r + 1) if r < 1 else 0.0


def solve(rows):
    """Of a small regular system, the right side in the last column."""
    n = len(rows)
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(n):
            if i != k:
                factor = rows[i][k] / rows[k][k]
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    return [rows[k][n] / rows[k][k] for k in range(n)]


def moved(name, points, triangles):
    tops = [place_of(well, depth) for well, surface, depth in TOPS if surface == name]
    rows = []
    for x, y, z in tops:
        shares = shares_of(points, triangles, x, y)
        row = [sum(s * bell(math.dist(points[i][:2], other[:2])) for i, s in shares) for other in tops]
        rows.append(row + [z - sum(s * points[i][2] for i, s in shares)])
    weights = solve(rows)
    return [(x, y, z + sum(w * bell(math.dist((x, y), top[:2])) for w, top in zip(weights, tops))) for x, y, z in points]


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    heights = {"top_sand": lambda x, y: -990.0 + 30 * math.sin(x / 600.0) - 0.01 * y,
               "base_sand": lambda x, y: -1270.0 + 25 * math.sin(x / 640.0 + 0.4) - 0.02 * y}
    graphs = []
    for seed, (name, height) in enumerate(heights.items(), start=81):
        points, triangles = horizon((-80.0, 3110.0), (-60.0, 3070.0), 14, 14, height, seed)
        write_ts(os.path.join(folder, name + ".ts"), name, points, triangles)
        graphs.append(Graph(moved(name, rounded(points), triangles), triangles, 2))
    for name, path in WELLS.items():
        write_polyline(os.path.join(folder, name + ".pl"), name, path)
    with open(os.path.join(folder, "tops.csv"), "w", newline="\n") as file:
        file.write("well,horizon,depth\n" + "".join("%s,%s,%.1f\n" % top for top in TOPS))
    volumes = box_layers((0.0, 0.0, -2000.0), (3000.0, 3000.0, 0.0), graphs)
    write_expected(os.path.join(HERE, "expected.json"), {unit: [v] for unit, v in zip(("overburden", "sand", "underburden"), volumes)})


if __name__ == "__main__":
    main()
