#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/*.ts, project.yaml and expected.json of this sample: irregular grains in a box, pore space between them (the fourth example
of Cavalcanti and Mello 1999, its Figure 10, made anew). Lengths are in micrometres, called metres.

    make_surfaces.py                             the eight grains of this folder
    make_surfaces.py --grains 1000 --output DIR  a project of 1,000 grains in the folder DIR
"""
import argparse
import math
import random
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import rounded, volume_between, write_expected, write_ts  # noqa: E402

CELL = 250.0  # room for one grain


def icosphere(levels):
    """Unit directions and outward triangles: an icosahedron, each triangle in four `levels` times."""
    golden = (1 + math.sqrt(5)) / 2
    points = []
    for s in (-1, 1):
        for t in (-golden, golden):
            points += [(0, s, t), (s, t, 0), (t, 0, s)]
    edge = min(math.dist(points[0], p) for p in points[1:])

    def near(i, j):
        return abs(math.dist(points[i], points[j]) - edge) < 0.1
    triangles = []
    for a in range(12):
        for b in range(a + 1, 12):
            for c in range(b + 1, 12):
                if near(a, b) and near(b, c) and near(a, c):
                    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = points[a], points[b], points[c]
                    det = ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx)
                    triangles.append((a, b, c) if det > 0 else (a, c, b))
    for _ in range(levels):
        middle = {}

        def between(i, j):
            key = (min(i, j), max(i, j))
            if key not in middle:
                middle[key] = len(points)
                points.append(tuple((x + y) / 2 for x, y in zip(points[i], points[j])))
            return middle[key]
        finer = []
        for a, b, c in triangles:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = finer
    return [tuple(x / math.hypot(*p) for x in p) for p in points], triangles


def grain(rng, directions, centre, room):
    """Points of a lumpy ellipsoid in a ball of radius `room` about the centre."""
    axes = [rng.uniform(0.72, 1.0) for _ in range(3)]
    lumps = [([rng.gauss(0, 1.6) for _ in range(3)], rng.uniform(0, 2 * math.pi), rng.uniform(0.01, 0.05)) for _ in range(5)]
    largest = 1 + sum(amplitude for _, _, amplitude in lumps)
    size = room * rng.uniform(0.86, 1.0) / largest
    turn = rng.uniform(0, 2 * math.pi)
    points = []
    for d in directions:
        r = size * (1 + sum(a * math.cos(sum(k * x for k, x in zip(wave, d)) + phase) for wave, phase, a in lumps))
        x, y, z = (r * axis * c for axis, c in zip(axes, d))
        points.append((centre[0] + x * math.cos(turn) - y * math.sin(turn), centre[1] + x * math.sin(turn) + y * math.cos(turn),
                       centre[2] + z))
    return points


def project_text(n, size, folder):
    schema = os.path.relpath(os.path.join(HERE, "..", "..", "docs", "project.schema.json"), folder)
    lines = ["# yaml-language-server: $schema=" + schema,
             "# Irregular grains in a box, and the pore space between them: %d regions. The grains are bodies; what is in none of them is the" % (n + 1),
             "# only unit of the column. Lengths are in micrometres, called metres.", "",
             "name: sediment_grains", "box: {min: [0, 0, 0], max: [%g, %g, %g]}" % (size, size, size), "surfaces:"]
    lines += ["  - {name: grain_%d, kind: body, file: surfaces/grain_%d.ts}" % (i + 1, i + 1) for i in range(n)]
    return "\n".join(lines + ["column: [pore]", "output: {directory: out, formats: [vtu]}", ""])


def main():
    parser = argparse.ArgumentParser(description="Irregular grains in a box, as a geomesh project")
    parser.add_argument("--grains", type=int, default=8)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--output", default=HERE)
    options = parser.parse_args()
    rng = random.Random(options.seed)
    per_side = next(k for k in range(1, 1000) if k ** 3 >= options.grains)
    size = CELL * per_side
    cells = [(i, j, k) for i in range(per_side) for j in range(per_side) for k in range(per_side)]
    cells = sorted(rng.sample(cells, options.grains))
    folder = os.path.join(options.output, "surfaces")
    os.makedirs(folder, exist_ok=True)
    directions, triangles = icosphere(2)
    expected = {"pore": [size ** 3]}
    for i, cell in enumerate(cells):
        room = CELL * rng.uniform(0.40, 0.47)
        shift = CELL / 2 - room - 0.01 * CELL
        centre = [CELL * (c + 0.5) + rng.uniform(-shift, shift) for c in cell]
        points = grain(rng, directions, centre, room)
        name = "grain_%d" % (i + 1)
        write_ts(os.path.join(folder, name + ".ts"), name, points, triangles)
        volume = volume_between(rounded(points), triangles, 0.0, size)
        expected[name] = [volume]
        expected["pore"][0] -= volume
    with open(os.path.join(options.output, "project.yaml"), "w", newline="\n") as file:
        file.write(project_text(options.grains, size, options.output))
    write_expected(os.path.join(options.output, "expected.json"), expected)


if __name__ == "__main__":
    main()
