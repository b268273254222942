#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/strata.npy, a scalar field on a regular grid as implicit models give it, and the fault of the sample.

The field is the height above a fold whose axial plane leans to the east. Standard library only; the same bytes every time.
"""
import math
import os
import struct
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
import gocad_surfaces  # noqa: E402

ORIGIN, STEP, NODES = (0.0, 0.0, -1000.0), 50.0, (41, 31, 21)


def strata(x, y, z):
    """Height above a fold whose hinge leans to the east."""
    lean = x - 0.9 * (z + 500)
    return z + 500 - 170 * math.sin(lean / 260) - 40 * math.cos(y / 300)


def write_npy(path):
    header = "{'descr': '<f4', 'fortran_order': False, 'shape': (%d, %d, %d), }" % NODES
    header += " " * (-(len(header) + 11) % 64) + "\n"
    places = ([o + STEP * i for i in range(n)] for o, n in zip(ORIGIN, NODES))
    xs, ys, zs = places
    with open(path, "wb") as file:
        file.write(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode())
        for x in xs:
            for y in ys:
                file.write(struct.pack("<%df" % len(zs), *(strata(x, y, z) for z in zs)))


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    write_npy(os.path.join(folder, "strata.npy"))
    points, triangles = gocad_surfaces.sheet(8, 6, lambda u, v: (1250 + 420 * (v - 0.5), -100 + 1700 * u, -1100 + 1200 * v), 3)
    gocad_surfaces.write_ts(os.path.join(folder, "fault.ts"), "fault", points, triangles)


if __name__ == "__main__":
    main()
