# SPDX-License-Identifier: GPL-3.0-or-later
"""The named mesh. Arrays are read-only views of the mesh's own memory, which they keep alive."""
import json
import os
import shutil
import subprocess
import tempfile
from typing import List, NamedTuple

import numpy

from . import _geomodel
from .core.errors import UsageError


class Region(NamedTuple):
    """A rock unit, or a part of one: what tetrahedra of one `region` id fill. Volume in the unit's cube."""
    id: int
    name: str
    unit: str
    inside: List[str]
    n_tetrahedra: int
    volume: float


class Surface(NamedTuple):
    """A surface with the area of its faces in the mesh. Kinds: horizon, fault, body, box, surface."""
    id: int
    name: str
    kind: str
    area: float


class Curve(NamedTuple):
    """Kinds: intersection, border, fault_tip, well."""
    id: int
    name: str
    kind: str
    length: float


class Point(NamedTuple):
    """A named place; `vertex` is its row in `points`."""
    id: int
    name: str
    vertex: int


class Mesh:
    """A tetrahedral mesh in which regions, surfaces, curves and points have names. It has been verified exactly.

    Attributes
    ----------
    points : float64 (n, 3)
        In the project's coordinates less `shift`, z upwards.
    point_kind : uint8 (n,)
        0 input, 1 intersection, 2 added on a segment, 3 on a facet, 4 inside.
    input_vertex : int32 (n,)
        Row in the points of all surfaces one after the other; -1 where added.
    tetrahedra : uint32 (m, 4)
        Rows of points; every volume is positive.
    region : int32 (m,)
        Id of the region, from 1.
    faces : uint32 (k, 3)
        Every face on a surface, once; the normal points from minus to plus.
    face_surface, face_surface_set, face_patch : int32 (k,)
        Id of the first surface in project order; row of `surface_sets`; patch from 1.
    face_region_minus, face_region_plus : int32 (k,)
        Regions on both sides; 0 outside.
    face_source_triangle : int32 (k,)
        Row in that surface as given.
    surface_sets : list of list of int
        Ids of all surfaces that coincide in a face.
    curve_edges : uint32 (l, 2); curve_of_edge : int32 (l,)
        Edges of intersections, borders, fault tips and wells, and the id of their curve.
    cell_arrays : dict of str to float64 (m,)
        What ``cell_arrays`` asked for.
    regions, surfaces, curves, marked_points : list of Region, Surface, Curve, Point
    names : dict of int to str
        Name of every id above: regions, surfaces, curves and points share one numbering.
    statistics : dict
        The report of the run (docs/output-files.md): stages, recovery, quality, displacement.
    summary, warnings, files : list of str
    name, unit : str
    shift : (x, y, z)
        What was subtracted from the project's coordinates (``output: {origin: ...}``).
    """

    _ARRAYS = ("points", "point_kind", "input_vertex", "tetrahedra", "region", "faces", "face_surface",
               "face_surface_set", "face_patch", "face_region_minus", "face_region_plus", "face_source_triangle",
               "surface_sets", "curve_edges", "curve_of_edge", "cell_arrays", "attributes", "summary", "warnings",
               "files", "name", "unit", "shift")

    def __init__(self, result):
        self._result = result
        self._statistics = None

    def __getattr__(self, name):
        if name in Mesh._ARRAYS:
            return getattr(self._result, name)
        raise AttributeError("'Mesh' has no attribute %r" % name)

    def __dir__(self):
        return sorted(list(super().__dir__()) + list(Mesh._ARRAYS))

    def __repr__(self):
        return "<geomesh.Mesh %r: %d tetrahedra, %d points, %d regions>" % (
            self.name, len(self.tetrahedra), len(self.points), len(self.regions))

    @property
    def regions(self):
        return [Region(*r) for r in self._result.regions]

    @property
    def surfaces(self):
        return [Surface(*s) for s in self._result.surfaces]

    @property
    def curves(self):
        return [Curve(*c) for c in self._result.curves]

    @property
    def marked_points(self):
        return [Point(*p) for p in self._result.marked_points]

    @property
    def names(self):
        return {item.id: item.name
                for items in (self.regions, self.surfaces, self.curves, self.marked_points) for item in items}

    @property
    def statistics(self):
        if self._statistics is None:
            self._statistics = json.loads(self._result.report)
        return self._statistics

    def tetrahedra_of(self, region):
        """Rows of the tetrahedra of a region, or of all parts of a unit, by name or id."""
        ids = [r.id for r in self.regions if region in (r.id, r.name, r.unit)]
        if not ids:
            raise UsageError("no region is called %r; there are %s" % (region, ", ".join(r.name for r in self.regions)))
        return numpy.flatnonzero(numpy.isin(self.region, ids))

    def faces_of(self, surface):
        """Rows of the faces that a surface is part of, alone or with others, by name or id."""
        ids = [s.id for s in self.surfaces if surface in (s.id, s.name)]
        if not ids:
            raise UsageError("no surface is called %r; there are %s" % (surface, ", ".join(s.name for s in self.surfaces)))
        sets = [row for row, members in enumerate(self.surface_sets) if ids[0] in members]
        return numpy.flatnonzero(numpy.isin(self.face_surface_set, sets))

    def write(self, file):
        """Writes the mesh; the extension is the format: .vtu (and faces and curves beside it), .msh, .inp ...

        Returns the files written. Each is complete or absent. UsageError where the format is not known or the place
        cannot be written to.
        """
        stem, extension = os.path.splitext(os.fspath(file))
        if extension[1:] not in _geomodel.mesh_formats():
            raise UsageError("%s: the extension is to be one of %s; a page (html) is written by Model.run and "
                             "geomesh.run" % (file, ", ".join(_geomodel.mesh_formats())))
        return self._result.write(extension[1:], os.path.abspath(stem))

    def to_meshio(self):
        """A meshio.Mesh with tetrahedra, faces and curve edges; cell data `region`, field data with the names."""
        import meshio
        cells = [("tetra", self.tetrahedra), ("triangle", self.faces), ("line", self.curve_edges)]
        ids = [self.region, self.face_surface, self.curve_of_edge]
        kept = [i for i, (_, rows) in enumerate(cells) if len(rows) > 0]
        field_data = {}
        for items, dimension in ((self.regions, 3), (self.surfaces, 2), (self.curves, 1)):
            for item in items:
                field_data[item.name] = numpy.array([item.id, dimension])
        return meshio.Mesh(self.points, [cells[i] for i in kept], point_data={"kind": self.point_kind},
                           cell_data={"region": [ids[i] for i in kept]}, field_data=field_data)

    def to_pyvista(self):
        """A pyvista.UnstructuredGrid of the tetrahedra with cell data `region`."""
        import pyvista
        cells = numpy.empty((len(self.tetrahedra), 5), dtype=numpy.int64)  # the form that VTK asks for
        cells[:, 0] = 4
        cells[:, 1:] = self.tetrahedra
        grid = pyvista.UnstructuredGrid(cells.ravel(), numpy.full(len(cells), 10, dtype=numpy.uint8), self.points)
        grid.cell_data["region"] = self.region
        for name, values in self.cell_arrays.items():
            grid.cell_data[name] = values
        return grid

    def picture(self, file, view="cut", size=(1200, 900), **options):
        """Draws the mesh into a PNG file with the program ``geomesh picture``, which must be installed.

        Parameters
        ----------
        file : path
        view : {"regions", "cut", "exploded", "surfaces", "quality"}
        size : (width, height) in pixels
        **options
            Of ``geomesh picture``: ``azimuth``, ``elevation`` in degrees, ``zoom``, ``scale_z``.

        Raises
        ------
        UsageError
            The program is not there, or could not draw (no display and no xvfb).
        """
        words = [_program(), "picture", None, "-o", os.path.abspath(os.fspath(file)), "--view=" + view,
                 "--size=%dx%d" % tuple(size)]
        words += ["--%s=%s" % (key.replace("_", "-"), value) for key, value in options.items()]
        with tempfile.TemporaryDirectory() as folder:
            words[2] = self.write(os.path.join(folder, "mesh.vtu"))[0]
            done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            raise UsageError("no picture was drawn: " + done.stdout.strip())


def _program():
    """The program geomesh: GEOMESH_PROGRAM, that on the path, or that of the build folder this package is in."""
    built = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(_geomodel.__file__))), "bin", "geomesh")
    for program in (os.environ.get("GEOMESH_PROGRAM"), shutil.which("geomesh"), built):
        if program and os.access(program, os.X_OK):
            return program
    raise UsageError("pictures are drawn by the program geomesh, which is not on the path")
