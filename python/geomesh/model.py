# SPDX-License-Identifier: GPL-3.0-or-later
"""Models made in Python, and project files. Keys of the project file are keyword arguments with the same names."""
from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy

from . import _geomodel, inputs
from .core.errors import UsageError
from .mesh import Mesh
from .progress import Progress, end_progress, progress_of

if TYPE_CHECKING:
    import numpy.typing as npt

Path = Union[str, "os.PathLike[str]"]
Log = Callable[[str, str], None]
SizeFunction = Callable[[float, float, float], float]
Size = Union[float, SizeFunction, Dict[str, Any], None]

_SIDES = ("min", "max")


def _plain(value: Any) -> Any:
    """Converts numpy's numbers and arrays, tuples and paths to types that JSON can hold."""
    if isinstance(value, dict):
        return {str(k): _plain(v) for k, v in value.items()}
    if isinstance(value, numpy.ndarray):
        return _plain(value.tolist())
    if isinstance(value, (list, tuple)):
        return [_plain(v) for v in value]
    if isinstance(value, numpy.generic):
        return value.item()
    if isinstance(value, os.PathLike):
        return os.path.abspath(os.fspath(value))
    return value


def _run_options(threads: int, progress: Optional[Progress], log: Optional[Log], size_function: Optional[SizeFunction] = None,
                 directory: Optional[Path] = None, write: bool = False) -> Dict[str, Any]:
    return {"threads": int(threads), "progress": progress, "log": log, "size_function": size_function,
            "directory": None if directory is None else os.path.abspath(os.fspath(directory)), "write": write}


def _drawing(progress: Union[bool, Progress, None], run: Callable[[Optional[Progress]], Mesh]) -> Mesh:
    """Runs work with the requested display of progress, and closes the display whatever happens."""
    shown = progress_of(progress)
    finished = False
    try:
        mesh = run(shown)
        finished = True
        return mesh
    finally:
        end_progress(shown, finished)


class Model:
    """An earth model in memory: surfaces, wells, rules and a volume.

    Parameters
    ----------
    box : array_like, shape (2, 3), or dict, optional
        Least and greatest corner of the model volume; or the `box` of a project file, such as ``{"margin": 500}``.
    name : str
        Of the model, and of files written by :meth:`run`.
    column : list of str, optional
        Unit, horizon, unit, ..., unit, youngest first: names the regions.
    **keys
        Further keys of a project file (docs/project-file.md), as dicts and lists: ``crs``, ``rules``, ``regions``,
        ``groups``, ``attributes``, ``merge_within``, ``output``.

    Raises
    ------
    UsageError
        From :meth:`mesh` and :meth:`run`: an unknown key or name, with all mistakes at once.

    Examples
    --------
    >>> import geomesh
    >>> model = geomesh.Model(box=[[0, 0, -2000], [4000, 4000, 0]], column=["upper", "top", "lower"])
    >>> model.add_surface("top", [[-100, -100, -900], [4100, -100, -900], [4100, 4100, -1100], [-100, 4100, -1100]],
    ...                   [[0, 1, 2], [0, 2, 3]])
    <geomesh.Model 'model': 1 surface>
    >>> mesh = model.add_well("W1", [[2000, 2000, 0], [2000, 2000, -1500]]).mesh(size=1000)
    >>> [region.name for region in mesh.regions], [curve.name for curve in mesh.curves if curve.kind == "well"]
    (['upper', 'lower'], ['W1'])
    """

    def __init__(self, box: Union[npt.ArrayLike, Dict[str, Any], None] = None, name: str = "model",
                 column: Optional[Sequence[str]] = None, **keys: Any) -> None:
        self._keys: Dict[str, Any] = {"name": str(name)}
        if box is not None:
            self._keys["box"] = box if isinstance(box, dict) else self._box(box)
        self.column: List[str] = list(column) if column else []
        self._keys.update(keys)
        self._surfaces: List[Dict[str, Any]] = []
        self._wells: List[Dict[str, Any]] = []
        self._points: List[Dict[str, Any]] = []
        self._given: Dict[str, _geomodel.Given] = {}
        self._fields: Dict[str, Any] = {}
        self._functions: Dict[int, Any] = {}
        self._grids: Dict[str, Tuple[Any, ...]] = {}  # arguments of _geomodel.grid for each grid, kept for pickling

    def __repr__(self) -> str:
        counts = [(len(self._surfaces), "surface"), (len(self._wells), "well"), (len(self._points), "point")]
        words = ["%d %s%s" % (n, word, "" if n == 1 else "s") for n, word in counts if n or word == "surface"]
        return "<geomesh.Model %r: %s>" % (self._keys["name"], ", ".join(words))

    def __getstate__(self) -> Dict[str, Any]:
        """Returns the model's state with its inputs as arrays, for pickling and copying."""
        state = dict(self.__dict__)
        state["_given"] = {name: _arrays_of_given(given) for name, given in self._given.items()
                           if name not in self._grids}
        return state

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._given = {name: getattr(_geomodel, kind)(name, *arrays) for name, (kind, *arrays) in state["_given"].items()}
        for name, arguments in self._grids.items():
            self._given[name] = _geomodel.grid(name, *arguments)

    @staticmethod
    def _box(box: npt.ArrayLike) -> Dict[str, Any]:
        corners = numpy.asarray(box, dtype=float)
        if corners.shape != (2, 3):
            raise UsageError("box: [[x0, y0, z0], [x1, y1, z1]] was expected, found shape %s" % (corners.shape,))
        return dict(zip(_SIDES, corners.tolist()))

    def add_surface(self, name: str, points: Any, triangles: Optional[npt.ArrayLike] = None, *, kind: str = "horizon",
                    **rules: Any) -> Model:
        """Adds a surface.

        Parameters
        ----------
        name : str
        points : array_like, shape (n, 3); or a path; or an object
            Without triangles the points become a surface over the map (key `gridding`). A path is a file of any
            format of docs/input-formats.md. Objects of PyVista, meshio, VTK, GemPy, LoopStructural and trimesh are
            understood by their attributes; vertices of theirs that are NaN, as isosurfaces have them, are dropped with
            their triangles. The arrays are copied once, when the model keeps them.
        triangles : integer array, shape (m, 3), optional
            Rows of points. The rows are those of ``mesh.face_source_triangle``.
        kind : {"horizon", "fault", "body"}
        **rules
            Keys of an entry of `surfaces` in a project file: ``extend``, ``fill_holes``, ``cuts``, ``base``,
            ``throw_at``, ``gridding``, ``resample``, ``smooth``, ``crs``, ``z`` ...

        Raises
        ------
        InvalidInput
            A coordinate that is not finite, or a triangle that names no point.
        UsageError
            An array of another shape.
        """
        entry = {"name": name, "kind": kind}
        if inputs.is_path(points):
            if triangles is not None:
                raise UsageError("%s: a file was given, and triangles too" % name)
            entry["file"] = os.path.abspath(os.fspath(points))
        else:
            if triangles is None and not isinstance(points, numpy.ndarray) and not _is_rows(points):
                points, triangles = inputs.without_nan(*inputs.arrays_of(points))
            points = inputs.as_points(points)
            self._given[name] = (_geomodel.point_set(name, points) if triangles is None else
                                 _geomodel.surface(name, points, inputs.as_triangles(triangles)))
        self._add_entry(self._surfaces, entry, rules)
        return self

    def add_grid(self, name: str, heights: npt.ArrayLike, origin: Sequence[float] = (0.0, 0.0),
                 spacing: Union[float, Sequence[float]] = (1.0, 1.0), *, rotation: float = 0.0, kind: str = "horizon",
                 **rules: Any) -> Model:
        """Adds a surface given by heights at the nodes of a regular grid.

        Parameters
        ----------
        heights : array_like, shape (rows, columns)
            Height of the node at ``x = x0 + column * dx``, ``y = y0 + row * dy``; NaN where there is none.
        origin : (x0, y0)
            The node of row 0, column 0.
        spacing : (dx, dy), or one number
            dy may be negative, as in rasters with the north on top; dx too, where columns run westwards.
        rotation : float
            Degrees counter-clockwise about the origin.
        kind, **rules
            As of :meth:`add_surface`.
        """
        heights = numpy.asarray(heights, dtype=numpy.float64)
        if heights.ndim != 2:
            raise UsageError("%s: heights of a grid are an array of shape (rows, columns)" % name)
        arguments = _grid_arguments(name, heights, origin, spacing, float(rotation))
        self._given[name] = _geomodel.grid(name, *arguments)
        self._grids[name] = arguments
        self._add_entry(self._surfaces, {"name": name, "kind": kind}, rules)
        return self

    def add_field(self, name: str, field: Any, value: float, *, kind: str = "horizon",
                  domain: Optional[Dict[str, Any]] = None, **rules: Any) -> Model:
        """Adds the surface on which a scalar field has one value.

        Parameters
        ----------
        name : str
        field : callable, or a path
            ``field(x, y, z)`` of three arrays of one length gives an array of that length; it must have a finite value
            everywhere in the model's box, which is needed. A path is a grid (.vti, .npy) or tetrahedra (.vtu).
            Surfaces of the same function, or of the same file, come from one mesh and never cross.
        value : float
        domain : dict, optional
            Where the field holds: ``{"above": names, "below": names}`` of horizons and faults, or ``{"block": (x, y, z)}``, a
            place in its fault block. The surface is cut off there. A horizon is added once for each of its fields,
            under one name; the function must have values beyond the domain, too.
        kind, **rules
            As of :meth:`add_surface`, with the first field of a name; ``array``, ``origin`` and ``spacing`` for files.

        Notes
        -----
        The surface is refined until it is within a quarter of ``mesh.surfaces_within`` of the field's own: proven for grids
        and tetrahedra, found at 20,000 samples for functions, which may hide features smaller than a fiftieth of the
        box.

        Raises
        ------
        InvalidInput
            From :meth:`mesh` and :meth:`run`: the function fails or gives a value that is not finite, or the field does
            not take the value in the box.
        """
        entry = {"name": name, "kind": kind, "value": float(value)}
        if domain is not None:
            entry["domain"] = domain
        n_before = sum(1 for other in self._surfaces if other["name"] == name)
        if inputs.is_path(field):
            entry["field"] = os.path.abspath(os.fspath(field))
        elif callable(field):
            self._fields[name if n_before == 0 else "%s\n%d" % (name, n_before + 1)] = self._functions.setdefault(id(field), inputs.field_of(name, field))
        else:
            raise UsageError("%s: a function of x, y, z or a file was expected" % name)
        self._add_entry(self._surfaces, entry, rules)
        return self

    def add_well(self, name: str, path: Any, **keys: Any) -> Model:
        """Adds a well: an array of shape (n, 3) with points along it, or a file. It becomes a curve of the mesh."""
        entry = {"name": name}
        if inputs.is_path(path):
            entry["file"] = os.path.abspath(os.fspath(path))
        else:
            self._given[name] = _geomodel.polyline(name, inputs.as_points(path))
        self._add_entry(self._wells, entry, keys)
        return self

    def add_point(self, name: str, at: Sequence[float]) -> Model:
        """Adds a named place (x, y, z), which becomes a vertex of the mesh."""
        self._points.append({"name": name, "at": [float(v) for v in at]})
        return self

    @staticmethod
    def _add_entry(entries: List[Dict[str, Any]], entry: Dict[str, Any], keys: Dict[str, Any]) -> None:
        for key in keys:
            if key in entry:
                raise UsageError("%s: %s is a duplicate" % (entry["name"], key))
        entries.append({**entry, **keys})

    def project(self, **mesh: Any) -> Dict[str, Any]:
        """Returns the model as the dict of a project file; surfaces given as arrays have no `file`."""
        project = dict(self._keys)
        for key, entries in (("surfaces", self._surfaces), ("wells", self._wells), ("points", self._points),
                             ("column", self.column)):
            if entries:
                project[key] = entries
        mesh = {key: value for key, value in mesh.items() if value is not None}
        if mesh:
            project["mesh"] = {**project.get("mesh", {}), **mesh}
        return _plain(project)

    def mesh(self, size: Size = None, *, threads: int = 0, progress: Union[bool, Progress, None] = None,
             log: Optional[Log] = None, **mesh: Any) -> Mesh:
        """Meshes the model and keeps the result in memory.

        Parameters
        ----------
        size : float, callable or dict, optional
            Target edge length everywhere; a function ``size(x, y, z)`` of places in the project's coordinates; or the
            `size` of a project file, whose ``background`` may be such a function.
        threads : int
            0: all cores. Without influence on the result.
        progress : callable or True, optional
            ``progress(stage, done, total)``, about 20 times a second; total 0 where it is not known. True: a bar of
            tqdm, or lines where it is not installed.
        log : callable, optional
            ``log(level, text)`` with level "debug", "info" or "warning".
        **mesh
            Keys of `mesh` in a project file: ``quality``, ``refine``, ``honour``, ``surfaces_within``, ``mode`` ...

        Returns
        -------
        Mesh

        Raises
        ------
        UsageError, InvalidInput, CannotMesh
            With ``surfaces``, ``triangles`` and ``places``. KeyboardInterrupt on Ctrl-C, within two seconds.
        """
        plain, function = _size_function(size)
        return _drawing(progress, lambda shown: self._run(_run_options(threads, shown, log, function), size=plain,
                                                          **mesh))

    def run(self, directory: Path, formats: Optional[Sequence[str]] = None, size: Size = None, *, threads: int = 0,
            progress: Union[bool, Progress, None] = None, log: Optional[Log] = None, **mesh: Any) -> Mesh:
        """Meshes as :meth:`mesh` does, and writes the files of a project into the folder: ``formats`` as ``["vtu",
        "html"]``."""
        plain, function = _size_function(size)
        return _drawing(progress, lambda shown: self._run(
            _run_options(threads, shown, log, function, directory, write=True), formats, size=plain, **mesh))

    def _run(self, options: Dict[str, Any], formats: Optional[Sequence[str]] = None, **mesh: Any) -> Mesh:
        project = self.project(**mesh)
        if formats:
            project["output"] = {**project.get("output", {}), "formats": list(formats)}
        options = {**options, "fields": self._fields}
        return Mesh(_geomodel.run_given(json.dumps(project), self._keys["name"], os.getcwd(), self._given, options))


def _grid_arguments(name: str, heights: Any, origin: Sequence[float], spacing: Union[float, Sequence[float]],
                    rotation: float) -> Tuple[Any, ...]:
    """Returns a copy of the heights, and the node with the least x and y, so that both spacings are positive."""
    x0, y0 = (float(v) for v in origin)
    given = numpy.asarray(spacing, dtype=float)
    if given.shape not in ((), (2,)):
        raise UsageError("%s: spacing: (dx, dy) or one number was expected, found shape %s" % (name, given.shape))
    dx, dy = (float(given), float(given)) if given.ndim == 0 else (float(given[0]), float(given[1]))
    if rotation and (dx < 0 or dy < 0):
        raise UsageError("%s: a grid with a rotation needs a positive spacing" % name)
    if dx < 0:
        x0, dx, heights = x0 + dx * (heights.shape[1] - 1), -dx, heights[:, ::-1]
    if dy < 0:
        y0, dy, heights = y0 + dy * (heights.shape[0] - 1), -dy, heights[::-1]
    return numpy.array(heights), [x0, y0], [dx, dy], rotation


def _arrays_of_given(given: _geomodel.Given) -> Tuple[Any, ...]:
    """Returns the function of _geomodel that makes the input, and copies of its arrays."""
    if given.surfaces:
        return ("surface", numpy.array(given.surfaces[0][1]), numpy.array(given.surfaces[0][2]))
    if given.polylines:
        return ("polyline", numpy.array(given.polylines[0][1]))
    return ("point_set", numpy.array(given.point_sets[0][1]))


def _is_rows(thing: Any) -> bool:
    """Returns whether the argument is nested lists or tuples of numbers: [[x, y, z], ...]."""
    return isinstance(thing, (list, tuple)) and len(thing) > 0 and numpy.ndim(thing[0]) == 1 and len(thing[0]) == 3


def _size_function(size: Size) -> Tuple[Any, Optional[SizeFunction]]:
    """Divides the argument `size`: returns the value of `size` for the project file, and the size function or None."""
    if callable(size):
        return None, size
    if isinstance(size, dict) and callable(size.get("background")):
        rest = {key: value for key, value in size.items() if key != "background"}
        return rest or None, size["background"]
    return size, None


def run(project: Path, directory: Optional[Path] = None, *, write: bool = True, threads: int = 0,
        progress: Union[bool, Progress, None] = None, log: Optional[Log] = None) -> Mesh:
    """Meshes a project file as ``geomesh PROJECT.yaml`` does.

    Parameters
    ----------
    project : path
    directory : path, optional
        Where files go; else the project's ``output.directory``.
    write : bool
        False: nothing is written.
    threads, progress, log
        As of :meth:`Model.mesh`.

    Returns
    -------
    Mesh
        ``mesh.files`` lists what was written.
    """
    return _drawing(progress, lambda shown: Mesh(_geomodel.run_file(
        os.fspath(project), _run_options(threads, shown, log, None, directory, write))))


def check(mesh: Path, project: Optional[Path] = None) -> Dict[str, Any]:
    """Verifies a mesh file exactly, as ``geomesh check`` does; returns its report as a dict with "passes"."""
    return json.loads(_geomodel.check(os.fspath(mesh), "" if project is None else os.fspath(project)))
