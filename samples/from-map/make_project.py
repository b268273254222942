#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""From a geological map to a project: contacts, dips, thicknesses, fault traces and a terrain model, as map2loop leaves them, become
surfaces and a project.yaml. The construction and what it assumes stand in docs/model-building.md ("From a geological map").

    samples/from-map/make_project.py MAP_FOLDER OUTPUT_FOLDER
    geomesh OUTPUT_FOLDER/project.yaml

MAP_FOLDER holds geological_map_data/ (contacts.csv: points on the base of the unit named; stratigraphic_order.csv, stratigraphic_thickness.csv,
stratigraphic_orientations.csv, fault_locations.csv: pairs of points on each fault, at the ground and at depth; bbox.csv) and a terrain
model (*.tif, float32 without compression). Python's standard library only."""
import csv
import glob
import math
import os
import shutil
import statistics
import struct
import sys

SPACING, SMOOTHING = 400, 800  # m, of the gridded horizons: see `gridding` in docs/input-formats.md
FAULTS_BEYOND = 1500.0         # m in height by which faults are drawn out above the ground and below their lowest points


class Terrain:
    """Heights of the cells of a GeoTIFF."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        at, = struct.unpack_from("<I", data, 4)
        count, = struct.unpack_from("<H", data, at)
        tags = {}
        for i in range(count):
            tag, kind, n = struct.unpack_from("<HHI", data, at + 2 + 12 * i)
            letter, size = {3: ("H", 2), 4: ("I", 4), 12: ("d", 8)}.get(kind, (None, 0))
            if letter:
                where = at + 10 + 12 * i
                tags[tag] = struct.unpack_from("<%d%s" % (n, letter), data, where if n * size <= 4 else struct.unpack_from("<I", data, where)[0])
        if data[:2] != b"II" or tags[259][0] != 1 or tags[258][0] != 32:
            raise SystemExit(path + ": only little-endian float32 without compression is read here")
        self.columns, self.rows = tags[256][0], tags[257][0]
        self.step, self.corner = tags[33550][:2], tags[33922][3:5]
        strips = b"".join(data[o:o + n] for o, n in zip(tags[273], tags[279]))
        self.values = struct.unpack("<%df" % (self.columns * self.rows), strips)

    def height(self, x, y):
        """Bilinear between the cells' centres."""
        u = min(max((x - self.corner[0]) / self.step[0] - 0.5, 0), self.columns - 1.001)
        v = min(max((self.corner[1] - y) / self.step[1] - 0.5, 0), self.rows - 1.001)
        i, j = int(u), int(v)
        s, t = u - i, v - j
        at = j * self.columns + i
        a, b, c, d = self.values[at], self.values[at + 1], self.values[at + self.columns], self.values[at + self.columns + 1]
        return (1 - t) * ((1 - s) * a + s * b) + t * ((1 - s) * c + s * d)


def rows_of(folder, name):
    with open(os.path.join(folder, name)) as file:
        return list(csv.DictReader(file))


def vertical_distances(folder, units):
    """From the base of the youngest unit down to the base of each: thicknesses divided by the cosine of the unit's median dip."""
    thickness = {row[""]: float(row["thickness"]) for row in rows_of(folder, "stratigraphic_thickness.csv")}
    dips = {}
    for row in rows_of(folder, "stratigraphic_orientations.csv"):
        dips.setdefault(row["formation"], []).append(float(row["dip"]))
    distance, total = {units[0]: 0.0}, 0.0
    for unit in units[1:]:
        total += thickness[unit] / math.cos(math.radians(statistics.median(dips[unit])))
        distance[unit] = total
    return distance


def write_fault(path, name, pairs):
    """A strip between the points at the ground and those at depth, drawn out along each pair."""
    points = []
    for ground, deep in pairs:
        unit = [(g - d) / (ground[2] - deep[2]) for g, d in zip(ground, deep)]  # per metre of height
        points.append([g + FAULTS_BEYOND * e for g, e in zip(ground, unit)])
        points.append([d - FAULTS_BEYOND * e for d, e in zip(deep, unit)])
    lines = ["GOCAD TSurf 1", "HEADER {", "name:" + name, "}", "TFACE"]
    lines += ["VRTX %d %.3f %.3f %.3f" % (i + 1, *p) for i, p in enumerate(points)]
    for i in range(1, len(points) - 2, 2):
        lines += ["TRGL %d %d %d" % (i, i + 1, i + 2), "TRGL %d %d %d" % (i + 1, i + 3, i + 2)]
    with open(path, "w", newline="\n") as file:
        file.write("\n".join(lines + ["END", ""]))


def faults_of(folder):
    points = {}
    for row in rows_of(folder, "fault_locations.csv"):
        points.setdefault(row["feature_name"], []).append(tuple(float(row[k]) for k in "XYZ"))
    return {name: list(zip(p[::2], p[1::2])) for name, p in points.items()}


def main(map_folder, output):
    folder = os.path.join(map_folder, "geological_map_data")
    image, = glob.glob(os.path.join(map_folder, "*.tif"))
    terrain = Terrain(image)
    os.makedirs(os.path.join(output, "surfaces"), exist_ok=True)
    shutil.copyfile(image, os.path.join(output, "surfaces", "relief.tif"))
    contacts = rows_of(folder, "contacts.csv")
    mapped = {row["name"] for row in contacts}
    order = [row["unit name"] for row in rows_of(folder, "stratigraphic_order.csv")]
    units = [unit for unit in order if unit in mapped]
    below = vertical_distances(folder, units)
    # Every contact tells the height of one reference surface, the base of the youngest unit.
    reference = [(float(c["X"]), float(c["Y"]), terrain.height(float(c["X"]), float(c["Y"])) + below[c["name"]]) for c in contacts]
    reference = sorted({(x, y): (x, y, z) for x, y, z in reference}.values())
    entries, column = ["  - {name: relief, kind: horizon, file: surfaces/relief.tif, object: relief}"], []
    for unit in units:
        with open(os.path.join(output, "surfaces", "base_%s.csv" % unit), "w", newline="\n") as file:
            file.write("x,y,z\n" + "".join("%.3f,%.3f,%.3f\n" % (x, y, z - below[unit]) for x, y, z in reference))
        entries.append("  - {name: base_%s, kind: horizon, file: surfaces/base_%s.csv,\n     gridding: {spacing: %d, smoothing: %d, extent: box}}"
                       % (unit, unit, SPACING, SMOOTHING))
        column += [unit, "base_" + unit]
    for name, pairs in faults_of(folder).items():
        write_fault(os.path.join(output, "surfaces", name + ".ts"), name, pairs)
        entries.append("  - {name: %s, kind: fault, file: surfaces/%s.ts}" % (name, name))
    with open(os.path.join(folder, "bbox.csv")) as file:
        low, high = [[float(x) for x in line.split(",")[1:]] for line in file.read().split("\n")[:2]]
    with open(os.path.join(output, "project.yaml"), "w", newline="\n") as file:
        file.write("name: map_model\ncrs: {horizontal: epsg:28350, z: elevation, unit: m}\nbox: {min: %s, max: %s}\nsurfaces:\n%s\ncolumn: [%s, older]\n"
                   "rules: {topography: relief}\noutput: {directory: out, formats: [vtu, inp]}\n"
                   % (low, high, "\n".join(entries), ", ".join(column)))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    main(*sys.argv[1:])
