#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a random whole model smaller while one program fails on it and another one passes, for tests/corpus/models.

    tests/fuzz/minimise_model.py 860690 --light --failing OLD/bin/geomesh --folder tests/corpus/models/NAME

A failure that is mended shows no more, so the failing program is an older one, or one without the change that mended it. Wells, surfaces,
keys and triangles are deleted, by halves and then one by one, as long as it fails in the same way and the other program passes.
"""
import argparse
import os
import re
import shutil
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
from random_models import RandomModel  # noqa: E402
from run_random_models import checked_outcome  # noqa: E402


def used_alone(points, triangles):
    """The surface without points that no triangle has."""
    rows = sorted({v for t in triangles for v in t})
    new = {row: i for i, row in enumerate(rows)}
    return [points[row] for row in rows], [tuple(new[v] for v in t) for t in triangles]


class Model(RandomModel):
    """A random model with parts left out."""

    mesh = None

    def mesh_text(self):
        """As it was drawn once, because each call draws anew."""
        self.mesh = self.mesh or super().mesh_text()
        return self.mesh

    def changed(self, **parts):
        other = object.__new__(Model)
        other.__dict__.update(self.__dict__, **parts)
        other.text = other.project_text()
        return other

    def without_surface(self, k):
        name, column = self.surfaces[k][0], list(self.column)
        if name in column:
            del column[column.index(name):column.index(name) + 2]
        return self.changed(surfaces=self.surfaces[:k] + self.surfaces[k + 1:], column=column)

    def with_triangles(self, k, triangles):
        name, kind, points, _, extra = self.surfaces[k]
        return self.changed(surfaces=self.surfaces[:k] + [(name, kind, *used_alone(points, triangles), extra)] + self.surfaces[k + 1:])

    def n_triangles(self):
        return sum(len(s[3]) for s in self.surfaces)

    def smaller(self):
        """Models with one well, surface, rule or key less."""
        for k in range(len(self.wells)):
            yield self.changed(wells=self.wells[:k] + self.wells[k + 1:])
        for k in range(len(self.surfaces)):
            yield self.without_surface(k)
        for k in range(len(self.rules)):
            yield self.changed(rules=self.rules[:k] + self.rules[k + 1:])
        if self.column:
            yield self.changed(column=[])
        for k, (name, kind, points, triangles, extra) in enumerate(self.surfaces):
            if extra:
                yield self.changed(surfaces=self.surfaces[:k] + [(name, kind, points, triangles, "")] + self.surfaces[k + 1:])


class Minimiser:
    def __init__(self, failing, passing, limit, minutes):
        self.failing, self.passing, self.limit, self.end = failing, passing, limit, time.monotonic() + 60 * minutes
        self.kind = None

    def outcome(self, model, program):
        with tempfile.TemporaryDirectory() as folder:
            outcome, why = checked_outcome(model.write(folder), folder, program, self.limit)
        return outcome, re.split("[:;(]", why)[0] if outcome == "wrong" else ""

    def is_kept(self, model):
        return time.monotonic() < self.end and self.outcome(model, self.failing) == self.kind and self.outcome(model, self.passing)[0] == "passes"

    def run(self, model):
        self.kind = self.outcome(model, self.failing)
        print("%d triangles: %s %s" % (model.n_triangles(), *self.kind), flush=True)
        if self.kind[0] == "passes" or not self.is_kept(model):
            return None
        before = None
        while before != model.text + repr(model.surfaces) and time.monotonic() < self.end:
            before = model.text + repr(model.surfaces)
            model = self.without_parts(model)
            for k in range(len(model.surfaces)):
                model = self.without_triangles(model, k)
            print("%d triangles of %d surfaces" % (model.n_triangles(), len(model.surfaces)), flush=True)
        return model

    def without_parts(self, model):
        while True:
            less = next((m for m in model.smaller() if self.is_kept(m)), None)
            if less is None:
                return model
            model = less

    def without_triangles(self, model, k):
        size = len(model.surfaces[k][3]) // 2
        while size > 0:
            first = 0
            while first < len(model.surfaces[k][3]):
                triangles = model.surfaces[k][3]
                rest = triangles[:first] + triangles[first + size:]
                less = model.with_triangles(k, rest) if rest else None
                if less and self.is_kept(less):
                    model = less
                else:
                    first += size
            size //= 2
        return model


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    options.add_argument("seed", type=int)
    options.add_argument("--light", action="store_true", help="with fewer triangles and larger sizes")
    options.add_argument("--failing", required=True, help="the program that fails")
    options.add_argument("--passing", default=os.path.join(HERE, "..", "..", "build", "release", "bin", "geomesh"), help="the program that passes")
    options.add_argument("--folder", required=True, help="of the model that is left")
    options.add_argument("--limit", type=int, default=20, help="CPU seconds of one run")
    options.add_argument("--minutes", type=float, default=10, help="after which what is left is written")
    options = options.parse_args()
    model = Minimiser(options.failing, options.passing, options.limit, options.minutes).run(Model(options.seed, light=options.light))
    if model is None:
        raise SystemExit("the one program passes, or the other one does not")
    shutil.rmtree(options.folder, ignore_errors=True)
    os.makedirs(options.folder)
    model.write(options.folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
