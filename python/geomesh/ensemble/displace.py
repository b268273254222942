# SPDX-License-Identifier: GPL-3.0-or-later
"""Displacement of a surface in one realisation: shift, tilt, perturbation, throw, and wells at which it is not moved."""
import math

import numpy

from ..core.errors import UsageError
from . import fields


def mean_normal(points, triangles):
    """Returns the upward mean normal of a surface, weighted by area; without triangles, the normal of the plane through the points."""
    if triangles is not None:
        total = _doubled_normals(points, triangles).sum(axis=0)
    else:
        total = numpy.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2][2]
    normal = total / max(float(numpy.linalg.norm(total)), 1e-300)
    # The mean normal of a surface points upwards; that of a vertical surface points east, or else north.
    first = [component for component in (normal[2], normal[0], normal[1]) if abs(component) > 1e-9]
    return -normal if first and first[0] < 0 else normal


def _doubled_normals(points, triangles):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return numpy.cross(b - a, c - a)


def vertex_normals(points, triangles):
    """Returns the area-weighted mean of the normals around each vertex; points with equal coordinates have one normal."""
    each = _doubled_normals(points, triangles)
    _, place = numpy.unique(points, axis=0, return_inverse=True)
    place = place.reshape(-1)
    total = numpy.zeros((place.max() + 1, 3))
    for corner in range(3):
        numpy.add.at(total, place[triangles[:, corner]], each)
    length = numpy.linalg.norm(total, axis=1, keepdims=True)
    return (total / numpy.where(length > 0, length, 1))[place]


def rotation(axis, angle):
    """Returns the matrix of a rotation by `angle` radians about a unit vector (Rodrigues)."""
    x, y, z = axis
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * (cross @ cross)


class Displacement:
    """Displaces the points of one surface, z upwards."""

    def __init__(self, spec, draws):
        self._spec, self._draws = spec, draws
        self._name = "surfaces." + spec.name

    def of(self, points, triangles, holds):
        """Returns the displaced points. Only horizons use `holds` (see fields.held)."""
        if self._spec.kind == "horizon":
            return self._of_horizon(points, holds)
        turned = self._turned(points) + self._shift()
        return turned + self._perturbation(points)[:, None] * self._directions(points, triangles)

    def _of_horizon(self, points, holds):
        shift = self._shift()
        rise = shift[2] + self._tilt_rise(points) + self._perturbation(points[:, :2])
        if holds:
            reach, kind = self._spec.hold_range, self._spec.correlation
            rise = fields.held(rise, points[:, :2], holds, reach, kind)
        moved = points + [shift[0], shift[1], 0.0]
        moved[:, 2] += rise
        return moved

    def _value(self, key, distribution):
        return float(self._draws.value(self._name + "." + key, distribution))

    def _shift(self):
        return numpy.array([self._value("shift." + axis, d) for axis, d in zip("xyz", self._spec.shift)])

    def _tilt(self):
        """Returns the angle of the tilt and the azimuth of the side that rises, in radians; the azimuth is measured
        from the y axis towards x."""
        if self._spec.tilt is None:
            return 0.0, 0.0
        angle, azimuth = self._spec.tilt
        return math.radians(self._value("tilt.angle", angle)), math.radians(self._value("tilt.azimuth", azimuth))

    def _tilt_rise(self, points):
        angle, azimuth = self._tilt()
        centre = (points[:, :2].min(axis=0) + points[:, :2].max(axis=0)) / 2
        offset = points[:, :2] - centre
        return math.tan(angle) * (offset[:, 0] * math.sin(azimuth) + offset[:, 1] * math.cos(azimuth))

    def _turned(self, points):
        """Returns the points rotated as a whole about a horizontal axis through their centre, perpendicular to the
        azimuth."""
        angle, azimuth = self._tilt()
        if angle == 0:
            return points.copy()
        centre = (points.min(axis=0) + points.max(axis=0)) / 2
        axis = (math.cos(azimuth), -math.sin(azimuth), 0.0)
        return centre + (points - centre) @ rotation(axis, angle).T

    def _perturbation(self, places):
        if self._spec.perturbation is None:
            return numpy.zeros(len(places))
        sd, reach = (self._value("perturbation." + key, d) for key, d in zip(("sd", "range"), self._spec.perturbation))
        if sd == 0:
            return numpy.zeros(len(places))
        if not (sd > 0 and reach > 0):
            raise UsageError("%s.perturbation: sd %g and range %g were drawn; sd may not be negative, and the range is "
                             "positive" % (self._name, sd, reach))
        stream = self._draws.stream(self._name + ".perturbation")
        return sd * fields.gaussian_field(places, reach, self._spec.correlation, stream)

    def _directions(self, points, triangles):
        if self._spec.kind == "body" and triangles is not None:
            return vertex_normals(points, triangles)
        return numpy.broadcast_to(mean_normal(points, triangles), points.shape)


def pieces(n_points, triangles):
    """Returns the piece of each vertex: vertices connected by triangles have the same number, which is their smallest
    vertex."""
    label = numpy.arange(n_points)
    while True:
        before = label.copy()
        least = label[triangles].min(axis=1)
        for corner in range(3):
            numpy.minimum.at(label, triangles[:, corner], least)
        label = label[label]
        if (label == before).all():
            return label


def throw_blocks(horizon, points, triangles, fault):
    """Adds `fault.throw` to a horizon given block by block: blocks on the hanging wall are lowered by it. A block is a
    connected piece of the horizon; the side of its centre relative to the fault's mean plane decides. Raises
    UsageError if the horizon is one piece, or all its pieces lie on one side.
    """
    label = pieces(len(points), triangles)
    hanging = numpy.zeros(len(points), dtype=bool)
    sides = set()
    for piece in numpy.unique(label[triangles.ravel()]):
        rows = label == piece
        side = float((points[rows].mean(axis=0) - fault.place) @ fault.normal) > 0
        sides.add(side)
        hanging[rows] = side
    if len(sides) < 2:
        raise UsageError("throw.%s: the horizon %s is not given block by block at this fault: all of it lies on one side of the "
                         "fault's mean plane, or it runs through in one piece" % (fault.name, horizon))
    moved = points.copy()
    moved[hanging, 2] -= fault.throw
    return moved


def picks(points, triangles, wells):
    """Returns the holds of a horizon (see fields.held): points where paths of wells, without extrapolation, cross its
    triangles."""
    holds = []
    corner = points[triangles]  # (m, 3, 3)
    for path in wells:
        for start, end in zip(path[:-1], path[1:]):
            holds += _crossings(corner, triangles, start, end - start)
    return holds


def _crossings(corner, triangles, start, along):
    """Intersects one segment with all triangles (Moeller and Trumbore 1997)."""
    u, v = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
    p = numpy.cross(along, v)
    determinant = (u * p).sum(axis=1)
    safe = numpy.where(determinant == 0, 1.0, determinant)
    offset = start - corner[:, 0]
    b1 = (offset * p).sum(axis=1) / safe
    q = numpy.cross(offset, u)
    b2 = (q * along).sum(axis=1) / safe
    t = (q * v).sum(axis=1) / safe
    hit = (determinant != 0) & (b1 >= 0) & (b2 >= 0) & (b1 + b2 <= 1) & (t >= 0) & (t <= 1)
    return [(triangles[row], numpy.array([1 - b1[row] - b2[row], b1[row], b2[row]])) for row in numpy.flatnonzero(hit)]
