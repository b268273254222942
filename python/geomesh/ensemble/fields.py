# SPDX-License-Identifier: GPL-3.0-or-later
"""Correlated Gaussian perturbations, by the spectral method, and displacements held at places.

A field is a sum of waves whose wave vectors are drawn from the spectrum of the correlation and whose amplitudes are normal
(M. Shinozuka and C.-M. Jan, "Digital simulation of random processes", 1972). It is known at every place, so that it does not depend on
the triangulation of a surface. Holding is simple kriging of what has to vanish (A. G. Journel and Ch. J. Huijbregts, 1978).
"""
import numpy

N_WAVES = 400
CORRELATIONS = ("gaussian", "exponential")
_LEFT_AT_RANGE = 3.0  # the correlation at the range is exp(-3), one twentieth


def correlation(distance, reach, kind):
    """Returns the correlation of a random field over a distance; at `reach`, the range, 5 % of it are left."""
    ratio = distance / reach
    return numpy.exp(-_LEFT_AT_RANGE * (ratio * ratio if kind == "gaussian" else ratio))


def _wave_vectors(stream, dimension, reach, kind):
    directions = stream.normals(N_WAVES * dimension).reshape(N_WAVES, dimension)
    if kind == "gaussian":
        return directions * (numpy.sqrt(2 * _LEFT_AT_RANGE) / reach)
    # The spectrum of exp(-c h) is Student's distribution with one degree of freedom, in any dimension.
    return directions / numpy.abs(stream.normals(N_WAVES))[:, None] * (_LEFT_AT_RANGE / reach)


def gaussian_field(places, reach, kind, stream):
    """Returns the values at the places (n, d) of a random field with mean 0 and variance 1."""
    waves = _wave_vectors(stream, places.shape[1], reach, kind)
    amplitudes = stream.normals(2 * N_WAVES).reshape(2, N_WAVES) / numpy.sqrt(N_WAVES)
    values = numpy.empty(len(places))
    for start in range(0, len(places), 4096):  # works in pieces to bound memory; sums in a fixed order, without BLAS and its threads
        rows = slice(start, start + 4096)
        phase = sum(places[rows, axis, None] * waves[None, :, axis] for axis in range(places.shape[1]))
        values[rows] = (numpy.cos(phase) * amplitudes[0] + numpy.sin(phase) * amplitudes[1]).sum(axis=1)
    return values


def held(displacement, places, holds, reach, kind):
    """Returns the displacement, changed by kriging so that it vanishes at the holds.

    A hold is (vertices, weights): a place on the surface as a weighted mean of vertices. Therefore the surface, and
    not only the field, is exactly fixed there.
    """
    if not holds:
        return displacement
    used = numpy.unique(numpy.concatenate([vertices for vertices, _ in holds]))
    row = {int(v): i for i, v in enumerate(used)}
    weights = numpy.zeros((len(holds), len(used)))
    for hold, (vertices, shares) in enumerate(holds):
        for vertex, share in zip(vertices, shares):
            weights[hold, row[int(vertex)]] += share
    among = correlation(_distances(places[used], places[used]), reach, kind)
    matrix = weights @ among @ weights.T
    left = numpy.linalg.lstsq(matrix, weights @ displacement[used], rcond=1e-12)[0]
    return displacement - correlation(_distances(places, places[used]), reach, kind) @ (weights.T @ left)


def _distances(a, b):
    return numpy.sqrt(((a[:, None, :] - b[None, :, :]) ** 2).sum(axis=2))
