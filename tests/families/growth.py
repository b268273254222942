# SPDX-License-Identifier: GPL-3.0-or-later
"""A family of growth faults."""
import math

from family import Family, lattice, strip


class GrowthFault(Family):
    """One or two listric normal faults that were active while the layers were deposited: the throw grows from layer to layer downwards, and the layers
    of the hanging wall thicken towards the fault. The throw varies along strike. In even models each fault ends inside the box, where its throw
    has died out, and the horizons are given round its tip."""
    step = 100.0
    tip = 0.0        # length of a fault along y where it ends inside; 0: it reaches through the box
    reach = 2500.0   # distance from the fault over which the throw in the hanging wall falls to 1/e

    def __init__(self, seed):
        self.dies_out = seed % 2 == 0
        super().__init__(seed)

    def setup(self):
        c = self.chance
        self.gap = c.uniform(3, 30)
        self.growth = (c.uniform(0.15, 0.4), c.uniform(0.5, 0.7), 1.0)   # share of the throw that each horizon has
        n_faults = c.randint(1, 2)
        self.shapes = []
        for f in range(n_faults):
            x = (c.uniform(2300, 2900), c.uniform(1200, 1600))[n_faults - 1] + 2000 * f
            self.shapes.append((x, c.uniform(100, 220), c.uniform(2000, 3400) if self.dies_out else math.inf, c.uniform(0, 6)))
            self.faults["f%d" % f] = self.wall(f)
        for k in range(self.n_layers):
            self.keys["h%d" % k] = "throw_at: [%s], extend: tangent" % ", ".join(self.faults)

    def wall(self, f):
        """The fault as given: beyond the box at the top, the base and the sides, up to its tip where it has one."""
        end = min(self.shapes[f][2], 5200.0)
        heights = [200 - 3400 * j / 17 for j in range(18)]
        return strip([[(self.fault_x(f, -200 + (end + 200) * i / 20, z), -200 + (end + 200) * i / 20, z) for i in range(21)] for z in heights])

    def fault_x(self, f, y, z):
        """The place of the fault along x: steep at the top (about 70 degrees), about 45 degrees at the base of the box, gently curved along strike."""
        t = -z / 3000
        return self.shapes[f][0] + 3000 * (0.36 * t + 0.32 * t * t) + 60 * math.sin(y / 1200 + self.shapes[f][3])

    def from_fault(self, f, p):
        """The distance from the fault, about; positive in the hanging wall."""
        t = -p[2] / 3000
        return (p[0] - self.fault_x(f, p[1], p[2])) / math.hypot(1, 0.36 + 0.64 * t)

    def throw(self, f, k, y):
        """The throw of a horizon at the fault."""
        _, largest, tip, phase = self.shapes[f]
        along = max(0.0, 1 - (y / tip) ** 2) if self.dies_out else 0.75 + 0.25 * math.sin(y / 1500 + phase)
        return largest * self.growth[k] * along

    def level(self, k, block, x, y):
        """The height of a horizon in a block: the hanging wall is rolled over into the fault."""
        z = self.height(k, x, y)
        for f, hanging in enumerate(block):
            if hanging:
                z -= self.throw(f, k, y) * math.exp(-max(0.0, x - self.shapes[f][0]) / self.reach)
        return z

    def block_at(self, p):
        return tuple(self.from_fault(f, p) > 0 for f in range(len(self.shapes)))

    def unit_at(self, p):
        block = self.block_at(p)
        for k in range(self.n_layers):
            if p[2] > self.level(k, block, p[0], p[1]):
                return "u%d" % k
        return "u%d" % self.n_layers

    def block_in_map(self, k, x, y):
        """The block whose horizon is there, or None in the heave gap of a fault and nearer to it than `gap`. All is one block beyond the tips."""
        n = len(self.shapes)
        for block in [tuple(g < f for g in range(n)) for f in range(n + 1)]:
            p = (x, y, self.level(k, block, x, y))
            if all(y > self.shapes[f][2] or self.from_fault(f, p) * (1 if side else -1) >= self.gap for f, side in enumerate(block)):
                return block
        return None

    def sheet(self, k):
        """The horizon over the map. No triangle crosses a fault, and those beyond the tip connect both sides."""
        blocks = {}

        def place(x, y):
            block = self.block_in_map(k, x, y)
            if block is None:
                return None
            p = (x, y, self.level(k, block, x, y))
            blocks[p] = tuple(self.from_fault(f, p) > 0 for f in range(len(self.shapes)))
            return p[2]

        def is_whole(corners):
            return all(len({blocks[p][f] for p in corners}) == 1 or min(p[1] for p in corners) > self.shapes[f][2] for f in range(len(self.shapes)))

        points, triangles = lattice(self.box, self.step, self.margin, place)
        return points, [t for t in triangles if is_whole([points[v] for v in t])]

    def horizons(self):
        return {"h%d" % k: self.sheet(k) for k in range(self.n_layers)}
