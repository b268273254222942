# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from arrays, files, and objects of other packages, which are recognised by their attributes."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, List, Tuple, Union

import numpy

from .core.errors import InvalidInput, UsageError

if TYPE_CHECKING:
    import numpy.typing as npt


def is_path(thing: Any) -> bool:
    return isinstance(thing, (str, os.PathLike))


def as_points(points: Any) -> npt.NDArray[numpy.float64]:
    """Returns float64, C-contiguous points of shape (n, 3); the caller's own array if it is already of this form."""
    array = numpy.ascontiguousarray(points, dtype=numpy.float64)
    if array.ndim != 2 or array.shape[1] != 3:
        raise UsageError("points: an array of shape (n, 3) was expected, found shape %s" % (array.shape,))
    return array


def as_triangles(triangles: Any) -> Any:
    array = numpy.asarray(triangles)
    if array.ndim == 2 and array.shape[1] == 4:  # each quadrangle is split into two triangles
        array = split_quadrangles(array)
    return array


def split_quadrangles(quads: Any) -> Any:
    quads = numpy.asarray(quads)
    return numpy.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def _fans(flat: Any) -> Any:
    """Returns triangles of polygons stored consecutively as (count, rows...), as VTK stores them."""
    flat = numpy.asarray(flat).ravel()
    if flat.size % 4 == 0 and flat.size > 0 and (flat[::4] == 3).all():
        return flat.reshape(-1, 4)[:, 1:]
    triangles: List[Tuple[int, ...]] = []
    at = 0
    while at < flat.size:
        n = int(flat[at])
        rows = flat[at + 1:at + 1 + n]
        triangles += [(rows[0], rows[k], rows[k + 1]) for k in range(1, n - 1)]
        at += n + 1
    return numpy.array(triangles, dtype=numpy.int64).reshape(-1, 3)


def field_of(name, function):
    """Returns the function of a field with its result as float64 in the shape of the places, and errors with name and
    place."""
    def values(x, y, z):
        try:
            found = numpy.asarray(function(x, y, z), dtype=numpy.float64)
            return numpy.broadcast_to(found, x.shape)
        except Exception as error:
            raise InvalidInput("surface %s: the function of its field failed for %d places, the first of them "
                               "(%.9g, %.9g, %.9g): %s: %s" % (name, len(x), x[0], y[0], z[0], type(error).__name__, error)
                               ) from error
    values.function = function  # keeps the function alive, so that its id remains unique
    return values


def _of_meshio(mesh: Any) -> Tuple[Any, Any]:
    blocks = []
    for block in mesh.cells:
        kind, rows = (block.type, block.data) if hasattr(block, "type") else block
        if kind == "triangle":
            blocks.append(numpy.asarray(rows))
        elif kind == "quad":
            blocks.append(split_quadrangles(rows))
    if not blocks:
        raise UsageError("the meshio mesh has no triangles; found %s" %
                         ", ".join(str(getattr(b, "type", b[0])) for b in mesh.cells))
    return mesh.points, numpy.concatenate(blocks)


def _of_vtk(data: Any) -> Tuple[Any, Any]:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    return vtk_to_numpy(data.GetPoints().GetData()), _fans(vtk_to_numpy(data.GetPolys().GetData()))


def without_nan(points: Any, triangles: Any) -> Tuple[Any, Any]:
    """Returns points and triangles without NaN vertices and the triangles that use them.

    Isosurfaces of implicit models have such vertices where the surface leaves the model. Arrays without any are
    returned unchanged.
    """
    points, triangles = numpy.asarray(points), numpy.asarray(triangles)
    if points.dtype.kind != "f" or points.ndim != 2:
        return points, triangles
    known = numpy.isfinite(points).all(axis=1)
    if known.all() or triangles.size == 0:
        return points, triangles
    inside = (triangles >= 0) & (triangles < len(points))
    # triangles with rows out of range are not dropped: the check of the arrays rejects them later
    kept = numpy.where(inside, known[numpy.where(inside, triangles, 0)], True).all(axis=1)
    rows = numpy.cumsum(known) - 1
    triangles = triangles[kept].astype(numpy.int64)
    valid = (triangles >= 0) & (triangles < len(points))
    return points[known], numpy.where(valid, rows[numpy.where(valid, triangles, 0)], triangles)


def arrays_of(thing: Any) -> Tuple[Any, Any]:
    """Returns (points, triangles) of an object that is a triangulated surface in one of these forms, tried in this
    order: meshio (``points``, ``cells``); PyVista (``points``, ``faces`` as one flat list); VTK (``GetPoints``,
    ``GetPolys``); GemPy (``vertices``, ``edges`` of three columns); LoopStructural (``vertices``, ``triangles``);
    trimesh and others (``vertices``, ``faces``); a pair (points, triangles).
    """
    if isinstance(thing, (tuple, list)) and len(thing) == 2:
        return thing[0], thing[1]
    if hasattr(thing, "points") and hasattr(thing, "cells") and not hasattr(thing, "GetPolys"):
        return _of_meshio(thing)
    if hasattr(thing, "points") and hasattr(thing, "faces"):
        faces = numpy.asarray(thing.faces)
        return thing.points, faces if faces.ndim == 2 else _fans(faces)
    if hasattr(thing, "GetPolys"):
        return _of_vtk(thing)
    if hasattr(thing, "vertices"):
        for name in ("triangles", "edges", "faces"):
            rows = getattr(thing, name, None)
            if rows is not None and numpy.ndim(rows) == 2 and numpy.shape(rows)[1] in (3, 4):
                return thing.vertices, rows
    raise UsageError("no triangulated surface is known in a %s: give points and triangles as arrays, a file, or an "
                     "object with points and faces" % type(thing).__name__)


def read_surfaces(file: Union[str, "os.PathLike[str]"]) -> "List[Tuple[str, npt.NDArray[numpy.float64], npt.NDArray[numpy.uint32]]]":
    """Reads the triangulated surfaces of a file in any format of docs/input-formats.md.

    Returns
    -------
    list of (name, points, triangles)
        float64 (n, 3) with z upwards, uint32 (m, 3).
    """
    from . import _geomodel
    return _geomodel.read_surfaces(os.fspath(file))
