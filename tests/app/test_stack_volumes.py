# SPDX-License-Identifier: GPL-3.0-or-later
"""Volumes of units of a settled stack against an integration of the generator's own grids, written apart from the program.

The rules of docs/model-building.md ("The stack") are applied to the grids on a raster of the map: order, shared surfaces where a unit is thin
in the mean over half of the size, the least thickness elsewhere, and what the row of triangles along the pinch-out lines takes away.
"""
import math
import os
import re
import subprocess
import sys

from geomesh_program import SOURCE, ProgramTest, main

sys.path.insert(0, os.path.join(SOURCE, "samples", "reservoir"))
import make_surfaces as reservoir  # noqa: E402

COLUMNS, SIZE, LEAST = 36, 400.0, 4.0     # of the sample: nodes across, size asked in the units, least thickness in m
MARGIN = 400.0                            # m between the grids' rim and the box
PIXEL, PIXELS_A_CELL = 20.0, 5            # the raster of volumes, and that of mean thicknesses: a quarter of the size
ROW_OF_THICKNESS = 12
ALLOWED = 0.005


class Grid:
    def __init__(self, heights, step):
        self.heights, self.step = heights, step

    def at(self, u, v):
        x, y = u / self.step, v / self.step
        i, j = min(int(x), len(self.heights[0]) - 2), min(int(y), len(self.heights) - 2)
        x, y, low, high = x - i, y - j, self.heights[j], self.heights[j + 1]
        return (1 - y) * ((1 - x) * low[i] + x * low[i + 1]) + y * ((1 - x) * high[i] + x * high[i + 1])


def smoothed(rows):
    """Four times the binomial mean over three cells each way; beyond the rim its own value goes on."""
    def along(row):
        for _ in range(4):
            row = [0.25 * row[max(0, i - 1)] + 0.5 * row[i] + 0.25 * row[min(len(row) - 1, i + 1)] for i in range(len(row))]
        return row
    return list(zip(*[along(list(column)) for column in zip(*[along(row) for row in rows])]))


def thin_cells(columns):
    """Per cell of mean thicknesses, whether the unit is too thin there; `columns`: rows of pixels of thicknesses."""
    n, m, k = len(columns) // PIXELS_A_CELL, len(columns[0]) // PIXELS_A_CELL, PIXELS_A_CELL
    means = [[sum(sum(columns[j * k + q][i * k:(i + 1) * k]) for q in range(k)) / (k * k) for i in range(m)] for j in range(n)]
    return [[mean < LEAST for mean in row] for row in smoothed(means)]


def line_length(cells):
    """Of the line between thin cells and others. Sides of cells are longer than a line in any direction by 4 / pi in the mean."""
    n = sum(a != b for row in cells for a, b in zip(row, row[1:])) + sum(a != b for rows in zip(cells, cells[1:]) for a, b in zip(*rows))
    return math.pi / 4 * n * PIXEL * PIXELS_A_CELL


def integrate():
    """Volumes of the units between the four grids, in m3."""
    step = reservoir.WIDTH / (COLUMNS - 1)
    n_rows = int(round(reservoir.LENGTH / step)) + 1
    grids = [Grid(heights, step) for heights in reservoir.make_grids(COLUMNS, n_rows, 1.5 * step)]
    us = [MARGIN + PIXEL * (i + 0.5) for i in range(int((reservoir.WIDTH - 2 * MARGIN) / PIXEL))]
    vs = [MARGIN + PIXEL * (j + 0.5) for j in range(int((reservoir.LENGTH - 2 * MARGIN) / PIXEL))]
    heights = [[[grid.at(u, v) for u in us] for v in vs] for grid in grids]
    thin = [thin_cells([[max(0.0, a - b) for a, b in zip(*rows)] for rows in zip(heights[k], heights[k + 1])]) for k in range(3)]
    volumes = [0.0] * 3
    for j in range(len(vs)):
        for i in range(len(us)):
            top = heights[0][j][i]
            for k in range(3):
                cells = thin[k]
                is_thin = cells[min(j // PIXELS_A_CELL, len(cells) - 1)][min(i // PIXELS_A_CELL, len(cells[0]) - 1)]
                base = top if is_thin else min(heights[k + 1][j][i], top - LEAST)
                volumes[k] += (top - base) * PIXEL * PIXEL
                top = base
    for k in range(3):  # the older horizon gives way: what the row takes from a unit goes to the next
        taken = 0.5 * ROW_OF_THICKNESS * LEAST * LEAST * line_length(thin[k])
        volumes[k] -= taken
        if k < 2:
            volumes[k + 1] += taken
    return dict(zip(("upper", "middle", "lower"), volumes))


class StackVolumes(ProgramTest):
    timeout = 800

    def test_units_of_the_reservoir_have_the_volumes_that_its_grids_have_by_the_rules(self):
        folder = self.path("project")
        subprocess.run([sys.executable, os.path.join(SOURCE, "samples", "reservoir", "make_surfaces.py"), "--output", folder], check=True,
                       timeout=120)
        self.run_program(os.path.join(folder, "project.yaml"), "-o", self.folder)
        meshed = {}
        for region in self.report(self.path("reservoir.report.json"))["regions"]:
            unit = re.sub(r"__B\d+$", "", region["name"])
            meshed[unit] = meshed.get(unit, 0) + region["volume"]
        for unit, volume in integrate().items():
            self.assertAlmostEqual(meshed[unit] / volume, 1, delta=ALLOWED, msg=unit)


if __name__ == "__main__":
    main()
