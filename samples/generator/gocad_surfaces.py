# SPDX-License-Identifier: GPL-3.0-or-later
"""What the samples' make_surfaces.py scripts share: triangulated shapes and a GOCAD TSurf writer.

Standard library only. Everything is a function of an explicit seed: running a script again gives the same bytes. Coordinates are
written in metres with three decimals, and grid points are moved about so that no four of them are coplanar by accident.
"""
import json
import math
import random


def gocad_head(kind, name, unit="m", z_positive="Elevation"):
    return ["GOCAD " + kind + " 1", "HEADER {", "name:" + name, "}", "GOCAD_ORIGINAL_COORDINATE_SYSTEM", "NAME Default",
            'AXIS_NAME "X" "Y" "Z"', 'AXIS_UNIT "%s" "%s" "%s"' % (unit, unit, unit), "ZPOSITIVE " + z_positive,
            "END_ORIGINAL_COORDINATE_SYSTEM"]


def write_ts(path, name, points, triangles, unit="m", z_positive="Elevation"):
    """One TSurf. Rows of `triangles` are 0-based rows of `points`; vertices are numbered from 1 in the file."""
    lines = gocad_head("TSurf", name, unit, z_positive) + ["TFACE"]
    lines += ["VRTX %d %.3f %.3f %.3f" % (i + 1, *p) for i, p in enumerate(points)]
    lines += ["TRGL %d %d %d" % (a + 1, b + 1, c + 1) for a, b, c in triangles]
    with open(path, "w", newline="\n") as file:
        file.write("\n".join(lines + ["END", ""]))


def write_polyline(path, name, points):
    """One GOCAD PLine with one part."""
    lines = gocad_head("PLine", name) + ["ILINE"]
    lines += ["VRTX %d %.3f %.3f %.3f" % (i + 1, *p) for i, p in enumerate(points)]
    lines += ["SEG %d %d" % (i, i + 1) for i in range(1, len(points))]
    with open(path, "w", newline="\n") as file:
        file.write("\n".join(lines + ["END", ""]))


def sheet(nu, nv, place, seed, jitter=0.3):
    """A sheet of nu x nv cells: place(u, v) gives the point for u, v in 0..1. Inner nodes move by `jitter` of a cell; the diagonals
    of the cells go either way. Counter-clockwise in (u, v)."""
    rng = random.Random(seed)
    points = []
    for j in range(nv + 1):
        for i in range(nu + 1):
            du = rng.uniform(-jitter, jitter) if 0 < i < nu else 0.0
            dv = rng.uniform(-jitter, jitter) if 0 < j < nv else 0.0
            points.append(place((i + du) / nu, (j + dv) / nv))
    triangles = []
    for j in range(nv):
        for i in range(nu):
            a, b = j * (nu + 1) + i, j * (nu + 1) + i + 1
            c, d = a + nu + 1, b + nu + 1
            triangles += [(a, b, d), (a, d, c)] if rng.random() < 0.5 else [(a, b, c), (b, d, c)]
    return points, triangles


def horizon(x_range, y_range, nu, nv, height, seed):
    """A horizon z = height(x, y) over a rectangle of the map."""
    def place(u, v):
        x = x_range[0] + u * (x_range[1] - x_range[0])
        y = y_range[0] + v * (y_range[1] - y_range[0])
        return x, y, height(x, y)
    return sheet(nu, nv, place, seed)


def closed_of_rings(n_around, n_rings, bottom, top, place, seed, jitter=0.25):
    """A closed body: a pole at each end, `n_rings` rings of `n_around` points between. place(s, angle) gives the point for s in 0..1
    from bottom to top. Outward normals where the body is seen counter-clockwise from above as the angle grows."""
    rng = random.Random(seed)
    points = [bottom]
    for ring in range(n_rings):
        for k in range(n_around):
            s = (ring + 1 + rng.uniform(-jitter, jitter)) / (n_rings + 1)
            angle = 2 * math.pi * (k + 0.5 * (ring % 2) + rng.uniform(-jitter, jitter)) / n_around
            points.append(place(s, angle))
    points.append(top)

    def node(ring, k):
        return 1 + ring * n_around + k % n_around

    triangles = [(0, node(0, k + 1), node(0, k)) for k in range(n_around)]
    for ring in range(n_rings - 1):
        for k in range(n_around):
            a, b = node(ring, k), node(ring, k + 1)
            c, d = node(ring + 1, k), node(ring + 1, k + 1)
            triangles += [(a, b, c), (b, d, c)] if ring % 2 == 0 else [(a, b, d), (a, d, c)]
    last = len(points) - 1
    triangles += [(last, node(n_rings - 1, k), node(n_rings - 1, k + 1)) for k in range(n_around)]
    return points, triangles


def smooth_curve(knots):
    """Monotone cubic interpolation (Fritsch and Carlson 1980) through (x, y) knots with rising x; y between neighbours never
    overshoots."""
    n = len(knots)
    slope = [(knots[i + 1][1] - knots[i][1]) / (knots[i + 1][0] - knots[i][0]) for i in range(n - 1)]
    tangent = [slope[0]] + [0.0 if slope[i - 1] * slope[i] <= 0 else 2 * slope[i - 1] * slope[i] / (slope[i - 1] + slope[i])
                            for i in range(1, n - 1)] + [slope[-1]]

    def value(x):
        i = max(0, min(n - 2, next((k for k in range(n - 1) if x <= knots[k + 1][0]), n - 2)))
        h = knots[i + 1][0] - knots[i][0]
        t = (x - knots[i][0]) / h
        return ((1 + 2 * t) * (1 - t) ** 2 * knots[i][1] + t * (1 - t) ** 2 * h * tangent[i] + t * t * (3 - 2 * t) * knots[i + 1][1]
                + t * t * (t - 1) * h * tangent[i + 1])
    return value


def rectangles(corner_lists):
    """Plane quadrilaterals, each given by four corners in order, as one surface of unconnected parts."""
    points, triangles = [], []
    for corners in corner_lists:
        a = len(points)
        points += corners
        triangles += [(a, a + 1, a + 2), (a, a + 2, a + 3)]
    return points, triangles


def section_strip(line, y_range):
    """A surface that strikes along y: the polyline `line` of (x, z) swept over y_range."""
    points = [(x, y, z) for y in y_range for x, z in line]
    n = len(line)
    triangles = []
    for i in range(n - 1):
        triangles += [(i, i + 1, n + i + 1), (i, n + i + 1, n + i)]
    return points, triangles


def section_area(polygon):
    """Area of a polygon of (x, z) in a vertical section."""
    return abs(sum(x0 * z1 - x1 * z0 for (x0, z0), (x1, z1) in zip(polygon, polygon[1:] + polygon[:1]))) / 2


def height_of(line, x):
    """Height at x of a polyline of (x, z) with rising x."""
    for (x0, z0), (x1, z1) in zip(line, line[1:]):
        if x0 <= x <= x1:
            return z0 + (z1 - z0) * (x - x0) / (x1 - x0)
    raise ValueError("x lies beside the line")


def area_under_both(one, other, x_range):
    """Integral of the lower of two polylines over x_range: exact, as it is broken at all corners and where they cross."""
    breaks = sorted({x for line in (one, other) for x, _ in line if x_range[0] < x < x_range[1]} | set(x_range))
    crossings = []
    for a, b in zip(breaks, breaks[1:]):
        da, db = height_of(one, a) - height_of(other, a), height_of(one, b) - height_of(other, b)
        if da * db < 0:
            crossings.append(a + (b - a) * da / (da - db))
    breaks = sorted(breaks + crossings)
    lower = [min(height_of(one, x), height_of(other, x)) for x in breaks]
    return sum((b - a) * (u + v) / 2 for a, b, u, v in zip(breaks, breaks[1:], lower, lower[1:]))


def volume_between(points, triangles, low, high):
    """Volume that a closed outward surface encloses between the heights low and high (divergence theorem on the clipped triangles)."""
    def above(level):
        total = 0.0
        for t in triangles:
            polygon, kept = [points[v] for v in t], []
            for p, q in zip(polygon, polygon[1:] + polygon[:1]):
                if p[2] >= level:
                    kept.append(p)
                if (p[2] > level) != (q[2] > level) and p[2] != level and q[2] != level:
                    s = (level - p[2]) / (q[2] - p[2])
                    kept.append((p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1]), level))
            for b, c in zip(kept[1:], kept[2:]):
                a = kept[0]
                flat = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2
                total += flat * ((a[2] + b[2] + c[2]) / 3 - level)
        return total
    return above(low) - above(high)


def rounded(points):
    """As write_ts writes them."""
    return [tuple(float("%.3f" % x) for x in p) for p in points]


def write_expected(path, units):
    """expected.json of a sample: the volumes of the regions of each unit, in m3. Regions of one unit are listed from small to large."""
    units = {name: sorted(volumes) for name, volumes in units.items()}
    with open(path, "w", newline="\n") as file:
        json.dump({"units": units}, file, indent=1, sort_keys=True)
        file.write("\n")
