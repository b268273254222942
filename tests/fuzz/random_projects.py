# SPDX-License-Identifier: GPL-3.0-or-later
"""Random well-formed projects: horizons, faults and a salt body that disagree with each other as interpreted surfaces do.

    python3 tests/fuzz/random_projects.py SEED FOLDER     writes FOLDER/project.yaml and its surfaces

The same seed gives the same files. Every surface by itself is a sheet or a closed body without crossings; what they do to each other
is left to chance: horizons may cross, stop short of the box, coincide or lie in a side of the box; faults may end inside, pass along grid
lines or through everything; salt may pierce, touch or leave the box. A third of the projects has rounded coordinates, so that points,
edges and planes of different surfaces coincide exactly.
"""
import math
import os
import random
import sys

from gocad_files import write_project, write_surface


class RandomProject:
    """The model of one seed: `box` (low, high corners), `surfaces` as (name, kind, points, triangles), `text` of the project file."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.rounded = self.random.random() < 1 / 3
        self.origin = self.random.choice([(0.0, 0.0, 0.0), (0.0, 0.0, -3000.0), (432000.0, 6512000.0, -4000.0)])
        self.size = tuple(self.number(*limits) for limits in ((800, 12000), (800, 12000), (400, 5000)))
        self.box = (self.origin, tuple(o + s for o, s in zip(self.origin, self.size)))
        self.surfaces = []
        for k in range(self.random.randint(1, 4)):
            self.surfaces.append(("horizon_%d" % (k + 1), "horizon", *self.horizon()))
        for k in range(self.random.choice([0, 1, 1, 2, 3])):
            self.surfaces.append(("fault_%d" % (k + 1), "fault", *self.fault()))
        if self.random.random() < 0.4:
            self.surfaces.append(("salt", "body", *self.salt()))
        self.text = self.project_text()

    def number(self, low, high):
        value = self.random.uniform(low, high)
        return float(round(value, -2)) if self.rounded else value

    def point(self, fractions):
        """A place given by fractions of the box."""
        place = [o + f * s for o, f, s in zip(self.origin, fractions, self.size)]
        return tuple(float(round(c, -1)) for c in place) if self.rounded else tuple(place)

    def sheet(self, n_u, n_v, place):
        """A grid of n_u x n_v cells, each cut along a random diagonal; place(u, v) for u and v from 0 to 1."""
        points = [self.point(place(i / n_u, j / n_v)) for j in range(n_v + 1) for i in range(n_u + 1)]
        triangles = []
        for j in range(n_v):
            for i in range(n_u):
                a, b = j * (n_u + 1) + i, (j + 1) * (n_u + 1) + i
                if self.random.random() < 0.5:
                    triangles += [(a, a + 1, b + 1), (a, b + 1, b)]
                else:
                    triangles += [(a, a + 1, b), (a + 1, b + 1, b)]
        return points, triangles

    def horizon(self):
        choice = self.random
        level = choice.choice([0.0, 1.0, 0.5]) if choice.random() < 0.08 else choice.uniform(0.1, 0.9)
        wave = 0.0 if choice.random() < 0.2 else choice.uniform(0.0, 0.15)
        dip_x, dip_y = (choice.uniform(-0.4, 0.4) if choice.random() < 0.3 else 0.0 for _ in range(2))
        long_x, long_y, phase = choice.uniform(3, 12), choice.uniform(3, 12), choice.uniform(0, 6)
        low = [-0.1 if choice.random() < 0.85 else choice.uniform(0.05, 0.4) for _ in range(2)]
        high = [1.1 if choice.random() < 0.85 else choice.uniform(0.6, 0.95) for _ in range(2)]
        noise = choice.choice([0.0, 0.0, 0.01])

        def place(u, v):
            x, y = low[0] + u * (high[0] - low[0]), low[1] + v * (high[1] - low[1])
            z = level + wave * math.sin(long_x * x + phase) * math.cos(long_y * y) + dip_x * (x - 0.5) + dip_y * (y - 0.5)
            return x, y, z + choice.uniform(-noise, noise)

        return self.sheet(choice.randint(1, 9), choice.randint(1, 9), place)

    def fault(self):
        """Along a strike, down a dip, waved; half of the borders lie inside the box."""
        choice = self.random
        x, y = choice.uniform(0.2, 0.8), choice.uniform(0.2, 0.8)
        strike = choice.choice([0.0, math.pi / 2]) if choice.random() < 0.3 else choice.uniform(0, math.pi)
        lean = 0.0 if choice.random() < 0.3 else choice.uniform(-0.6, 0.6)
        back, ahead = (2.0 if choice.random() < 0.5 else choice.uniform(0.1, 0.5) for _ in range(2))
        top = 1.1 if choice.random() < 0.5 else choice.uniform(0.55, 0.95)
        foot = -0.1 if choice.random() < 0.5 else choice.uniform(0.05, 0.45)
        wave = 0.0 if choice.random() < 0.5 else choice.uniform(0, 0.05)

        def place(u, v):
            along = -back + u * (back + ahead)
            z = foot + v * (top - foot)
            aside = lean * (z - 0.5) + wave * math.sin(7 * along + 3 * z)
            return x + along * math.cos(strike) - aside * math.sin(strike), y + along * math.sin(strike) + aside * math.cos(strike), z

        return self.sheet(choice.randint(1, 7), choice.randint(1, 6), place)

    def salt(self):
        """A waved ball of rings of points, outward."""
        choice = self.random
        centre = [choice.uniform(0.2, 0.8) for _ in range(3)]
        radii = [choice.uniform(0.1, 0.4) for _ in range(3)]
        n_rings, n_round = choice.randint(2, 6), choice.randint(3, 10)

        def place(latitude, longitude):
            swell = 1 + 0.15 * math.sin(3 * longitude) * math.cos(latitude) ** 2
            direction = (math.cos(latitude) * math.cos(longitude), math.cos(latitude) * math.sin(longitude), math.sin(latitude))
            return self.point([c + r * swell * d for c, r, d in zip(centre, radii, direction)])

        points = [place(-math.pi / 2, 0)]
        for ring in range(n_rings):
            latitude = -math.pi / 2 + math.pi * (ring + 1) / (n_rings + 1)
            points += [place(latitude, 2 * math.pi * k / n_round) for k in range(n_round)]
        points.append(place(math.pi / 2, 0))
        triangles = []
        for k in range(n_round):
            after = (k + 1) % n_round
            triangles.append((0, 1 + after, 1 + k))
            last = 1 + (n_rings - 1) * n_round
            triangles.append((last + k, last + after, len(points) - 1))
            for ring in range(n_rings - 1):
                a, b = 1 + ring * n_round, 1 + (ring + 1) * n_round
                triangles += [(a + k, a + after, b + after), (a + k, b + after, b + k)]
        return points, triangles

    def project_text(self):
        lines = ["name: model", "box: {min: [%r, %r, %r], max: [%r, %r, %r]}" % (*self.box[0], *self.box[1]), "surfaces:"]
        for name, kind, _, _ in self.surfaces:
            cuts = ", cuts: none" if kind == "body" and self.random.random() < 0.2 else ""
            lines.append("  - {name: %s, kind: %s, file: %s.ts%s}" % (name, kind, name, cuts))
        horizons = [name for name, kind, _, _ in self.surfaces if kind == "horizon"]
        if self.random.random() < 0.7:
            column = ["unit_1"]
            for k, name in enumerate(horizons):
                column += [name, "unit_%d" % (k + 2)]
            lines.append("column: [%s]" % ", ".join(column))
        mesh = self.random.choice(["mesh: {refine: none}"] * 3 + ["mesh: {preserve_boundary: true}", "mesh: {mode: conforming}"])
        return "\n".join(lines + ([mesh] if mesh else []) + ["output: {directory: out, formats: [vtu]}", ""])

    def volume(self):
        return math.prod(high - low for low, high in zip(*self.box))

    def write(self, folder):
        """Returns the project file."""
        os.makedirs(folder, exist_ok=True)
        for name, _, points, triangles in self.surfaces:
            write_surface(folder, name, points, triangles)
        return write_project(folder, self.text)


if __name__ == "__main__":
    print(RandomProject(int(sys.argv[1])).write(sys.argv[2]))
