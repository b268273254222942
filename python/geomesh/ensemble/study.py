# SPDX-License-Identifier: GPL-3.0-or-later
"""The study file: what is drawn, how many realisations, and from which project (docs/ensemble.md)."""
import hashlib
import os
from dataclasses import dataclass, field
from typing import Dict, List, Optional, Tuple

from ..core.errors import UsageError
from . import reader
from .draws import Fixed, Pick
from .fields import CORRELATIONS
from .project_text import ProjectText
from .values import read_value

_KEYS = ("name", "project", "realisations", "seed", "output", "mesh", "grid", "time_limit", "parameters", "surfaces", "throw",
         "set")
_SURFACE_KEYS = ("shift", "tilt", "perturbation", "file", "hold")


@dataclass
class SurfaceSpec:
    """Distributions in the study file of what displaces one surface: shift, tilt, perturbation (displace.Displacement)."""
    name: str
    kind: str
    shift: Tuple = (Fixed(0.0), Fixed(0.0), Fixed(0.0))
    tilt: Optional[Tuple] = None  # Tilt: angle in degrees, and azimuth of the side that rises.
    perturbation: Optional[Tuple] = None  # Random perturbation: its standard deviation and correlation range.
    correlation: str = "gaussian"
    file: Optional[Pick] = None
    hold: Tuple = ()  # names of wells
    hold_range: float = 0.0

    def moves(self):
        return any(d != Fixed(0.0) for d in self.shift) or self.tilt is not None or self.perturbation is not None


@dataclass
class GridSpec:
    """The grid of unit probabilities: corners, and numbers of cells along x, y, z."""
    low: Tuple
    high: Tuple
    cells: Tuple

    def spacing(self):
        return tuple((h - l) / n for l, h, n in zip(self.low, self.high, self.cells))


@dataclass
class Study:
    file: str
    name: str
    project: ProjectText
    realisations: int
    seed: int
    directory: str
    mesh: object = None  # a YAML node that replaces the mesh settings of the project
    grid: Optional[GridSpec] = None
    time_limit: float = 0.0  # time limit in seconds per realisation; 0: no limit
    parameters: Dict = field(default_factory=dict)
    surfaces: List[SurfaceSpec] = field(default_factory=list)
    throws: Dict = field(default_factory=dict)  # Distribution of the throw of each fault.
    keys: Dict = field(default_factory=dict)  # Distribution of each changed value, by its path in the project.
    digest: str = ""


def read_study(file):
    """Reads and checks a study and its project. Raises UsageError with all mistakes and their lines."""
    problems = reader.Problems(os.path.basename(file))
    node = reader.composed(file)
    if node is None:
        raise UsageError("%s: the file is empty; a study needs `project` and `realisations` at least" % file)
    root = reader.Entry(node, "", problems)
    given = dict(root.items(_KEYS))
    for key in ("project", "realisations"):
        if root.is_map() and key not in given and not any(str(k.value) == key for k, _ in node.value):
            root.mistake("`%s` is missing" % key)
    project = _project(file, given, problems)
    study = _Reading(file, given, project).study()
    study.digest = _digest(file, study)
    return study


def _project(file, given, problems):
    name = given["project"].text() if "project" in given else None
    if name is None:
        problems.tell()
        raise UsageError("%s: `project` is missing" % file)
    path = os.path.join(os.path.dirname(os.path.abspath(file)), name)
    if not os.path.isfile(path):
        given["project"].mistake("no such file: %s" % path)
        problems.tell()
    return ProjectText(path)


class _Reading:
    """Reads all keys of a study file in one pass; mistakes are collected and reported at the end."""

    def __init__(self, file, given, project):
        self._file, self._given, self._project = os.path.abspath(file), given, project
        self._parameters = {}

    def study(self):
        stem = os.path.splitext(os.path.basename(self._file))[0]
        study = Study(self._file, self._text("name", stem), self._project, self._whole("realisations", 1, 0),
                      self._whole("seed", 0, 0), self._text("output", "ensemble"))
        study.directory = os.path.join(os.path.dirname(self._file), study.directory)
        study.mesh = self._given["mesh"].node if "mesh" in self._given else None
        study.time_limit = self._positive("time_limit")
        self._parameters = study.parameters = self._read_parameters()
        study.surfaces = [self._surface(name, entry) for name, entry in self._named("surfaces", self._project.surfaces)]
        faults = {n: s for n, s in self._project.surfaces.items() if s.kind == "fault"}
        study.throws = {name: self._value(entry) for name, entry in self._named("throw", faults)}
        study.keys = self._read_keys()
        study.grid = self._grid()
        self._refuse_contradictions(study)
        next(iter(self._given.values())).problems.tell()
        return study

    def _text(self, key, default):
        return (self._given[key].text() if key in self._given else None) or default

    def _whole(self, key, least, default):
        value = self._given[key].whole(least) if key in self._given else None
        return default if value is None else value

    def _positive(self, key):
        if key not in self._given:
            return 0.0
        value = self._given[key].number()
        if value is not None and value <= 0:
            self._given[key].mistake("a positive number was expected")
        return value or 0.0

    def _value(self, entry):
        return read_value(entry, self._parameters)

    def _named(self, key, known):
        return self._given[key].items(known, {"throw": "fault", "surfaces": "surface"}[key]) if key in self._given else []

    def _read_parameters(self):
        if "parameters" not in self._given:
            return {}
        return {name: read_value(entry, {}) for name, entry in self._given["parameters"].items()}

    def _read_keys(self):
        keys = {}
        for path, entry in self._given["set"].items() if "set" in self._given else ():
            keys[path] = self._value(entry)
            complaint = self._project.complaint_about(path)
            if complaint:
                entry.mistake(complaint)
        return keys

    def _surface(self, name, entry):
        spec = SurfaceSpec(name, self._project.surfaces[name].kind)
        for key, value in entry.items(_SURFACE_KEYS):
            getattr(self, "_read_" + key)(spec, value)
        if spec.moves():
            complaint = self._project.why_not_movable(name)
            if complaint:
                entry.mistake(complaint)
        if spec.hold:
            self._check_hold(spec, entry)
        return spec

    def _read_shift(self, spec, entry):
        if not entry.is_list():
            spec.shift = (Fixed(0.0), Fixed(0.0), self._value(entry))
        elif len(entry.node.value) != 3:
            entry.mistake("three values along x, y, z were expected, or one along z")
        else:
            spec.shift = tuple(self._value(e) for e in entry.elements())

    def _read_tilt(self, spec, entry):
        found = {key: self._value(value) for key, value in entry.items(("angle", "azimuth"))}
        if "angle" not in found:
            entry.mistake("`angle` is missing (degrees)")
            return
        spec.tilt = (found["angle"], found.get("azimuth", Fixed(0.0)))

    def _read_perturbation(self, spec, entry):
        found = dict(entry.items(("sd", "range", "correlation")))
        for key in ("sd", "range"):
            if key not in found:
                entry.mistake("`%s` is missing" % key)
        if "correlation" in found:
            spec.correlation = found["correlation"].text() or ""
            if spec.correlation not in CORRELATIONS:
                found["correlation"].mistake("one of %s was expected" % ", ".join(CORRELATIONS))
        if "sd" in found and "range" in found:
            spec.perturbation = (self._value(found["sd"]), self._value(found["range"]))

    def _read_file(self, spec, entry):
        value = self._value(entry)
        if not isinstance(value, Pick):
            entry.mistake("{pick: [FILE, ...]} was expected")
            return
        for name in value.values:
            if not os.path.isfile(self._project.path(str(name))):
                entry.mistake("no such file: %s" % self._project.path(str(name)))
        spec.file = value

    def _read_hold(self, spec, entry):
        found = dict(entry.items(("wells", "range")))
        names = tuple(self._project.wells)
        if "wells" in found and found["wells"].is_list():
            names = tuple(e.text() for e in found["wells"].elements())
        elif "wells" in found and found["wells"].text() != "all":
            found["wells"].mistake("`all` or a list of wells was expected")
        for name in names:
            if name not in self._project.wells:
                entry.mistake("no such well: %s%s" % (name, reader.meant(str(name), self._project.wells)))
        spec.hold = names
        spec.hold_range = (found["range"].number() if "range" in found else None) or 0.0

    def _check_hold(self, spec, entry):
        if spec.kind != "horizon":
            entry.mistake("wells hold horizons; this is a %s" % spec.kind)
        if spec.shift[:2] != (Fixed(0.0), Fixed(0.0)):
            entry.mistake("`hold` and a shift along x or y contradict each other: a surface that stands still at wells can only "
                          "move up and down elsewhere")
        if spec.hold_range <= 0 and spec.perturbation and isinstance(spec.perturbation[1], Fixed):
            spec.hold_range = float(spec.perturbation[1].value)
        if spec.hold_range <= 0:
            entry.mistake("`hold` needs `range`, a length: how far from a well its hold is felt")

    def _grid(self):
        found = dict(self._given["grid"].items(("min", "max", "cells", "spacing"))) if "grid" in self._given else {}
        low, high = (found[key].numbers(3) if key in found else corner
                     for key, corner in zip(("min", "max"), self._project.box or (None, None)))
        if low is None or high is None:
            if "grid" in self._given:
                self._given["grid"].mistake("`min` and `max` are needed: the project's box has no corners")
            return None
        if not all(l < h for l, h in zip(low, high)):
            self._given["grid"].mistake("`min` must be below `max`")
            return None
        return GridSpec(tuple(low), tuple(high), self._cells(found, low, high))

    def _cells(self, found, low, high):
        edges = [h - l for l, h in zip(low, high)]
        if "cells" in found:
            counts = [e.whole(1) or 1 for e in found["cells"].elements()] if found["cells"].is_list() else []
            if len(counts) != 3:
                found["cells"].mistake("three whole numbers were expected")
                return (1, 1, 1)
            return tuple(counts)
        spacing = found["spacing"].number() if "spacing" in found else None
        if spacing is not None and spacing <= 0:
            found["spacing"].mistake("a positive length was expected")
            spacing = None
        if spacing is None:  # a grid of about 20,000 cells, in the proportions of the box
            return tuple(max(1, round(27 * edge / (edges[0] * edges[1] * edges[2]) ** (1 / 3))) for edge in edges)
        return tuple(max(1, round(edge / spacing)) for edge in edges)

    def _refuse_contradictions(self, study):
        for spec in study.surfaces:
            if spec.hold and study.throws:
                self._given["throw"].mistake("throws move blocks of horizons, and %s is held at wells: hold it or throw it"
                                             % spec.name)
        for name in study.throws:
            horizons = [s for s in self._project.surfaces.values() if s.kind == "horizon"]
            complaint = self._project.why_not_movable(name) or next(
                (c for c in (self._project.why_not_movable(h.name) for h in horizons) if c), None)
            if complaint:
                self._given["throw"].mistake(complaint)


def _digest(file, study):
    """Returns a hash of everything that determines a realisation. The number of realisations is not included."""
    total = hashlib.sha256()
    with open(file, encoding="utf-8") as text:
        lines = [line for line in text if not line.startswith(("realisations:", "name:", "output:", "time_limit:", "#"))]
    total.update("".join(lines).encode())
    for path in [study.project.file, *study.project.files(study)]:
        with open(path, "rb") as content:
            total.update(hashlib.sha256(content.read()).digest())
    return total.hexdigest()[:16]
