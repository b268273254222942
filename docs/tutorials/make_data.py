#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the files of docs/tutorials/data. Same files every time; the GeoTIFF needs gdal_translate and is left as it is without.

`field`: three folded horizons, and a graben between two normal faults that throw them by 60 m. The grids have the throw smeared into a
ramp, as gridding programs leave it. Wells, a salt body and a dyke are there for the examples of the other pages.
`layers`: two horizons as points. `degrees`: a terrain model and three horizons in longitude and latitude.
"""
import math
import os
import shutil
import subprocess

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "data")
XS = range(-200, 6201, 100)
YS = range(-200, 5201, 100)
THROW = 60
HALF_WIDTH_OF_RAMP = 100
DIP = 1 / math.tan(math.radians(60))


def fault_west(y, z):
    """x of the western fault, which dips to the east."""
    return 2000 + 0.12 * y + (-z - 1200) * DIP


def fault_east(y, z):
    """x of the eastern fault, which dips to the west."""
    return 4900 - 0.08 * y - (-z - 1200) * DIP


def ramp(distance):
    """0 below, 1 above, linear over the width of the ramp."""
    return min(max((distance / HALF_WIDTH_OF_RAMP + 1) / 2, 0), 1)


def horizon(depth, amplitude):
    def height(x, y):
        z = -depth + amplitude * math.cos(x / 1400) * math.cos(y / 1700)
        return z - THROW * ramp(x - fault_west(y, z)) * ramp(fault_east(y, z) - x)
    return height


HORIZONS = {"top_chalk": horizon(900, 40), "base_chalk": horizon(1250, 35), "top_bunter": horizon(1750, 30)}


def write(name, lines, folder="field"):
    os.makedirs(os.path.join(FOLDER, folder), exist_ok=True)
    with open(os.path.join(FOLDER, folder, name), "w", encoding="utf-8", newline="\n") as file:
        file.write("\n".join(lines) + "\n")


def zmap(name, height):
    """Columns from west to east, each from north to south; blank outside of an ellipse, as exported grids are."""
    def value(x, y):
        return height(x, y) if ((x - 3000) / 4100) ** 2 + ((y - 2500) / 3900) ** 2 < 1 else -9999
    lines = ["! exported horizon", "@%s, GRID, 5" % name, "12, -9999.0, , 3, 1",
             "%d, %d, %d.0, %d.0, %d.0, %d.0" % (len(YS), len(XS), XS[0], XS[-1], YS[0], YS[-1]), "0.0, 0.0, 0.0", "@"]
    for x in XS:
        values = ["%12.3f" % value(x, y) for y in reversed(YS)]
        lines += ["".join(values[i:i + 5]) for i in range(0, len(values), 5)]
    write(name + ".dat", lines)


def esri(name, height):
    """Rows from the north."""
    lines = ["ncols %d" % len(XS), "nrows %d" % len(YS), "xllcenter %d" % XS[0], "yllcenter %d" % YS[0], "cellsize 100", "NODATA_value -9999"]
    write(name + ".asc", lines + [" ".join("%.2f" % height(x, y) for x in XS) for y in reversed(YS)])


def table_in_feet(name, height):
    write(name + ".csv", ["x,y,depth_ft"] + ["%d,%d,%.1f" % (x, y, -height(x, y) / 0.3048) for y in YS for x in XS])


def gocad(name, points, triangles):
    lines = ["GOCAD TSurf 1", "HEADER {", "name:" + name, "}", "TFACE"]
    lines += ["VRTX %d %.2f %.2f %.2f" % (i, *point) for i, point in enumerate(points, 1)]
    lines += ["TRGL %d %d %d" % tuple(v + 1 for v in triangle) for triangle in triangles]
    write(name + ".ts", lines + ["END"])


def sheet(rows):
    """Points and triangles of a grid of points."""
    n = len(rows[0])
    corners = [j * n + i for j in range(len(rows) - 1) for i in range(n - 1)]
    triangles = [t for a in corners for t in ((a, a + 1, a + n + 1), (a, a + n + 1, a + n))]
    return [point for row in rows for point in row], triangles


def ball(centre, radii, n=12):
    """A closed surface: the two poles, and rings between them."""
    points = [(centre[0], centre[1], centre[2] + radii[2])]
    for i in range(1, n):
        angle = math.pi * i / n
        points += [(centre[0] + radii[0] * math.sin(angle) * math.cos(math.pi * k / n), centre[1] + radii[1] * math.sin(angle) * math.sin(math.pi * k / n),
                    centre[2] + radii[2] * math.cos(angle)) for k in range(2 * n)]
    points.append((centre[0], centre[1], centre[2] - radii[2]))
    ring = 2 * n
    triangles = [(0, 1 + k, 1 + (k + 1) % ring) for k in range(ring)]
    for i in range(n - 2):
        first = 1 + i * ring
        for k in range(ring):
            a, b = first + k, first + (k + 1) % ring
            triangles += [(a, a + ring, b + ring), (a, b + ring, b)]
    last = 1 + (n - 2) * ring
    return points, triangles + [(last + k, len(points) - 1, last + (k + 1) % ring) for k in range(ring)]


def well(name, places):
    lines = ["GOCAD PLine 1", "HEADER {", "name:" + name, "}", "ILINE"]
    lines += ["VRTX %d %g %g %g" % (i, *place) for i, place in enumerate(places, 1)]
    write(name + ".pl", lines + ["SEG %d %d" % (i, i + 1) for i in range(1, len(places))] + ["END"])


def polygon(name, fault, height):
    """The gap between the cut-offs of a fault, as a closed line in the map."""
    def place(y, side):
        return "%.1f %.1f" % (fault(y, height(fault(y, -1000), y)) + side * 1.3 * HALF_WIDTH_OF_RAMP, y)
    ys = range(-200, 5201, 200)
    write(name, [place(y, -1) for y in ys] + [place(y, 1) for y in reversed(ys)] + [place(ys[0], -1)])


def layers():
    """Two horizons as points in columns."""
    for name, height in (("top_sand", lambda x, y: -800 + 60 * math.sin(x / 900) * math.cos(y / 800)),
                         ("base_sand", lambda x, y: -1100 + 80 * math.sin(x / 1000))):
        rows = ["%d,%d,%.2f" % (x, y, height(x, y)) for x in range(0, 4001, 200) for y in range(0, 4001, 200)]
        write(name + ".csv", ["x,y,z"] + rows, "layers")


def degrees():
    """Grids of the same nodes in four formats."""
    west, south, step, columns, rows = 10.0, 48.0, 0.01, 41, 31
    nodes = [[(west + step * i, south + step * j) for i in range(columns)] for j in range(rows)]

    def esri_lines(height):
        head = ["ncols %d" % columns, "nrows %d" % rows, "xllcenter %g" % west, "yllcenter %g" % south, "cellsize %g" % step]
        return head + [" ".join("%.1f" % height(x, y) for x, y in row) for row in reversed(nodes)]

    def dip(depth):
        return lambda x, y: -depth - 2500 * (y - 48) + 60 * math.sin(15 * x)

    write("relief.asc", esri_lines(lambda x, y: 550 + 80 * math.sin(20 * x) * math.cos(25 * y)), "degrees")
    if shutil.which("gdal_translate"):
        here = os.path.join(FOLDER, "degrees")
        subprocess.run(["gdal_translate", "-q", "-ot", "Float32", "-co", "COMPRESS=DEFLATE", "-a_srs", "EPSG:4326", "relief.asc", "relief.tif"],
                       cwd=here, check=True)
    os.remove(os.path.join(FOLDER, "degrees", "relief.asc"))
    write("base_fill.asc", esri_lines(lambda x, y: 300 - 2000 * (y - 48)), "degrees")
    heights = [[dip(700)(x, y) for x, y in row] for row in nodes]
    write("base_sand.grd", ["DSAA", "%d %d" % (columns, rows), "%g %g" % (west, nodes[0][-1][0]), "%g %g" % (south, nodes[-1][0][1]),
                            "%.1f %.1f" % (min(map(min, heights)), max(map(max, heights)))]
          + [" ".join("%.1f" % h for h in row) for row in heights], "degrees")
    write("base_shale.csv", ["longitude,latitude,depth_m"] + ["%.2f,%.2f,%.1f" % (x, y, -dip(1600)(x, y)) for row in nodes for x, y in row], "degrees")


def main():
    layers()
    degrees()
    zmap("top_chalk", HORIZONS["top_chalk"])
    esri("base_chalk", HORIZONS["base_chalk"])
    table_in_feet("top_bunter", HORIZONS["top_bunter"])
    esri("relief", lambda x, y: -60 + 25 * math.sin(x / 900) * math.cos(y / 1100))
    for name, fault in (("west_fault", fault_west), ("east_fault", fault_east)):
        gocad(name, *sheet([[(fault(y, z), y, z) for z in range(-2700, 301, 500)] for y in range(-200, 5201, 600)]))
    gocad("salt", *ball((1000, 1500, -1900), (500, 500, 450)))
    gocad("dyke", *sheet([[(5300 + 0.1 * (z + 1500), y, z) for z in range(-2400, -599, 300)] for y in range(800, 4201, 400)]))
    well("W1", [(1500, 3600, 0), (1500, 3600, -2200)])
    well("W2", [(3000, 2000, 0), (3000, 2000, -800), (3250, 2300, -1500), (3600, 2700, -2100)])
    polygon("top_chalk_polygons.txt", fault_west, HORIZONS["top_chalk"])
    write("tops.csv", ["well,horizon,depth"] + ["W1,%s,%.1f" % (name, -HORIZONS[name](1500, 3600) + miss)
                                               for name, miss in (("top_chalk", 4), ("base_chalk", -3), ("top_bunter", 6))])


if __name__ == "__main__":
    main()
