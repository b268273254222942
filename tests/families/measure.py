# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs models of the families and measures how much of each lies in the wrong unit.

    python3 tests/families/measure.py PROGRAM [--families a,b] [--seeds 0-9] [--forms bare,careful] [--jobs 1]

Prints one line a model: the share of random points (uniform in the volume of the mesh, farther than three tolerances from where the unit changes)
that lie in the wrong unit, the largest such pairs of units, elements, CPU seconds. A point in a region of joined names counts as wrong.
"""
import argparse
import bisect
import math
import os
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "app")]
from families import FAMILIES  # noqa: E402
from vtk_files import VtkFile  # noqa: E402

N_POINTS = 20000


def read_regions(folder):
    """Corners of the elements, their region's name and the volume of each."""
    import json
    with open(os.path.join(folder, "model.report.json")) as file:
        report = json.load(file)
    names = {r["id"]: re.sub(r"__.*", "", r["name"]) for r in report["regions"]}
    mesh = VtkFile.read(os.path.join(folder, "model.vtu"))
    p, cells = mesh["Points", "Points"].values, mesh["Cells", "connectivity"].values
    points = list(zip(p[::3], p[1::3], p[2::3]))
    corners = [cells[4 * k:4 * k + 4] for k in range(len(cells) // 4)]
    regions = [names[r] for r in mesh["CellData", "region"].values]
    return points, corners, regions, report


def volume(points, cell):
    a, b, c, d = (points[v] for v in cell)
    u, v, w = ([x - y for x, y in zip(q, a)] for q in (b, c, d))
    return abs(u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6


def is_clear(model, p):
    """True if the unit is the same in all six directions, farther than the tolerance, the noise and what the data leave open."""
    distance = 3 * (model.size() / 40 + model.noise()) + model.room(p)
    if distance == math.inf:
        return False
    unit = model.unit_at(p)
    steps = ((distance, 0, 0), (-distance, 0, 0), (0, distance, 0), (0, -distance, 0), (0, 0, distance), (0, 0, -distance))
    return all(model.unit_at((p[0] + a, p[1] + b, p[2] + c)) == unit for a, b, c in steps)


def wrong_share(model, folder):
    points, corners, regions, report = read_regions(folder)
    sums, total = [], 0.0
    for cell in corners:
        total += volume(points, cell)
        sums.append(total)
    chance = random.Random(1)
    n, wrong = 0, {}
    (x0, y0, z0), (x1, y1, z1) = model.box
    for _ in range(N_POINTS):
        k = bisect.bisect_left(sums, chance.random() * total)
        cuts = sorted(chance.random() for _ in range(3))
        w = (cuts[0], cuts[1] - cuts[0], cuts[2] - cuts[1], 1 - cuts[2])
        p = tuple(sum(w[i] * points[corners[k][i]][a] for i in range(4)) for a in range(3))
        if not is_clear(model, p):
            continue
        n += 1
        if regions[k] != model.unit_at(p):
            pair = (model.unit_at(p), regions[k])
            wrong[pair] = wrong.get(pair, 0) + 1
    missing = abs(total / ((x1 - x0) * (y1 - y0) * (z1 - z0)) - 1)
    worst = sorted(wrong.items(), key=lambda item: -item[1])[:2]
    return sum(wrong.values()) / max(1, n), missing, ", ".join("%s in %s %.1f%%" % (*pair, 100 * c / n) for pair, c in worst), len(corners)


def run(program, family, seed, form, keep=None, limit=120):
    model = FAMILIES[family](seed)
    folder = keep or tempfile.mkdtemp()
    try:
        project = model.write(folder, form)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        def limits():
            resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 5))
        result = subprocess.run([program, project, "--quiet", "--threads", "1"], capture_output=True, text=True, preexec_fn=limits)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime - before.ru_utime
        if result.returncode != 0:
            return "%-13s %4d %-8s exit %d after %.0f s: %s" % (family, seed, form, result.returncode, seconds, result.stderr.strip()[:160])
        share, missing, worst, n = wrong_share(model, os.path.join(folder, "out"))
        verdict = "ok   " if share <= 0.001 and missing < 1e-6 else "WRONG"
        return "%-13s %4d %-8s %s %7.3f%% wrong, %7d elements, %5.1f s  %s" % (family, seed, form, verdict, 100 * share, n, seconds, worst)
    finally:
        if not keep:
            shutil.rmtree(folder, ignore_errors=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--families", default=",".join(FAMILIES))
    parser.add_argument("--seeds", default="0-3")
    parser.add_argument("--forms", default="bare,careful")
    parser.add_argument("--keep")
    asked = parser.parse_args()
    first, _, last = asked.seeds.partition("-")
    n_wrong = 0
    for family in asked.families.split(","):
        for seed in range(int(first), int(last or first) + 1):
            for form in asked.forms.split(","):
                line = run(asked.program, family, seed, form, asked.keep)
                n_wrong += " ok " not in line
                print(line, flush=True)
    print("%d wrong" % n_wrong)
    return n_wrong > 0


if __name__ == "__main__":
    sys.exit(main())
