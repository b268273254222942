# SPDX-License-Identifier: GPL-3.0-or-later
"""Volumes of units of settled stacks, integrated over the generators' own grids with nothing of geomesh.

The rules of docs/model-building.md ("The stack") are applied on a raster of the map to the grids as delivered, with their noise: order, shared
surfaces where a unit is thin in the mean over half of the size, the least thickness elsewhere. Nodes without a value have that of the nearest
node with one. Standard library only.
"""
import importlib.util
import math
import os

SAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
PIXELS_A_CELL = 5       # of thickness; a cell of mean thicknesses is a quarter of the size
CELLS_BEYOND = 2        # the rectangle


def generator_of(sample, seed):
    spec = importlib.util.spec_from_file_location(sample.replace("-", "_"), os.path.join(SAMPLES, sample, "make_surfaces.py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.SmoothField.seed = seed
    return module


def filled(heights):
    """Each node without a value gets that of about the nearest one with one, by two sweeps."""
    n_rows, n_columns = len(heights), len(heights[0])
    source = [[(i, j) if heights[j][i] is not None else None for i in range(n_columns)] for j in range(n_rows)]
    rows = range(n_rows)
    for order, step in ((rows, -1), (reversed(rows), 1), (rows, -1), (reversed(rows), 1)):
        for j in order:
            for columns, side in ((range(n_columns), -1), (range(n_columns - 1, -1, -1), 1)):
                for i in columns:
                    near = [(i, j)] if source[j][i] else []
                    near += [(a, b) for a, b in ((i + side, j), (i, j + step), (i - 1, j + step), (i + 1, j + step))
                             if 0 <= a < n_columns and 0 <= b < n_rows and source[b][a]]
                    if near:
                        source[j][i] = min((source[b][a] for a, b in near), key=lambda p: (p[0] - i) ** 2 + (p[1] - j) ** 2)
    return [[heights[source[j][i][1]][source[j][i][0]] for i in range(n_columns)] for j in range(n_rows)]


class Grid:
    """Heights at nodes, bilinear between; beyond the rim the last cell goes on."""

    def __init__(self, heights, step, first=(0.0, 0.0)):
        self.heights = filled(heights) if any(None in row for row in heights) else heights
        self.step, self.first = step, first

    def at(self, u, v):
        x, y = (u - self.first[0]) / self.step, (v - self.first[1]) / self.step
        i, j = max(0, min(int(x), len(self.heights[0]) - 2)), max(0, min(int(y), len(self.heights) - 2))
        x, y, low, high = x - i, y - j, self.heights[j], self.heights[j + 1]
        return (1 - y) * ((1 - x) * low[i] + x * low[i + 1]) + y * ((1 - x) * high[i] + x * high[i + 1])


def geographic(x, y, central_meridian):
    """Longitude and latitude of a place of a UTM zone in the north (L. Krueger, 1912, to the third order; WGS 84)."""
    flattening, equator, scale = 1 / 298.257223563, 6378137.0, 0.9996
    n = flattening / (2 - flattening)
    rectifying = equator / (1 + n) * (1 + n * n / 4 + n ** 4 / 64)
    xi, eta = y / (scale * rectifying), (x - 500000.0) / (scale * rectifying)
    beta = (n / 2 - 2 * n * n / 3 + 37 * n ** 3 / 96, n * n / 48 + n ** 3 / 15, 17 * n ** 3 / 480)
    delta = (2 * n - 2 * n * n / 3 - 2 * n ** 3, 7 * n * n / 3 - 8 * n ** 3 / 5, 56 * n ** 3 / 15)
    a = xi - sum(b * math.sin(2 * k * xi) * math.cosh(2 * k * eta) for k, b in enumerate(beta, start=1))
    b = eta - sum(c * math.cos(2 * k * xi) * math.sinh(2 * k * eta) for k, c in enumerate(beta, start=1))
    chi = math.asin(math.sin(a) / math.cosh(b))
    latitude = chi + sum(d * math.sin(2 * k * chi) for k, d in enumerate(delta, start=1))
    return central_meridian + math.degrees(math.atan2(math.sinh(b), math.cos(a))), math.degrees(latitude)


def smoothed(rows):
    """Four times the binomial mean over three cells each way; beyond the rim its own value goes on."""
    def along(row):
        for _ in range(4):
            row = [0.25 * row[max(0, i - 1)] + 0.5 * row[i] + 0.25 * row[min(len(row) - 1, i + 1)] for i in range(len(row))]
        return row
    return list(zip(*[along(list(column)) for column in zip(*[along(row) for row in rows])]))


def groups_of(rows, is_member):
    """Lists of cells (j, i) joined by their sides, of those that are members."""
    seen, groups = set(), []
    for j, row in enumerate(rows):
        for i, value in enumerate(row):
            if (j, i) in seen or not is_member(value):
                continue
            group, ends = [], [(j, i)]
            seen.add((j, i))
            while ends:
                b, a = ends.pop()
                group.append((b, a))
                for q, p in ((b + 1, a), (b - 1, a), (b, a + 1), (b, a - 1)):
                    if 0 <= q < len(rows) and 0 <= p < len(row) and (q, p) not in seen and is_member(rows[q][p]):
                        seen.add((q, p))
                        ends.append((q, p))
            groups.append(group)
    return groups


def in_order(thicknesses):
    """Of units under each other at one place: none below zero, what a unit has too much is missing in the next."""
    ordered, debt = [], 0.0
    for t in thicknesses:
        t -= debt
        debt = max(0.0, -t)
        ordered.append(max(0.0, t))
    return ordered


def without_islands(rows, least):
    """Openings and thin areas below two squares of the size are dropped, but for openings more than three times as thick as the least."""
    n, m, fewest = len(rows), len(rows[0]), 2 * 16  # cells of a quarter of the size
    for group in groups_of(rows, lambda t: t >= least):
        most = max(rows[j][i] for j, i in group)
        if len(group) < n * m and most <= 3 * least and (len(group) < fewest or most <= 1.5 * least):
            for j, i in group:
                rows[j][i] = 0.75 * least
    for group in groups_of(rows, lambda t: t < least):
        if len(group) < n * m and (len(group) < fewest or min(rows[j][i] for j, i in group) >= 0.75 * least):
            for j, i in group:
                rows[j][i] = 1.25 * least
    return rows


def between(rows, j, i):
    """Linear both ways between the centres of cells, at the middle of pixel (j, i)."""
    def place(pixel, n):
        at = max(0.0, min((pixel + 0.5) / PIXELS_A_CELL - 0.5, n - 1.0))
        first = min(int(at), max(0, n - 2))
        return first, min(first + 1, n - 1), at - first
    j0, j1, v = place(j, len(rows))
    i0, i1, u = place(i, len(rows[0]))
    return (1 - v) * ((1 - u) * rows[j0][i0] + u * rows[j0][i1]) + v * ((1 - u) * rows[j1][i0] + u * rows[j1][i1])


class Model:
    """Heights of the horizons over a rectangle, the youngest first, and the units between them."""

    def __init__(self, units, corner, lengths, size, least, heights):
        self.units, self.corner, self.lengths, self.size, self.least, self.heights = units, corner, lengths, size, least, heights

    def thin_areas(self, pixels):
        """By unit, mean thicknesses by cell, smoothed and in order; thin where below the least."""
        n, m, k = len(pixels) // PIXELS_A_CELL, len(pixels[0]) // PIXELS_A_CELL, PIXELS_A_CELL
        units = range(len(self.units))

        def mean(j, i, unit):
            return sum(h[unit] - h[unit + 1] for row in pixels[j * k:(j + 1) * k] for h in row[i * k:(i + 1) * k]) / (k * k)
        means = [smoothed([[mean(j, i, unit) for i in range(m)] for j in range(n)]) for unit in units]
        ordered = [[in_order([means[unit][j][i] for unit in units]) for i in range(m)] for j in range(n)]
        return [without_islands([[cell[unit] for cell in row] for row in ordered], self.least) for unit in units]

    def volumes(self):
        """By unit, in m3. The raster reaches half of the size beyond the rectangle: areas are as large as they are there."""
        k, rim = PIXELS_A_CELL, CELLS_BEYOND * PIXELS_A_CELL
        n, m = (max(1, round(length / (self.size / 4))) * k for length in self.lengths)
        du, dv = self.lengths[0] / n, self.lengths[1] / m
        pixels = [[self.heights(self.corner[0] + du * (i + 0.5), self.corner[1] + dv * (j + 0.5)) for i in range(-rim, n + rim)]
                  for j in range(-rim, m + rim)]
        thin = self.thin_areas(pixels)
        sums = [0.0] * len(self.units)
        for cell_j in range(rim, m + rim, k):
            for cell_i in range(rim, n + rim, k):
                places = [(j, i) for j in range(cell_j, cell_j + k) for i in range(cell_i, cell_i + k)]
                for unit, thickness in enumerate(self.column(places, pixels, thin)):
                    sums[unit] += thickness * du * dv
        return dict(zip(self.units, sums))

    def column(self, places, pixels, thin):
        """Sums of thicknesses over the pixels of a cell, by unit."""
        tops, sums = {(j, i): pixels[j][i][0] for j, i in places}, []
        for unit in range(len(self.units)):
            there = [p for p in places if between(thin[unit], *p) >= self.least]
            bases = {(j, i): pixels[j][i][unit + 1] for j, i in there}
            if there:  # the mean over a cell is at least the least: noise from node to node adds nothing
                missing = max(0.0, self.least - sum(tops[p] - bases[p] for p in there) / len(there))
                for p in there:
                    bases[p] -= missing
            sums.append(sum(tops[p] - bases[p] for p in there))
            tops.update(bases)
        return sums


def basin(nodes=40, size=10000.0, tolerance=60.0, seed=0):
    made = generator_of("basin", seed)
    step = made.WIDTH / nodes
    grids = [Grid(heights, step, (made.WEST + 0.5 * step, made.SOUTH + 0.5 * step)) for heights in made.make_grids(nodes)]

    def heights(x, y):
        place = geographic(x, y, 9.0)
        return [grid.at(*place) for grid in grids]
    return Model(("quaternary", "tertiary", "jurassic"), (580000.0, 5325000.0), (70000.0, 110000.0), size, max(tolerance / 2, size / 150),
                 heights)


def reservoir(columns=36, size=400.0, thickness=4.0, outer=None, seed=0):
    made = generator_of("reservoir", seed)
    margin = 400.0  # between the rim of the grids and the box, which is turned with them
    step = made.WIDTH / (columns - 1)
    n_rows = int(round(made.LENGTH / step)) + 1
    grids = [Grid(heights, step) for heights in made.make_grids(columns, n_rows, 1.5 * step)]
    return Model(("upper", "middle", "lower"), (margin, margin), (made.WIDTH - 2 * margin, made.LENGTH - 2 * margin), size, thickness,
                 lambda u, v: [grid.at(u, v) for grid in grids])


def blank_grids(columns=56, size=1500.0, tolerance=8.0, seed=0):
    made = generator_of("blank-grids", seed)
    step = made.WIDTH / (columns - 1)
    n_rows = int(round(made.LENGTH / step)) + 1
    grids = [Grid(heights, step, made.ORIGIN) for heights in made.make_grids(columns, n_rows)]
    return Model(("shale", "sand", "coal"), (501000.0, 6501000.0), (11800.0, 9200.0), size, max(tolerance / 2, size / 150),
                 lambda x, y: [grid.at(x, y) for grid in grids])


def exploration(nodes=40, size=2500.0, tolerance=40.0, seed=0):
    made = generator_of("exploration", seed)
    grid = Grid(made.make_grids(nodes)[0], made.WIDTH / (nodes - 1))
    return Model(("cover", "granite"), (1000.0, 1000.0), (18000.0, 18000.0), size, 0.0,
                 lambda x, y: [0.0, min(0.0, max(-8000.0, grid.at(x, y))), -8000.0])


MODELS = {"basin": basin, "reservoir": reservoir, "blank-grids": blank_grids, "exploration": exploration}
