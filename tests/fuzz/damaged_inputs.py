#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Damaged files of the formats that libraries read (netCDF, HDF5, Shapefile, GeoPackage, GeoJSON), and of sticks of faults. Each small file is cut
short, has bytes changed, or numbers made extreme; the seeds are fixed. `geomesh info` and a project must read the file or refuse it with a message
that names it, within ten CPU seconds and 1 GB of memory; nothing may crash.

    tests/fuzz/damaged_inputs.py [--count N] [--from K] [FORMAT...]     runs N damaged files of each format, and prints what is wrong and the outcomes

A file that was found stays in the folder ./damaged_inputs.found. Without netCDF4 and h5py, or without ogr2ogr, their formats are left out.
"""
import argparse
import json
import math
import os
import random
import re
import resource
import shutil
import struct
import subprocess
import sys
import tempfile

try:
    import h5py
    import netCDF4
    import numpy
except ImportError:
    netCDF4 = None

PROGRAM = os.environ.get("GEOMESH_PROGRAM", "build/release/bin/geomesh")
SECONDS, MEMORY = 10, 1 << 30  # what a file of a few kB may take
OUTCOMES = {0: "read", 2: "refused", 3: "refused", 4: "refused"}
X0, Y0, NX, NY, STEP = 430000.0, 5800000.0, 9, 7, 500.0
STICKS = [[(X0 + 1500 + 60 * math.sin(k) + 180 * i, Y0 + 600 * k, 100 - 450.0 * i) for i in range(4)] for k in range(6)]
BOX = "name: m\nbox: {min: [430000, 5800000, -1500], max: [433000, 5803000, 0]}\nmesh: {refine: none}\n"
HORIZON = BOX + "surfaces: [{name: damaged_top, kind: horizon, file: %s}]\ncolumn: [a, damaged_top, b]\n"
FAULT = BOX + "surfaces: [{name: damaged_fault, kind: fault, file: %s}]\n"
NUMBER = re.compile(rb"-?\d+(\.\d+)?")
EXTREME_WORDS = [b"0", b"-1", b"1e300", b"-1e30", b"1e400", b"nan", b"inf", b"1e-320", b"99999999999999999999", b"", b"x", b"[", b"\xff", b"4294967296"]
EXTREME_FIELDS = [struct.pack(order + kind, value) for order in "<>" for kind, values in (
    ("I", (0, 1, 0x7fffffff, 0x80000000, 0xffffffff, 100000)), ("Q", (1 << 20, 1 << 32, 1 << 40, (1 << 63) - 1, (1 << 64) - 1)), ("H", (0xffff, 0)),
    ("d", (float("nan"), float("inf"), 1e300, -1e30, 5e-324))) for value in values]


def heights():
    x, y = X0 - 500 + STEP * numpy.arange(NX), Y0 - 500 + STEP * numpy.arange(NY + 2)
    return x, y, numpy.array([[-700 + 40 * math.sin((a - X0) / 900) + 0.01 * (b - Y0) for a in x] for b in y])


def write_netcdf(path, kind, **options):
    x, y, z = heights()
    with netCDF4.Dataset(path, "w", format=kind) as data:
        for axis, values in (("x", x), ("y", y)):
            data.createDimension(axis, len(values))
            data.createVariable(axis, "f8", (axis,))[:] = values
        v = data.createVariable("z", "f8", ("y", "x"), fill_value=-9999, **options)
        v.setncatts({"units": "m", "positive": "up", "standard_name": "altitude", "scale_factor": 1.0})
        v[:] = z


def write_netcdf_with_records(path):
    """The rows are records, whose number the file may double."""
    x, y, z = heights()
    with netCDF4.Dataset(path, "w", format="NETCDF3_CLASSIC") as data:
        data.createDimension("x", len(x))
        data.createDimension("y", None)
        data.createVariable("x", "f8", ("x",))[:] = x
        data.createVariable("y", "f8", ("y",))[:] = y
        data.createVariable("z", "f4", ("y", "x"))[:] = z


def write_hdf5(path):
    x, y, z = heights()
    with h5py.File(path, "w") as file:
        group = file.create_group("horizons")
        group["easting"], group["northing"] = x, y
        group.create_dataset("top", data=z, compression="gzip")


def write_geojson(path):
    with open(path, "w", encoding="utf-8") as file:
        json.dump({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::25832"}}, "features": [
            {"type": "Feature", "properties": {"fault": "F1", "no": k}, "geometry": {"type": "LineString", "coordinates": line}}
            for k, line in enumerate(STICKS)]}, file)


def write_by_ogr(path, driver):
    source = path + ".geojson"
    write_geojson(source)
    subprocess.run(["ogr2ogr", "-f", driver, "-a_srs", "EPSG:25832", path, source], check=True, capture_output=True)
    os.remove(source)


def write_lines(path, form):
    points = [(k, i, *p) for k, line in enumerate(STICKS) for i, p in enumerate(line)]
    rows = {"charisma": ["INLINE- %7d %7d %14.3f %14.3f %12.3f F 1 %d\n" % (100 + k, 200 + i, x, y, z, k + 1) for k, i, x, y, z in points],
            "table": ["x,y,z,stick\n"] + ["%.3f,%.3f,%.3f,%d\n" % (x, y, z, k) for k, _, x, y, z in points],
            "segments": [("" if i else "> -L%d\n" % k) + "%.3f %.3f %.3f\n" % (x, y, z) for k, i, x, y, z in points]}[form]
    with open(path, "w", encoding="utf-8") as file:
        file.write("".join(rows))


#: Each format: the file, its project, and what writes it into a folder.
FORMATS = {"segments": ("damaged_sticks.txt", FAULT, lambda path: write_lines(path, "segments")), "table": ("damaged_sticks.csv", FAULT, lambda path: write_lines(path, "table")),
           "charisma": ("damaged_sticks.txt", FAULT, lambda path: write_lines(path, "charisma"))}
if shutil.which("ogr2ogr"):
    FORMATS.update({"geojson": ("damaged_faults.geojson", FAULT, write_geojson), "geopackage": ("damaged_faults.gpkg", FAULT, lambda path: write_by_ogr(path, "GPKG")),
                    "shapefile": ("damaged_faults.shp", FAULT, lambda path: write_by_ogr(path, "ESRI Shapefile"))})
if netCDF4:
    FORMATS.update({"netcdf_classic": ("damaged_grid.nc", HORIZON, lambda path: write_netcdf(path, "NETCDF3_CLASSIC")),
                    "netcdf_5": ("damaged_grid.nc", HORIZON, lambda path: write_netcdf(path, "NETCDF3_64BIT_DATA")),
                    "netcdf_records": ("damaged_grid.nc", HORIZON, write_netcdf_with_records),
                    "netcdf_4": ("damaged_grid.nc", HORIZON, lambda path: write_netcdf(path, "NETCDF4")),
                    "netcdf_4_packed": ("damaged_grid.nc", HORIZON, lambda path: write_netcdf(path, "NETCDF4", zlib=True)),
                    "hdf5": ("damaged_grid.h5", HORIZON, write_hdf5)})


def written(name, folder):
    """The file of a format, and those beside it, as bytes by their names."""
    os.makedirs(folder)
    FORMATS[name][2](os.path.join(folder, FORMATS[name][0]))
    files = {}
    for file in sorted(os.listdir(folder)):
        with open(os.path.join(folder, file), "rb") as data:
            files[file] = data.read()
    return files


def damaged(files, name, k):
    """The k-th damage of a format's files: of one of them, which is the main one in half of the cases."""
    chance = random.Random("%s %d" % (name, k))
    main = FORMATS[name][0]
    victim = main if chance.random() < 0.5 else chance.choice(sorted(files))
    content = bytearray(files[victim])
    kind = chance.choice(("cut", "bytes", "bytes", "extreme", "extreme", "extreme", "repeat"))
    filled = [i for i, byte in enumerate(content) if byte]  # most of a GeoPackage and of HDF5 is empty
    if kind == "cut":
        del content[chance.randrange(len(content)):]
    elif kind == "repeat":
        start = chance.choice(filled)
        content[start:start] = content[start:start + chance.randrange(1, 200)]
    else:
        for _ in range(chance.choice((1, 1, 2, 5))):
            at = chance.choice(filled)
            if kind == "bytes":
                content[at] ^= 1 << chance.randrange(8)
            elif b"\0" not in files[victim]:
                numbers = list(NUMBER.finditer(bytes(content)))
                content[slice(*chance.choice(numbers).span())] = chance.choice(EXTREME_WORDS)
            else:
                field = chance.choice(EXTREME_FIELDS)
                at -= at % min(4, len(field))
                content[at:at + len(field)] = field
            filled = [i for i in filled if i < len(content)]
    return {**files, victim: bytes(content)}


def run(arguments, folder, program, bounded):
    """Exit status (negative: a signal), CPU seconds, bytes of memory, and what was printed."""
    def bound():
        resource.setrlimit(resource.RLIMIT_CPU, (60, 60))
        if bounded:
            resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))

    with tempfile.TemporaryFile() as output:
        process = subprocess.Popen([program, *arguments], cwd=folder, stdout=output, stderr=subprocess.STDOUT, preexec_fn=bound)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        return process.returncode, used.ru_utime + used.ru_stime, used.ru_maxrss * 1024, output.read().decode(errors="replace")


def fault_of(outcome, file, slowness=1):
    """What is wrong with an outcome; empty: nothing."""
    status, seconds, memory, printed = outcome
    if status not in OUTCOMES:
        return "exit %d" % status
    if "internal error" in printed or "Sanitizer" in printed or "runtime error" in printed:
        return "a bug of ours"
    if status != 0 and "error:" not in printed:
        return "no message"
    names = (os.path.splitext(file)[0], "damaged_top", "damaged_fault")  # or the project's surface of that file
    if status in (2, 3) and not any(name in printed for name in names):
        return "no message that names the file"
    if seconds > slowness * SECONDS:
        return "%.1f s" % seconds
    if slowness == 1 and memory > MEMORY:
        return "%d MB" % (memory >> 20)
    return ""


def outcomes(name, ks, folder, program=PROGRAM, slowness=1):
    """Runs the damages `ks` of a format in a folder: k, the command, the outcome, and what is wrong with it."""
    files = written(name, os.path.join(folder, name + ".whole"))
    file, project, _ = FORMATS[name]
    for k in ks:
        place = os.path.join(folder, name)
        shutil.rmtree(place, ignore_errors=True)
        os.makedirs(place)
        for title, content in {**damaged(files, name, k), "project.yaml": (project % file).encode()}.items():
            with open(os.path.join(place, title), "wb") as data:
                data.write(content)
        for arguments in (("info", file), ("project.yaml", "-o", "out", "--threads", "1")):
            outcome = run(arguments, place, program, slowness == 1)
            yield k, arguments[0], outcome, fault_of(outcome, file, slowness)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("formats", nargs="*")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--from", dest="first", type=int, default=0)
    options = parser.parse_args()
    program, wrong = os.path.abspath(PROGRAM), 0
    for name in options.formats or FORMATS:
        counts, seconds, most = {}, 0, 0
        with tempfile.TemporaryDirectory() as scratch:
            for k, command, outcome, fault in outcomes(name, range(options.first, options.first + options.count), scratch, program):
                label = fault or OUTCOMES[outcome[0]]
                counts[label] = counts.get(label, 0) + 1
                seconds, most = seconds + outcome[1], max(most, outcome[2])
                if fault:
                    wrong += 1
                    shutil.copytree(os.path.join(scratch, name), os.path.join("damaged_inputs.found", "%s_%d" % (name, k)), dirs_exist_ok=True)
                    print("%s %d %s: %s: %s" % (name, k, command, fault, outcome[3].strip().split("\n")[-1][:300]), flush=True)
        print("%s: %s, %.1f CPU s, at most %d MB" % (name, counts, seconds, most >> 20), flush=True)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
