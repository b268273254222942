#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a whole model smaller while one program fails on it and another one passes, for tests/corpus/models.

    tests/fuzz/minimise_model.py 860690 --light --failing OLD/bin/geomesh --folder tests/corpus/models/NAME
    tests/fuzz/minimise_model.py 3105 --options --failing OLD/bin/geomesh --folder ...      of the random options
    tests/fuzz/minimise_model.py some/folder --failing OLD/bin/geomesh --folder ...         of a project and its surfaces
    tests/fuzz/minimise_model.py some/folder --regions ...      fails where it has other regions than the passing program's

A failure that is mended shows no more, so the failing program is an older one, or one without the change that mended it. Wells, surfaces,
keys and triangles are deleted, by halves and then one by one, and edges are contracted, as long as it fails in the same way and the other
program passes. Only surfaces in the form of the random models (GOCAD TSurf) lose triangles. With `--regions`, the passing program's regions
and their volumes are written beside the project, and the test of the corpus expects them.
"""
import argparse
import copy
import json
import os
import re
import shutil
import sys
import tempfile
import time

import yaml

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
from gocad_files import read_surface, write_project, write_surface  # noqa: E402
from random_models import RandomModel  # noqa: E402
from random_options import RandomOptions  # noqa: E402
from run_random_models import checked_outcome  # noqa: E402

SIMPLEST_MESH = {"mode": "constrained", "refine": "none"}
SIMPLEST_OUTPUT = {"directory": "out", "formats": ["vtu"]}


def used_alone(points, triangles):
    """The surface without points that no triangle has."""
    rows = sorted({v for t in triangles for v in t})
    new = {row: i for i, row in enumerate(rows)}
    return [points[row] for row in rows], [tuple(new[v] for v in t) for t in triangles]


def inline(value):
    """As YAML in one line; numbers as Python prints them, which keeps every digit."""
    return yaml.safe_dump(value, default_flow_style=True, width=10 ** 6, sort_keys=False).replace("\n...", "").strip()


def without_name(value, name):
    """The part of a project without entries that are this name, or a column without the horizon and the unit below it."""
    if isinstance(value, list):
        return [without_name(entry, name) for entry in value if entry != name]
    if isinstance(value, dict):
        return {key: without_name(entry, name) for key, entry in value.items() if key != name and entry != name}
    return value


class Model:
    """A project with its surfaces (points, triangles) by file name, and the files of its wells."""

    def __init__(self, folder):
        with open(os.path.join(folder, "project.yaml"), encoding="utf-8") as file:
            text = file.read()
        # Random options are in JSON, whose numbers as 1e-06 are no numbers in YAML 1.1.
        self.project = json.loads(text) if text.startswith("{") else yaml.safe_load(text)
        self.folder, self.surfaces = folder, {}
        for entry in self.project["surfaces"]:
            if entry["file"].endswith(".ts"):
                self.surfaces[entry["file"]] = read_surface(os.path.join(folder, entry["file"]))

    def text(self):
        lines = []
        for key, value in self.project.items():
            if key in ("surfaces", "wells") and value:
                lines += [key + ":"] + ["  - " + inline(entry) for entry in value]
            else:
                lines.append("%s: %s" % (key, inline(value)))
        return "\n".join(lines) + "\n"

    def write(self, folder):
        """Returns the project file."""
        os.makedirs(folder, exist_ok=True)
        for name in sorted({entry["file"] for key in ("surfaces", "wells") for entry in self.project.get(key, [])}):
            if name in self.surfaces:
                write_surface(folder, os.path.splitext(name)[0], *self.surfaces[name])
            else:
                shutil.copy(os.path.join(self.folder, name), folder)
        return write_project(folder, self.text())

    def changed(self, project=None, surfaces=None):
        other = copy.copy(self)
        other.project, other.surfaces = project or self.project, surfaces or self.surfaces
        return other

    def with_surface(self, name, points, triangles):
        return self.changed(surfaces={**self.surfaces, name: used_alone(points, triangles)})

    def n_triangles(self):
        return sum(len(self.surfaces[entry["file"]][1]) for entry in self.project["surfaces"] if entry["file"] in self.surfaces)

    def without_surface(self, k):
        project = copy.deepcopy(self.project)
        name = project["surfaces"].pop(k)["name"]
        column = project.get("column", [])
        if name in column:
            del column[column.index(name):column.index(name) + 2]
        return self.changed({key: without_name(value, name) for key, value in project.items()})

    def smaller(self):
        """Models with one surface, well, key or entry of a list less, and with the simplest mesh and output."""
        for key, simplest in (("mesh", SIMPLEST_MESH), ("output", SIMPLEST_OUTPUT)):
            if self.project.get(key) != simplest:
                yield self.changed({**self.project, key: dict(simplest)})
        for k in range(len(self.project["surfaces"])):
            yield self.without_surface(k)
        for path in self.paths_of_keys(self.project, ()):
            project = copy.deepcopy(self.project)
            parent = project
            for step in path[:-1]:
                parent = parent[step]
            del parent[path[-1]]
            yield self.changed(project)

    @staticmethod
    def paths_of_keys(value, path):
        needed = ("name", "kind", "file", "surfaces", "directory", "formats")
        entries = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
        for key, entry in entries:
            is_number = isinstance(value, list) and not isinstance(entry, (dict, list, str))
            if key not in needed and not is_number and path != ("surfaces",) and path != ("column",):
                yield (*path, key)
            yield from Model.paths_of_keys(entry, (*path, key))


def regions_of(folder):
    """Volumes by name, from the report of a run."""
    with open(os.path.join(folder, "out", "model.report.json"), encoding="utf-8") as file:
        return {region["name"]: region["volume"] for region in json.load(file)["regions"]}


def are_alike(some, others):
    share = 0.01  # of the volume of the model
    return set(some) == set(others) and all(abs(some[name] - others[name]) < share * sum(some.values()) for name in some)


class Minimiser:
    def __init__(self, failing, passing, limit, minutes, by_regions=False):
        self.failing, self.passing, self.limit, self.end = failing, passing, limit, time.monotonic() + 60 * minutes
        self.by_regions, self.kind, self.regions = by_regions, None, {}

    def outcome(self, model, program):
        with tempfile.TemporaryDirectory() as folder:
            outcome, why = checked_outcome(model.write(folder), folder, program, self.limit, options=True)
            self.regions = regions_of(folder) if self.by_regions and outcome in ("passes", "wrong") else {}
        return outcome, re.split("[:;(]", why)[0] if outcome == "wrong" else ""

    def is_kept(self, model):
        if time.monotonic() > self.end or self.outcome(model, self.failing) != self.kind:
            return False
        of_failing = self.regions
        return self.outcome(model, self.passing)[0] == "passes" and (not self.by_regions or not are_alike(of_failing, self.regions))

    def run(self, model):
        self.kind = self.outcome(model, self.failing)
        print("%d triangles: %s %s" % (model.n_triangles(), *self.kind), flush=True)
        if (self.kind[0] == "passes" and not self.by_regions) or not self.is_kept(model):
            return None
        before = None
        while before != (model.text(), model.surfaces) and time.monotonic() < self.end:
            before = model.text(), model.surfaces
            model = self.without_parts(model)
            for name in [entry["file"] for entry in model.project["surfaces"] if entry["file"] in model.surfaces]:
                model = self.without_triangles(self.with_fewer_points(model, name), name)
            print("%d triangles of %d surfaces" % (model.n_triangles(), len(model.project["surfaces"])), flush=True)
        return model

    def without_parts(self, model):
        while True:
            less = next((m for m in model.smaller() if self.is_kept(m)), None)
            if less is None:
                return model
            model = less

    def without_triangles(self, model, name):
        size = len(model.surfaces[name][1]) // 2
        while size > 0:
            first = 0
            while first < len(model.surfaces[name][1]):
                points, triangles = model.surfaces[name]
                rest = triangles[:first] + triangles[first + size:]
                less = model.with_surface(name, points, rest) if rest else None
                if less and self.is_kept(less):
                    model = less
                else:
                    first += size
            size //= 2
        return model

    def with_fewer_points(self, model, name):
        """Contracts edges that share no vertex, each to one of its ends: half of them at once, then fewer."""
        size = len(model.surfaces[name][0]) // 3
        while size > 0:
            points, triangles = model.surfaces[name]
            edges = [edge for t in triangles for edge in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))]
            edges = edges if size == 1 else apart(edges)
            edges = list(dict.fromkeys(edges + [(b, a) for a, b in edges]))
            for first in range(0, len(edges), size):
                onto = {a: b for a, b in apart(edges[first:first + size])}
                moved = [tuple(onto.get(v, v) for v in t) for t in triangles]
                moved = [t for t in moved if len(set(t)) == 3]
                less = model.with_surface(name, points, moved) if moved else None
                if less and self.is_kept(less):
                    model = less
                    break
            else:
                size //= 2
        return model


def apart(edges):
    """Edges of the list that share no vertex with those before."""
    used, kept = set(), []
    for edge in edges:
        if used.isdisjoint(edge):
            kept.append(edge)
            used.update(edge)
    return kept


def model_of(options):
    if os.path.isdir(options.model):
        return Model(options.model)
    maker = RandomOptions if options.options else RandomModel
    folder = tempfile.mkdtemp()
    maker(int(options.model), options.as_default, options.light or options.options).write(folder)
    return Model(folder)


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    options.add_argument("model", help="seed, or folder of a project.yaml")
    options.add_argument("--light", action="store_true", help="with fewer triangles and larger sizes")
    options.add_argument("--as-default", action="store_true", help="with `mesh: {size: L}` in place of the modes")
    options.add_argument("--options", action="store_true", help="with random keys of the project file (random_options.py)")
    options.add_argument("--regions", action="store_true", help="it fails where names or volumes of its regions are others")
    options.add_argument("--failing", required=True, help="the program that fails")
    options.add_argument("--passing", default=os.path.join(HERE, "..", "..", "build", "release", "bin", "geomesh"), help="the program that passes")
    options.add_argument("--folder", required=True, help="of the model that is left")
    options.add_argument("--limit", type=int, default=20, help="CPU seconds of one run")
    options.add_argument("--minutes", type=float, default=10, help="after which what is left is written")
    options = options.parse_args()
    minimiser = Minimiser(options.failing, options.passing, options.limit, options.minutes, options.regions)
    model = minimiser.run(model_of(options))
    if model is None:
        raise SystemExit("the one program passes, or the other one does not")
    shutil.rmtree(options.folder, ignore_errors=True)
    model.write(options.folder)
    if options.regions:
        minimiser.outcome(model, options.passing)
        with open(os.path.join(options.folder, "regions.json"), "w", encoding="utf-8") as file:
            file.write(json.dumps(minimiser.regions, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
