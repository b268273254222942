#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Times samples/salt-dome in the page of scripts/browser and by the program, in turns: scripts/browser --times."""
import os
import statistics
import subprocess
import tempfile
import time

from browser_page import PAGE, BrowserPage
from geomesh_program import PROGRAM, SOURCE

ROUNDS = 3
SAMPLE = os.path.join(SOURCE, "samples", "salt-dome", "project.yaml")


def in_page(folder):
    """(seconds on the clock from the button to the result, report)"""
    page = BrowserPage(os.path.join(folder, "profile"))
    try:
        page.press("Salt dome")
        page.wait_for_project()
        began = time.monotonic()
        page.mesh()
        return time.monotonic() - began, page.report()
    finally:
        page.close()


def by_program(folder, threads):
    began = time.monotonic()
    subprocess.run([PROGRAM, SAMPLE, "-o", folder, "--quiet", "--threads", str(threads)], check=True)
    return time.monotonic() - began


def main():
    times, report = {"page": [], "program, 1 thread": [], "program, all threads": []}, None
    for _ in range(ROUNDS):
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
            seconds, report = in_page(folder)
            times["page"].append(seconds)
            times["program, 1 thread"].append(by_program(folder, 1))
            times["program, all threads"].append(by_program(folder, 0))
    stages = sum(stage["wall_s"] for stage in report["stages"])
    print("samples/salt-dome, %d tetrahedra; seconds on the clock, median of %d" % (report["recovery"]["tetrahedra_final"], ROUNDS))
    for name, seconds in times.items():
        print("%-22s %6.1f" % (name, statistics.median(seconds)))
    print("stages in the last page   %.1f; the page has %.1f MB" % (stages, os.path.getsize(PAGE) / 1e6))


if __name__ == "__main__":
    main()
