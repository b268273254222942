#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/*.ts and expected.json of this sample: three folded horizons that run uncut through a salt dome with an overhang (the third example
of Cavalcanti and Mello 1999, its Figures 8 and 9, made anew). Run it from anywhere; the same files come out every time."""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import closed_of_rings, horizon, rounded, smooth_curve, write_expected, write_ts  # noqa: E402
from region_volumes import Graph, box_layers, level, volume_above  # noqa: E402

BOX = (0.0, 0.0, -5000.0), (10000.0, 8000.0, 0.0)
AXIS = (5140.0, 3890.0)  # of the dome, in the map
# Radius of the dome against height: a foot in the lowest layer, a stem, and a head that overhangs it.
FOOT, CROWN = -4630.0, -560.0
RADIUS = smooth_curve([(FOOT, 0.0), (-4560.0, 560.0), (-4330.0, 1010.0), (-4000.0, 1080.0), (-3500.0, 800.0), (-3000.0, 655.0),
                       (-2600.0, 800.0), (-2100.0, 1290.0), (-1600.0, 1690.0), (-1250.0, 1730.0), (-900.0, 1420.0), (-660.0, 790.0),
                       (CROWN, 0.0)])


def folds(level, amplitude, wavelength, azimuth, phase, drag):
    """A folded horizon: cylindrical folds with a gentle cross fold, tilted, dragged upwards beside the salt by `drag` metres."""
    cos_a, sin_a = math.cos(math.radians(azimuth)), math.sin(math.radians(azimuth))

    def height(x, y):
        along, across = x * cos_a + y * sin_a, -x * sin_a + y * cos_a
        fold = amplitude * math.sin(2 * math.pi * across / wavelength + phase)
        cross_fold = 0.4 * amplitude * math.cos(2 * math.pi * along / (1.7 * wavelength) + 2 * phase)
        distance = math.hypot(x - AXIS[0], y - AXIS[1])
        return level + fold + cross_fold - 0.012 * (x - AXIS[0]) + drag * math.exp(-(distance / 1900.0) ** 2)
    return height


def dome(s, angle):
    z = FOOT + s * (CROWN - FOOT)
    r = RADIUS(z) * (1 + 0.07 * math.cos(2 * angle + 0.4) + 0.045 * math.sin(3 * angle + z / 900.0))
    return AXIS[0] + r * math.cos(angle), AXIS[1] + r * math.sin(angle), z


def volumes(points, triangles, horizons):
    """Each layer is that of the box without the salt in it."""
    salt = [[points[v] for v in t] for t in triangles]
    whole = volume_above(salt, Graph(level(*BOX, BOX[0][2]), [(0, 1, 2), (0, 2, 3)], 2))
    above = [0.0] + [volume_above(salt, h) for h in horizons] + [whole]
    layers = [v - (below - over) for v, over, below in zip(box_layers(*BOX, horizons), above, above[1:])]
    return {"salt": [whole], **{unit: [v] for unit, v in zip(("tertiary", "chalk", "lower_cretaceous", "bunter"), layers)}}


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    horizons = {"top_chalk": folds(-1420.0, 95.0, 5300.0, 24.0, 0.7, 180.0),
                "base_chalk": folds(-2310.0, 130.0, 5900.0, 31.0, 1.5, 160.0),
                "top_bunter": folds(-3360.0, 150.0, 6400.0, 17.0, 2.9, 130.0)}
    graphs = []
    for seed, (name, height) in enumerate(horizons.items(), start=11):
        # The box is 0..10000 by 0..8000: every horizon overshoots it, each by its own amount.
        points, triangles = horizon((-170.0 - 9 * seed, 10130.0 + 7 * seed), (-140.0 - 5 * seed, 8160.0 + 11 * seed), 28, 23, height, seed)
        write_ts(os.path.join(folder, name + ".ts"), name, points, triangles)
        graphs.append(Graph(rounded(points), triangles, 2))
    axis = (AXIS[0] + 3.7, AXIS[1] - 5.2)
    points, triangles = closed_of_rings(38, 27, (*axis, FOOT), (*axis, CROWN), dome, 5)
    write_ts(os.path.join(folder, "salt.ts"), "salt", points, triangles)
    write_expected(os.path.join(HERE, "expected.json"), volumes(rounded(points), triangles, graphs))


if __name__ == "__main__":
    main()
