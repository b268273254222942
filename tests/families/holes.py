# SPDX-License-Identifier: GPL-3.0-or-later
"""Horizons with holes: data that are missing, beside faults too, and a high of older rock that pierces a horizon."""
import math
import random

from family import Family, lattice
from measured import NO_DATA, NoisyGrid


class Holes(Family):
    """Layers without faults, whose horizons have undefined round holes with radii of 80 to 400 m, and noise of up to 2 m. The third layer is 80 to 150 m
    thick. In every third model the lowest horizon rises through the others above it, which end 3 to 15 m before it."""
    n_layers = 4
    step = 50.0

    def __init__(self, seed):
        self.has_high = seed % 3 == 2
        super().__init__(seed)

    def setup(self):
        c = self.chance
        self.deviation, self.stop = c.uniform(0, 2), c.uniform(3, 15)
        self.noise_seed = c.random()
        self.depths = [-600 + c.uniform(-50, 50), -1250 + c.uniform(-30, 30), 0.0, -2100 + c.uniform(-60, 60)]
        self.depths[2] = self.depths[1] - c.uniform(80, 150)
        self.middle, self.radius, self.rise = (c.uniform(2000, 4000), c.uniform(1800, 3200)), c.uniform(500, 800), c.uniform(1000, 1150)
        self.holes = {k: [(c.uniform(600, 5400), c.uniform(600, 4400), c.uniform(80, 400)) for _ in range(c.randint(1, 5))] for k in range(4)}
        if self.has_high:
            self.holes[3] = []
        else:
            self.keys = {"h%d" % k: "fill_holes: all" for k in range(4)}

    def size(self):
        return 450.0

    def noise(self):
        return self.deviation

    def height(self, k, x, y):
        z = super().height(k, x, y)
        if k == 3 and self.has_high:
            z += self.rise * math.exp(-math.dist((x, y), self.middle) ** 2 / (2 * self.radius ** 2))
        return z

    def in_hole(self, k, x, y, further=0.0):
        return any(math.hypot(x - u, y - v) < radius + further for u, v, radius in self.holes[k])

    def sheet(self, k, block):
        noise = random.Random("%r %d" % (self.noise_seed, k))

        def place(x, y):
            z = self.height(k, x, y)
            is_pierced = k < 3 and self.has_high and z < self.height(3, x, y) + self.stop
            return None if is_pierced or self.in_hole(k, x, y) else z + noise.gauss(0, self.deviation)
        return lattice(self.box, self.step, self.margin, place)

    def unit_at(self, p):
        return "u4" if p[2] < self.height(3, *p[:2]) else super().unit_at(p)

    def room(self, p):
        """Straight lines across a hole leave the layers by up to the rise of their bend."""
        bend = 0.125 * 800 ** 2 * self.wave[0] * (2 * math.pi / self.wave[1]) ** 2
        return bend if any(self.in_hole(k, p[0], p[1], 100) for k in range(4)) else self.stop if self.has_high else 0.0


class FaultHoles(NoisyGrid):
    """Noisy grids with a round undefined place of 80 to 200 m radius at or beside each fault in each horizon."""

    def make(self):
        super().make()
        c = self.chance
        self.holes = {k: [(x + c.uniform(-600, 600), c.uniform(1000, 4000), c.uniform(80, 200)) for (x, _, _), _ in self.planes] for k in range(3)}

    def in_hole(self, k, x, y, further=0.0):
        return any(math.hypot(x - u, y - v) < radius + further for u, v, radius in self.holes[k])

    def node(self, k, i, j, noise):
        z = super().node(k, i, j, noise)
        return NO_DATA if self.in_hole(k, (i + 0.5) * self.step, (j + 0.5) * self.step) else z

    def room(self, p):
        is_near = any(self.in_hole(k, p[0], p[1], 150) for k in range(3))
        return max(super().room(p), 30.0 if is_near else 0.0)
