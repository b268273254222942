#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/*.ts and expected.json of this sample: a valley through tilted layers. All lines of the section are straight, so that
volumes are known."""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import area_under_both, section_strip, write_expected, write_ts  # noqa: E402

EAST, WIDTH, BOTTOM = 6000.0, 3000.0, -2000.0
VALLEY = 3000.0
RELIEF = [(-150.0, 900.0), (1800.0, 640.0), (2900.0, 110.0), (3400.0, 90.0), (4700.0, 820.0), (6170.0, 980.0)]


def layer(west):
    """Rises to the east by one in eight from `west` at x = 0."""
    return [(-130.0, west - 130.0 / 8), (6130.0, west + 6130.0 / 8)]


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    tops = {"marl": layer(1100.0), "limestone": layer(250.0), "slate": layer(-250.0), "granite": layer(-800.0)}
    write_ts(os.path.join(folder, "relief.ts"), "relief", *section_strip(RELIEF, (-80.0, WIDTH + 60.0)))
    for unit, line in tops.items():
        write_ts(os.path.join(folder, "top_%s.ts" % unit), "top_" + unit, *section_strip(line, (-70.0, WIDTH + 50.0)))

    def volumes(x_range):
        areas = [area_under_both(RELIEF, line, x_range) for line in tops.values()] + [BOTTOM * (x_range[1] - x_range[0])]
        return {unit: WIDTH * (areas[i] - areas[i + 1]) for i, unit in enumerate(tops)}
    expected = {unit: [volume] for unit, volume in volumes((0.0, EAST)).items()}
    # The valley cuts down into the slate: the limestone is parted.
    expected["limestone"] = [volumes(side)["limestone"] for side in ((0.0, VALLEY), (VALLEY, EAST))]
    write_expected(os.path.join(HERE, "expected.json"), expected)


if __name__ == "__main__":
    main()
