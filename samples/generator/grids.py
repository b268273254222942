# SPDX-License-Identifier: GPL-3.0-or-later
"""What the samples of gridded stacks share: smooth random fields, noise at nodes, and writers of grids.

Standard library only. A grid is a list of rows from south to north, each a list of heights from west to east; None has no value.
"""
import math
import random


class SmoothField:
    """A sum of cosines with wavelengths of `wavelength` to twice that, standard deviation 1, mean 0."""

    seed = 0  # of the whole model: other fields of the same kind

    def __init__(self, seed, wavelength, n_waves=12):
        rng = random.Random(seed + 1000 * SmoothField.seed)
        self.waves = []
        for _ in range(n_waves):
            angle, length = rng.uniform(0, 2 * math.pi), wavelength * rng.uniform(1, 2)
            k = 2 * math.pi / length
            self.waves.append((k * math.cos(angle), k * math.sin(angle), rng.uniform(0, 2 * math.pi)))
        self.scale = math.sqrt(2.0 / n_waves)

    def at(self, x, y):
        return self.scale * sum(math.cos(kx * x + ky * y + phase) for kx, ky, phase in self.waves)


def add_noise(grid, deviation, seed):
    """Independent normal noise at each node that has a value."""
    rng = random.Random(seed)
    for row in grid:
        for i, z in enumerate(row):
            noise = rng.gauss(0, deviation)
            if z is not None:
                row[i] = z + noise


def write_esri_ascii(path, grid, corner, step):
    """Values at the centres of cells; `corner` is the lower left corner of the first cell."""
    with open(path, "w", newline="\n") as file:
        file.write("ncols %d\nnrows %d\nxllcorner %.10g\nyllcorner %.10g\ncellsize %.10g\nNODATA_value -9999\n"
                   % (len(grid[0]), len(grid), corner[0], corner[1], step))
        for row in reversed(grid):
            file.write(" ".join("-9999" if z is None else "%.2f" % z for z in row) + "\n")


def write_irap(path, grid, origin, step, rotation):
    """Irap classic text; `rotation` in degrees counter-clockwise about the origin."""
    n_columns, n_rows = len(grid[0]), len(grid)
    x1, y1 = origin[0] + (n_columns - 1) * step, origin[1] + (n_rows - 1) * step
    with open(path, "w", newline="\n") as file:
        file.write("-996 %d %.6f %.6f\n%.6f %.6f %.6f %.6f\n%d %.6f %.6f %.6f\n0 0 0 0 0 0 0\n"
                   % (n_rows, step, step, origin[0], x1, origin[1], y1, n_columns, rotation, origin[0], origin[1]))
        values = ["9999900.0" if z is None else "%.3f" % z for row in grid for z in row]
        for k in range(0, len(values), 6):
            file.write(" ".join(values[k:k + 6]) + "\n")


