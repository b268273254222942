# SPDX-License-Identifier: GPL-3.0-or-later
"""Structural models whose rock unit is known at every place by a formula.

    python3 tests/families/families.py FAMILY SEED FOLDER [bare|careful]     writes FOLDER/project.yaml and its surfaces

A family is a kind of geology that users bring. Each model exists in two forms: `careful` has the keys that somebody who has read the documents
would write, `bare` has the box, the surfaces, their kinds and the column alone. family.py has what the families share.
"""
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from family import Family, PlaneFaults, lattice, strip  # noqa: E402
from deposits import Channel, Lens  # noqa: E402
from growth import GrowthFault  # noqa: E402
from holes import FaultHoles, Holes  # noqa: E402
from intrusions import Intrusion  # noqa: E402
from low_angles import RampThrust, SaltSheet  # noqa: E402
from measured import NoisyGrid, SparsePicks  # noqa: E402


class ShortGrids(Family):
    """Grids that end 20 to 80 m before the sides of the box."""

    def setup(self):
        self.margin = -self.chance.uniform(20, 80)
        for k in range(self.n_layers):
            self.keys["h%d" % k] = "extend: tangent"


class SaltGaps(Family):
    """A salt dome with overhang; horizons end 1 to 30 m (and up to a cell of their lattice) before it."""
    step = 120.0

    def setup(self):
        c = self.chance
        self.centre = (c.uniform(2400, 3600), c.uniform(2000, 3000))
        self.gap = c.uniform(1, 30)
        self.radius = c.uniform(600, 900)
        rings, n = [], 48
        for j in range(17):
            t = j / 16
            z = -3200 + t * 2500
            rings.append([(self.centre[0] + self.radius_at(z) * math.cos(2 * math.pi * i / n),
                           self.centre[1] + self.radius_at(z) * math.sin(2 * math.pi * i / n), z) for i in range(n)] )
        points = [p for ring in rings for p in ring]
        triangles = []
        for j in range(len(rings) - 1):
            for i in range(n):
                a, b = j * n + i, j * n + (i + 1) % n
                triangles += [(a, b, b + n), (a, b + n, a + n)]
        low, high = len(points), len(points) + 1
        points += [(self.centre[0], self.centre[1], -3200.0), (self.centre[0], self.centre[1], -700.0)]
        last = (len(rings) - 1) * n
        triangles += [(low, (i + 1) % n, i) for i in range(n)] + [(high, last + i, last + (i + 1) % n) for i in range(n)]
        self.bodies["salt"] = (points, triangles)
        for k in range(self.n_layers):
            self.keys["h%d" % k] = "fill_holes: all"

    def radius_at(self, z):
        """A stem with a wider head above -1,600 m, closed by a flat top at -700 m."""
        t = min(1.0, max(0.0, (z + 1900) / 700))
        return self.radius * (0.6 + 0.4 * t * t * (3 - 2 * t))

    def from_salt(self, p):
        if p[2] > -700:
            return math.hypot(p[0] - self.centre[0], p[1] - self.centre[1]) + p[2] + 700
        return math.hypot(p[0] - self.centre[0], p[1] - self.centre[1]) - self.radius_at(p[2])

    def margin_to(self, block, p):
        return self.from_salt(p)

    def unit_at(self, p):
        if p[2] < -700 and self.from_salt(p) < 0:
            return "salt"
        return super().unit_at(p)


class Thrust(PlaneFaults):
    """A thrust at 25 to 35 degrees that repeats the layers in the map: the hanging wall is 150 to 350 m higher."""

    def make(self):
        c = self.chance
        self.plane(c.uniform(2500, 3500), 2500, c.uniform(-15, 15), c.uniform(25, 35))
        self.throws = {(False,): 0.0, (True,): c.uniform(150, 350)}
        self.faults["f0"] = self.fault_sheet(0)


class Conjugate(PlaneFaults):
    """Two faults that dip towards each other: in the form of an X, or of a Y whose second fault ends on the first."""

    def make(self):
        c = self.chance
        a = self.plane(c.uniform(2300, 2800), 2500, c.uniform(-10, 10), c.uniform(55, 65), -1600)
        q, n = self.planes[a]
        self.plane(q[0] + c.uniform(500, 900), 2500, 180 + c.uniform(-10, 10), c.uniform(55, 65), -1600)
        self.is_y = c.random() < 0.5
        drop = -c.uniform(60, 160)
        if self.is_y:  # the second fault is there in the hanging wall of the first alone
            self.throws = {(False, None): 0.0, (True, False): drop, (True, True): 1.7 * drop}
            misfit = c.uniform(-40, 40)
            self.faults["f0"] = self.fault_sheet(0)
            self.faults["f1"] = self.fault_sheet(1, keep=lambda p: self.distance(0, p) > misfit, step=100.0)
        else:
            self.throws = {(a, b): drop * (a + b) + (0.5 * drop if a and b else 0) for a in (False, True) for b in (False, True)}
            self.faults["f0"] = self.fault_sheet(0)
            self.faults["f1"] = self.fault_sheet(1)
        if self.is_y:
            self.keys["f1"] = "extent: to_fault f0"

    def setup(self):
        super().setup()
        if self.is_y:
            self.keys["f1"] = "extent: to_fault f0"

    def canonical(self, sides):
        return (False, None) if self.is_y and not sides[0] else sides

    def bounding(self, block):
        return [0] if block == (False, None) else [0, 1]


class Network(Family):
    """8 to 15 curved, upright faults that end on each other with misfits of 0 to 50 m, and throw by block. Each fault splits one block."""
    step = 150.0

    def setup(self):
        c = self.chance
        self.gap = c.uniform(0, 30)
        self.splits, self.throws = [], {(): 0.0}   # block: sequence of (split, side)
        leaves = [()]
        for s in range(c.randint(8, 15)):
            leaf = max(leaves, key=lambda b: self.area(b) * c.uniform(0.6, 1))
            x, y = self.middle(leaf)
            angle = c.choice([0, math.pi / 2]) + c.uniform(-0.4, 0.4)
            self.splits.append((x, y, math.cos(angle), math.sin(angle), c.uniform(-60, 60), c.uniform(1200, 2500)))
            leaves.remove(leaf)
            shift = self.throws.pop(leaf)
            for side in (False, True):
                leaves.append(leaf + ((s, side),))
                self.throws[leaf + ((s, side),)] = shift + c.uniform(-80, 80)
            self.faults["f%d" % s] = self.wall(s, leaf, c.uniform(-50, 50))
        for k in range(self.n_layers):
            self.keys["h%d" % k] = "throw_at: auto, extend: flat"

    def signed(self, s, x, y):
        px, py, ux, uy, amplitude, length = self.splits[s]
        along = (x - px) * ux + (y - py) * uy
        return -(x - px) * uy + (y - py) * ux - amplitude * math.sin(along / length)

    def holds(self, block, x, y, room=0.0):
        return all((self.signed(s, x, y) > -room) if side else (self.signed(s, x, y) < room) for s, side in block)

    def places(self, block):
        return [(x, y) for x in range(50, 6000, 100) for y in range(50, 5000, 100) if self.holds(block, x, y)]

    def area(self, block):
        return len(self.places(block))

    def middle(self, block):
        places = self.places(block)
        return (sum(x for x, _ in places) / len(places), sum(y for _, y in places) / len(places))

    def wall(self, s, block, misfit):
        """The fault within its block, longer (or shorter, where negative) by the misfit at both ends."""
        px, py, ux, uy, amplitude, length = self.splits[s]
        inside = []
        for k in range(-800, 801):
            t = 10.0 * k
            across = amplitude * math.sin(t / length)
            x, y = px + t * ux - across * uy, py + t * uy + across * ux
            if self.holds(block, x, y, 0.0) and -150 < x < 6150 and -150 < y < 5150:
                inside.append(t)
        low, high = min(inside) - misfit, max(inside) + misfit
        n = max(3, round((high - low) / 200))
        rows = []
        for z in (100.0, -800.0, -1600.0, -2400.0, -3100.0):
            line = []
            for i in range(n + 1):
                t = low + (high - low) * i / n
                across = amplitude * math.sin(t / length)
                line.append((px + t * ux - across * uy, py + t * uy + across * ux, z))
            rows.append(line)
        return strip(rows)

    def blocks(self):
        return sorted(self.throws)

    def block_at(self, p):
        for block in self.throws:
            if self.holds(block, p[0], p[1]):
                return block
        return next(iter(self.throws))

    def shift(self, block, x, y):
        return self.throws[block]

    def margin_to(self, block, p):
        return min((self.signed(s, p[0], p[1]) * (1 if side else -1) for s, side in block), default=math.inf)


class DyingFault(Family):
    """A listric fault with throw that varies along strike and dies out inside the model, with the horizons given round its tip."""
    step = 120.0

    def setup(self):
        c = self.chance
        self.x0, self.tip = c.uniform(2600, 3400), c.uniform(2200, 3600)
        self.throw = c.uniform(60, 160)
        self.gap = c.uniform(2, 20)
        rows = []
        for j in range(13):
            z = 200 - 3400 * j / 12
            n = 16
            rows.append([(self.x_at(z), -200 + (self.tip + 200) * i / n, z) for i in range(n + 1)])
        self.faults["f0"] = strip(rows)
        for k in range(self.n_layers):
            self.keys["h%d" % k] = "throw_at: auto, extend: flat"

    def x_at(self, z):
        return self.x0 + 0.6 * (z + 1500) / 2 + 0.00006 * (z + 1500) ** 2 / 2

    def blocks(self):
        return [(False,), (True,)]

    def block_at(self, p):
        return (p[0] > self.x_at(p[2]),)

    def shift(self, block, x, y):
        return -self.throw * min(1.0, max(0.0, 1 - y / self.tip)) ** 0.7 if block[0] else 0.0

    def margin_to(self, block, p):
        d = (p[0] - self.x_at(p[2])) * (1 if block[0] else -1)
        return d

    def sheet(self, k, block):
        def place(x, y):
            z = self.height(k, x, y) + self.shift(block, x, y)
            if y > self.tip:
                return z if block == (False,) else None
            return z if self.margin_to(block, (x, y, z)) >= self.gap else None
        return lattice(self.box, self.step, self.margin, place)


class Unconformity(PlaneFaults):
    """Faulted blocks under an angular unconformity, which the older horizons and the faults stop at or overshoot by 50 m."""

    def make(self):
        c = self.chance
        self.plane(c.uniform(1800, 2400), 2500, c.uniform(-15, 15), c.uniform(60, 75))
        self.plane(c.uniform(3600, 4200), 2500, c.uniform(-15, 15), c.uniform(60, 75))
        drop = -c.uniform(80, 160)
        self.throws = {(False, False): 0.0, (True, False): drop, (True, True): 1.9 * drop}
        self.tilt = (c.choice([-1, 1]) * c.uniform(0.1, 0.16), self.tilt[1])
        self.overshoot = c.choice([50.0, 20.0])
        keep = lambda p: p[2] < self.cut(p[0], p[1]) + self.overshoot  # noqa: E731
        for f in (0, 1):
            self.faults["f%d" % f] = self.fault_sheet(f, keep, 100.0)

    def setup(self):
        super().setup()
        self.rules = []
        self.keys = {"h%d" % k: "throw_at: [f0, f1]" for k in range(self.n_layers)}
        self.keys["unconformity"] = "base: erode"

    def bounding(self, block):
        return [0, 1]

    def canonical(self, sides):
        return (True, True) if sides[1] else sides

    def cut(self, x, y):
        return -650.0 + 0.01 * (x - 3000)

    def unit_at(self, p):
        if p[2] > self.cut(p[0], p[1]):
            return "cover"
        return super().unit_at(p)

    def sheet(self, k, block):
        def place(x, y):
            z = self.height(k, x, y) + self.shift(block, x, y)
            if z > self.cut(x, y) + self.overshoot:
                return None
            return z if self.margin_to(block, (x, y, z)) >= self.gap else None
        return lattice(self.box, self.step, self.margin, place)

    def horizons(self):
        cover = lattice(self.box, self.step, self.margin, self.cut)
        return {"unconformity": cover, **super().horizons()}

    def column(self):
        return ["cover", "unconformity", *super().column()]


class ThinBeds(Family):
    """A bed of 2 to 15 m between thick units, and one that pinches out."""
    n_layers = 4

    def setup(self):
        c = self.chance
        self.bed, self.wedge = c.uniform(2, 15), c.uniform(40, 80)

    def height(self, k, x, y):
        if k == 1:
            return super().height(0, x, y) - self.bed
        if k == 3:  # a wedge that pinches out at x = 4000
            return self.height(2, x, y) - max(0.0, self.wedge * (4000 - x) / 4000)
        return super().height(k, x, y)


class Recumbent(Family):
    """A recumbent fold: horizons with three heights over a part of the map, given as rolled sheets."""
    n_layers = 2

    def setup(self):
        c = self.chance
        self.amplitude, self.centre = c.uniform(500, 800), c.uniform(2600, 3400)
        self.lean = c.uniform(0.9, 1.4)

    def warp(self, z):
        """How far a place at this height is carried along x."""
        return self.lean * self.amplitude * math.exp(-((z + 1500) / 500.0) ** 2)

    def height(self, k, x, y):
        return -1250.0 - 550.0 * k + 250 * math.tanh((x - self.centre) / 250.0)

    def unit_at(self, p):
        x = p[0] + self.warp(p[2])
        for k in range(self.n_layers):
            if p[2] > self.height(k, x, p[1]):
                return "u%d" % k
        return "u%d" % self.n_layers

    def sheet(self, k, block):
        rows = []
        for j in range(27):
            y = -200 + 5400 * j / 26
            line = []
            for i in range(121):
                x = -1500 + 9500 * i / 120
                z = self.height(k, x, y)
                line.append((x - self.warp(z), y, z))
            rows.append(line)
        return strip(rows)


FAMILIES = {"short_grids": ShortGrids, "salt_gaps": SaltGaps, "thrust": Thrust, "conjugate": Conjugate, "network": Network,
            "dying_fault": DyingFault, "unconformity": Unconformity, "thin_beds": ThinBeds, "recumbent": Recumbent,
            "noisy_grid": NoisyGrid, "growth_fault": GrowthFault, "sparse_picks": SparsePicks,
            "channel": Channel, "intrusion": Intrusion, "lens": Lens, "holes": Holes,
            "fault_holes": FaultHoles, "ramp_thrust": RampThrust, "salt_sheet": SaltSheet}

if __name__ == "__main__":
    form = sys.argv[4] if len(sys.argv) > 4 else "bare"
    print(FAMILIES[sys.argv[1]](int(sys.argv[2])).write(sys.argv[3], form))
