#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/*.ts and expected.json of this sample: forty flat layers of 50 m, every fifth of which pinches out: its top comes
down onto its base along a line and lies on it from there on, so that both horizons coincide. All numbers are exact, so that volumes
are known."""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "generator"))
from gocad_surfaces import section_strip, write_expected, write_ts  # noqa: E402

LAYERS, THICKNESS = 40, 50.0
LENGTH, WIDTH = 4000.0, 3000.0


def pinch_out(layer):
    """Where the top of the layer reaches its base, and where it begins to come down; None for a layer that does not pinch out."""
    if layer % 5 != 3:
        return None
    end = 800.0 + 75.0 * layer
    return end - 400.0, end


def main():
    folder = os.path.join(HERE, "surfaces")
    os.makedirs(folder, exist_ok=True)
    thickness_areas = [LENGTH * THICKNESS] * LAYERS  # section areas
    for layer in range(1, LAYERS):  # the top of layer 0 is the box's
        top, base = -THICKNESS * layer, -THICKNESS * (layer + 1)
        line = [(-100.0, top), (LENGTH + 100.0, top)]
        where = pinch_out(layer)
        if where:
            start, end = where
            line = [(-100.0, top), (start, top), (end, base), (LENGTH + 100.0, base)]
            lost = THICKNESS * (LENGTH - end) + THICKNESS * (end - start) / 2
            thickness_areas[layer] -= lost
            thickness_areas[layer - 1] += lost
        write_ts(os.path.join(folder, "top_%02d.ts" % (layer + 1)), "top_%02d" % (layer + 1), *section_strip(line, (-50.0, WIDTH + 50.0)))
    write_expected(os.path.join(HERE, "expected.json"),
                   {"layer_%02d" % (i + 1): [area * WIDTH] for i, area in enumerate(thickness_areas)})


if __name__ == "__main__":
    main()
