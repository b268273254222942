#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random columns with rules, whose unit is known at each point.

    python3 tests/fuzz/random_rules.py SEED FOLDER     writes FOLDER/project.yaml and its surfaces

Two to four horizons run through the model, each a function of the map on a lattice of its own. They cross as slopes and domes will have it.
What they do then is drawn: `base: erode` or `onlap`, `on_crossing`, or nothing. A topography or a bottom ends some models. In some, one or two
faults through the model throw the older horizons, which come in sheets that overshoot the faults. Faults without throw, bodies and the kind of
volume are drawn too.

`unit_at` tells the unit at a point from the heights of the horizons and the rules alone.
"""
import math
import os
import random
import sys

from gocad_files import write_project, write_surface

SIZE = 10.0  # of the model, in units of its scale


class Sheet:
    """A function of the map, linear on the triangles of a lattice from -1 to 11."""

    def __init__(self, chance, level, slope, relief, steps=(0.75, 1.0, 1.5, 3.0, 12.0)):
        self.step = chance.choice(steps)
        self.n = round(12 / self.step)
        a, b = chance.uniform(-slope, slope), chance.uniform(-slope, slope)
        domes = [(chance.uniform(0, 10), chance.uniform(0, 10), chance.uniform(1.5, 4), chance.uniform(-relief, relief)) for _ in range(2)]
        self.nodes = [[level + a * (x - 5) + b * (y - 5) + sum(h * math.exp(-((x - u) ** 2 + (y - v) ** 2) / (r * r)) for u, v, r, h in domes)
                       for x in self.ticks()] for y in self.ticks()]

    def ticks(self):
        return [-1 + self.step * i for i in range(self.n + 1)]

    def z(self, x, y):
        u, v = (x + 1) / self.step, (y + 1) / self.step
        i, j = min(self.n - 1, max(0, int(u))), min(self.n - 1, max(0, int(v)))
        u, v = u - i, v - j
        low, high = self.nodes[j], self.nodes[j + 1]
        if v > u:
            return low[i] + u * (high[i + 1] - high[i]) + v * (high[i] - low[i])
        return low[i] + u * (low[i + 1] - low[i]) + v * (high[i + 1] - low[i + 1])

    def triangulated(self, low=-1.0, high=11.0, lift=0.0):
        """What of it meets x from low to high, lifted."""
        columns = [i for i, x in enumerate(self.ticks()) if low - self.step < x < high + self.step]
        ticks, n = self.ticks(), len(columns)
        points = [(ticks[i], y, self.nodes[j][i] + lift) for j, y in enumerate(ticks) for i in columns]
        corners = [j * n + i for j in range(self.n) for i in range(n - 1)]
        return points, [t for c in corners for t in ((c, c + 1, c + n + 1), (c, c + n + 1, c + n))]


class ThrowFault:
    """A plane along y through the model, which may lean."""

    def __init__(self, place, lean):
        self.place, self.lean = place, lean

    def x(self, z):
        return self.place + self.lean * (z - 5)

    def triangulated(self):
        return [(self.x(z), y, z) for z in (-1, 11) for y in (-1, 11)], [(0, 1, 3), (0, 3, 2)]


class Body:
    """A convex octahedron; what is inside is told by its planes."""

    def __init__(self, chance):
        self.center = [chance.uniform(1, 9) for _ in range(3)]
        self.radii = [chance.uniform(1, 2.5) for _ in range(3)]
        turn = chance.uniform(0, math.pi)
        self.axes = [(math.cos(turn), math.sin(turn), 0.0), (-math.sin(turn), math.cos(turn), 0.0), (0.0, 0.0, 1.0)]

    def depth(self, p):
        """Of a point below the walls, in shares of the radius; below nought outside."""
        d = [a - b for a, b in zip(p, self.center)]
        return 1 - sum(abs(sum(a * b for a, b in zip(d, axis))) / r for axis, r in zip(self.axes, self.radii))

    def triangulated(self):
        points = [tuple(c + s * r * a for c, a in zip(self.center, axis)) for axis, r in zip(self.axes, self.radii) for s in (1, -1)]
        triangles = []
        for a in (0, 1):
            for b in (2, 3):
                for c in (4, 5):
                    triangles.append((a, b, c) if (a + b + c) % 2 == 0 else (a, c, b))
        return points, triangles


class RandomRules:
    """`least` is the distance from surfaces within which a point's unit is not asked."""

    def __init__(self, seed):
        self.chance = chance = random.Random(seed)
        self.scale, self.shift = chance.choice([(1.0, (0, 0, 0)), (1.0, (0, 0, 0)), (200.0, (0, 0, -1000)), (500.0, (500000, 5800000, -3000))])
        n = chance.choice([2, 2, 3, 3, 4])
        slope, relief = chance.choice([(0, 0), (0.1, 0.3), (0.3, 1), (0.3, 2)])
        levels = [8 - 6 * (k + 0.5 + chance.uniform(-0.3, 0.3)) / n for k in range(n)]
        self.throw_faults = [ThrowFault(x, chance.choice([0, chance.uniform(-0.2, 0.2)])) for x in chance.choice([[], [], [5.2], [3.3, 6.9]])]
        steps = [(0.75, 1.0, 1.5)] if self.throw_faults else []
        self.sheets = [Sheet(chance, level, slope, relief, *steps) for level in levels]
        self.n_whole = chance.randrange(n) if self.throw_faults else n  # the younger horizons, which have no throw
        compartments = [0.0] + [chance.uniform(-1.5, 1.5) for _ in self.throw_faults]
        self.lifts = [compartments if k >= self.n_whole else [0.0] * len(compartments) for k in range(n)]
        self.bases = [chance.choice(["conformable", "conformable", "erode", "onlap"]) for _ in range(n)]
        self.on_crossing = chance.choice(["leave", "leave", "clip_older", "clip_younger"])
        self.relief = Sheet(chance, chance.uniform(7.5, 9), 0.1, 1) if chance.random() < 0.3 else None
        self.floor = Sheet(chance, chance.uniform(0.5, 2), 0.1, 1) if chance.random() < 0.2 else None
        self.bodies = [Body(chance) for _ in range(chance.choice([0, 0, 1, 2]))]
        self.faults = [self.fault() for _ in range(chance.choice([0, 0, 1, 2]))]
        self.size = chance.choice([None, None, 3, 1.5])
        self.tolerance = 0 if self.size is None else self.size / 40
        self.least = 1e-6 if self.size is None else 4 * self.tolerance
        self.text = self.project_text()
        self.margin = 1.5 * self.least
        if self.throw_faults and self.size and "stack: keep" not in self.text:
            self.margin = max(self.margin, self.size / 3)  # in the strips along faults of a settled stack a throw is straight over the size

    def fault(self):
        chance = self.chance
        x, lean, turn = chance.uniform(2, 8), chance.uniform(-0.4, 0.4), chance.uniform(-0.3, 0.3)
        low, high = chance.choice([(-1, 11), (-1, 6), (3, 11)])
        points = [(x + lean * (z - 5) + turn * (y - 5), y, z) for z in chance.choice([(-1, 11), (3, 11)]) for y in (low, high)]
        return points, [(0, 1, 3), (0, 3, 2)]

    # ---- the unit at a point

    def after_rules(self, heights):
        """Of heights of horizons, youngest first."""
        heights = list(heights)
        for k in range(len(heights) - 2, -1, -1):  # as they were laid down: each onto the older ones, then into them
            older = range(k + 1, len(heights))
            heights[k] = max([heights[k]] + [heights[j] for j in older if not self.cuts_older(k, j)])
            for j in older:
                if self.cuts_older(k, j):
                    heights[j] = min(heights[j], heights[k])
        return heights

    def cuts_older(self, younger, older):
        """What happens where two horizons cross: the older one goes, or the younger one."""
        if self.bases[younger] == "erode":
            return True
        if self.bases[older] == "onlap":
            return False
        return self.on_crossing != "clip_younger"

    def unit_at(self, place):
        """None near a surface. `place` is that of a mesh."""
        p = [(c - s) / self.scale for c, s in zip(place, self.shift)]
        from_faults = [p[0] - fault.x(p[2]) for fault in self.throw_faults]
        ends = [sheet.z(p[0], p[1]) for sheet in (self.relief, self.floor) if sheet]
        compartment = sum(d > 0 for d in from_faults)
        given = [sheet.z(p[0], p[1]) + lift[compartment] for sheet, lift in zip(self.sheets, self.lifts)]
        if any(abs(d) < self.margin for d in from_faults + [p[2] - z for z in ends + given]):
            return None
        heights = self.after_rules(given)
        depths = [body.depth(p) for body in self.bodies]
        inside = [k for k, depth in enumerate(depths) if depth > 0]
        if any(abs(depth) < 2 * self.least for depth in depths) or len(inside) > 1:
            return None
        if inside:
            return "b%d" % inside[0]
        return "u%d" % sum(p[2] < z for z in heights)

    def volume(self):
        """Of the model, by columns of a lattice of 200 by 200."""
        total, n = 0.0, 200
        for i in range(n):
            for j in range(n):
                x, y = SIZE * (i + 0.5) / n, SIZE * (j + 0.5) / n
                top = min(SIZE, self.relief.z(x, y)) if self.relief else SIZE
                bottom = max(0.0, self.floor.z(x, y)) if self.floor else 0.0
                total += max(0.0, top - bottom)
        return total * (SIZE / n) ** 2 * self.scale ** 3

    # ---- the project

    def at(self, p):
        return tuple(s + self.scale * float(c) for c, s in zip(p, self.shift))

    def project_text(self):
        chance = self.chance
        lines = ["name: model", "box: " + self.box(), "surfaces:"]
        for name, kind, keys in self.entries():
            lines.append("  - {name: %s, kind: %s, file: %s.ts%s}" % (name, kind, name, keys))
        column = ["u0"]
        for k in range(len(self.sheets)):
            column += ["h%d" % k, "u%d" % (k + 1)]
        lines.append("column: [%s]" % ", ".join(column))
        rules = ["on_crossing: " + self.on_crossing]
        rules += ["fault_blocks: true"] if chance.random() < 0.2 else []
        rules += ["stack: keep"] if chance.random() < 0.3 else []
        rules += ["topography: relief"] if self.relief else []
        lines.append("rules: {%s}" % ", ".join(rules))
        lines.append("mesh: {refine: none}" if self.size is None else "mesh: {size: %r, quality: fast}" % (self.size * self.scale))
        lines.append("output: {directory: out, formats: [vtu, msh22]}")
        return "\n".join(lines) + "\n"

    def box(self):
        low, high = self.at((0, 0, 0)), self.at((SIZE, SIZE, SIZE))
        if not self.floor:
            return "{min: %s, max: %s}" % (list(low), list(high))
        return "{center: %s, size: %s, bottom: floor, top: %r}" % (list(self.at((SIZE / 2, SIZE / 2, 0)))[:2], [SIZE * self.scale] * 2, high[2])

    def entries(self):
        chance = self.chance
        result = [("h%d" % k, "horizon", "" if base == "conformable" else ", base: " + base) for k, base in enumerate(self.bases)]
        thrown = "[%s]" % ", ".join("t%d" % k for k in range(len(self.throw_faults)))
        if not self.faults and chance.random() < 0.5:  # where the sheets overshoot, data cannot tell which of two faults is meant
            thrown = "auto"
        result = [(name, kind, keys + (", throw_at: " + thrown if int(name[1:]) >= self.n_whole else "")) for name, kind, keys in result]
        result += [("t%d" % k, "fault", "") for k in range(len(self.throw_faults))]
        result += [(name, "horizon", "") for name, sheet in (("relief", self.relief), ("floor", self.floor)) if sheet]
        result += [("f%d" % k, "fault", chance.choice(["", ", extent: to_box"])) for k in range(len(self.faults))]
        result += [("b%d" % k, "body", chance.choice(["", ", cuts: none"])) for k in range(len(self.bodies))]
        chance.shuffle(result)
        return result

    def horizon(self, k):
        """One sheet, or one for each compartment, which overshoots its faults."""
        if k < self.n_whole:
            return self.sheets[k].triangulated()
        points, triangles = [], []
        for compartment, lift in enumerate(self.lifts[k]):
            low, high = -1.0, 11.0
            if compartment > 0:
                low = min(self.throw_faults[compartment - 1].x(z) for z in (0, 10))
            if compartment < len(self.throw_faults):
                high = max(self.throw_faults[compartment].x(z) for z in (0, 10))
            more, others = self.sheets[k].triangulated(low, high, lift)
            triangles += [tuple(v + len(points) for v in t) for t in others]
            points += more
        return points, triangles

    def write(self, folder):
        os.makedirs(folder, exist_ok=True)
        shapes = {"h%d" % k: self.horizon(k) for k in range(len(self.sheets))}
        shapes.update({"t%d" % k: fault.triangulated() for k, fault in enumerate(self.throw_faults)})
        shapes.update({name: sheet.triangulated() for name, sheet in (("relief", self.relief), ("floor", self.floor)) if sheet})
        shapes.update({"f%d" % k: fault for k, fault in enumerate(self.faults)})
        shapes.update({"b%d" % k: body.triangulated() for k, body in enumerate(self.bodies)})
        for name, (points, triangles) in shapes.items():
            write_surface(folder, name, [self.at(p) for p in points], triangles)
        return write_project(folder, self.text)


if __name__ == "__main__":
    print(RandomRules(int(sys.argv[1])).write(sys.argv[2]))
