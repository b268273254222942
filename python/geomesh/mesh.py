# SPDX-License-Identifier: GPL-3.0-or-later
"""The named mesh. Arrays are read-only views of the mesh's own memory, which they keep alive."""
from __future__ import annotations

import json
import os
import tempfile
from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy

from . import _geomodel, handover, views
from .core.errors import UsageError
from .tables import Table

if TYPE_CHECKING:
    import numpy.typing as npt

    Doubles = npt.NDArray[numpy.float64]
    Integers = npt.NDArray[numpy.int32]
    Rows = npt.NDArray[numpy.uint32]

Path = Union[str, "os.PathLike[str]"]


class Region(NamedTuple):
    """A rock unit, or a part of one: the tetrahedra with one `region` id. The volume is in cubed units of length."""
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
    """A curve of the mesh. Kinds: intersection, border, fault_tip, well."""
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
    """A tetrahedral mesh in which regions, surfaces, curves and points have names.

    Meshes that geomesh made have been verified exactly; those of :func:`geomesh.read` are as their file has them. A
    notebook shows a mesh as a picture that can be turned. Meshes can be pickled and copied.

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
        Arrays that ``cell_arrays`` requested.
    point_arrays : dict of str to float64 (n,)
        Values at points, of meshes that were read.
    attributes : dict of str to list of float
        Numbers of units by region id - 1; NaN where a unit has none.
    groups : dict of str to list of int
        Ids of the regions of each group.
    regions, surfaces, curves, marked_points : Table of Region, Surface, Curve, Point
        Lists that print as tables; ``pandas.DataFrame(mesh.regions)`` works.
    names : dict of int to str
        Name of every id above: regions, surfaces, curves and points share one numbering.
    statistics : dict
        The report of the run (docs/output-files.md): stages, recovery, quality, displacement. Of a mesh that was read:
        the report beside it, where there is one.
    summary, warnings, files : list of str
    name, unit : str
    shift : (x, y, z)
        What was subtracted from the project's coordinates (``output: {origin: ...}``).

    Examples
    --------
    >>> import geomesh
    >>> model = geomesh.Model(box=[[0, 0, -1000], [1000, 1000, 0]], column=["upper", "top", "lower"])
    >>> _ = model.add_grid("top", [[-350, -350], [-350, -350]], spacing=1000)
    >>> mesh = model.mesh(size=500)
    >>> mesh.regions
    id  name   unit   inside  n_tetrahedra  volume
     1  upper  upper  ...
     2  lower  lower  ...
    >>> round(mesh.regions["lower"].volume)
    650000000
    """

    points: Doubles
    point_kind: npt.NDArray[numpy.uint8]
    input_vertex: Integers
    tetrahedra: Rows
    region: Integers
    faces: Rows
    face_surface: Integers
    face_surface_set: Integers
    face_patch: Integers
    face_region_minus: Integers
    face_region_plus: Integers
    face_source_triangle: Integers
    surface_sets: List[List[int]]
    curve_edges: Rows
    curve_of_edge: Integers
    cell_arrays: Dict[str, Doubles]
    point_arrays: Dict[str, Doubles]
    attributes: Dict[str, List[float]]
    groups: Dict[str, List[int]]
    summary: List[str]
    warnings: List[str]
    files: List[str]
    name: str
    unit: str
    shift: Tuple[float, float, float]

    _ARRAYS = ("points", "point_kind", "input_vertex", "tetrahedra", "region", "faces", "face_surface",
               "face_surface_set", "face_patch", "face_region_minus", "face_region_plus", "face_source_triangle",
               "surface_sets", "curve_edges", "curve_of_edge", "cell_arrays", "point_arrays", "attributes", "groups",
               "summary", "warnings", "files", "name", "unit", "shift")

    def __init__(self, result: _geomodel.JobResult) -> None:
        if not isinstance(result, _geomodel.JobResult):
            raise TypeError("a mesh comes from Model.mesh, geomesh.run or geomesh.read(FILE); found a %s" %
                            type(result).__name__)
        self._result = result
        self._statistics: Optional[Dict[str, Any]] = None
        self._png: Optional[bytes] = None

    if not TYPE_CHECKING:
        def __getattr__(self, name):
            if name in Mesh._ARRAYS:
                return getattr(self._result, name)
            raise AttributeError("'Mesh' has no attribute %r" % name)

    def __dir__(self) -> List[str]:
        return sorted(list(super().__dir__()) + list(Mesh._ARRAYS))

    def __repr__(self) -> str:
        return "<geomesh.Mesh %r: %d tetrahedra, %d points, %d regions>" % (
            self.name, len(self.tetrahedra), len(self.points), len(self.regions))

    def _repr_html_(self) -> str:
        return "<p>%s</p>%s" % (views.html.escape(repr(self)[1:-1]), self._view()._repr_html_())

    def _repr_png_(self) -> Optional[bytes]:
        """Returns a PNG picture, drawn once, for places that cannot show a page (a notebook as a PDF); None if it cannot be drawn."""
        if self._png is None:
            with tempfile.TemporaryDirectory() as folder:
                file = os.path.join(folder, "mesh.png")
                try:
                    self.picture(file, size=(900, 675))
                except UsageError:
                    return None
                with open(file, "rb") as drawn:
                    self._png = drawn.read()
        return self._png

    @property
    def regions(self) -> Table[Region]:
        return Table((Region(*r) for r in self._result.regions), Region._fields)

    @property
    def surfaces(self) -> Table[Surface]:
        return Table((Surface(*s) for s in self._result.surfaces), Surface._fields)

    @property
    def curves(self) -> Table[Curve]:
        return Table((Curve(*c) for c in self._result.curves), Curve._fields)

    @property
    def marked_points(self) -> Table[Point]:
        return Table((Point(*p) for p in self._result.marked_points), Point._fields)

    @property
    def names(self) -> Dict[int, str]:
        named: List[Tuple[int, str]] = [(r.id, r.name) for r in self.regions] + [(s.id, s.name) for s in self.surfaces]
        return dict(named + [(c.id, c.name) for c in self.curves] + [(p.id, p.name) for p in self.marked_points])

    @property
    def statistics(self) -> Dict[str, Any]:
        if self._statistics is None:
            self._statistics = dict(json.loads(self._result.report))
        return self._statistics

    def tetrahedra_of(self, region: Union[int, str]) -> npt.NDArray[numpy.intp]:
        """Returns the rows of the tetrahedra of a region, or of all parts of a unit, by name or id."""
        ids = [r.id for r in self.regions if region in (r.id, r.name, r.unit)]
        if not ids:
            raise UsageError("no region is called %r; there are %s" % (region, ", ".join(r.name for r in self.regions)))
        return numpy.flatnonzero(numpy.isin(self.region, ids))

    def faces_of(self, surface: Union[int, str]) -> npt.NDArray[numpy.intp]:
        """Returns the rows of the faces on a surface, including those shared with others, by name or id."""
        ids = [s.id for s in self.surfaces if surface in (s.id, s.name)]
        if not ids:
            raise UsageError("no surface is called %r; there are %s" % (surface, ", ".join(s.name for s in self.surfaces)))
        sets = [row for row, members in enumerate(self.surface_sets) if ids[0] in members]
        return numpy.flatnonzero(numpy.isin(self.face_surface_set, sets))

    def write(self, file: Path, *, format: Optional[str] = None, order: int = 1, split: Union[str, Sequence[str]] = (),
              **options: Any) -> List[str]:
        """Writes the mesh; the extension is the format: .vtu (and faces and curves beside it), .msh, .inp, .e ...

        Parameters
        ----------
        file : path
            An extension of docs/outputs.md, the name of a format, or .html for a page that shows the mesh.
        format : str, optional
            The format, where the extension does not say which: ``"msh22"``, ``"medit"``, ``"ogs"`` ...
        order : {1, 2}
            2: a node in the middle of every edge.
        split : str or list of str
            Surfaces along which nodes are doubled.
        **options
            Further keys of `output` in a project file: ``groups``, ``inner_faces``, ``curves``, ``cohesive``,
            ``fault_zone``, ``partitions``, ``starter``, ``fields``, ``region_array``, ``single_grid``,
            ``node_arrays``, ``compression``, ``fractures_only``.

        Returns
        -------
        list of str
            The files written. Each is complete or absent.

        Raises
        ------
        UsageError
            The format is unknown or cannot hold what the options request, or the place is not writable.
        """
        stem, extension = os.path.splitext(os.fspath(file))
        if extension == ".html":
            if format not in (None, "html") or options or order != 1 or split:
                raise UsageError("%s: a page takes no options" % file)
            return [self._view().save(file)]
        name = format or _geomodel.format_of_extension(extension) or extension[1:]
        if name not in _geomodel.mesh_formats():
            raise UsageError("%s: %r is no format; the extension is to be one of %s, or format one of %s" % (
                file, name, ", ".join(_geomodel.known_extensions()), ", ".join(_geomodel.mesh_formats())))
        options = {key: os.fspath(value) if isinstance(value, os.PathLike) else value for key, value in options.items()}
        options.update(order=order, split=[split] if isinstance(split, str) else list(split))
        return self._result.write(name, os.path.abspath(stem), options)

    def to_meshio(self) -> Any:
        """Returns a meshio.Mesh with tetrahedra, faces and curve edges, which ``write`` keeps with names in Gmsh's
        formats.

        Cell data ``region`` and ``gmsh:physical`` have the ids, field data their names, and cell and point arrays
        are included. A surface with the name of a region, such as the body ``salt``, is called ``salt.surface``,
        because meshio requires distinct names.
        """
        return handover.to_meshio(self)

    def to_pyvista(self) -> Any:
        """Returns a pyvista.MultiBlock with the blocks ``mesh``, ``surfaces``, ``curves`` and, if there are any,
        ``points``.

        ``mesh`` is an UnstructuredGrid of the tetrahedra with cell data ``region``, attributes of units and cell
        arrays, and field data ``region_ids`` and ``region_names``. ``surfaces`` and ``curves`` are MultiBlocks with a
        PolyData under each name; ``mesh_point`` and ``mesh_face`` are rows of this mesh.
        """
        return handover.to_pyvista(self)

    def _view(self, height: int = 560) -> views.View:
        return views.View(self._result.viewer_page(), height)

    def plot(self, height: int = 560) -> views.View:
        """Returns the mesh as a picture that can be rotated and cut: shown by a notebook, else opened in a browser.

        Parameters
        ----------
        height : int
            Pixels, in a notebook.

        Returns
        -------
        View
            ``.save(file)`` keeps the page.
        """
        view = self._view(height)
        if not views.is_notebook():
            view.show()
        return view

    def picture(self, file: Path, view: str = "cut", size: Tuple[int, int] = (1200, 900), **options: Any) -> None:
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
        views.draw(self._result, os.fspath(file), view, size, options)


def read(file: Path) -> Mesh:
    """Reads a mesh file of any tool, as ``geomesh convert`` and ``geomesh check`` do: .vtu, .msh, .inp, .e, .med ...

    Sets of the file become regions, surfaces, curves and points with new ids. The mesh is not verified;
    :func:`geomesh.check` does that.

    Examples
    --------
    >>> import geomesh, os, tempfile
    >>> mesh = geomesh.Model(box=[[0, 0, 0], [1, 1, 1]]).mesh()
    >>> file = mesh.write(os.path.join(tempfile.mkdtemp(), "cube.vtu"))[0]
    >>> again = geomesh.read(file)
    >>> len(again.tetrahedra) == len(mesh.tetrahedra), round(again.regions[0].volume, 12)
    (True, 1.0)

    Raises
    ------
    UsageError
        The file is not there, or its format is not read.
    InvalidInput
        The file cannot be understood.
    """
    mesh = Mesh(_geomodel.read_mesh(os.fspath(file)))
    report = os.path.splitext(os.fspath(file))[0] + ".report.json"
    if os.path.exists(report):
        with open(report, encoding="utf-8") as text:
            mesh._statistics = json.load(text)
    return mesh
