#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/* and expected.json of this sample: two horizons in longitude and latitude, one as a table of points, one as a TSurf.
On the map (UTM zone 32N) they are planes, so that volumes are known."""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import gocad_head, horizon, write_expected  # noqa: E402

EAST, NORTH, WIDTH, LENGTH, DEPTH = 440000.0, 5800000.0, 6000.0, 5000.0, 2000.0  # of the box
MERIDIAN = 9.0
A, F, SCALE = 6378137.0, 1 / 298.257223563, 0.9996  # WGS84, UTM


def to_lon_lat(easting, northing):
    """The inverse transverse Mercator projection by Krueger's series (1912) in the third flattening, to its fourth power: good to a
    hundredth of a millimetre here."""
    n = F / (2 - F)
    radius = A / (1 + n) * (1 + n ** 2 / 4 + n ** 4 / 64)
    beta = (n / 2 - 2 * n ** 2 / 3 + 37 * n ** 3 / 96 - n ** 4 / 360, n ** 2 / 48 + n ** 3 / 15 - 437 * n ** 4 / 1440,
            17 * n ** 3 / 480 - 37 * n ** 4 / 840, 4397 * n ** 4 / 161280)
    xi, eta = northing / (SCALE * radius), (easting - 500000.0) / (SCALE * radius)
    xi_0 = xi - sum(b * math.sin(2 * j * xi) * math.cosh(2 * j * eta) for j, b in enumerate(beta, 1))
    eta_0 = eta - sum(b * math.cos(2 * j * xi) * math.sinh(2 * j * eta) for j, b in enumerate(beta, 1))
    conformal = math.asin(math.sin(xi_0) / math.cosh(eta_0))
    longitude = math.atan2(math.sinh(eta_0), math.cos(xi_0))
    eccentricity = math.sqrt(F * (2 - F))
    latitude = conformal
    for _ in range(10):  # converges by a factor of 150 a step
        latitude = math.asin(math.tanh(math.atanh(math.sin(conformal)) + eccentricity * math.atanh(eccentricity * math.sin(latitude))))
    return MERIDIAN + math.degrees(longitude), math.degrees(latitude)


def plane(z, east_slope, north_slope):
    """A height over the map, `z` at the middle of the box."""
    return lambda x, y: z + east_slope * (x - EAST - WIDTH / 2) + north_slope * (y - NORTH - LENGTH / 2)


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    x_range, y_range = (EAST - 400, EAST + WIDTH + 400), (NORTH - 400, NORTH + LENGTH + 400)
    points, _ = horizon(x_range, y_range, 8, 7, plane(-600.0, 0.02, -0.01), seed=1)
    with open(os.path.join(folder, "top_sand.csv"), "w", newline="\n") as file:
        file.write("longitude,latitude,depth_m\n")
        for x, y, z in points:
            file.write("%.10f,%.10f,%.6f\n" % (*to_lon_lat(x, y), -z))
    points, triangles = horizon(x_range, y_range, 6, 6, plane(-1100.0, -0.03, 0.02), seed=2)
    lines = gocad_head("TSurf", "base_sand") + ["TFACE"]
    lines += ["VRTX %d %.10f %.10f %.6f" % (i + 1, *to_lon_lat(x, y), z) for i, (x, y, z) in enumerate(points)]
    lines += ["TRGL %d %d %d" % (a + 1, b + 1, c + 1) for a, b, c in triangles]
    with open(os.path.join(folder, "base_sand.ts"), "w", newline="\n") as file:
        file.write("\n".join(lines + ["END", ""]))
    area = WIDTH * LENGTH
    write_expected(os.path.join(HERE, "expected.json"), {"cover": [600 * area], "sand": [500 * area], "basement": [(DEPTH - 1100) * area]})


if __name__ == "__main__":
    main()
