#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Projects in which one number is extreme: each number of each key in turn takes the values below. A project must be meshed, or refused with a
message within ten CPU seconds; nothing may crash. A run that has no mesh after a minute is
ended, which is right only where it had told that a million elements or more would come.

    tests/fuzz/extreme_numbers.py [--every N] [--from K] [--jobs N] [FOLDER]     runs them, prints what is wrong and a count of the outcomes
    GEOMESH_SANITIZE=1 GEOMESH_PROGRAM=build/asan/bin/geomesh tests/fuzz/extreme_numbers.py --slowness 10     under sanitizers
"""
import argparse
import copy
import multiprocessing
import os
import re
import resource
import signal
import struct
import subprocess
import sys
import tempfile

PROGRAM = os.environ.get("GEOMESH_PROGRAM", "build/release/bin/geomesh")
#: YAML scalars, as a user may have typed them. F: times the number that was there.
VALUES = ["0", "-0.0", "5e-324", "1e-300", "1e-30", "1e30", "1e300", "1.7976931348623157e308", "1e400", ".nan", ".inf", "-1e300", "-1", "x", "",
          "F1e-6", "F1e6", "F-1", "F1e3", "F1e-3", "123456789012345678901234567890"]
SECONDS_TO_REFUSAL = 10
SECONDS_TO_MESH = 60
LARGE = 1e6  # elements: what a minute is too short for
OUTCOMES = {0: "meshed", 2: "refused", 3: "refused", 4: "refused"}
ENDED = {-signal.SIGXCPU: "a large mesh, ended", -signal.SIGKILL: "a large mesh, ended"}


def horizon(name, z, n=6, tilt=0.0):
    """A square of n by n points a little beyond 1,000 m, as a GOCAD surface."""
    lines = ["GOCAD TSurf 1", "HEADER {", "name: " + name, "}", "TFACE"]
    for j in range(n):
        for i in range(n):
            x, y = -37.0 + 1074.0 * i / (n - 1), -41.0 + 1082.0 * j / (n - 1)
            lines.append("VRTX %d %r %r %r" % (j * n + i + 1, x, y, z + tilt * x + 7 * ((3 * i + 5 * j) % 4)))
    for j in range(n - 1):
        for i in range(n - 1):
            a = j * n + i + 1
            lines += ["TRGL %d %d %d" % (a, a + 1, a + n + 1), "TRGL %d %d %d" % (a, a + n + 1, a + n)]
    return "\n".join(lines + ["END", ""])


def sheet(name, corners):
    lines = ["GOCAD TSurf 1", "HEADER {", "name: " + name, "}", "TFACE"]
    lines += ["VRTX %d %r %r %r" % (k + 1, *map(float, p)) for k, p in enumerate(corners)]
    return "\n".join(lines + ["TRGL 1 2 3", "TRGL 1 3 4", "END", ""])


def points(z):
    """Scattered points in columns."""
    return "x y z\n" + "".join("%r %r %r\n" % (90.0 * i + 7.0 * (j % 3), 110.0 * j + 5.0 * (i % 4), z + 3.0 * ((i * j) % 5))
                               for i in range(12) for j in range(10))


def field():
    """Heights as a scalar field on a grid, as NumPy writes it: 11 by 11 by 11 doubles."""
    head = "{'descr': '<f8', 'fortran_order': False, 'shape': (11, 11, 11), }"
    head += " " * (63 - (len(head) + 10) % 64) + "\n"
    values = [-1000.0 + 100 * k + 0.01 * i for i in range(11) for _ in range(11) for k in range(11)]
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head.encode() + struct.pack("<1331d", *values)


FILES = {"field.npy": field(), "section.txt": "300 -700\n600 -700\n600 -640\n300 -640\n", "survey.csv": "md,incl,azim\n0,0,0\n300,5,90\n600,20,90\n",
         "tops.csv": "well,horizon,depth\nw,top,270\n", "top.ts": horizon("top", -300.0, tilt=0.05), "base.ts": horizon("base", -520.0), "thin.ts": horizon("thin", -505.0, tilt=0.01),
         "fault.ts": sheet("fault", [(310, -50, 50), (360, 1050, 50), (560, 1050, -1050), (510, -50, -1050)]),
         "sand.xyz": points(-420.0), "sizes.txt": "0 0 -500 200\n1000 1000 -500 300\n",
         "well.pl": "GOCAD PLine 1\nHEADER {\nname: w\n}\nILINE\nVRTX 1 700 500 -10\nVRTX 2 710 480 -700\nSEG 1 2\nEND\n"}

BOX = {"min": [0, 0, -1000], "max": [1000, 1000, 0]}
TOP = {"name": "top", "kind": "horizon", "file": "top.ts"}
BASE = {"name": "base", "kind": "horizon", "file": "base.ts"}
THIN = {"name": "thin", "kind": "horizon", "file": "thin.ts"}
FAULT = {"name": "fault", "kind": "fault", "file": "fault.ts"}
COLUMN = ["a", "top", "b", "base", "c"]

BASES = {
    "sizes": {"box": BOX, "surfaces": [TOP, BASE, FAULT], "column": COLUMN,
              "points": [{"name": "p", "at": [500, 500, -100]}],
              "mesh": {"size": {"global": 300, "units": {"b": 200}, "surfaces": {"fault": {"size": 150, "radius": 50}},
                                "curves": {"intersections": 200}, "near": [{"at": [200, 200, -200], "size": 150, "radius": 80}],
                                "gradation": 0.3, "min": 50, "max": 400, "curvature": 40, "gap_layers": 0.4, "layers": {"b": 1}},
                       "max_elements": 50000000, "time_budget": 5, "quality": "fast"}},
    "tolerance": {"box": BOX, "surfaces": [TOP, THIN, BASE], "column": ["a", "top", "b", "thin", "d", "base", "c"],
                  "mesh": {"size": 300, "tolerance": 10, "quality": "fast"}, "rules": {"min_thickness": 5, "min_volume": 100.0}},
    "settled": {"box": BOX, "surfaces": [TOP, THIN, BASE], "column": ["a", "top", "b", "thin", "d", "base", "c"],
                "mesh": {"size": 300, "quality": "fast"}, "rules": {"min_thickness": 5}},
    "target": {"box": {"center": [500, 500], "size": [900, 900], "azimuth": 20, "bottom": -900, "top": -10}, "surfaces": [TOP, BASE],
               "column": COLUMN, "mesh": {"target_elements": 2000, "quality": "fast"}},
    "waves": {"box": {"margin": [10, 10, 10], "bottom": -1000, "top": 0}, "surfaces": [TOP, BASE], "column": COLUMN,
              "attributes": {"a": {"vp": 2000, "vs": 900.0}, "b": {"vp": 2500}, "c": {"vp": 4000}},
              "mesh": {"size": {"frequency": 2, "points_per_wavelength": 5}, "quality": "fast"}},
    "depths": {"box": BOX, "surfaces": [TOP, BASE], "column": COLUMN,
               "mesh": {"size": {"by_depth": [[100, 200], [800, 300]]}, "quality": "fast"}},
    "gridded": {"box": BOX, "surfaces": [{"name": "sand", "kind": "horizon", "file": "sand.xyz",
                                          "gridding": {"method": "minimum_curvature", "spacing": 100, "smoothing": 100.0,
                                                       "max_distance": 300}, "extend": "flat"},
                                         {**BASE, "resample": 200.0, "smooth": 2}],
                "column": ["a", "sand", "b", "base", "c"], "mesh": {"size": 300, "quality": "fast"}},
    "kept": {"box": {"polygon": [[10, 10], [990, 20], [950, 980], [30, 940]], "bottom": -900, "top": -20}, "surfaces": [TOP, BASE, FAULT],
             "column": COLUMN, "mesh": {"size": 400, "honour": "exact", "quality": "fast"}, "tolerance": 0.5,
             "rules": {"trim_overshoot": 20.0}},
    "bare": {"crs": {"z_scale": 2}, "box": BOX, "surfaces": [TOP, BASE, {**FAULT, "thickness": 20.0}], "column": COLUMN,
             "mesh": {"refine": "none", "cluster_distance": 1.0}, "wells": [{"name": "w", "file": "well.pl"}],
             "regions": [{"name": "seed", "at": [100, 100, -100]}], "output": {"formats": ["vtu"], "origin": [10, 20, 30]}},
    "written": {"box": BOX, "surfaces": [TOP, BASE, FAULT], "column": COLUMN, "wells": [{"name": "w", "file": "well.pl"}],
                "mesh": {"size": 400, "quality": "fast"},
                "output": {"formats": ["vtu"], "order": 1, "fault_zone": {"fault": {"thickness": 5.0, "layers": 2}}}},
    "network": {"box": BOX, "fractures": {"seed": 7, "corners": 8, "families": [
                    {"name": "steep", "dip_direction": 90, "dip": 80, "kappa": 20, "radius": {"min": 100, "max": 300, "exponent": 2.5}, "p32": 1e-6},
                    {"name": "flat", "dip": 5, "kappa": 50, "radius": 20, "count": 3}]},
                "merge_within": 1.0, "mesh": {"size": 300, "quality": "fast"}},
    "inputs": {"box": {"margin": 10.0, "bottom": -1000, "top": 0},
               "surfaces": [{"name": "top", "kind": "horizon", "field": "field.npy", "origin": [0, 0, -1000], "spacing": 100, "value": -300},
                            {"name": "sand", "kind": "horizon", "file": "sand.xyz", "columns": {"x": 1, "y": 2, "z": 3}, "no_data": -9999},
                            {"name": "base", "kind": "horizon", "below": "sand", "thickness": 100.0},
                            {"name": "deep", "kind": "horizon", "field": "field.npy", "origin": [0, 0, -1000], "spacing": [100, 100, 100], "value": -850},
                            {"name": "lens", "kind": "body", "file": "section.txt", "extrude": {"along": "y", "from": 200, "to": 700}}],
               "column": ["a", "top", "b", "sand", "c", "base", "d", "deep", "e"], "colours": {"a": [10, 20, 30]},
               "rules": {"continue_within": 200.0}, "mesh": {"size": 300, "surfaces_within": 15.0, "quality": "fast"},
               "output": {"formats": ["vtu", "html"]}},
    "tops": {"box": BOX, "surfaces": [{**TOP, "z_datum": 10.0, "fill_holes": 50.0}, BASE], "column": COLUMN,
             "wells": [{"name": "w", "file": "survey.csv", "head": [400, 500, -10], "columns": {"md": 1, "incl": 2, "azim": 3}, "z_datum": 5.0}],
             "tops": {"file": "tops.csv", "reach": 400.0}, "mesh": {"size": 300, "quality": "fast"},
             "output": {"formats": ["msh"], "partitions": 2}},
    "along": {"box": BOX, "surfaces": [TOP, BASE, FAULT], "column": COLUMN,
              "mesh": {"size": {"global": 300, "layers": {"b": 2}, "surfaces": {"top": 200},
                                "curves": {"intersections": {"size": 100, "radius": 50}}}, "quality": "fast"}},
    "background": {"box": BOX, "surfaces": [TOP, BASE], "column": COLUMN, "mesh": {"size": {"background": "sizes.txt"}, "quality": "fast"}},
    "domains": {"box": BOX, "surfaces": [
                    {"name": "top", "kind": "horizon", "field": "field.npy", "origin": [0, 0, -1000], "spacing": 100, "value": -300, "domain": {"block": [100, 500, -500]}},
                    {"name": "top", "kind": "horizon", "field": "field.npy", "origin": [0, 0, -1000], "spacing": 100, "value": -400, "domain": {"block": [900, 500, -500]}},
                    FAULT], "column": ["a", "top", "b"], "mesh": {"size": 300, "quality": "fast"}},
}


def numbers_in(value, path=()):
    """Paths to all numbers."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from numbers_in(inner, path + (key,))
    elif isinstance(value, list):
        for k, inner in enumerate(value):
            yield from numbers_in(inner, path + (k,))
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path


def keys_of_numbers(schema):
    """Paths of all keys that may be a number by a JSON Schema; "*" stands for any name, 0 for any item."""
    found = set()

    def walk(node, path, inside):
        if not isinstance(node, dict):
            return
        if "$ref" in node:
            name = node["$ref"].split("/")[-1]
            if name not in inside:
                walk(schema["definitions"][name], path, inside | {name})
        kinds = node.get("type", [])
        if {"number", "integer"} & set([kinds] if isinstance(kinds, str) else kinds):
            found.add(path)
        for key, inner in node.get("properties", {}).items():
            walk(inner, path + (key,), inside)
        for inner in [node.get("additionalProperties"), *node.get("patternProperties", {}).values()]:
            walk(inner, path + ("*",), inside)
        for inner in [node.get("items"), *node.get("prefixItems", [])]:
            walk(inner, path + (0,), inside)
        for word in ("oneOf", "anyOf", "allOf"):
            for inner in node.get(word, []):
                walk(inner, path, inside)
        for word in ("if", "then", "else"):
            walk(node.get(word), path, inside)

    walk(schema, (), frozenset())
    return found


def keys_not_covered(schema):
    """Those of them that are a number in none of the BASES."""
    def fits(key, path):
        return len(key) == len(path) and all(k == "*" and isinstance(p, str) or k == p or k == 0 and isinstance(p, int) for k, p in zip(key, path))

    paths = [path for project in BASES.values() for path in numbers_in(project)]
    return sorted(".".join(map(str, key)) for key in keys_of_numbers(schema) if not any(fits(key, path) for path in paths))


def written(value):
    """Flow YAML; a scalar of text is written as it is."""
    if isinstance(value, dict):
        return "{" + ", ".join("%s: %s" % (key, written(inner)) for key, inner in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(written, value)) + "]"
    return str(value)


def projects():
    """Names and texts of all projects, each with one extreme number. The extreme coordinates of files come last."""
    for base, project in BASES.items():
        for path in numbers_in(project):
            for value in VALUES:
                changed = copy.deepcopy(project)
                inner = changed
                for key in path[:-1]:
                    inner = inner[key]
                text = repr(float(value[1:]) * inner[path[-1]]) if value.startswith("F") else value
                inner[path[-1]] = text if text else "''"
                name = "%s: %s = %s" % (base, ".".join(map(str, path)), text)
                yield name, {"project.yaml": "".join("%s: %s\n" % (key, written(part)) for key, part in {"name": "m", **changed}.items())}
    plain = "".join("%s: %s\n" % (key, written(part)) for key, part in {"name": "m", **BASES["sizes"]}.items())
    gridded = "".join("%s: %s\n" % (key, written(part)) for key, part in {"name": "m", **BASES["gridded"]}.items())
    for value in VALUES:
        if not value or value.startswith("F"):
            continue
        first = FILES["top.ts"].split("\n")
        row = next(k for k, line in enumerate(first) if line.startswith("VRTX 8 "))
        words = first[row].split()
        for axis in (0, 2):
            place = list(words)
            place[2 + axis] = value
            first[row] = " ".join(place)
            yield "coordinate %d = %s" % (axis, value), {"project.yaml": plain, "top.ts": "\n".join(first)}
        yield "height in columns = %s" % value, {"project.yaml": gridded, "sand.xyz": FILES["sand.xyz"] + "512.5 497.5 %s\n" % value}


def run(files, folder, program=PROGRAM, seconds=SECONDS_TO_MESH, memory=4 << 30):
    """Exit status (negative: a signal), CPU seconds, and what was printed."""
    for name, text in {**FILES, **files}.items():
        with open(os.path.join(folder, name), "wb") as file:
            file.write(text if isinstance(text, bytes) else text.encode())

    def bound():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
        if memory:
            resource.setrlimit(resource.RLIMIT_AS, (memory, memory))

    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program, "project.yaml", "-o", "out", "--threads", "1"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, errors="replace", check=False, preexec_fn=bound)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done.returncode, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stdout


def told_elements(printed):
    """The number of elements that a run said it would make. 0: none yet."""
    found = re.search(r"elements to come: about ([\d,.]+(?:e[+]?\d+)?)", printed)
    return float(found.group(1).rstrip(".,").replace(",", "")) if found else 0


def fault_of(status, seconds, printed, slowness=1):
    """What is wrong with an outcome; empty: nothing."""
    if status in ENDED and seconds >= slowness * SECONDS_TO_MESH - 1 and told_elements(printed) >= LARGE:
        return ""
    if status not in OUTCOMES:
        return "exit %d" % status
    if "internal error" in printed or "Sanitizer" in printed or "runtime error" in printed:
        return "a bug of ours"
    if status != 0 and "error:" not in printed:
        return "no message"
    if status != 0 and seconds > slowness * SECONDS_TO_REFUSAL:
        return "%.1f s to a refusal" % seconds
    return ""


def judge(case):
    """Outcome and, where that is a fault, a line about it."""
    (k, (name, files)), folder, options = case
    memory = 0 if os.environ.get("GEOMESH_SANITIZE") else 4 << 30
    with tempfile.TemporaryDirectory() as scratch:
        seconds = int(SECONDS_TO_MESH * options.slowness)
        status, seconds, printed = run(files, folder or scratch, os.path.abspath(PROGRAM), seconds, memory)
    fault = fault_of(status, seconds, printed, options.slowness)
    if not fault:
        return {**OUTCOMES, **ENDED}[status], ""
    said = printed.strip().split("\n")
    return fault, "%d %s: %s (%.1f s): %s" % (k, name, fault, seconds, next((x for x in said if "ERROR: " in x), said[-1])[:300])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", help="where the files stay; with one job")
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--from", dest="first", type=int, default=0)
    parser.add_argument("--slowness", type=float, default=1, help="times the CPU seconds of a release build that are allowed")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    chosen = [(k, case) for k, case in enumerate(projects()) if k >= options.first and (k - options.first) % options.every == 0]
    if options.list:
        print("\n".join("%d %s" % (k, name) for k, (name, _) in chosen))
        return 0
    outcomes, wrong = {}, 0
    with multiprocessing.Pool(options.jobs) as pool:
        for outcome, line in pool.imap(judge, [(case, options.folder if options.jobs == 1 else None, options) for case in chosen]):
            outcomes[outcome] = outcomes.get(outcome, 0) + 1
            if line:
                wrong += 1
                print(line, flush=True)
    print(outcomes)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
