# SPDX-License-Identifier: GPL-3.0-or-later
"""One realisation: draws what index and seed determine, meshes it and summarises it. The same call gives the same
result."""
import contextlib
import os
import signal
import time
from dataclasses import dataclass

import numpy

from .. import _geomodel
from ..core.errors import CannotMesh, Error, InternalError, Interrupted, InvalidInput, UsageError
from ..mesh import Mesh
from . import displace, unit_grid
from .draws import Draws
from .project_text import as_text, with_surface_files

_KINDS = ((UsageError, "study"), (InvalidInput, "input"), (CannotMesh, "mesh"), (InternalError, "bug"))


class OutOfTime(Exception):
    """A realisation has taken longer than the study's time_limit."""


@dataclass
class Fault:
    """A fault, and the throw drawn for it in one realisation."""
    name: str
    throw: float
    place: numpy.ndarray
    normal: numpy.ndarray


@dataclass
class Drawn:
    """The random values drawn for one realisation, and the surfaces moved by them."""
    node: object  # The project as a YAML node.
    inputs: dict  # Surfaces given in memory.
    moved: dict  # (points, triangles or None) of each moved surface by name, in the file's coordinates.
    values: dict


class Realiser:
    """Runs realisations; files are read once for all realisations of a process."""

    def __init__(self, study):
        self._study = study
        self._files = {}
        self._wells = None

    def draw(self, index):
        study, draws = self._study, Draws(self._study.seed, index, self._study.parameters)
        for name, distribution in study.parameters.items():
            draws.value("parameters." + name, distribution)
        keys = {path: draws.value("set." + path, d) for path, d in study.keys.items()}
        picked = {s.name: str(draws.value("surfaces.%s.file" % s.name, s.file)) for s in study.surfaces if s.file}
        moved = {s.name: self._displaced(s, draws, picked) for s in study.surfaces if s.moves()}
        self._throw(draws, picked, moved)
        inputs = {name: self._contents(name, picked).moved(*self._object(name, picked)[:2], points)
                  for name, (points, _) in moved.items()}
        files = {**picked, **{name: None for name in moved}}
        return Drawn(study.project.changed(study.mesh, keys, files), inputs, moved, draws.values)

    def result(self, index):
        """Returns the record of a realisation that ended, successfully or not; times are separate."""
        started = time.monotonic(), time.process_time()
        record = {"index": index, "seed": self._study.seed, "study": self._study.digest, "drawn": {}}
        drawn = None
        try:
            with _limited(self._study.time_limit):
                drawn = self.draw(index)
                record["drawn"] = drawn.values
                record.update(self._meshed(drawn))
                record["status"] = "done"
        except Interrupted:
            raise
        except (Error, OutOfTime, MemoryError) as error:
            record.update(failure_of(error))
        record["wall_s"], record["cpu_s"] = time.monotonic() - started[0], time.process_time() - started[1]
        return record, drawn

    def _meshed(self, drawn):
        options = {"threads": 1, "progress": None, "log": None, "size_function": None, "directory": None, "write": False}
        project = self._study.project
        mesh = Mesh(_geomodel.run_given(as_text(drawn.node), project.name, project.folder, drawn.inputs, options))
        units = {}
        for region in mesh.regions:
            units[region.unit] = units.get(region.unit, 0.0) + region.volume
        quality = mesh.statistics["quality"]
        record = {"units": units, "tetrahedra": len(mesh.tetrahedra), "points": len(mesh.points),
                  "warnings": list(mesh.warnings)}
        for key in ("min_dihedral", "max_dihedral", "min_radius_ratio"):
            record[key] = quality.get(key)
        if self._study.grid is not None:
            record["grid"] = unit_grid.packed(unit_grid.units_at(mesh, self._study.grid, list(units)))
        return record

    def _displaced(self, spec, draws, picked):
        points, triangles = self._elevations(spec.name, picked)
        holds = ()
        if spec.hold:
            if triangles is None:
                raise UsageError("surfaces.%s.hold: the file holds points and no triangles, so that the place of a well on the "
                                 "surface is not known; give a grid or triangles" % spec.name)
            holds = displace.picks(points, triangles, [path for name in spec.hold for path in self._paths(name)])
        points = displace.Displacement(spec, draws).of(points, triangles, holds)
        return self._as_in_file(spec.name, picked, points), triangles

    def _throw(self, draws, picked, moved):
        for name, distribution in self._study.throws.items():
            points, triangles = self._now(name, picked, moved)
            fault = Fault(name, float(draws.value("throw." + name, distribution)), points.mean(axis=0),
                          displace.mean_normal(points, triangles))
            for horizon, entry in self._study.project.surfaces.items():
                if entry.kind != "horizon":
                    continue
                points, triangles = self._now(horizon, picked, moved)
                if triangles is None:
                    raise UsageError("throw.%s: the horizon %s is given as points, whose blocks are not known" % (name, horizon))
                points = displace.throw_blocks(horizon, points, triangles, fault)
                moved[horizon] = self._as_in_file(horizon, picked, points), triangles

    def _now(self, surface, picked, moved):
        """Returns a surface (points with z upwards, triangles) with the displacements made in this realisation so far."""
        if surface not in moved:
            return self._elevations(surface, picked)
        points, triangles = moved[surface]
        return self._as_in_file(surface, picked, points), triangles

    def _contents(self, surface, picked):
        entry = self._study.project.surfaces[surface]
        return self._read(self._study.project.path(picked.get(surface, entry.file)))

    def _read(self, file):
        if file not in self._files:
            self._files[file] = _geomodel.read_given(file)
        return self._files[file]

    def _object(self, surface, picked):
        """Returns ("surface" or "points", row, points, triangles) of the surface or point set that a study's entry names."""
        contents, entry = self._contents(surface, picked), self._study.project.surfaces[surface]
        objects = [("surface", row, *item) for row, item in enumerate(contents.surfaces)]
        objects += [("points", row, name, points, None) for row, (name, points) in enumerate(contents.point_sets)]
        wanted = entry.object or surface
        named = [o for o in objects if o[2] == wanted]
        if not named and entry.object == "":
            named = objects if len(objects) == 1 else [o for o in objects if o[0] == "surface"]
        if not named or (len(named) > 1 and named[0][2] != wanted):
            raise UsageError("surfaces.%s: its file holds %s, and none is called %s: name the one you mean with `object` in the "
                             "project" % (surface, ", ".join(o[2] for o in objects) or "no surface", wanted))
        kind, row, _, points, triangles = named[0]
        return kind, row, points, triangles

    def _elevations(self, surface, picked):
        _, _, points, triangles = self._object(surface, picked)
        triangles = None if triangles is None else numpy.asarray(triangles, dtype=numpy.int64)
        return self._as_in_file(surface, picked, numpy.array(points)), triangles

    def _as_in_file(self, surface, picked, points):
        """Converts elevations to the numbers of the file, and back: depths change sign, unless the file itself declares
        them."""
        if self._study.project.z_is_depth(surface) and not self._contents(surface, picked).z_is_named:
            points = points * [1.0, 1.0, -1.0]
        return points

    def _paths(self, well):
        return [numpy.array(points) for _, points in self._read(self._study.project.wells[well]).polylines]


def failure_of(error):
    """Returns status, kind and message of the error with which a realisation failed, for the record of its result."""
    if isinstance(error, OutOfTime):
        return {"status": "failed", "failure": {"kind": "time", "message": str(error)}}
    if isinstance(error, MemoryError):
        return {"status": "failed", "failure": {"kind": "memory", "message": "out of memory"}}
    kind = next((word for type_, word in _KINDS if isinstance(error, type_)), "other")
    return {"status": "failed", "failure": {"kind": kind, "message": str(error)}}


@contextlib.contextmanager
def _limited(seconds):
    """Signal handler that raises OutOfTime in the running work, which checks for signals 20 times a second."""
    if not seconds:
        yield
        return

    def ring(*_):
        raise OutOfTime("the time_limit of %g s was over" % seconds)
    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def write_input(study, drawn, folder):
    """Writes the input of a realisation as a project that `geomesh` can mesh: project.yaml and the surfaces that moved."""
    os.makedirs(os.path.join(folder, "surfaces"), exist_ok=True)
    node = study.project.with_absolute_files(drawn.node)
    files = {}
    for row, (name, (points, triangles)) in enumerate(drawn.moved.items()):
        file = os.path.join("surfaces", "%d.%s" % (row, "csv" if triangles is None else "ts"))
        with open(os.path.join(folder, file), "w", encoding="utf-8") as out:
            out.write(_points_text(points) if triangles is None else _ts_text(name, points, triangles))
        files[name] = file
    with open(os.path.join(folder, "project.yaml"), "w", encoding="utf-8") as out:
        out.write(as_text(with_surface_files(node, files)))


def _points_text(points):
    return "".join(["x,y,z\n"] + ["%.17g,%.17g,%.17g\n" % tuple(p) for p in points.tolist()])


def _ts_text(name, points, triangles):
    lines = ["GOCAD TSurf 1", "HEADER {", "name:" + name, "}", "TFACE"]
    lines += ["VRTX %d %.17g %.17g %.17g" % (row + 1, *p) for row, p in enumerate(points.tolist())]
    lines += ["TRGL %d %d %d" % tuple(v + 1 for v in t) for t in triangles.tolist()]
    return "\n".join(lines + ["END", ""])
