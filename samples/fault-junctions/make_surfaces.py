#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/*.ts and expected.json of this sample: faults that cross (X), meet from above (Y) and branch downwards (lambda), all
striking north, with two horizons. Seen in a section along x all is made of straight lines, so that volumes are known. The Y and the
lambda end exactly on the fault they branch from."""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import section_area, section_strip, write_expected, write_ts  # noqa: E402

WIDTH, DEPTH, EAST = 4000.0, 3000.0, 12000.0
TOP_LOWER, TOP_BASEMENT = -1500.0, -2400.0


def on(line, z):
    """x of a straight fault at height z."""
    (x0, z0), (x1, z1) = line
    return x0 + (x1 - x0) * (z - z0) / (z1 - z0)


X1 = [(1000.0, 0.0), (3100.0, -3000.0)]
X2 = [(3200.0, 0.0), (1400.0, -3000.0)]
Y1 = [(6000.0, 0.0), (6600.0, -3000.0)]
Y2 = [(7600.0, 0.0), (6400.0, -2000.0)]       # ends on Y1
LAMBDA1 = [(10600.0, 0.0), (9400.0, -3000.0)]
LAMBDA2 = [(10200.0, -1000.0), (11400.0, -3000.0)]  # begins on LAMBDA1


def extended(line, up, down):
    """The line, longer by a fiftieth where it leaves the box (exact in whole metres)."""
    (x0, z0), (x1, z1) = line
    dx, dz = (x1 - x0) / 50, (z1 - z0) / 50
    return [(x0 - dx, z0 - dz) if up else (x0, z0), (x1 + dx, z1 + dz) if down else (x1, z1)]


def regions():
    """Sections of all regions above, between and below the horizons."""
    def at(line, z):
        return on(line, z), z
    h, d = TOP_LOWER, TOP_BASEMENT
    cross = (on(X1, -22000.0 / 13), -22000.0 / 13)
    above = [[(0, 0), at(X1, 0), at(X1, h), (0, h)],
             [at(X1, 0), at(X2, 0), at(X2, h), at(X1, h)],
             [at(X2, 0), at(Y1, 0), at(Y1, h), at(X2, h)],
             [at(Y1, 0), at(Y2, 0), at(Y2, h), at(Y1, h)],
             [at(Y2, 0), at(LAMBDA1, 0), at(LAMBDA1, h), at(Y2, h)],
             [LAMBDA2[0], at(LAMBDA2, h), at(LAMBDA1, h)],
             [at(LAMBDA1, 0), (EAST, 0), (EAST, h), at(LAMBDA2, h), LAMBDA2[0]]]
    middle = [[(0, h), at(X1, h), cross, at(X2, d), (0, d)],
              [at(X1, h), at(X2, h), cross],
              [cross, at(X1, d), at(X2, d)],
              [at(X2, h), at(Y1, h), at(Y1, d), at(X1, d), cross],
              [at(Y1, h), at(Y2, h), Y2[1]],
              [at(Y2, h), at(LAMBDA1, h), at(LAMBDA1, d), at(Y1, d), Y2[1]],
              [at(LAMBDA1, h), at(LAMBDA2, h), at(LAMBDA2, d), at(LAMBDA1, d)],
              [at(LAMBDA2, h), (EAST, h), (EAST, d), at(LAMBDA2, d)]]
    walls = [[(0, d), (0, -DEPTH)]] + [[at(f, d), at(f, -DEPTH)] for f in (X2, X1, Y1, LAMBDA1, LAMBDA2)] + [[(EAST, d), (EAST, -DEPTH)]]
    below = [[a[0], b[0], b[1], a[1]] for a, b in zip(walls, walls[1:])]
    return above, middle, below


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    lines = {"x_west": extended(X1, True, True), "x_east": extended(X2, True, True), "y_main": extended(Y1, True, True),
             "y_branch": extended(Y2, True, False), "lambda_main": extended(LAMBDA1, True, True),
             "lambda_branch": extended(LAMBDA2, False, True), "top_lower": [(-200.0, TOP_LOWER), (EAST + 200.0, TOP_LOWER)],
             "top_basement": [(-300.0, TOP_BASEMENT), (EAST + 100.0, TOP_BASEMENT)]}
    for name, line in lines.items():
        write_ts(os.path.join(folder, name + ".ts"), name, *section_strip(line, (-150.0, WIDTH + 150.0)))
    above, middle, below = regions()
    write_expected(os.path.join(HERE, "expected.json"),
                   {unit: [WIDTH * section_area(s) for s in sections]
                    for unit, sections in (("upper", above), ("lower", middle), ("basement", below))})


if __name__ == "__main__":
    main()
