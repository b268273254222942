# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces for the tests."""
import numpy

CUBE = numpy.array([[x, y, z] for z in (0.0, 1.0) for y in (0.0, 1.0) for x in (0.0, 1.0)])
CUBE_FACES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


def sheet(height, n=6, low=-100.0, high=1100.0):
    """Returns a horizon over a square of the map: height(x, y) at n x n nodes, two triangles per cell."""
    x, y = numpy.meshgrid(numpy.linspace(low, high, n), numpy.linspace(low, high, n))
    points = numpy.column_stack([x.ravel(), y.ravel(), height(x, y).ravel()])
    corner = (numpy.arange(n - 1)[:, None] * n + numpy.arange(n - 1)).ravel()
    triangles = numpy.concatenate([numpy.column_stack([corner, corner + 1, corner + n + 1]),
                                   numpy.column_stack([corner, corner + n + 1, corner + n])])
    return points, triangles


def volumes(points, tetrahedra):
    a, b, c, d = (points[tetrahedra[:, i]] for i in range(4))
    return numpy.einsum("ij,ij->i", numpy.cross(b - a, c - a), d - a) / 6
