#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes surfaces/mapped.csv: three fractures of known dip and radius, one of which ends outside of the block."""
import os

ROWS = [("main", 50, 50, 50, 45, 120, 70), ("branch", 60, 40, 55, 25, 30, 60), ("border", 95, 50, 30, 20, 270, 45)]


def main():
    folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "surfaces")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "mapped.csv"), "w", newline="\n") as file:
        file.write("name,x,y,z,radius,dip_direction,dip\n")
        file.writelines("%s,%g,%g,%g,%g,%g,%g\n" % row for row in ROWS)


if __name__ == "__main__":
    main()
