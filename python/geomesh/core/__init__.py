# SPDX-License-Identifier: MIT
"""The engine of geomesh for plain arrays: Delaunay, constrained meshing, refinement. MIT; needs numpy and oneTBB.

Every function releases the interpreter's lock while it works. Ctrl-C ends it, and so does an exception in a callback.
Arrays of results are read-only views of memory that the result owns: nothing is copied. ``numpy.array(view)`` copies.
Lengths are in the unit of the points, angles in degrees, rows count from 0.
"""
import numpy as _numpy

from . import _core
from ._core import Delaunay, Tetrahedralization, __version__
from .errors import CannotMesh, Error, InternalError, Interrupted, InvalidInput, UsageError

__all__ = ["delaunay", "tetrahedralize", "refine", "Delaunay", "Tetrahedralization", "Error", "UsageError",
           "InvalidInput", "CannotMesh", "Interrupted", "InternalError", "NO_ROW", "__version__"]

#: Value in arrays of row numbers that means "no row".
NO_ROW = 0xFFFFFFFF


def _choice(name, value, words):
    if value not in words:
        raise UsageError("%s: %r is not among %s" % (name, value, ", ".join(words)))
    return value


def _run_options(threads, progress, log):
    return {"threads": int(threads), "progress": progress, "log": log}


def _points(points, name="points"):
    """Returns float64, C-contiguous points; the caller's own array if it is already of this form."""
    return _numpy.ascontiguousarray(points if points is not None else _numpy.empty((0, 3)), dtype=_numpy.float64)


def _complex(points, facets, segments, regions, holes):
    triangles, polygons = None, []
    array = facets if isinstance(facets, _numpy.ndarray) else None
    if array is None and len(facets) > 0 and all(len(f) == 3 and not hasattr(f[0], "__len__") for f in facets):
        array = _numpy.asarray(facets)
    if array is not None:
        triangles = array
    else:
        polygons = [[list(map(int, loop)) for loop in (f if hasattr(f[0], "__len__") else [f])] for f in facets]
    segments = _numpy.empty((0, 2), dtype=_numpy.int64) if segments is None else _numpy.asarray(segments)
    return _core.PlcArguments(_points(points), triangles, polygons, segments, _points(regions), _points(holes))


def delaunay(points, *, algorithm="cavity", cluster_distance=None, threads=0, progress=None, log=None):
    """Delaunay tetrahedralization of points.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        float64 and C-contiguous arrays are read in place, not copied; do not change them meanwhile.
    algorithm : {"cavity", "flip"}
        Both give the same, unique tetrahedralization; the first is faster.
    cluster_distance : float, optional
        Points nearer than this to an inserted one wait until the end. Changes the speed alone.
    threads : int
        0: all cores. Without influence on the result.
    progress : callable, optional
        ``progress(stage, done, total)``, about 20 times a second; total 0 where it is not known.
    log : callable, optional
        ``log(level, text)`` with level "debug", "info" or "warning".

    Returns
    -------
    Delaunay

    Raises
    ------
    InvalidInput
        A coordinate is not finite, or out of the exact range.
    CannotMesh
        All points lie in one plane or on one line.
    UsageError
        An argument has another shape or value than listed here.
    """
    return _core.delaunay(_points(points), _choice("algorithm", algorithm, ("cavity", "flip")),
                          -1.0 if cluster_distance is None else float(cluster_distance),
                          _run_options(threads, progress, log))


def tetrahedralize(points, facets, *, segments=None, regions=None, holes=None, mode="constrained",
                   preserve_boundary=False, threads=0, progress=None, log=None):
    """Tetrahedral mesh of what facets enclose, with every facet a union of its faces.

    Parameters
    ----------
    points : array_like, shape (n, 3)
    facets : integer array, shape (m, 3), or list of polygons
        A polygon is a list of rows of points, or a list of such lists: its border first, then its holes. Polygons
        must be planar up to rounding. Facets meet in shared points and edges alone.
    segments : integer array, shape (k, 2), optional
        Edges that the mesh must contain in addition to those of facets; absent ones are reported.
    regions : array_like, shape (r, 3), optional
        A point inside each part that ``component_seed`` is to identify.
    holes : array_like, shape (h, 3), optional
        A point inside each part that is to be left out.
    mode : {"constrained", "conforming"}
        Fewest added points, or Delaunay by added points.
    preserve_boundary : bool
        No point is added on facets or segments, only inside.
    threads, progress, log
        As of :func:`delaunay`.

    Returns
    -------
    Tetrahedralization

    Raises
    ------
    InvalidInput
        Facets cross, a facet has no area, or a row is out of range; ``facets`` and ``places`` report which and where.
    CannotMesh
        Nothing is enclosed, or a facet cannot be recovered.
    """
    options = dict(_run_options(threads, progress, log), preserve_boundary=bool(preserve_boundary),
                   mode=_choice("mode", mode, ("constrained", "conforming")))
    return _core.tetrahedralize(_complex(points, facets, segments, regions, holes), options)


def refine(points, facets, *, size=None, segments=None, regions=None, holes=None, quality="default", tolerance=0.0,
           gradation=0.3, curvature_angle=0.0, max_elements=50_000_000, threads=0, progress=None, log=None):
    """Tetrahedral mesh of what facets enclose, with sizes and shapes for solvers.

    Parameters
    ----------
    points, facets, segments, regions, holes
        As of :func:`tetrahedralize`.
    size : float or callable, optional
        Target edge length everywhere, or a function of a place, ``size(x, y, z)``; values that are not positive request
        nothing. Without it sizes follow the edges of the facets. A call of a function costs about a microsecond.
    quality : {"fast", "default", "best"}
    tolerance : float
        Facets are kept exactly where 0, else surfaces are remeshed within this distance of them.
    gradation : float
        Growth of the size per unit of distance.
    curvature_angle : float
        Degrees that one edge may turn on a curved surface; 0: no limit.
    max_elements : int
        If the sizes require more, the run ends before the work starts.
    threads, progress, log
        As of :func:`delaunay`.

    Returns
    -------
    Tetrahedralization

    Raises
    ------
    InvalidInput, CannotMesh
        As of :func:`tetrahedralize`; CannotMesh also where more elements than allowed would be made.
    """
    options = dict(_run_options(threads, progress, log), preserve_boundary=False, mode="constrained", size=size,
                   quality=_choice("quality", quality, ("fast", "default", "best")), tolerance=float(tolerance),
                   gradation=float(gradation), curvature_angle=float(curvature_angle), max_elements=int(max_elements))
    return _core.refine(_complex(points, facets, segments, regions, holes), options)
