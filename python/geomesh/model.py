# SPDX-License-Identifier: GPL-3.0-or-later
"""Models made in Python, and project files. Keys of the project file are keyword arguments of the same names."""
import json
import os

import numpy

from . import _geomodel, inputs
from .core.errors import UsageError
from .mesh import Mesh

_SIDES = ("min", "max")


def _plain(value):
    """What JSON holds: numpy's numbers and arrays, tuples and paths as plain ones."""
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


def _run_options(threads, progress, log, size_function=None, directory=None, write=False):
    return {"threads": int(threads), "progress": _progress(progress), "log": log, "size_function": size_function,
            "directory": None if directory is None else os.path.abspath(os.fspath(directory)), "write": write}


def _progress(progress):
    """True: a bar of tqdm where it is installed, else lines on the standard error."""
    if progress is not True:
        return progress or None
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return _PrintedStages()
    return _Bars(tqdm)


class _PrintedStages:
    def __call__(self, stage, done, total):
        import sys
        if done == 0:
            print(stage, "...", file=sys.stderr)


class _Bars:
    def __init__(self, tqdm):
        self._tqdm, self._bar, self._stage = tqdm, None, None

    def __call__(self, stage, done, total):
        if stage != self._stage:
            if self._bar is not None:
                self._bar.close()
            self._bar, self._stage = self._tqdm(desc=stage, leave=False), stage
        self._bar.total = total or None
        self._bar.n = done
        self._bar.refresh()


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
        ``groups``, ``attributes``, ``tolerance``, ``output``.

    Raises
    ------
    UsageError
        From :meth:`mesh` and :meth:`run`: an unknown key or name, with all mistakes at once.
    """

    def __init__(self, box=None, name="model", column=None, **keys):
        self._keys = {"name": str(name)}
        if box is not None:
            self._keys["box"] = box if isinstance(box, dict) else self._box(box)
        self.column = list(column) if column else []
        self._keys.update(keys)
        self._surfaces, self._wells, self._points = [], [], []
        self._given = {}
        self._fields = {}
        self._functions = {}

    @staticmethod
    def _box(box):
        corners = numpy.asarray(box, dtype=float)
        if corners.shape != (2, 3):
            raise UsageError("box: [[x0, y0, z0], [x1, y1, z1]] was expected, found shape %s" % (corners.shape,))
        return dict(zip(_SIDES, corners.tolist()))

    def add_surface(self, name, points, triangles=None, *, kind="horizon", **rules):
        """Adds a surface.

        Parameters
        ----------
        name : str
        points : array_like, shape (n, 3); or a path; or an object
            Without triangles the points become a surface over the map (key `gridding`). A path is a file of any
            format of docs/input-formats.md. Objects of PyVista, meshio, VTK, GemPy, LoopStructural and trimesh are
            understood by their attributes. The arrays are copied once, when the model keeps them.
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
                points, triangles = inputs.arrays_of(points)
            points = inputs.as_points(points)
            self._given[name] = (_geomodel.point_set(name, points) if triangles is None else
                                 _geomodel.surface(name, points, inputs.as_triangles(triangles)))
        self._add_entry(self._surfaces, entry, rules)
        return self

    def add_grid(self, name, heights, origin=(0.0, 0.0), spacing=(1.0, 1.0), *, rotation=0.0, kind="horizon", **rules):
        """Adds a surface given by heights at the nodes of a regular grid.

        Parameters
        ----------
        heights : array_like, shape (rows, columns)
            Height of the node at ``x = x0 + column * dx``, ``y = y0 + row * dy``; NaN where there is none.
        origin : (x0, y0)
            The node of row 0, column 0.
        spacing : (dx, dy), or one number
            dy may be negative, as in rasters with the north on top.
        rotation : float
            Degrees counter-clockwise about the origin.
        kind, **rules
            As of :meth:`add_surface`.
        """
        heights = numpy.asarray(heights, dtype=numpy.float64)
        if heights.ndim != 2:
            raise UsageError("%s: heights of a grid are an array of shape (rows, columns)" % name)
        dx, dy = (spacing, spacing) if numpy.ndim(spacing) == 0 else spacing
        x0, y0 = origin
        if dy < 0:
            if rotation:
                raise UsageError("%s: a grid with a rotation needs a positive spacing" % name)
            y0, dy, heights = y0 + dy * (heights.shape[0] - 1), -dy, heights[::-1]
        self._given[name] = _geomodel.grid(name, heights, [float(x0), float(y0)], [float(dx), float(dy)],
                                           float(rotation))
        self._add_entry(self._surfaces, {"name": name, "kind": kind}, rules)
        return self

    def add_field(self, name, field, value, *, kind="horizon", **rules):
        """Adds the surface on which a scalar field has one value.

        Parameters
        ----------
        name : str
        field : callable, or a path
            ``field(x, y, z)`` of three arrays of one length gives an array of that length; it must have a finite value
            everywhere in the model's box, which is needed. A path is a grid (.vti, .npy) or tetrahedra (.vtu).
            Surfaces of the same function, or of the same file, come from one mesh and never cross.
        value : float
        kind, **rules
            As of :meth:`add_surface`; ``array``, ``origin`` and ``spacing`` for files.

        Notes
        -----
        The surface is refined until it is within a quarter of ``mesh.tolerance`` of the field's own: proven for grids
        and tetrahedra, found at 20,000 samples for functions, which may hide features smaller than a fiftieth of the
        box.

        Raises
        ------
        InvalidInput
            From :meth:`mesh` and :meth:`run`: the function fails or gives a value that is not finite, or the field does
            not take the value in the box.
        """
        entry = {"name": name, "kind": kind, "value": float(value)}
        if inputs.is_path(field):
            entry["field"] = os.path.abspath(os.fspath(field))
        elif callable(field):
            self._fields[name] = self._functions.setdefault(id(field), inputs.field_of(name, field))
        else:
            raise UsageError("%s: a function of x, y, z or a file was expected" % name)
        self._add_entry(self._surfaces, entry, rules)
        return self

    def add_well(self, name, path, **keys):
        """Adds a well: an array of shape (n, 3) of places along it, or a file. It becomes a curve of the mesh."""
        entry = {"name": name}
        if inputs.is_path(path):
            entry["file"] = os.path.abspath(os.fspath(path))
        else:
            self._given[name] = _geomodel.polyline(name, inputs.as_points(path))
        self._add_entry(self._wells, entry, keys)
        return self

    def add_point(self, name, at):
        """Adds a named place (x, y, z), which becomes a vertex of the mesh."""
        self._points.append({"name": name, "at": [float(v) for v in at]})
        return self

    @staticmethod
    def _add_entry(entries, entry, keys):
        for key in keys:
            if key in entry:
                raise UsageError("%s: %s is given twice" % (entry["name"], key))
        entries.append({**entry, **keys})

    def project(self, **mesh):
        """The model as the dict of a project file; surfaces given as arrays have no `file`."""
        project = dict(self._keys)
        for key, entries in (("surfaces", self._surfaces), ("wells", self._wells), ("points", self._points),
                             ("column", self.column)):
            if entries:
                project[key] = entries
        mesh = {key: value for key, value in mesh.items() if value is not None}
        if mesh:
            project["mesh"] = {**project.get("mesh", {}), **mesh}
        return _plain(project)

    def mesh(self, size=None, *, threads=0, progress=None, log=None, **mesh):
        """Meshes the model and keeps the result in memory.

        Parameters
        ----------
        size : float, callable or dict, optional
            Edge length asked everywhere; a function ``size(x, y, z)`` of places in the project's coordinates; or the
            `size` of a project file, whose ``background`` may be such a function.
        threads : int
            0: all cores. Without influence on the result.
        progress : callable or True, optional
            ``progress(stage, done, total)``, about 20 times a second; total 0 where it is not known. True: a bar of
            tqdm, or lines where it is not installed.
        log : callable, optional
            ``log(level, text)`` with level "debug", "info" or "warning".
        **mesh
            Keys of `mesh` in a project file: ``quality``, ``refine``, ``honour``, ``tolerance``, ``mode`` ...

        Returns
        -------
        Mesh

        Raises
        ------
        UsageError, InvalidInput, CannotMesh
            With ``surfaces``, ``triangles`` and ``places``. KeyboardInterrupt on Ctrl-C, within two seconds.
        """
        size, function = _size_function(size)
        return self._run(_run_options(threads, progress, log, function), size=size, **mesh)

    def run(self, directory, formats=None, size=None, *, threads=0, progress=None, log=None, **mesh):
        """As :meth:`mesh`, and writes the files of a project into the folder: ``formats`` as ``["vtu", "html"]``."""
        size, function = _size_function(size)
        options = _run_options(threads, progress, log, function, directory, write=True)
        return self._run(options, formats, size=size, **mesh)

    def _run(self, options, formats=None, **mesh):
        project = self.project(**mesh)
        if formats:
            project["output"] = {**project.get("output", {}), "formats": list(formats)}
        options = {**options, "fields": self._fields}
        return Mesh(_geomodel.run_given(json.dumps(project), self._keys["name"], os.getcwd(), self._given, options))


def _is_rows(thing):
    """Nested lists or tuples of numbers: [[x, y, z], ...]."""
    return isinstance(thing, (list, tuple)) and len(thing) > 0 and numpy.ndim(thing[0]) == 1 and len(thing[0]) == 3


def _size_function(size):
    """What of a size goes into the project, and the function in it."""
    if callable(size):
        return None, size
    if isinstance(size, dict) and callable(size.get("background")):
        rest = {key: value for key, value in size.items() if key != "background"}
        return rest or None, size["background"]
    return size, None


def run(project, directory=None, *, write=True, threads=0, progress=None, log=None):
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
        ``mesh.files`` tells what was written.
    """
    return Mesh(_geomodel.run_file(os.fspath(project), _run_options(threads, progress, log, None, directory, write)))


def check(mesh, project=None):
    """Verifies a mesh file exactly, as ``geomesh check`` does; returns its report as a dict with "passes"."""
    return json.loads(_geomodel.check(os.fspath(mesh), "" if project is None else os.fspath(project)))
