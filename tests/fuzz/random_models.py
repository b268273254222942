# SPDX-License-Identifier: GPL-3.0-or-later
"""Random whole models: what interpreters bring, made by chance from a seed.

    python3 tests/fuzz/random_models.py SEED FOLDER     writes FOLDER/project.yaml and its surfaces

Layers are random fields (sums of waves) over the map; the column may pinch out, be eroded or onlap. Faults have throw: the horizons are
given block by block. Domes pierce, wells run anywhere. Surfaces may be there twice, nearly twice (moved by 1e-9 to 1e-3 of their size),
or with gaps of 1e-9 along a cut. Coordinates may be those of UTM or rounded. All modes, sizes and tolerances. Every surface by itself
is a graph, a plane or a closed body, so that every model is valid input; what surfaces do to each other is left to chance.
"""
import math
import os
import random
import sys

from gocad_files import write_project, write_surface


class Field:
    """A sum of waves over the unit square, of amplitude 1."""

    def __init__(self, chance, n_waves):
        self.waves = [(chance.uniform(-9, 9), chance.uniform(-9, 9), chance.uniform(0, 7), chance.uniform(0.2, 1)) for _ in range(n_waves)]
        self.sum = sum(w[3] for w in self.waves) or 1

    def __call__(self, u, v):
        return sum(a * math.sin(p * u + q * v + phase) for p, q, phase, a in self.waves) / self.sum


class RandomModel:
    """`surfaces`: (name, kind, points, triangles, extra keys of the entry); `wells`: (name, points); `text` of the project."""

    def __init__(self, seed, as_default=False, light=False):
        """as_default: with the same model, `mesh: {size: L}` and nothing else. light: fewer triangles and larger sizes, so that many run."""
        self.as_default, self.most_cells = as_default, 5 if light else 12
        self.sizes = (0.35, 0.9) if light else (0.15, 0.6)  # of the least side of the box
        self.chance = chance = random.Random(seed)
        self.rounded = chance.random() < 0.2
        self.origin = chance.choice([(0.0, 0.0, 0.0), (-500.0, 300.0, -2500.0), (432000.0, 6512000.0, -4000.0), (7.1e6, 1.2e7, 0.0)])
        self.size = (chance.uniform(500, 9000), chance.uniform(500, 9000), chance.uniform(200, 4000))
        if self.rounded:
            self.size = tuple(float(round(s, -2)) for s in self.size)
        self.surfaces, self.wells, self.rules, self.column = [], [], [], []
        self.fault = self.make_fault() if chance.random() < 0.5 else None
        self.add_layers()
        self.add_more_faults()
        if chance.random() < 0.35:
            self.add_dome()
        self.add_twins()
        for k in range(chance.choice([0, 0, 1, 2])):
            self.add_well(k)
        self.text = self.project_text()

    # ---- places

    def place(self, u, v, w):
        point = tuple(o + f * s for o, f, s in zip(self.origin, (u, v, w), self.size))
        return tuple(float(round(c)) for c in point) if self.rounded else point

    def sheet(self, n_u, n_v, at):
        """A grid of n_u by n_v cells with random diagonals; at(u, v) for u and v from 0 to 1."""
        points = [self.place(*at(i / n_u, j / n_v)) for j in range(n_v + 1) for i in range(n_u + 1)]
        triangles = []
        for j in range(n_v):
            for i in range(n_u):
                a, b = j * (n_u + 1) + i, (j + 1) * (n_u + 1) + i
                triangles += [(a, a + 1, b + 1), (a, b + 1, b)] if self.chance.random() < 0.5 else [(a, a + 1, b), (a + 1, b + 1, b)]
        return points, triangles

    # ---- layers and the main fault

    def make_fault(self):
        """A plane fault across the model: x = place + lean * (z - 1/2), in fractions of the box; throw to its far side."""
        chance = self.chance
        return {"at": chance.uniform(0.3, 0.7), "lean": chance.choice([0.0, chance.uniform(-0.4, 0.4)]), "throw": chance.choice([0.0, chance.uniform(-0.15, 0.15)])}

    def add_layers(self):
        chance = self.chance
        n = chance.randint(1, 5)
        base = Field(chance, 4)
        height = chance.uniform(0.0, 0.12)
        level, levels = 0.93, []
        for _ in range(n):
            level -= chance.uniform(0.05, 0.8 / n)
            levels.append(level)
        previous = None
        for k, level in enumerate(levels):
            field, own = Field(chance, 3), chance.uniform(0, 0.06)
            pinches = previous is not None and chance.random() < 0.3

            def z(u, v, level=level, field=field, own=own, above=previous, pinches=pinches):
                value = level + height * base(u, v) + own * field(u, v)
                if pinches:  # onto the horizon above, exactly
                    value = min(above(u, v), value + 0.15 * max(0.0, u + v - 0.9))
                return value

            self.add_horizon("h%d" % (k + 1), z)
            previous = z
        names = ["h%d" % (k + 1) for k in range(n)]
        if chance.random() < 0.85:
            self.column = ["u1"]
            for k, name in enumerate(names):
                self.column += [name, "u%d" % (k + 2)]
        if self.column and chance.random() < 0.4:
            self.rules.append("on_crossing: %s" % chance.choice(["clip_younger", "clip_older"]))

    def add_horizon(self, name, z):
        chance = self.chance
        n_u, n_v = chance.randint(2, self.most_cells), chance.randint(2, self.most_cells)
        extra = ""
        if chance.random() < 0.1:
            extra = ", base: %s" % chance.choice(["erode", "onlap"])
        reach = 0.1 if chance.random() < 0.85 else -chance.uniform(0.05, 0.2)
        if reach < 0:
            extra += chance.choice(["", ", extend: flat", ", extend: tangent"])
        low, high = -reach, 1 + reach
        if not self.fault or self.fault["throw"] == 0:
            points, triangles = self.sheet(n_u, n_v, lambda u, v: (low + u * (high - low), low + v * (high - low), z(low + u * (high - low), low + v * (high - low))))
        else:
            points, triangles = self.two_blocks(n_u, n_v, z, low, high)
        self.surfaces.append((name, "horizon", points, triangles, extra))

    def two_blocks(self, n_u, n_v, z, low, high):
        """The horizon on either side of the fault, meeting it where it stands at that height; the far side is thrown."""
        points, triangles = [], []
        for far in (False, True):
            def at(u, v, far=far):
                y = low + v * (high - low)
                w = z(self.fault["at"], y) + (self.fault["throw"] if far else 0)
                edge = self.fault["at"] + self.fault["lean"] * (w - 0.5)
                x = edge + u * (high - edge) if far else low + u * (edge - low)
                fade = u if far else 1 - u  # near the fault the height is that at the fault, so that the edge lies on it
                height = fade * z(x, y) + (1 - fade) * z(self.fault["at"], y)
                return x, y, height + (self.fault["throw"] if far else 0)
            block_points, block_triangles = self.sheet(max(1, n_u // 2), n_v, at)
            triangles += [tuple(i + len(points) for i in t) for t in block_triangles]
            points += block_points
        return points, triangles

    def add_more_faults(self):
        chance = self.chance
        if self.fault:
            at, lean = self.fault["at"], self.fault["lean"]
            n_u, n_v = chance.randint(1, 6), chance.randint(1, 6)
            self.surfaces.append(("f1", "fault", *self.sheet(n_u, n_v, lambda u, v: (at + lean * (1.2 * v - 0.1 - 0.5), -0.1 + 1.2 * u, -0.1 + 1.2 * v)), ""))
        for k in range(chance.choice([0, 0, 1, 2])):
            x, y, strike = chance.uniform(0.2, 0.8), chance.uniform(0.2, 0.8), chance.uniform(0, math.pi)
            lean, wave = chance.uniform(-0.5, 0.5), chance.choice([0.0, chance.uniform(0, 0.04)])
            back, ahead = (2.0 if chance.random() < 0.5 else chance.uniform(0.1, 0.5) for _ in range(2))
            top, foot = (1.1 if chance.random() < 0.5 else chance.uniform(0.6, 0.95)), (-0.1 if chance.random() < 0.5 else chance.uniform(0.05, 0.4))

            def at_fault(u, v):
                along, w = -back + u * (back + ahead), foot + v * (top - foot)
                aside = lean * (w - 0.5) + wave * math.sin(8 * along)
                return x + along * math.cos(strike) - aside * math.sin(strike), y + along * math.sin(strike) + aside * math.cos(strike), w

            self.surfaces.append(("f%d" % (k + 2), "fault", *self.sheet(chance.randint(1, 8), chance.randint(1, 6), at_fault), ""))
        if len(self.surfaces) > 2 and chance.random() < 0.15:
            self.rules.append("trim_overshoot: %r" % (0.05 * min(self.size)))

    def add_dome(self):
        """A closed mushroom or ball of rings, outward."""
        chance = self.chance
        centre, radius = [chance.uniform(0.25, 0.75) for _ in range(2)], chance.uniform(0.08, 0.25)
        foot, crown = chance.choice([-0.15, chance.uniform(0.05, 0.3)]), chance.choice([1.15, chance.uniform(0.6, 0.95)])
        n_rings, n_round, bulge = chance.randint(2, 7), chance.randint(4, 12), chance.uniform(0.0, 0.6)

        def ring(t, angle):
            r = radius * (math.sin(math.pi * t) + bulge * math.sin(2 * math.pi * t) ** 2) * (1 + 0.12 * math.sin(3 * angle))
            return self.place(centre[0] + r * math.cos(angle), centre[1] + r * math.sin(angle), foot + t * (crown - foot))

        points = [self.place(centre[0], centre[1], foot)]
        for k in range(n_rings):
            points += [ring((k + 1) / (n_rings + 1), 2 * math.pi * i / n_round) for i in range(n_round)]
        points.append(self.place(centre[0], centre[1], crown))
        triangles = []
        last = 1 + (n_rings - 1) * n_round
        for i in range(n_round):
            j = (i + 1) % n_round
            triangles += [(0, 1 + j, 1 + i), (last + i, last + j, len(points) - 1)]
            for k in range(n_rings - 1):
                a, b = 1 + k * n_round, 1 + (k + 1) * n_round
                triangles += [(a + i, a + j, b + j), (a + i, b + j, b + i)]
        self.surfaces.append(("salt", "body", points, triangles, "" if chance.random() < 0.8 else ", cuts: none"))

    # ---- what makes trouble

    def add_twins(self):
        """A surface again, moved by nothing or next to nothing; or a gap of 1e-9 along a column of cells."""
        chance = self.chance
        draw = chance.random()
        if draw > 0.35 or self.rounded:
            return
        faults = [s for s in self.surfaces if s[1] == "fault"]
        if draw < 0.1:
            self.open_a_gap(chance.choice(self.surfaces))
        elif faults:
            name, kind, points, triangles, extra = chance.choice(faults)
            by = chance.choice([0.0, 1e-9, 1e-6, 1e-3]) * min(self.size)
            self.surfaces.append((name + "_twin", kind, [(x + by, y, z) for x, y, z in points], triangles, extra))

    def open_a_gap(self, surface):
        """The first triangles get points of their own, 1e-9 apart from the others'."""
        _, kind, points, triangles, _ = surface
        if kind == "body":
            return
        n_own = len(triangles) // 2
        own = {}
        for t in range(n_own):
            for v in triangles[t]:
                if v not in own:
                    own[v] = len(points)
                    points.append(tuple(c + 1e-9 * self.chance.uniform(-1, 1) for c in points[v]))
            triangles[t] = tuple(own[v] for v in triangles[t])

    def add_well(self, k):
        chance = self.chance
        u, v, top = chance.uniform(0.05, 0.95), chance.uniform(0.05, 0.95), chance.choice([1.0, 1.1])
        points, w = [self.place(u, v, top)], top
        for _ in range(chance.randint(1, 8)):
            w -= chance.uniform(0.05, 0.3)
            u, v = u + chance.choice([0, chance.uniform(-0.1, 0.1)]), v + chance.choice([0, chance.uniform(-0.1, 0.1)])
            points.append(self.place(u, v, w))
        self.wells.append(("w%d" % (k + 1), points))

    # ---- files

    def mesh_text(self):
        chance = self.chance
        size = float("%.3g" % (min(self.size) * chance.uniform(*self.sizes)))
        if self.as_default:
            return "{size: %r}" % size
        draw = chance.random()
        if draw < 0.3:
            return "{mode: constrained, refine: none}"
        if draw < 0.4:
            return "{mode: constrained, refine: none, preserve_boundary: true}"
        if draw < 0.5:
            return "{mode: conforming, refine: none}"
        asked = "size: {global: %r, input_edges: false}, quality: fast" % size
        if draw < 0.75:
            return "{%s, honour: exact}" % asked
        return "{%s, honour: tolerance, tolerance: %r}" % (asked, float("%.3g" % (size * chance.choice([0.005, 0.02, 0.1]))))

    def project_text(self):
        high = tuple(o + s for o, s in zip(self.origin, self.size))
        lines = ["name: model", "box: {min: [%r, %r, %r], max: [%r, %r, %r]}" % (*self.origin, *high), "surfaces:"]
        lines += ["  - {name: %s, kind: %s, file: %s.ts%s}" % (name, kind, name, extra) for name, kind, _, _, extra in self.surfaces]
        if self.wells:
            lines += ["wells:"] + ["  - {name: %s, file: %s.pl}" % (name, name) for name, _ in self.wells]
        if self.column:
            lines.append("column: [%s]" % ", ".join(self.column))
        if self.rules:
            lines.append("rules: {%s}" % ", ".join(self.rules))
        return "\n".join(lines + ["mesh: " + self.mesh_text(), "output: {directory: out, formats: [vtu]}", ""])

    def write(self, folder):
        """Returns the project file."""
        os.makedirs(folder, exist_ok=True)
        for name, _, points, triangles, _ in self.surfaces:
            write_surface(folder, name, points, triangles)
        for name, points in self.wells:
            with open(os.path.join(folder, name + ".pl"), "w") as file:
                file.write("GOCAD PLine 1\nHEADER {\nname:%s\n}\nILINE\n" % name)
                file.writelines("VRTX %d %r %r %r\n" % (i + 1, *p) for i, p in enumerate(points))
                file.writelines("SEG %d %d\n" % (i + 1, i + 2) for i in range(len(points) - 1))
                file.write("END\n")
        return write_project(folder, self.text)


if __name__ == "__main__":
    print(RandomModel(int(sys.argv[1])).write(sys.argv[2]))
