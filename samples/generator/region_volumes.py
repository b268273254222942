# SPDX-License-Identifier: GPL-3.0-or-later
"""Volumes of regions between triangulated surfaces, for the samples' expected.json: from the geometry alone, with nothing of geomesh.

By the divergence theorem with a vertical field, the part of a body above the graph z = h(x, y) has the volume of the integral of
max(z - h, 0) over the map, signed, over the body's surface. All surfaces are made of triangles, so the integrals are sums over
convex polygons on which z - h is linear: exact but for rounding. Polygons are cut by `sides_of_sheet`. Standard library only.

A sheet is (points, triangles) and a graph along one axis (0, 1 or 2): `as_graph` checks that.
"""


def lower_half(polygon, value):
    """The part of a convex polygon where the affine function `value` of a point is at most zero."""
    kept = []
    for p, q in zip(polygon, polygon[1:] + polygon[:1]):
        vp, vq = value(p), value(q)
        if vp <= 0:
            kept.append(p)
        if (vp < 0 < vq) or (vq < 0 < vp):
            s = vp / (vp - vq)
            kept.append(tuple(a + s * (b - a) for a, b in zip(p, q)))
    return kept if len(kept) > 2 else []


class Graph:
    """A sheet as a function of the two coordinates beside `axis`: its triangles with their half-planes and heights."""

    def __init__(self, points, triangles, axis):
        self.u, self.v = [k for k in range(3) if k != axis]
        self.axis = axis
        self.cells = []
        turns = set()
        for t in triangles:
            a, b, c = (points[i] for i in t)
            area = self.cross(a, b, c)
            turns.add(area > 0)
            if area < 0:
                b, c = c, b
            self.cells.append((a, b, c))
        if len(turns) != 1:
            raise ValueError("the sheet is folded along the axis %d" % axis)
        self.boxes = [(min(p[self.u] for p in t), max(p[self.u] for p in t), min(p[self.v] for p in t), max(p[self.v] for p in t))
                      for t in self.cells]

    def cross(self, a, b, p):
        u, v = self.u, self.v
        return (b[u] - a[u]) * (p[v] - a[v]) - (b[v] - a[v]) * (p[u] - a[u])

    def beyond(self, cell, p):
        """Coordinate of p along the axis less the cell's there."""
        a, b, c = cell
        whole = self.cross(a, b, c)
        s, t = self.cross(a, p, c) / whole, self.cross(a, b, p) / whole
        k = self.axis
        return p[k] - (a[k] + s * (b[k] - a[k]) + t * (c[k] - a[k]))

    def parts(self, polygon):
        """The polygon cut at the cells' borders: (cell, part). What lies beside the sheet is left out."""
        u, v = [p[self.u] for p in polygon], [p[self.v] for p in polygon]
        u_low, u_high, v_low, v_high = min(u), max(u), min(v), max(v)
        for (cu_low, cu_high, cv_low, cv_high), cell in zip(self.boxes, self.cells):
            if cu_low > u_high or cu_high < u_low or cv_low > v_high or cv_high < v_low:
                continue
            part = polygon
            for a, b in zip(cell, cell[1:] + cell[:1]):
                part = lower_half(part, lambda p: -self.cross(a, b, p))
                if not part:
                    break
            if part:
                yield cell, part

    def below(self, polygons):
        """What of the polygons lies on the low side of the sheet along its axis."""
        kept = []
        for polygon in polygons:
            for cell, part in self.parts(polygon):
                part = lower_half(part, lambda p: self.beyond(cell, p))
                if part:
                    kept.append(part)
        return kept


def in_box(polygons, low, high):
    """What of the polygons lies in the box."""
    kept = []
    for polygon in polygons:
        for k in range(3):
            polygon = lower_half(polygon, lambda p: low[k] - p[k]) if polygon else polygon
            polygon = lower_half(polygon, lambda p: p[k] - high[k]) if polygon else polygon
        if polygon:
            kept.append(polygon)
    return kept


def volume_above(polygons, horizon):
    """Volume above the horizon (a Graph along z) of the body whose surface the polygons are: counter-clockwise as seen from outside;
    vertical ones, and all below the horizon, may be left out."""
    total = 0.0
    for polygon in polygons:
        for cell, part in horizon.parts(polygon):
            part = lower_half(part, lambda p: -horizon.beyond(cell, p))
            heights = [horizon.beyond(cell, p) for p in part]
            for i in range(1, len(part) - 1):
                total += horizon.cross(part[0], part[i], part[i + 1]) / 2 * (heights[0] + heights[i] + heights[i + 1]) / 3
    return total


def level(low, high, z):
    """The rectangle of a box at one height, facing up."""
    return [(low[0], low[1], z), (high[0], low[1], z), (high[0], high[1], z), (low[0], high[1], z)]


def layers(surface_polygons, horizons, whole):
    """Volumes of a body between horizons, from the highest down: above the first, between them, below the last (of `whole`)."""
    above = [volume_above(surface_polygons, horizon) for horizon in horizons] + [whole]
    return [above[0]] + [below - over for over, below in zip(above, above[1:])]


def box_layers(low, high, horizons):
    """Volumes of the layers of a box that horizons divide, from the highest down."""
    volume = (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2])
    return layers([level(low, high, high[2])], horizons, volume)
