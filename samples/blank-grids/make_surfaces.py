#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the sample `blank-grids`: four horizon grids with undefined nodes outside a ragged outline and in holes, and three wells.

    make_surfaces.py [--columns N] [--output DIR]

N is the number of columns of each grid (default 56; 554 is the benchmark, 554 by 451 nodes).
"""
import argparse
import math
import os
import random
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import write_polyline  # noqa: E402
from grids import SmoothField, add_noise, write_irap  # noqa: E402

WIDTH, LENGTH = 13825.0, 11250.0      # m
ORIGIN = (500000.0, 6500000.0)
NOISE = 0.5                           # m
NAMES = ["top_shale", "top_sand", "top_coal", "base_coal"]
WELLS = [("A1", (4200, 5000)), ("A2", (7300, 4100)), ("A3", (9100, 7200))]

PROJECT = """\
# yaml-language-server: $schema=../../docs/project.schema.json
# Four horizon grids with undefined nodes outside a ragged outline and in holes, and three vertical wells. The horizons are filled and
# continued to the box, and settled as a stack.
#
#   ./geomesh samples/blank-grids/project.yaml

name: blank_grids
crs: {horizontal: local, z: elevation, unit: m}
box: {min: [501000, 6501000, -3200], max: [512800, 6510200, -1200]}
surfaces:
  - {name: top_shale, kind: horizon, file: surfaces/top_shale.irap, fill_holes: all, extend: nearest}
  - {name: top_sand,  kind: horizon, file: surfaces/top_sand.irap,  fill_holes: all, extend: nearest}
  - {name: top_coal,  kind: horizon, file: surfaces/top_coal.irap,  fill_holes: all, extend: nearest}
  - {name: base_coal, kind: horizon, file: surfaces/base_coal.irap, fill_holes: all, extend: nearest}
column: [overburden, top_shale, shale, top_sand, sand, top_coal, coal, base_coal, underburden]
wells:
WELLS
mesh: {size: {global: SIZE, input_edges: false, gap_layers: none}, honour: tolerance, surfaces_within: TOLERANCE, quality: fast}
output: {directory: out, formats: [vtu]}
"""


def make_grids(n_columns, n_rows):
    shape, shale, sand, coal = SmoothField(1, 7000), SmoothField(2, 6000), SmoothField(3, 5000), SmoothField(4, 4000)
    outline = SmoothField(5, 1500)
    holes = [(random.Random(6 + k).uniform(3000, 10500), random.Random(60 + k).uniform(3000, 8500), 150 + 90 * k) for k in range(4)]
    step = WIDTH / (n_columns - 1)
    grids = [[[None] * n_columns for _ in range(n_rows)] for _ in NAMES]
    for j in range(n_rows):
        for i in range(n_columns):
            u, v = step * i, step * j
            # A rounded outline with a ragged rim, each horizon's a little further in; holes shared by all.
            rim = min(u, v, WIDTH - u, LENGTH - v, 0.5 * (u + v), 0.5 * (WIDTH - u + v)) + 250 * outline.at(u, v) - 350
            if any(math.hypot(u - x, v - y) < radius for x, y, radius in holes):
                continue
            z = -1900 + 140 * shape.at(u, v) - 0.02 * u
            for k, thickness in enumerate([0, 90 + 25 * shale.at(u, v), max(0.0, 30 * sand.at(u, v)), max(0.0, 10 + 12 * coal.at(u, v))]):
                z -= thickness
                if rim > 40 * k:
                    grids[k][j][i] = z
    for k, grid in enumerate(grids):
        add_noise(grid, NOISE, 100 + k)
    return grids


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--columns", type=int, default=56)
    parser.add_argument("--size", type=float, default=1500)
    parser.add_argument("--tolerance", type=float, default=8)
    parser.add_argument("--seed", type=int, default=0, help="other fields of the same kind")
    parser.add_argument("--output", default=HERE)
    arguments = parser.parse_args()
    SmoothField.seed = arguments.seed
    folder = os.path.join(arguments.output, "surfaces")
    os.makedirs(folder, exist_ok=True)
    step = WIDTH / (arguments.columns - 1)
    n_rows = int(round(LENGTH / step)) + 1
    for name, grid in zip(NAMES, make_grids(arguments.columns, n_rows)):
        write_irap(os.path.join(folder, name + ".irap"), grid, ORIGIN, step, 0.0)
    for name, (u, v) in WELLS:
        x, y = ORIGIN[0] + u, ORIGIN[1] + v
        write_polyline(os.path.join(folder, name + ".pl"), name, [(x, y, -1300), (x, y, -3000)])
    wells = "\n".join("  - {name: %s, file: surfaces/%s.pl}" % (name, name) for name, _ in WELLS)
    text = PROJECT.replace("WELLS", wells).replace("SIZE", "%g" % arguments.size).replace("TOLERANCE", "%g" % arguments.tolerance)
    with open(os.path.join(arguments.output, "project.yaml"), "w", newline="\n") as file:
        file.write(text)


if __name__ == "__main__":
    main()
