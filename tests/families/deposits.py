# SPDX-License-Identifier: GPL-3.0-or-later
"""Families of deposits with a limited extent: channels, lenses and wedges that pinch out."""
import math

from family import Family, lattice


class Channel(Family):
    """A sinuous channel of 250 to 400 m depth, incised below horizon h0 into two layers and filled. Its base is eroded into them.

    The base is given in the channel and its levees alone, where it rises above h0; or, in odd models, over the whole map, where it coincides with h0
    beside the channel. The channel begins inside the box in every third model. Older horizons run through the channel as deposited, or stop
    a few metres before its base (models 2, 3 of each four)."""
    step = 60.0

    def __init__(self, seed):
        self.whole_map, self.has_head, self.is_cut = seed % 2 == 1, seed % 3 == 0, seed % 4 >= 2
        super().__init__(seed)

    def setup(self):
        c = self.chance
        self.depths = [-600 + c.uniform(-40, 40), -800 + c.uniform(-30, 30), -1500 + c.uniform(-60, 60)]
        self.depth, self.width = c.uniform(250, 400), c.uniform(450, 800)
        self.bend, self.bend_length, self.middle = c.uniform(200, 600), c.uniform(3500, 6000), c.uniform(2000, 3000)
        self.head = c.uniform(1500, 2500)
        self.levee, self.stop = c.uniform(10, 40), c.uniform(3, 15)
        self.gap = 10.0   # lattices cut the corner between the base and h0 by as much
        self.keys["base"] = "base: erode"

    def size(self):
        return 450.0

    def incision(self, x, y):
        """How far the base of the channel lies below h0; negative in the levees and beyond."""
        slope = 2 * math.pi * self.bend / self.bend_length * math.cos(2 * math.pi * x / self.bend_length)
        across = (y - self.middle - self.bend * math.sin(2 * math.pi * x / self.bend_length)) / math.hypot(1, slope)
        along = min(1.0, (x - self.head) / 1500) if self.has_head else 1.0
        return self.depth * (along - (across / self.width) ** 2)

    def base(self, x, y):
        return self.height(0, x, y) - self.incision(x, y)

    def unit_at(self, p):
        if self.height(0, *p[:2]) > p[2] > self.base(*p[:2]):
            return "fill"
        return super().unit_at(p)

    def horizons(self):
        def place_of_base(x, y):
            if self.whole_map:
                return min(self.height(0, x, y), self.base(x, y))
            return self.base(x, y) if self.incision(x, y) > -self.levee else None

        def place_below(k, x, y):
            z = self.height(k, x, y)
            return None if self.is_cut and z > self.base(x, y) - self.stop else z

        sheets = {"h0": lattice(self.box, self.step, self.margin, lambda x, y: self.height(0, x, y)),
                  "base": lattice(self.box, self.step, self.margin, place_of_base)}
        for k in (1, 2):
            sheets["h%d" % k] = lattice(self.box, self.step, self.margin, lambda x, y, k=k: place_below(k, x, y))
        return sheets

    def column(self):
        return ["u0", "h0", "fill", "base", "u1", "h1", "u2", "h2", "u3"]


class Lens(Family):
    """A lens, or a wedge that pinches out (models 3, 4 of each six). In two of three models its top and base are horizons over the whole map, which
    coincide beyond the rim, or cross there by 3 to 15 m; in the third one the lens is a closed body inside a unit."""
    n_layers = 4
    step = 100.0

    def __init__(self, seed):
        self.form, self.is_wedge = ("coincide", "cross", "body")[seed % 3], seed % 6 in (3, 4)
        super().__init__(seed)

    def setup(self):
        c = self.chance
        self.depths = [-600 + c.uniform(-50, 50), -1200.0, -1200 + c.uniform(-50, 50), -2000 + c.uniform(-60, 60)]
        self.thickness, self.crossing = c.uniform(80, 220), c.uniform(3, 15)
        self.centre, self.radii = (c.uniform(2500, 3500), c.uniform(2000, 3000)), (c.uniform(1200, 2000), c.uniform(900, 1600))
        self.gap = 6.0   # lattices cut the corner at the rim by as much
        if self.form == "body":
            self.n_layers = 3
            self.depths[2] = self.depths[3]
            self.bodies["lens"] = self.body()
        else:
            self.rules = ["rules: {min_thickness: 10, thin_layers: collapse}"]

    def size(self):
        return 350.0

    def outwards(self, x, y):
        """0 in the middle of the lens, 1 at its rim."""
        if self.is_wedge:
            return x / 4000 + 0.1 * math.sin(y / 900)
        return ((x - self.centre[0]) / self.radii[0]) ** 2 + ((y - self.centre[1]) / self.radii[1]) ** 2

    def height(self, k, x, y):
        if k != 1 or self.form == "body":
            return super().height(k, x, y)
        thickness = self.thickness * (1 - self.outwards(x, y))
        return super().height(2, x, y) + max(0.0 if self.form == "coincide" else -self.crossing, thickness)

    def middle(self, x, y):
        """The surface in the middle of the body, in the third unit."""
        return (self.height(1, x, y) + self.height(2, x, y)) / 2

    def body(self):
        """Rings of the top and the base, which share the last one."""
        n, n_rings = 48, 12
        points, triangles, rows = [], [], {}

        def vertex(ring, i, side):
            """The row of a vertex, which is added at its first use; the middle is a ring of one point and the rim belongs to both sides."""
            return rows.setdefault((ring, i % n if ring else 0, side if ring < n_rings else 0), len(rows))

        for side in (1, -1):
            for ring in range(n_rings):
                for i in range(n):
                    a, b = vertex(ring, i, side), vertex(ring, i + 1, side)
                    d, e = vertex(ring + 1, i, side), vertex(ring + 1, i + 1, side)
                    added = [(a, d, e)] + ([(a, e, b)] if ring else [])
                    triangles += added if side > 0 else [t[::-1] for t in added]   # outwards
        for ring, i, side in rows:
            r, angle = ring / n_rings, 2 * math.pi * i / n
            x, y = self.centre[0] + self.radii[0] * r * math.cos(angle), self.centre[1] + self.radii[1] * r * math.sin(angle)
            points.append((x, y, self.middle(x, y) + side * self.thickness / 2 * (1 - r * r)))
        return points, triangles

    def unit_at(self, p):
        if self.form == "body" and abs(p[2] - self.middle(*p[:2])) < self.thickness / 2 * (1 - self.outwards(*p[:2])):
            return "lens"
        return super().unit_at(p)
