#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the sample `basin`: a terrain model and three tops in longitude and latitude, as mapping services deliver them.

    make_surfaces.py [--nodes N] [--output DIR]

N is the number of nodes a side of each grid (default 40, the sample; 387 is the benchmark with 150,000 nodes a grid). Each layer thins
out to nothing over about half of the area, where the grids touch and cross by noise of a few metres at each node.
"""
import argparse
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from grids import SmoothField, add_noise, write_esri_ascii  # noqa: E402

WEST, SOUTH, WIDTH = 10.0, 48.0, 1.2  # degrees
METRES = 90000.0                      # about a degree, for the fields alone
NOISE = 6.0                           # m, standard deviation at each node
NAMES = ["relief", "base_quaternary", "base_tertiary", "base_jurassic"]

PROJECT = """\
# yaml-language-server: $schema=../../docs/project.schema.json
# A terrain model and three tops of a sedimentary basin in longitude and latitude. Layers are missing over about half of the area: there
# the grids touch and cross by noise. The stack is settled before anything is intersected.
#
#   ./geomesh samples/basin/project.yaml

name: basin
crs: {horizontal: utm 32N, z: elevation, unit: m}
box: {min: [580000, 5325000, -5000], max: [650000, 5435000, 3000]}
surfaces:
  - {name: relief,          kind: horizon, file: surfaces/relief.asc,          crs: geographic}
  - {name: base_quaternary, kind: horizon, file: surfaces/base_quaternary.asc, crs: geographic}
  - {name: base_tertiary,   kind: horizon, file: surfaces/base_tertiary.asc,   crs: geographic}
  - {name: base_jurassic,   kind: horizon, file: surfaces/base_jurassic.asc,   crs: geographic}
column: [quaternary, base_quaternary, tertiary, base_tertiary, jurassic, base_jurassic, basement]
rules: {topography: relief}
mesh: {size: {global: SIZE, input_edges: false, gap_layers: none}, honour: tolerance, surfaces_within: TOLERANCE, quality: fast}
output: {directory: out, formats: [vtu]}
"""


def make_grids(n):
    relief = SmoothField(1, 30000)
    rough = SmoothField(2, 6000)
    layers = [(SmoothField(11, 25000), 60.0, 120.0), (SmoothField(12, 40000), 700.0, 900.0), (SmoothField(13, 35000), 400.0, 500.0)]
    step = WIDTH / n
    grids = [[[0.0] * n for _ in range(n)] for _ in NAMES]
    for j in range(n):
        for i in range(n):
            x, y = METRES * (i + 0.5) * step * 0.67, METRES * (j + 0.5) * step * 1.2
            z = 500 + 120 * relief.at(x, y) + 25 * rough.at(x, y)
            grids[0][j][i] = z
            for k, (field, mean, deviation) in enumerate(layers):
                # Mean zero of the field: the layer is there over half of the area, and thins out to nothing at a finite slope.
                z -= max(0.0, deviation * field.at(x, y) + (mean if k == 1 else 0.1 * mean))
                grids[k + 1][j][i] = z
    for k, grid in enumerate(grids):
        add_noise(grid, NOISE, 100 + k)
    return grids


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--nodes", type=int, default=40)
    parser.add_argument("--size", type=float, default=10000)
    parser.add_argument("--tolerance", type=float, default=60)
    parser.add_argument("--seed", type=int, default=0, help="other fields of the same kind")
    parser.add_argument("--output", default=HERE)
    arguments = parser.parse_args()
    SmoothField.seed = arguments.seed
    os.makedirs(os.path.join(arguments.output, "surfaces"), exist_ok=True)
    for name, grid in zip(NAMES, make_grids(arguments.nodes)):
        write_esri_ascii(os.path.join(arguments.output, "surfaces", name + ".asc"), grid, (WEST, SOUTH), WIDTH / arguments.nodes)
    with open(os.path.join(arguments.output, "project.yaml"), "w", newline="\n") as file:
        file.write(PROJECT.replace("SIZE", "%g" % arguments.size).replace("TOLERANCE", "%g" % arguments.tolerance))


if __name__ == "__main__":
    main()
