#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random horizons with throw across plane faults, whose blocks have known heights.

    python3 tests/fuzz/random_throw.py SEED FOLDER     writes FOLDER/project.yaml and its surfaces

The box is 10 by 10 by 10. One to three faults strike along y, nearly upright, and divide it into compartments. Each has its ends beyond the
box, exactly on its sides, or inside (at most one does). The horizon lies in each compartment at a height of its own, or at that of the last
one. It is given in sheets of one or several compartments, which stop short of the faults, end on them, or overshoot them, on lattices of any
spacing. `throw_at` names the faults between two sheets, and others by chance.

`heights` tells the height of each compartment, by which a test knows the volume below the horizon.
"""
import os
import random
import sys

from gocad_files import write_project, write_surface


class RandomThrow:
    def __init__(self, seed):
        self.chance = chance = random.Random(seed)
        n = chance.choice([1, 1, 2, 2, 3])
        self.places = [10 * (k + 1) / (n + 1) + chance.uniform(-0.6, 0.6) for k in range(n)]
        self.leans = [chance.choice([0, 0, chance.uniform(-0.12, 0.12)]) for _ in range(n)]
        self.ends = [chance.choice(["beyond", "beyond", "sides"]) for _ in range(n)]
        is_one_inside = chance.random() < 0.25
        if is_one_inside:
            self.ends[chance.randrange(n)] = "inside"
        self.heights = [chance.uniform(3, 7)]
        for end in self.ends:
            same = end == "inside" or chance.random() < 0.3
            self.heights.append(self.heights[-1] if same else chance.uniform(3, 7))
        self.surfaces = {"f%d" % k: self.fault(k) for k in range(n)}
        self.surfaces["h"] = self.horizon()
        self.text = self.project_text()

    def x(self, k, z):
        return self.places[k] + self.leans[k] * (z - 5)

    def fault(self, k):
        low, high = {"beyond": (-1, 11), "sides": (0, 10), "inside": (-1, self.chance.uniform(3, 8))}[self.ends[k]]
        bottom, top = (-1, 11) if self.ends[k] != "sides" or self.leans[k] else self.chance.choice([(-1, 11), (0, 10)])
        points = [(self.x(k, z), y, z) for z in (bottom, top) for y in (low, high)]
        return points, [(0, 1, 3), (0, 3, 2)]

    def horizon(self):
        """Sheets over runs of compartments that have one height, or over each of them."""
        points, triangles = [], []
        self.parted = []  # faults between two sheets
        k = 0
        while k < len(self.heights):
            last = k
            while last + 1 < len(self.heights) and self.heights[last + 1] == self.heights[k] and (self.ends[last] == "inside" or self.chance.random() < 0.7):
                last += 1
            z = self.heights[k]
            gap = self.chance.choice([0, 0, 0.3, -0.3])
            low = -1 if k == 0 else self.x(k - 1, z) + gap
            high = 11 if last == len(self.heights) - 1 else self.x(last, z) - gap
            more, others = self.lattice(low, high, z)
            triangles += [tuple(v + len(points) for v in t) for t in others]
            points += more
            if last < len(self.ends):
                self.parted.append(last)
            k = last + 1
        return points, triangles

    def lattice(self, low, high, z):
        step = self.chance.choice([0.6, 1.0, 1.7, 3.1])
        nx, ny = max(1, round((high - low) / step)), max(1, round(12 / step))
        points = [(low + (high - low) * i / nx, -1 + 12 * j / ny, z) for j in range(ny + 1) for i in range(nx + 1)]
        corners = [j * (nx + 1) + i for j in range(ny) for i in range(nx)]
        return points, [t for c in corners for t in ((c, c + 1, c + nx + 2), (c, c + nx + 2, c + nx + 1))]

    def project_text(self):
        names = ["f%d" % k for k in range(len(self.places))]
        named = [name for k, name in enumerate(names) if k in self.parted or self.chance.random() < 0.7]
        throw = "[%s]" % ", ".join(named)
        keys = "throw_at: %s" % throw if named else "extend: flat"
        if self.chance.random() < 0.5:
            keys += ", smeared_throw: %s" % self.chance.choice(["keep", "cut"]) if named else ""
        lines = ["name: model", "box: {min: [0, 0, 0], max: [10, 10, 10]}", "surfaces:", "  - {name: h, kind: horizon, file: h.ts, %s}" % keys]
        lines += ["  - {name: %s, kind: fault, file: %s.ts}" % (name, name) for name in names]
        self.within_tolerance = self.chance.random() < 0.5
        lines += ["column: [upper, h, lower]", "mesh: {size: 4, tolerance: 0.1}" if self.within_tolerance else "mesh: {refine: none}", "output: {directory: out}"]
        return "\n".join(lines) + "\n"

    def volume_below(self):
        """Of the compartments, each below its height; the faults lean about the height 5."""
        def below(x_at, z):  # of x < x_at, between 0 and z
            return 10 * (x_at(0) + x_at(z)) / 2 * z
        total = 0
        for k, z in enumerate(self.heights):
            right = below(lambda at, k=k: self.x(k, at), z) if k < len(self.places) else 100 * z
            left = below(lambda at, k=k: self.x(k - 1, at), z) if k > 0 else 0
            total += right - left
        return total

    def write(self, folder):
        os.makedirs(folder, exist_ok=True)
        for name, (points, triangles) in self.surfaces.items():
            write_surface(folder, name, [tuple(map(float, p)) for p in points], triangles)
        return write_project(folder, self.text)


if __name__ == "__main__":
    print(RandomThrow(int(sys.argv[1])).write(sys.argv[2]))
