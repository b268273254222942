# SPDX-License-Identifier: GPL-3.0-or-later
"""A family of dykes and plutons that a later fault has cut and displaced."""
import math

from family import PlaneFaults, joined, lattice


def box_surface(low, high, n):
    """The closed surface of a box between two corners, with `n` divisions along each axis, as a list of triangles of corners."""
    triangles = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for end in (0, 1):
            def corner(i, j):
                p = [0.0, 0.0, 0.0]
                p[axis] = high[axis] if end else low[axis]
                p[u] = low[u] + (high[u] - low[u]) * i / n[u]
                p[v] = low[v] + (high[v] - low[v]) * j / n[v]
                return tuple(p)
            for i in range(n[u]):
                for j in range(n[v]):
                    a, b, c, d = corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)
                    both = [(a, b, c), (a, c, d)]
                    triangles += both if end else [t[::-1] for t in both]
    return triangles


def cut(triangles, distance):
    """What lies of a closed surface where `distance` is not negative, closed by a plane cap about the middle of the cut."""
    kept, rim = [], []
    for t in triangles:
        at = [distance(p) for p in t]
        part, ends = [], []
        for i in range(3):
            p, q, dp, dq = t[i], t[(i + 1) % 3], at[i], at[(i + 1) % 3]
            if dp >= 0:
                part.append(p)
            if (dp >= 0) != (dq >= 0):
                if dp > dq:   # the same point from both triangles of the edge
                    p, q, dp, dq = q, p, dq, dp
                r = tuple(a + (b - a) * dp / (dp - dq) for a, b in zip(p, q))
                part.append(r)
                ends.append((r, at[i] >= 0))
        kept += [(part[0], part[i], part[i + 1]) for i in range(1, len(part) - 1)]
        if len(ends) == 2:
            leaving, entering = sorted(ends, key=lambda e: not e[1])
            rim.append((leaving[0], entering[0]))
    if rim:
        middle = tuple(sum(a[i] for a, _ in rim) / len(rim) for i in range(3))
        kept += [(b, a, middle) for a, b in rim]
    return kept


def indexed(triangles):
    """Points and triangles of rows."""
    rows = {}
    for t in triangles:
        for p in t:
            rows.setdefault(p, len(rows))
    return list(rows), [tuple(rows[p] for p in t) for t in triangles]


class Intrusion(PlaneFaults):
    """A near-vertical dyke of 40 to 150 m (even models) or a pluton that leaves the box through its base (odd models), in three layers. A later
    normal fault has displaced all along its dip. The body is given as two closed parts, which end at the fault, or some metres before it
    (models 2, 3 of each four)."""
    step = 120.0

    def __init__(self, seed):
        self.is_dyke, self.ends_before = seed % 2 == 0, seed % 4 >= 2
        super().__init__(seed)

    def make(self):
        c = self.chance
        if self.is_dyke:   # across the fault
            self.strike = math.radians(c.uniform(-25, 25))
            self.lean, self.half, self.middle = c.uniform(-0.1, 0.1), c.uniform(20, 75), (3000.0, c.uniform(2000, 3000), -1500.0)
            self.ends = c.choice([(4500.0, 3000.0), (2000.0, 700.0)])   # half length and half height: through the box, or blind in it
        else:
            self.middle, self.lobes = (c.uniform(2500, 3500), c.uniform(2200, 2800), -2700.0), (c.uniform(0.05, 0.15), c.uniform(0, 6))
            self.radii = (c.uniform(1200, 1700), c.uniform(1000, 1500), c.uniform(900, 1500))
        self.plane(c.uniform(2700, 3300), 2500, c.uniform(-15, 15), c.uniform(55, 70))
        self.throw = c.uniform(80, 250)
        self.faults["f0"] = self.fault_sheet(0)
        self.bodies["intrusion"] = joined([indexed(self.part(hanging)) for hanging in (False, True)])

    def size(self):
        return 300.0 if self.is_dyke else 400.0

    def slip(self):
        """How far the hanging wall was displaced, down the dip of the fault."""
        n = self.planes[0][1]
        flat = math.hypot(n[0], n[1])
        return tuple(self.throw * s for s in (n[0] / flat * n[2] / flat, n[1] / flat * n[2] / flat, -1.0))

    def surface(self):
        """The body before it was displaced, as triangles."""
        if self.is_dyke:
            length, height = self.ends
            corners = box_surface((-length, -self.half, -height), (length, self.half, height), (24, 2, 16))
            return [tuple(self.in_dyke(q) for q in t) for t in corners]
        def ball(q):
            length = math.hypot(*q)
            u = tuple(a / length for a in q)
            r = self.lobe(u)
            return tuple(m + r * s * a for m, s, a in zip(self.middle, self.radii, u))
        return [tuple(ball(q) for q in t) for t in box_surface((-1, -1, -1), (1, 1, 1), (12, 12, 12))]

    def lobe(self, u):
        """The radius of the pluton in a direction, in radii of the ellipsoid."""
        return 1 + self.lobes[0] * math.sin(3 * math.atan2(u[1], u[0]) + self.lobes[1]) * (1 - u[2] * u[2])

    def in_dyke(self, q):
        """The place along, across and above the middle of the dyke."""
        x, y, z = q
        c, s = math.cos(self.strike), math.sin(self.strike)
        y += self.lean * z
        return (self.middle[0] + x * c - y * s, self.middle[1] + x * s + y * c, self.middle[2] + z)

    def is_inside(self, p):
        """Whether a place, before it was displaced, lies in the body."""
        d = tuple(a - b for a, b in zip(p, self.middle))
        if not self.is_dyke:
            q = tuple(a / r for a, r in zip(d, self.radii))
            length = math.hypot(*q) or 1e-9
            return length < self.lobe(tuple(a / length for a in q))
        c, s = math.cos(self.strike), math.sin(self.strike)
        along, across = d[0] * c + d[1] * s, -d[0] * s + d[1] * c - self.lean * d[2]
        return abs(along) < self.ends[0] and abs(across) < self.half and abs(d[2]) < self.ends[1]

    def part(self, hanging):
        """The part of the body on one side of the fault, closed by a plane. Coordinates are rounded to millimetres, as files have them."""
        move = self.slip() if hanging else (0.0, 0.0, 0.0)
        triangles = [tuple(tuple(a + b for a, b in zip(p, move)) for p in t) for t in self.surface()]
        sign, stop = (1 if hanging else -1), (0.4 * self.gap if self.ends_before else 0.0)
        kept = [tuple(tuple(round(a, 3) for a in p) for p in t) for t in cut(triangles, lambda p: sign * self.distance(0, p) - stop)]
        return [t for t in kept if len(set(t)) == 3]

    def before(self, p):
        """The place before the fault moved."""
        return tuple(a - b for a, b in zip(p, self.slip())) if self.distance(0, p) > 0 else p

    def unit_at(self, p):
        q = self.before(p)
        return "intrusion" if self.is_inside(q) else next(("u%d" % k for k in range(self.n_layers) if q[2] > self.height(k, *q[:2])),
                                                          "u%d" % self.n_layers)

    def blocks(self):
        return [(False,), (True,)]

    def sheet(self, k, block):
        dx, dy, dz = self.slip() if block[0] else (0.0, 0.0, 0.0)

        def place(x, y):
            z = self.height(k, x - dx, y - dy) + dz
            outside = not self.is_inside(self.before((x, y, z)))
            return z if outside and self.margin_to(block, (x, y, z)) >= self.gap else None
        return lattice(self.box, self.step, self.margin, place)
