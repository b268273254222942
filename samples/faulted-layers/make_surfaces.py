#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/*.ts and expected.json of this sample: three gently folded horizons and two faults that cross each other, one of which ends inside the
model. The horizons simply cross the faults: no throw. Run it from anywhere; the same files come out every time."""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import horizon, rounded, sheet, write_expected, write_ts  # noqa: E402
from region_volumes import Graph, box_layers, in_box, layers, level, volume_above  # noqa: E402

BOX = (0.0, 0.0, -3000.0), (6000.0, 5000.0, 0.0)


def gentle(level, dip_x, dip_y, amplitude, wavelength, phase):
    """A tilted horizon with gentle folds."""
    def height(x, y):
        return (level + dip_x * (x - 3000) + dip_y * (y - 2500) + amplitude * math.sin(2 * math.pi * x / wavelength + phase)
                + 0.6 * amplitude * math.cos(2 * math.pi * y / (1.3 * wavelength) - phase))
    return height


def west_fault(u, v):
    """Strikes about north, dips east at about 70 degrees, leaves the box on four sides."""
    y, z = -230.0 + u * 5480.0, -3260.0 + v * 3420.0
    x = 2480.0 + 0.11 * (y - 2500) - 0.36 * (z + 1500) + 70 * math.sin(y / 830.0) + 25 * math.cos(z / 610.0)
    return x, y, z


def north_fault(u, v):
    """Strikes about east, dips north at about 65 degrees. Enters through the west side and ends inside, at a tip line near x = 4,700."""
    z = -3290.0 + v * 3470.0
    x = -260.0 + u * (4960.0 + 180 * math.sin(z / 700.0))
    y = 2730.0 + 0.07 * (x - 3000) - 0.45 * (z + 1500) + 60 * math.sin(x / 910.0) + 20 * math.cos(z / 500.0)
    return x, y, z


def volumes(west, north, horizons):
    """East of west_fault a unit is one region, west of it there are two: north and south of north_fault, which is whole there."""
    west_of, south_of = Graph(*west, 0), Graph(*north, 1)
    # The sides of a body are told by the way its polygons turn: a fault bounds the side that its triangles look away from.
    facing_east, facing_north = outward(west, 0), outward(north, 1)
    floor = Graph(level(*BOX, BOX[0][2]), [(0, 1, 2), (0, 2, 3)], 2)

    def regions(polygons):
        return layers(polygons, horizons, volume_above(polygons, floor))

    west_top = west_of.below([level(*BOX, BOX[1][2])])
    west_side = regions(west_top + in_box(facing_east, *BOX))
    south_west = regions(south_of.below(west_top) + south_of.below(in_box(facing_east, *BOX)) + west_of.below(in_box(facing_north, *BOX)))
    return {unit: [whole - side, south, side - south]
            for unit, whole, side, south in zip(("cover", "sand", "shale", "basement"), box_layers(*BOX, horizons), west_side, south_west)}


def outward(surface, axis):
    """The sheet's triangles, turned to look along the axis."""
    points, triangles = surface
    polygons = []
    for t in triangles:
        a, b, c = (points[v] for v in t)
        u, v = (axis + 1) % 3, (axis + 2) % 3
        looks_along = (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]) > 0
        polygons.append([a, b, c] if looks_along else [a, c, b])
    return polygons


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    horizons = {"top_sand": gentle(-640.0, 0.03, -0.02, 45.0, 3900.0, 0.3),
                "top_shale": gentle(-1310.0, 0.045, -0.015, 60.0, 4300.0, 1.1),
                "top_basement": gentle(-2180.0, 0.02, 0.03, 70.0, 4700.0, 2.2)}
    graphs = []
    for seed, (name, height) in enumerate(horizons.items(), start=21):
        points, triangles = horizon((-90.0 - 3 * seed, 6060.0 + 4 * seed), (-80.0 - 2 * seed, 5070.0 + 5 * seed), 18, 15, height, seed)
        write_ts(os.path.join(folder, name + ".ts"), name, points, triangles)
        graphs.append(Graph(rounded(points), triangles, 2))
    faults = []
    for name, (points, triangles) in (("west_fault", sheet(15, 9, west_fault, 31)), ("north_fault", sheet(14, 9, north_fault, 32))):
        write_ts(os.path.join(folder, name + ".ts"), name, points, triangles)
        faults.append((rounded(points), triangles))
    write_expected(os.path.join(HERE, "expected.json"), volumes(*faults, graphs))


if __name__ == "__main__":
    main()
