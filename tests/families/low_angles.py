# SPDX-License-Identifier: GPL-3.0-or-later
"""Families whose horizons end on a thrust or on salt at a low angle, so that the way along the horizon is many times the distance between the two."""
import math

from family import Family, lattice, strip


class RampThrust(Family):
    """A thrust with two flats and a ramp of 25 to 35 degrees between them. The upper flat lies near a horizon. The hanging wall is moved along the thrust
    by 400 to 900 m, with vertical shear, so that its layers are folded over the ramp."""
    step = 100.0

    def setup(self):
        c = self.chance
        self.gap = c.uniform(0, 30)
        self.slip, self.ramp_from = c.uniform(400, 900), c.uniform(1800, 2400)
        self.rise = c.uniform(700, 1100)
        self.ramp_length = self.rise / math.tan(math.radians(c.uniform(25, 35)))
        self.lower_flat = -2000.0 + c.uniform(-100, 100)
        self.depths = [-600, -1150, -1700]
        places = [-300 + 6600 * i / 60 for i in range(61)]
        self.faults["thrust"] = strip([[(x, y, self.thrust_at(x)) for x in places] for y in (-300 + 5600 * j / 20 for j in range(21))])
        for k in range(self.n_layers):
            self.keys["h%d" % k] = "throw_at: [thrust]"

    def thrust_at(self, x):
        """The height of the thrust."""
        t = min(1.0, max(0.0, (x - self.ramp_from) / self.ramp_length))
        return self.lower_flat + self.rise * t * t * (3 - 2 * t)

    def blocks(self):
        return [(False,), (True,)]

    def block_at(self, p):
        return (p[2] > self.thrust_at(p[0]),)

    def level(self, k, block, x, y):
        if not block[0]:
            return self.height(k, x, y)
        return self.height(k, x - self.slip, y) + self.thrust_at(x) - self.thrust_at(x - self.slip)

    def margin_to(self, block, p):
        distance = 0.87 * (p[2] - self.thrust_at(p[0]))
        return distance if block[0] else -distance

    def sheet(self, k, block):
        def place(x, y):
            z = self.level(k, block, x, y)
            return z if self.margin_to(block, (x, y, z)) >= self.gap else None
        return lattice(self.box, self.step, self.margin, place)

    def unit_at(self, p):
        block = self.block_at(p)
        for k in range(self.n_layers):
            if p[2] > self.level(k, block, p[0], p[1]):
                return "u%d" % k
        return "u%d" % self.n_layers


class SaltSheet(Family):
    """A gently dipping lens of salt, some 700 m thick and 3 km wide, between and across the horizons, which end 5 to 50 m from it."""
    step = 100.0

    def setup(self):
        c = self.chance
        self.gap = c.uniform(5, 50)
        self.depths = [-600, -1200, -1800]
        self.centre = (c.uniform(2700, 3300), c.uniform(2300, 2700), c.uniform(-1500, -1200))
        self.axes = (c.uniform(1400, 1900), c.uniform(1100, 1500), c.uniform(280, 420))
        self.dip = c.uniform(-0.25, 0.25)
        around, rings = 64, 28
        points = [self.salt_point(math.pi * j / rings, 2 * math.pi * i / around) for j in range(1, rings) for i in range(around)]
        triangles = []
        for j in range(rings - 2):
            for i in range(around):
                a, b = j * around + i, j * around + (i + 1) % around
                triangles += [(a, b, b + around), (a, b + around, a + around)]
        low, high, last = len(points), len(points) + 1, (rings - 2) * around
        points += [self.salt_point(0, 0), self.salt_point(math.pi, 0)]
        triangles += [(low, (i + 1) % around, i) for i in range(around)] + [(high, last + i, last + (i + 1) % around) for i in range(around)]
        self.bodies["salt"] = (points, triangles)

    def salt_point(self, polar, azimuth):
        x = self.axes[0] * math.sin(polar) * math.cos(azimuth)
        return (self.centre[0] + x, self.centre[1] + self.axes[1] * math.sin(polar) * math.sin(azimuth),
                self.centre[2] - self.axes[2] * math.cos(polar) + self.dip * x)

    def from_centre(self, p):
        """The distance from the middle of the salt, with its surface at 1."""
        x = p[0] - self.centre[0]
        return math.hypot(x / self.axes[0], (p[1] - self.centre[1]) / self.axes[1], (p[2] - self.centre[2] - self.dip * x) / self.axes[2])

    def margin_to(self, block, p):
        return (self.from_centre(p) - 1) * self.axes[2]

    def unit_at(self, p):
        return "salt" if self.from_centre(p) < 1 else super().unit_at(p)
