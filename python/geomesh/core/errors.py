# SPDX-License-Identifier: MIT
"""Exceptions of geomesh. Each message says what is wrong, where, and what to do about it."""


class Error(Exception):
    """Base of all errors of geomesh.

    Attributes
    ----------
    surfaces : list of str
        Names of the surfaces in trouble.
    triangles : list of (str, int)
        Triangles in trouble: name of the surface, row from 0 as given or read.
    places : numpy.ndarray, shape (n, 3)
        Coordinates of the trouble in the mesh's frame, the most telling first.
    facets, vertices : list of int
        Rows of facets and points of what was given to ``geomesh.core``, from 0.
    """

    surfaces = ()
    triangles = ()
    places = ()
    facets = ()
    vertices = ()


class UsageError(Error, ValueError):
    """The request is not supported or contradicts itself: a wrong shape, an unknown key, a missing file."""


class InvalidInput(Error, ValueError):
    """The given data are invalid: a coordinate that is not finite, or crossing facets where crossings are not allowed."""


class CannotMesh(Error, RuntimeError):
    """The input is valid but cannot be meshed as requested: nothing is enclosed, it is too thin, or needs more elements
    than allowed."""


class Interrupted(Error, RuntimeError):
    """The run was cancelled from inside; Ctrl-C raises KeyboardInterrupt."""


class InternalError(Error, RuntimeError):
    """An invariant of geomesh is violated: a bug of geomesh, never a mistake of the user. Nothing was written."""
