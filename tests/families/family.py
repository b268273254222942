# SPDX-License-Identifier: GPL-3.0-or-later
"""What the families of models share: lattices, the base class Family, and models whose faults are planes.

Layers lie at `height(k, x, y)`, youngest first. Faults divide the box into blocks. `shift(block, x, y)` tells by how much the layers of a block lie
higher than they were deposited. Surfaces are sampled on lattices, and stop short of what bounds them by `gap`, as interpreted surfaces do.

Lengths are metres. Only Python's standard library is used.
"""
import math
import os
import random
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "fuzz"))
from gocad_files import write_project, write_surface  # noqa: E402


def lattice(box, step, margin, place):
    """A triangulated lattice over the map of the box, grown by `margin` (negative: it ends inside). `place(x, y)` gives the height of a node, or
    None where there is no node. Triangles with a missing corner are left out."""
    (x0, y0, _), (x1, y1, _) = box
    x0, y0, x1, y1 = x0 - margin, y0 - margin, x1 + margin, y1 + margin
    nx, ny = max(2, round((x1 - x0) / step)), max(2, round((y1 - y0) / step))
    row, points = {}, []
    for j in range(ny + 1):
        for i in range(nx + 1):
            x, y = x0 + (x1 - x0) * i / nx, y0 + (y1 - y0) * j / ny
            z = place(x, y)
            if z is not None:
                row[i, j] = len(points)
                points.append((x, y, z))
    triangles = []
    for j in range(ny):
        for i in range(nx):
            for corners in (((i, j), (i + 1, j), (i + 1, j + 1)), ((i, j), (i + 1, j + 1), (i, j + 1))):
                if all(c in row for c in corners):
                    triangles.append(tuple(row[c] for c in corners))
    used = sorted({v for t in triangles for v in t})
    new = {v: k for k, v in enumerate(used)}
    return [points[v] for v in used], [tuple(new[v] for v in t) for t in triangles]


def joined(sheets):
    points, triangles = [], []
    for more, others in sheets:
        triangles += [tuple(v + len(points) for v in t) for t in others]
        points += more
    return points, triangles


def strip(rows):
    """Triangles between rows of equally many points."""
    points = [p for row in rows for p in row]
    n = len(rows[0])
    triangles = []
    for j in range(len(rows) - 1):
        for i in range(n - 1):
            a = j * n + i
            triangles += [(a, a + 1, a + n + 1), (a, a + n + 1, a + n)]
    return points, triangles


class Family:
    """Base: smooth layers without faults. `distances(p)` lists signed distances from faults, which tell the block."""
    box = ((0.0, 0.0, -3000.0), (6000.0, 5000.0, 0.0))
    n_layers = 3
    step = 250.0
    gap = 0.0
    margin = 300.0

    def __init__(self, seed):
        self.chance = random.Random(seed)
        c = self.chance
        self.depths = [-700.0 - 600.0 * k + c.uniform(-60, 60) for k in range(self.n_layers)]
        self.tilt = (c.uniform(-0.03, 0.03), c.uniform(-0.03, 0.03))
        self.wave = (c.uniform(20, 70), c.uniform(3000, 6000), c.uniform(0, 6))
        self.faults = {}   # name: (points, triangles)
        self.bodies = {}
        self.keys = {}     # careful form: keys of surfaces
        self.rules = []    # careful form: further lines
        self.setup()

    def setup(self):
        pass

    def height(self, k, x, y):
        amplitude, length, phase = self.wave
        return self.depths[k] + self.tilt[0] * (x - 3000) + self.tilt[1] * (y - 2500) + amplitude * math.sin(2 * math.pi * x / length + phase + y / 4000)

    def blocks(self):
        """Lists all blocks that have layers."""
        return [()]

    def block_at(self, p):
        return ()

    def shift(self, block, x, y):
        return 0.0

    def margin_to(self, block, p):
        """How far inside the block the place is, about; negative outside."""
        return math.inf

    def unit_at(self, p):
        block = self.block_at(p)
        for k in range(self.n_layers):
            if p[2] > self.height(k, p[0], p[1]) + self.shift(block, p[0], p[1]):
                return "u%d" % k
        return "u%d" % self.n_layers

    def sheet(self, k, block):
        def place(x, y):
            z = self.height(k, x, y) + self.shift(block, x, y)
            return z if self.margin_to(block, (x, y, z)) >= self.gap else None
        return lattice(self.box, self.step, self.margin, place)

    def horizons(self):
        return {"h%d" % k: joined([self.sheet(k, b) for b in self.blocks()]) for k in range(self.n_layers)}

    def column(self):
        entries = ["u0"]
        for k in range(self.n_layers):
            entries += ["h%d" % k, "u%d" % (k + 1)]
        return entries

    def write(self, folder, form="bare"):
        os.makedirs(folder, exist_ok=True)
        lines = ["name: model", "box: {min: [%g, %g, %g], max: [%g, %g, %g]}" % (self.box[0] + self.box[1]), "surfaces:"]
        for kind, surfaces in (("horizon", self.horizons()), ("fault", self.faults), ("body", self.bodies)):
            for name, surface in surfaces.items():
                file = self.write_data(folder, kind, name, surface)
                keys = self.keys.get(name, "") if form == "careful" else ""
                lines.append("  - {name: %s, kind: %s, file: %s%s}" % (name, kind, file, ", " + keys if keys else ""))
        lines += ["column: [%s]" % ", ".join(self.column()), "mesh: {size: %g}" % self.size()]
        if form == "careful":
            lines += self.rules
        lines.append("output: {directory: out}")
        return write_project(folder, "\n".join(lines) + "\n")

    def write_data(self, folder, kind, name, surface):
        """Writes the file of one surface and returns the file's name."""
        write_surface(folder, name, *surface)
        return name + ".ts"

    def size(self):
        return 300.0

    def noise(self):
        return 0.0

    def room(self, p):
        """How far boundaries near this place may lie from the formula by the data given; infinite where the data do not tell the unit."""
        return self.gap


class PlaneFaults(Family):
    """Faults that are planes, one behind the other or crossing; throws are constant by block. Subclasses fill `planes`: (point, unit normal)."""
    step = 150.0

    def setup(self):
        self.planes, self.throws = [], {}
        self.gap = self.chance.uniform(5, 40)
        self.make()
        for k in range(self.n_layers):
            self.keys["h%d" % k] = "throw_at: auto, extend: tangent"
        for f in self.faults:
            self.keys[f] = "extent: to_box"

    def plane(self, x, y, strike, dip, z=-1500.0):
        """A plane through the place, with its normal towards the hanging wall; strike and dip in degrees."""
        s, d = math.radians(strike), math.radians(dip)
        self.planes.append(((x, y, z), (math.cos(s) * math.sin(d), -math.sin(s) * math.sin(d), math.cos(d))))
        return len(self.planes) - 1

    def distance(self, f, p):
        q, n = self.planes[f]
        return sum((a - b) * c for a, b, c in zip(p, q, n))

    def fault_sheet(self, f, keep=lambda p: True, step=300.0):
        """The plane within the box, grown by some 200 m, where `keep` holds for all corners of a triangle."""
        q, n = self.planes[f]
        u = (n[1], -n[0], 0.0)
        length = math.hypot(*u[:2])
        u = (u[0] / length, u[1] / length, 0.0)
        v = (n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0])
        row, points, triangles = {}, [], []
        reach = 30
        for j in range(-reach, reach + 1):
            for i in range(-reach, reach + 1):
                p = tuple(a + step * (i * b + j * c) for a, b, c in zip(q, u, v))
                if all(lo - 1.7 * step <= x <= hi + 1.7 * step for x, lo, hi in zip(p, *self.box)) and keep(p):
                    row[i, j] = len(points)
                    points.append(p)
        for (i, j) in list(row):
            for corners in (((i, j), (i + 1, j), (i + 1, j + 1)), ((i, j), (i + 1, j + 1), (i, j + 1))):
                if all(c in row for c in corners):
                    triangles.append(tuple(row[c] for c in corners))
        used = sorted({v for t in triangles for v in t})
        new = {v: k for k, v in enumerate(used)}
        return [points[v] for v in used], [tuple(new[v] for v in t) for t in triangles]

    def block_at(self, p):
        return self.canonical(tuple(self.distance(f, p) > 0 for f in range(len(self.planes))))

    def canonical(self, sides):
        return sides

    def blocks(self):
        return sorted(self.throws)

    def shift(self, block, x, y):
        return self.throws.get(block, 0.0)

    def margin_to(self, block, p):
        if self.block_at(p) != block:
            return -1.0
        return min(abs(self.distance(f, p)) for f in self.bounding(block))

    def bounding(self, block):
        return range(len(self.planes))
