#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the sample `reservoir`: four rotated horizon grids with the throw of six faults smeared across them, and three wells.

    make_surfaces.py [--columns N] [--output DIR]

N is the number of columns of each grid (default 36; 175 is the benchmark, 175 by 275 nodes). Units are thin, and one wedges out.
"""
import argparse
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import write_polyline, write_ts  # noqa: E402
from grids import SmoothField, add_noise, write_irap  # noqa: E402

WIDTH, LENGTH = 8700.0, 13700.0       # m, of the grids
ROTATION = 30.0                       # degrees counter-clockwise
ORIGIN = (460000.0, 6780000.0)
NOISE = 0.4                           # m
NAMES = ["top_reservoir", "top_middle", "top_lower", "base_reservoir"]
# Faults in the grids' own axes: their middle, strike (degrees from x), side to which they dip, greatest throw (m), half of their length
# (m). Two cross the whole model; the others end inside, where their throw has died out.
FAULTS = [((4300, 1700), 4, 1, 45, 2600), ((4300, 4100), -6, -1, 40, 9000), ((3400, 6300), 3, 1, 50, 2200), ((5600, 7600), -3, -1, 25, 1800),
          ((4300, 9700), 6, -1, 60, 9000), ((4700, 12000), -4, 1, 35, 2500)]
DIP = math.radians(62)
DEPTH = 2400.0                        # m, about the middle of the reservoir
WELLS = [("W1", (2500, 3000), (2500, 3000)), ("W2", (5800, 7300), (6400, 7600)), ("W3", (3100, 11400), (3500, 11000))]

PROJECT = """\
# yaml-language-server: $schema=../../docs/project.schema.json
# Four rotated horizon grids of a reservoir, with the throw of six faults smeared over a few nodes, and three wells. Units are thin, and the
# middle one wedges out. Regions are named by fault block.
#
#   ./geomesh samples/reservoir/project.yaml

name: reservoir
crs: {horizontal: local, z: elevation, unit: m}
box: {center: [CENTRE], size: [7900, 12900], azimuth: -30, bottom: -2900, top: -1900}
surfaces:
  - {name: top_reservoir,  kind: horizon, file: surfaces/top_reservoir.irap}
  - {name: top_middle,     kind: horizon, file: surfaces/top_middle.irap}
  - {name: top_lower,      kind: horizon, file: surfaces/top_lower.irap}
  - {name: base_reservoir, kind: horizon, file: surfaces/base_reservoir.irap}
FAULTS
column: [overburden, top_reservoir, upper, top_middle, middle, top_lower, lower, base_reservoir, underburden]
wells:
WELLS
rules: {min_thickness: THICKNESS}
mesh: {size: {global: OUTER, units: {upper: SIZE, middle: SIZE, lower: SIZE}, input_edges: false, gap_layers: none}, honour: tolerance, surfaces_within: THICKNESS, quality: fast}
output: {directory: out, formats: [vtu]}
"""


def to_map(u, v):
    c, s = math.cos(math.radians(ROTATION)), math.sin(math.radians(ROTATION))
    return ORIGIN[0] + c * u - s * v, ORIGIN[1] + s * u + c * v


def across(fault, u, v, z):
    """Distance across the fault's plane in the map at height z, positive on the hanging wall."""
    (u0, v0), strike, side, _, _ = fault
    a = math.radians(strike)
    return side * (-math.sin(a) * (u - u0) + math.cos(a) * (v - v0)) - (-DEPTH - z) / math.tan(DIP)


def throw_at(u, v, z, smear):
    down = 0.0
    for fault in FAULTS:
        d = across(fault, u, v, z)
        (u0, v0), strike, _, throw, half = fault
        along = (math.cos(math.radians(strike)) * (u - u0) + math.sin(math.radians(strike)) * (v - v0)) / half
        if half < 8000:  # drag on both sides, so that the horizon is whole again away from the fault
            reach = max(0.0, 1 - along * along) * math.exp(-abs(d) / 700)
            down += throw * reach * 0.5 * max(-1.0, min(1.0, d / smear))
        else:
            down += throw * (0.5 + 0.5 * max(-1.0, min(1.0, d / smear)))
    return down


def make_grids(n_columns, n_rows, smear):
    shape, upper, middle, lower = SmoothField(1, 6000), SmoothField(2, 4000), SmoothField(3, 5000), SmoothField(4, 4000)
    grids = [[[0.0] * n_columns for _ in range(n_rows)] for _ in NAMES]
    for j in range(n_rows):
        for i in range(n_columns):
            u, v = WIDTH * i / (n_columns - 1), LENGTH * j / (n_rows - 1)
            z = -DEPTH + 90 + 50 * shape.at(u, v) + 0.008 * (u - 4300)
            for k, thickness in enumerate([0.0, 26 + 5 * upper.at(u, v), max(0.0, 9 + 9 * middle.at(u, v)), 34 + 6 * lower.at(u, v)]):
                z -= thickness
                grids[k][j][i] = z
            for k in range(len(NAMES)):
                grids[k][j][i] -= throw_at(u, v, grids[k][j][i], smear)
    for k, grid in enumerate(grids):
        add_noise(grid, NOISE, 100 + k)
    return grids


def fault_surface(fault, n_along, n_down):
    """The plane from above the box to below it, with a little relief."""
    (u0, v0), strike, side, _, half = fault
    a, bend = math.radians(strike), SmoothField(int(v0), 3000)
    points, triangles = [], []
    for j in range(n_down + 1):
        for i in range(n_along + 1):
            s, z = half * (2 * i / n_along - 1), -1700 - 1400 * j / n_down
            off = side * (-DEPTH - z) / math.tan(DIP) + 6 * bend.at(s, z)
            u, v = u0 + math.cos(a) * s - math.sin(a) * off, v0 + math.sin(a) * s + math.cos(a) * off
            points.append((*to_map(u, v), z))
    for j in range(n_down):
        for i in range(n_along):
            p = j * (n_along + 1) + i
            triangles += [(p, p + 1, p + n_along + 2), (p, p + n_along + 2, p + n_along + 1)]
    return points, triangles


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--columns", type=int, default=36)
    parser.add_argument("--size", type=float, default=400)
    parser.add_argument("--outer", type=float, default=2000)
    parser.add_argument("--thickness", type=float, default=4, help="least thickness of a unit, and tolerance, in m")
    parser.add_argument("--seed", type=int, default=0, help="other fields of the same kind")
    parser.add_argument("--output", default=HERE)
    arguments = parser.parse_args()
    SmoothField.seed = arguments.seed
    folder = os.path.join(arguments.output, "surfaces")
    os.makedirs(folder, exist_ok=True)
    n_columns = arguments.columns
    step = WIDTH / (n_columns - 1)
    n_rows = int(round(LENGTH / step)) + 1
    for name, grid in zip(NAMES, make_grids(n_columns, n_rows, 1.5 * step)):
        write_irap(os.path.join(folder, name + ".irap"), grid, ORIGIN, step, ROTATION)
    for k, fault in enumerate(FAULTS):
        write_ts(os.path.join(folder, "F%d.ts" % (k + 1)), "F%d" % (k + 1), *fault_surface(fault, 2 * n_columns // 3, max(4, n_columns // 8)))
    for name, (u0, v0), (u1, v1) in WELLS:
        path = [(*to_map(u0 + (u1 - u0) * t, v0 + (v1 - v0) * t), -1950 - 800 * t) for t in (0, 0.4, 0.7, 1)]
        write_polyline(os.path.join(folder, name + ".pl"), name, path)
    faults = "\n".join("  - {name: F%d, kind: fault, file: surfaces/F%d.ts}" % (k + 1, k + 1) for k in range(len(FAULTS)))
    wells = "\n".join("  - {name: %s, file: surfaces/%s.pl}" % (well[0], well[0]) for well in WELLS)
    centre = "%.3f, %.3f" % to_map(WIDTH / 2, LENGTH / 2)
    text = PROJECT.replace("CENTRE", centre).replace("FAULTS", faults).replace("WELLS", wells)
    text = text.replace("OUTER", "%g" % arguments.outer).replace("SIZE", "%g" % arguments.size)
    text = text.replace("THICKNESS", "%g" % arguments.thickness)
    with open(os.path.join(arguments.output, "project.yaml"), "w", newline="\n") as file:
        file.write(text)


if __name__ == "__main__":
    main()
