#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the sample `exploration`: the top of a granite, an isotherm that crosses it, and two faults, all as dense grids.

    make_surfaces.py [--nodes N] [--output DIR]

N is the number of nodes a side of the two grids (default 40; 387 is the benchmark with 150,000 nodes a grid).
"""
import argparse
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import write_ts  # noqa: E402
from grids import SmoothField, add_noise, write_irap  # noqa: E402

WIDTH = 20000.0  # m
NAMES = ["granite_top", "isotherm_150"]
FAULTS = [((7000, 10000), 75, 70), ((13500, 10000), 98, -65)]  # a point of the trace at sea level, strike and dip in degrees

PROJECT = """\
# yaml-language-server: $schema=../../docs/project.schema.json
# The top of a granite, an isotherm that crosses it, and two faults. The isotherm stands in no column: it divides what it passes.
#
#   ./geomesh samples/exploration/project.yaml

name: exploration
crs: {horizontal: local, z: elevation, unit: m}
box: {min: [1000, 1000, -8000], max: [19000, 19000, 0]}
surfaces:
  - {name: granite_top,  kind: horizon, file: surfaces/granite_top.irap}
  - {name: isotherm_150, kind: horizon, file: surfaces/isotherm_150.irap}
  - {name: west_fault,   kind: fault,   file: surfaces/west_fault.ts}
  - {name: east_fault,   kind: fault,   file: surfaces/east_fault.ts}
column: [cover, granite_top, granite]
mesh: {size: {global: SIZE, input_edges: false, gap_layers: none}, honour: tolerance, surfaces_within: TOLERANCE}
output: {directory: out, formats: [vtu]}
"""


def make_grids(n):
    shape, rough, heat = SmoothField(1, 9000), SmoothField(2, 1500), SmoothField(3, 12000)
    step = WIDTH / (n - 1)
    grids = [[[0.0] * n for _ in range(n)] for _ in NAMES]
    for j in range(n):
        for i in range(n):
            u, v = step * i, step * j
            grids[0][j][i] = -3800 + 700 * shape.at(u, v) + 20 * rough.at(u, v)
            grids[1][j][i] = -4000 + 250 * heat.at(u, v)
    for k, grid in enumerate(grids):
        add_noise(grid, 1.5, 100 + k)
    return grids


def fault_surface(fault, n_along, n_down):
    (u0, v0), strike, dip = fault
    a, slope, bend = math.radians(strike), 1 / math.tan(math.radians(dip)), SmoothField(int(u0), 5000)
    points, triangles = [], []
    for j in range(n_down + 1):
        for i in range(n_along + 1):
            s, z = -12000 + 24000 * i / n_along, 500 - 9000 * j / n_down
            off = -z * slope + 60 * bend.at(s, z)
            points.append((u0 + math.cos(a) * s + math.sin(a) * off, v0 + math.sin(a) * s - math.cos(a) * off, z))
    for j in range(n_down):
        for i in range(n_along):
            p = j * (n_along + 1) + i
            triangles += [(p, p + 1, p + n_along + 2), (p, p + n_along + 2, p + n_along + 1)]
    return points, triangles


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--nodes", type=int, default=40)
    parser.add_argument("--size", type=float, default=2500)
    parser.add_argument("--tolerance", type=float, default=40)
    parser.add_argument("--seed", type=int, default=0, help="other fields of the same kind")
    parser.add_argument("--output", default=HERE)
    arguments = parser.parse_args()
    SmoothField.seed = arguments.seed
    folder = os.path.join(arguments.output, "surfaces")
    os.makedirs(folder, exist_ok=True)
    n = arguments.nodes
    for name, grid in zip(NAMES, make_grids(n)):
        write_irap(os.path.join(folder, name + ".irap"), grid, (0.0, 0.0), WIDTH / (n - 1), 0.0)
    for name, fault in zip(("west_fault", "east_fault"), FAULTS):
        write_ts(os.path.join(folder, name + ".ts"), name, *fault_surface(fault, n // 2, n // 5))
    with open(os.path.join(arguments.output, "project.yaml"), "w", newline="\n") as file:
        file.write(PROJECT.replace("SIZE", "%g" % arguments.size).replace("TOLERANCE", "%g" % arguments.tolerance))


if __name__ == "__main__":
    main()
