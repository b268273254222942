# SPDX-License-Identifier: GPL-3.0-or-later
"""Families whose horizons are measured: regular grids with noise and undefined places, and a few picks in wells."""
import math
import os
import random

from family import PlaneFaults

NO_DATA = -9999


class FaultedRow(PlaneFaults):
    """Normal faults one behind the other, which all dip to the east and do not meet inside the box. Each block is lower than the one before it."""

    def make_row(self, n_faults, drops):
        """Adds the faults, evenly over the box. `drops` is the range of the throws."""
        c = self.chance
        for f in range(n_faults):
            x = 6000 * (f + 1) / (n_faults + 1) + c.uniform(-200, 200)
            self.plane(x, 2500, c.uniform(-10, 10), c.uniform(62, 72))
        shift = 0.0
        for f in range(n_faults + 1):
            self.throws[tuple(g < f for g in range(n_faults))] = shift
            shift -= c.uniform(*drops)

    def canonical(self, sides):
        n = sides.index(False) if False in sides else len(sides)
        return tuple(g < n for g in range(len(sides)))

    def margin_to(self, block, p):
        return super().margin_to(block, p) if self.planes else math.inf

    def place_on(self, k, x, y):
        """Returns the block and the height of a horizon in the map, or None in the heave gap of a fault and nearer to a fault than `gap`."""
        for block in self.blocks():
            z = self.height(k, x, y) + self.shift(block, x, y)
            if self.margin_to(block, (x, y, z)) >= self.gap:
                return block, z
        return None


class NoisyGrid(FaultedRow):
    """Horizons as regular grids with noise of 1 to 3 m, an undefined rim of 30 to 150 m, and undefined strips of 50 to 200 m along one to three
    faults with throw. In odd models the second horizon comes down onto the third one, which it touches and crosses by the noise."""

    def make(self):
        c = self.chance
        self.gap = c.uniform(25, 100)
        self.step = c.choice([50.0, 75.0, 100.0])
        self.deviation = c.uniform(1, 3)
        self.rim, self.rim_phase = c.uniform(60, 120), c.uniform(0, 6)
        self.noise_seed = c.random()
        self.make_row(c.randint(1, 3), (60, 180))
        for f in range(len(self.planes)):
            self.faults["f%d" % f] = self.fault_sheet(f)

    def __init__(self, seed):
        self.thins_out = seed % 2 == 1
        super().__init__(seed)
        if self.thins_out:
            self.rules = ["rules: {min_thickness: 10}"]

    def noise(self):
        return self.deviation

    def height(self, k, x, y):
        if k == 1 and self.thins_out:
            return super().height(2, x, y) + max(0.0, 600 * (1 - x / 4500))
        return super().height(k, x, y)

    def in_rim(self, x, y, further=0.0):
        """Tells whether the grids are undefined here because the sides of the box are near."""
        side = min(x, y, 6000 - x, 5000 - y)
        return side < self.rim + 30 * math.sin((x + y) / 400 + self.rim_phase) + further

    def room(self, p):
        """Where grids are undefined, horizons continue with their slope, which the noise and the curvature change by up to a tenth."""
        near_fault = min(abs(self.distance(f, p)) for f in range(len(self.planes))) < self.gap + 2 * self.step
        return 0.1 * (self.gap + self.rim) if near_fault or self.in_rim(p[0], p[1], 2 * self.step) else 0.0

    def horizons(self):
        noise = random.Random(self.noise_seed)
        return {"h%d" % k: [[self.node(k, i, j, noise) for i in range(round(6000 / self.step))] for j in range(round(5000 / self.step))]
                for k in range(self.n_layers)}

    def node(self, k, i, j, noise):
        x, y = (i + 0.5) * self.step, (j + 0.5) * self.step
        place = None if self.in_rim(x, y) else self.place_on(k, x, y)
        return place[1] + noise.gauss(0, self.deviation) if place else NO_DATA

    def write_data(self, folder, kind, name, surface):
        """Horizons are written as ESRI ASCII grids."""
        if kind != "horizon":
            return super().write_data(folder, kind, name, surface)
        with open(os.path.join(folder, name + ".asc"), "w") as file:
            file.write("ncols %d\nnrows %d\nxllcorner 0\nyllcorner 0\ncellsize %g\nNODATA_value %d\n"
                       % (len(surface[0]), len(surface), self.step, NO_DATA))
            for row in reversed(surface):
                file.write(" ".join("%.2f" % z if z != NO_DATA else str(z) for z in row) + "\n")
        return name + ".asc"


class SparsePicks(FaultedRow):
    """Horizons as the picks of 5 to 50 wells in one table, and up to two faults of few triangles. Four wells stand near the corners of the box, and
    each block has at least four picks of each horizon. Horizons are planes, gently curved where there are 20 wells or more."""

    def __init__(self, seed):
        self.n_wells, self.n_faults = ((5, 0), (12, 1), (8, 0), (30, 1), (20, 1), (50, 2))[seed % 6]
        super().__init__(seed)

    def make(self):
        c = self.chance
        self.deviation = c.uniform(0, 4)
        self.wave = (c.uniform(10, 25) if self.n_wells >= 20 else 0.0, 9000.0, c.uniform(0, 6))
        self.make_row(self.n_faults, (80, 200))
        for f in range(self.n_faults):
            self.faults["f%d" % f] = self.fault_sheet(f, step=1500.0)
        while True:
            self.picks = self.drill()
            if all(sum(q[0] == block for q in picks) >= 4 for picks in self.picks for block in self.blocks()):
                break
        throw_at = ", throw_at: [%s]" % ", ".join(self.faults) if self.faults else ""
        self.careful = "gridding: {extent: box}" + throw_at

    def setup(self):
        super().setup()
        for k in range(self.n_layers):
            self.keys["h%d" % k] = self.careful

    def drill(self):
        """Returns the picks of each horizon: the block and the place."""
        c = self.chance
        corners = [(x, y) for x in (150, 5850) for y in (150, 4850)]
        wells = [(x + c.uniform(-100, 100), y + c.uniform(-100, 100)) for x, y in corners]
        wells += [(c.uniform(300, 5700), c.uniform(300, 4700)) for _ in range(self.n_wells - 4)]
        picks = []
        for k in range(self.n_layers):
            places = [(x, y, self.place_on(k, x, y)) for x, y in wells]
            picks.append([(q[0], (x, y, q[1] + c.gauss(0, self.deviation))) for x, y, q in places if q])
        return picks

    def noise(self):
        return self.deviation

    def room(self, p):
        """Away from the picks of the block, a horizon is determined within the slope that it may have, 0.04."""
        block = self.block_at(p)
        return 0.04 * min(math.hypot(q[0] - p[0], q[1] - p[1]) for picks in self.picks for b, q in picks if b == block)

    def horizons(self):
        return {"h%d" % k: [q for _, q in picks] for k, picks in enumerate(self.picks)}

    def write_data(self, folder, kind, name, surface):
        """The picks of all horizons are in one table, whose column `formation` names the horizon."""
        if kind != "horizon":
            return super().write_data(folder, kind, name, surface)
        with open(os.path.join(folder, "picks.csv"), "w" if name == "h0" else "a") as file:
            if name == "h0":
                file.write("x,y,z,formation\n")
            file.writelines("%.2f,%.2f,%.2f,%s\n" % (*q, name) for q in surface)
        return "picks.csv"
