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
    """What was asked for is not offered or contradicts itself: a wrong shape, an unknown key, a missing file."""


class InvalidInput(Error, ValueError):
    """The data given are broken: a coordinate that is not finite, crossing facets where crossings are refused."""


class CannotMesh(Error, RuntimeError):
    """The input is valid but cannot be meshed as asked: nothing enclosed, too thin, more elements than allowed."""


class Interrupted(Error, RuntimeError):
    """The run was cancelled from inside; a Ctrl-C comes as KeyboardInterrupt."""


class InternalError(Error, RuntimeError):
    """An invariant of geomesh does not hold: a bug of geomesh, never the user's. Nothing was written."""
