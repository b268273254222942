#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/*.ts and expected.json of this sample: a normal fault that dips east and ends inside the model, at y = 2,600, and two
horizons, each in two blocks with gaps of 100 m along the fault and on beyond its end. The throw falls from 400 m at y = 0 to nothing at
y = 2,400. The expected volumes are those of the horizons drawn to the fault; what the program fills in beyond the end of the fault is as
wide as the gap, which "within" allows for."""
import json
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import sheet, write_ts  # noqa: E402

WIDTH, LENGTH, DEPTH = 6000.0, 4000.0, 3000.0
END, NO_THROW, THROW, GAP = 2600.0, 2400.0, 400.0, 100.0
LEVELS = {"top_sand": -1000.0, "top_basement": -1800.0}


def fault_x(z):
    """Dips east by 60 degrees, nearly."""
    return 2500.0 - 0.6 * z


def throw(y):
    return THROW * max(0.0, 1 - y / NO_THROW)


def block(level, lowered, seed):
    """One block, from the gap beside the fault outwards."""
    def place(u, v):
        y = -150.0 + v * (LENGTH + 300.0)
        z = level - (throw(y) if lowered else 0.0)
        edge = fault_x(z) + (GAP / 2 if lowered else -GAP / 2)
        far = WIDTH + 150.0 if lowered else -150.0
        return (edge + u * (far - edge) if lowered else far + u * (edge - far)), y, z
    return sheet(10, 43, place, seed, jitter=0.0)


def volume_below(level):
    """Of the model below a horizon, drawn to the fault: straight sections across, each a trapezium either side, integrated along y."""
    footwall, n = LENGTH * fault_x(level) * (level + DEPTH), 4000
    footwall += LENGTH * 0.3 * (level + DEPTH) ** 2  # the fault lies further east below the horizon
    hanging = 0.0
    for k in range(n):  # the integrand is a quadratic in y on either side of NO_THROW, a node: Simpson's rule is exact
        y0, y1 = LENGTH * k / n, LENGTH * (k + 1) / n
        sections = []
        for y in (y0, (y0 + y1) / 2, y1):
            h = level - throw(y) + DEPTH
            sections.append((WIDTH - fault_x(level - throw(y))) * h - 0.3 * h * h)
        hanging += (y1 - y0) * (sections[0] + 4 * sections[1] + sections[2]) / 6
    return footwall + hanging


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    for seed, (name, level) in enumerate(LEVELS.items(), start=61):
        points, triangles = block(level, False, seed)
        more, others = block(level, True, seed)
        write_ts(os.path.join(folder, name + ".ts"), name, points + more, triangles + [tuple(v + len(points) for v in t) for t in others])
    points, triangles = sheet(6, 6, lambda u, v: (fault_x(-3200 + 3400 * v), -150.0 + u * (END + 150.0), -3200 + 3400 * v), 63, jitter=0.0)
    write_ts(os.path.join(folder, "fault.ts"), "fault", points, triangles)
    below = {name: volume_below(level) for name, level in LEVELS.items()}
    volumes = {"cover": WIDTH * LENGTH * DEPTH - below["top_sand"], "sand": below["top_sand"] - below["top_basement"],
               "basement": below["top_basement"]}
    with open(os.path.join(HERE, "expected.json"), "w", newline="\n") as file:
        json.dump({"units": {unit: [v] for unit, v in volumes.items()}, "within": 1e-4}, file, indent=1, sort_keys=True)
        file.write("\n")


if __name__ == "__main__":
    main()
