#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""geomesh ensemble: a study gives one table, whatever runs it; what fails is recorded; mistakes are told with their lines."""
import csv
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree as xml

from geomesh_program import DONE, NIGHTLY, PROGRAM, SOURCE, USAGE, ProgramTest, main

PYTHON_PACKAGE = os.path.join(os.path.dirname(os.path.dirname(PROGRAM)), "python")

STUDY = """project: project.yaml
realisations: 12
seed: 3
mesh: {refine: none}
grid: {cells: [12, 10, 8]}
parameters:
  velocity: {normal: [0, 20], within: [-50, 50]}
surfaces:
  top_reservoir:
    shift: velocity
    tilt: {angle: {uniform: [-0.5, 0.5]}, azimuth: {uniform: [0, 360]}}
    perturbation: {sd: 15, range: 1200}
    hold: {wells: all}
  base_reservoir:
    shift: velocity
    perturbation: {sd: 10, range: 900, correlation: exponential}
"""


def can_run():
    """Why the Python package cannot be used here; empty where it can."""
    done = subprocess.run(["/usr/bin/python3", "-c", "import yaml, numpy, geomesh._geomodel"], env={**os.environ, "PYTHONPATH": PYTHON_PACKAGE},
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return "" if done.returncode == 0 else done.stdout.strip().splitlines()[-1]


class EnsembleTest(ProgramTest):
    bare = False

    def setUp(self):
        super().setUp()
        missing = can_run()
        if missing:
            self.skipTest("skipped: the Python package geomesh is not there: " + missing)
        self.project = os.path.dirname(self.copy_of_sample("wells", None))

    def study(self, text=STUDY, name="study.yaml"):
        file = os.path.join(self.project, name)
        with open(file, "w") as out:
            out.write(text)
        return file

    def content(self, *parts):
        with open(self.path(*parts), "rb") as file:
            return file.read()

    def table(self, folder):
        with open(self.path(folder, "table.csv")) as file:
            return list(csv.DictReader(file))

    def python(self, code):
        """Runs code with the package, and gives what it prints."""
        done = subprocess.run(["/usr/bin/python3", "-c", code], env={**os.environ, "PYTHONPATH": PYTHON_PACKAGE}, cwd=self.project,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout


class OneStudyOneTable(EnsembleTest):
    def test_one_process_two_processes_and_single_calls_give_the_same_table_page_grid_and_summary(self):
        study = self.study()
        said = self.run_program("ensemble", study, "-o", "one", "--jobs", 1)
        self.assertIn("12 realisations done, 0 failed, 0 missing", said)
        self.run_program("ensemble", study, "-o", "two", "--jobs", 2, "--quiet")
        for only in ("5", "1-4", "12,6-11"):
            self.run_program("ensemble", study, "-o", "calls", "--only", only, "--quiet")
        self.run_program("ensemble", study, "-o", "calls", "--collect")
        for name in ("table.csv", "summary.csv", "index.html", "probability.vti"):
            self.assertEqual(self.content("one", name), self.content("two", name), name)
            self.assertEqual(self.content("one", name), self.content("calls", name), name)
        rows = self.table("one")
        self.assertEqual([row["realisation"] for row in rows], [str(i) for i in range(1, 13)])
        self.assertEqual(len({row["volume:reservoir"] for row in rows}), 12, "realisations differ from each other")
        for row in rows:
            total = sum(float(value) for key, value in row.items() if key.startswith("volume:"))
            self.assertAlmostEqual(total / (3000.0 * 3000.0 * 2000.0), 1.0, places=12)

    def test_a_driver_that_is_killed_and_started_again_gives_the_table_of_one_that_was_not(self):
        study = self.study(STUDY.replace("refine: none", "size: 150"))
        self.run_program("ensemble", study, "-o", "whole", "--quiet")
        driver = subprocess.Popen([PROGRAM, "ensemble", study, "-o", self.path("killed"), "--jobs", "2"], stderr=subprocess.DEVNULL)
        results = self.path("killed", "realisations", "00000")
        deadline = time.monotonic() + 120
        while len(self.complete(results)) < 3 and time.monotonic() < deadline and driver.poll() is None:
            time.sleep(0.02)
        driver.send_signal(signal.SIGKILL)
        self.assertEqual(driver.wait(), -signal.SIGKILL, "the driver was still at work")
        before = len(self.complete(results))
        self.assertTrue(3 <= before < 12, before)
        self.assertFalse(os.path.exists(self.path("killed", "table.csv")))
        said = self.run_program("ensemble", study, "-o", "killed")
        self.assertRegex(said, r"\d+ of 12 realisations are there already")
        self.assertEqual(self.content("killed", "table.csv"), self.content("whole", "table.csv"))
        self.assertEqual(self.content("killed", "probability.vti"), self.content("whole", "probability.vti"))

    def test_the_salt_dome_has_some_5000_elements_a_realisation_all_its_units_and_passes_the_check(self):
        self.project = os.path.dirname(self.copy_of_sample("salt-dome", None))
        with open(os.path.join(self.project, "study.yaml")) as file:
            text = file.read()
        study = self.study(text.replace("realisations: 1000", "realisations: 6"))
        self.run_program("ensemble", study, "-o", "out", "--quiet")
        rows = self.table("out")
        self.assertEqual([row["status"] for row in rows], ["done"] * 6)
        self.assertAlmostEqual(sum(int(row["tetrahedra"]) for row in rows) / 6, 5000, delta=500)
        for row in rows:
            self.assertEqual(sum(float(value) > 0 for key, value in row.items() if key.startswith("volume:")), 5, row)
        self.python("""
from geomesh.ensemble import realise, study
s = study.read_study("study.yaml")
r = realise.Realiser(s)
realise.write_input(s, r.draw(2), "second")
""")
        project = os.path.join(self.project, "second", "project.yaml")
        self.run_program(project, "-o", "second")
        found = self.check(self.path("second", "salt_dome.vtu"), "--project", project)
        self.assertEqual(str(sum(region["tetrahedra"] for region in found["regions"])), rows[1]["tetrahedra"])

    @unittest.skipUnless(NIGHTLY, "a hundred realisations, twice: with GEOMESH_NIGHTLY=1 alone")
    def test_a_hundred_realisations_come_to_the_same_table_after_kill_9_in_the_middle(self):
        done = subprocess.run([sys.executable, os.path.join(SOURCE, "scripts", "ensemble-restart"), "--bin", os.path.dirname(PROGRAM), "--realisations", "100"],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("byte for byte", done.stdout)

    @staticmethod
    def complete(folder):
        return [name for name in os.listdir(folder) if name.endswith(".json")] if os.path.isdir(folder) else []

    def test_more_realisations_leave_the_first_ones_and_another_study_is_refused_the_folder(self):
        self.run_program("ensemble", self.study(STUDY.replace("realisations: 12", "realisations: 3")), "-o", "out", "--quiet")
        first = self.table("out")
        said = self.run_program("ensemble", self.study(STUDY.replace("realisations: 12", "realisations: 5")), "-o", "out")
        self.assertIn("3 of 5 realisations are there already", said)
        self.assertEqual(self.table("out")[:3], first)
        said = self.run_program("ensemble", self.study(STUDY.replace("seed: 3", "seed: 4")), "-o", "out", status=USAGE)
        self.assertIn("holds results of another study", said)

    def test_any_file_that_changes_makes_another_study(self):
        sizes = os.path.join(self.project, "sizes.txt")
        text = STUDY.replace("refine: none", "size: {global: 400, background: sizes.txt}").replace("realisations: 12", "realisations: 1")
        for size, status in ((400, 0), (300, USAGE)):
            with open(sizes, "w") as out:
                out.write("0 0 0 %d\n1000 0 0 %d\n" % (size, size))
            said = self.run_program("ensemble", self.study(text), "-o", "out", status=status)
        self.assertIn("holds results of another study", said)


class WhatIsDrawn(EnsembleTest):
    def test_surfaces_stand_still_at_held_wells_and_move_elsewhere_with_the_deviation_asked(self):
        self.study()
        printed = self.python("""
import numpy
from geomesh.ensemble import displace, realise, study
s = study.read_study("study.yaml")
r = realise.Realiser(s)
p, t = r._elevations("top_reservoir", {})
holds = displace.picks(p, t, [path for w in s.project.wells for path in r._paths(w)])
b, _ = r._elevations("base_reservoir", {})
moves, other, at = [], [], 0.0
for i in range(1, 201):
    drawn = r.draw(i)
    d = drawn.moved["top_reservoir"][0] - p
    assert (d[:, :2] == 0).all()
    at = max([at] + [abs((w * d[v, 2]).sum()) for v, w in holds])
    moves.append(abs(d[:, 2]).max())
    other.append(drawn.moved["base_reservoir"][0][:, 2] - b[:, 2] - drawn.values["parameters.velocity"])
print(len(holds), at, min(moves), numpy.std(other), numpy.mean(other))
""")
        holds, at, least, deviation, mean = map(float, printed.split())
        self.assertGreaterEqual(holds, 2)
        self.assertLess(at, 1e-9)
        self.assertGreater(least, 1.0)
        self.assertTrue(9.0 < deviation < 11.0, deviation)  # 10 asked; 200 fields of some ten independent places
        self.assertLess(abs(mean), 1.0)

    def test_fields_have_the_correlation_that_their_range_says(self):
        printed = self.python("""
import numpy
from geomesh.ensemble import draws, fields
for kind in fields.CORRELATIONS:
    for d in (2, 3):
        places = numpy.zeros((3, d)); places[1, 0] = 500.0; places[2, d - 1] = 1000.0
        z = numpy.array([fields.gaussian_field(places, 1000.0, kind, draws.Stream(1, i, "f")) for i in range(3000)])
        c = numpy.corrcoef(z.T)
        print(c[0, 1] - fields.correlation(500.0, 1000.0, kind), c[0, 2] - fields.correlation(1000.0, 1000.0, kind), z.var() - 1)
""")
        for line in printed.splitlines():
            for error in map(float, line.split()):
                self.assertLess(abs(error), 0.08, printed)  # four standard deviations of 3,000 draws

    def test_a_parameter_more_changes_no_draw_of_the_others(self):
        self.study()
        self.study(STUDY.replace("parameters:", "parameters:\n  another: {lognormal: [2, 0.3]}"), "more.yaml")
        printed = self.python("""
from geomesh.ensemble import realise, study
a, b = (realise.Realiser(study.read_study(f)).draw(7) for f in ("study.yaml", "more.yaml"))
assert b.values.pop("parameters.another") > 0
assert a.values == b.values and len(a.values) == 3
for name in a.moved:
    assert (a.moved[name][0] == b.moved[name][0]).all()
print("same")
""")
        self.assertEqual(printed.strip(), "same")

    def test_files_are_picked_keys_are_set_and_throws_move_the_hanging_wall(self):
        folder = os.path.dirname(self.copy_of_sample("normal-fault", None))
        with open(os.path.join(folder, "project.yaml")) as file:
            text = file.read()
        horizon, source = re.search(r"name: (\w+),\s*kind: horizon,\s*file: (\S+?)[,}]", text).groups()
        fault = re.search(r"name: (\w+),\s*kind: fault", text).group(1)
        shutil.copy(os.path.join(folder, source), os.path.join(folder, "surfaces", "copy.ts"))
        self.project = folder
        study = self.study("project: project.yaml\nrealisations: 6\nmesh: {refine: none}\nthrow: {%s: {uniform: [10, 60]}}\n"
                           "surfaces: {%s: {file: {pick: [%s, surfaces/copy.ts], weights: [1, 1]}}}\n"
                           "set: {tolerance: {pick: [0, 0.001]}}\n" % (fault, horizon, source))
        self.run_program("ensemble", study, "-o", "out", "--quiet")
        rows = self.table("out")
        self.assertEqual([row["status"] for row in rows], ["done"] * 6, rows)
        self.assertEqual({row["surfaces.%s.file" % horizon] for row in rows}, {source, "surfaces/copy.ts"})
        self.assertEqual({row["set.tolerance"] for row in rows}, {"0", "0.001"})
        # The hanging wall goes down by the throw: what lies above all horizons grows with it, in a straight line.
        unit = next(key for key in rows[0] if key.startswith("volume:"))
        points = sorted((float(row["throw." + fault]), float(row[unit])) for row in rows)
        slopes = [(b[1] - a[1]) / (b[0] - a[0]) for a, b in zip(points, points[1:])]
        self.assertGreater(min(slopes), 0)
        self.assertLess(max(slopes) / min(slopes), 1.2, slopes)


class Failures(EnsembleTest):
    def test_a_realisation_that_fails_is_recorded_with_an_input_that_fails_alike_and_the_rest_goes_on(self):
        mesh = "mesh: {size: {global: 100, background: sizes.txt}}"
        with open(os.path.join(self.project, "sizes.txt"), "w") as out:
            out.write("0 0 0 100\n1000 0 0 100\n")
        text = STUDY.replace("mesh: {refine: none}", mesh).replace("realisations: 12", "realisations: 6")
        study = self.study(text + "set: {mesh.max_elements: {pick: [10, 50000000]}}\n")
        said = self.run_program("ensemble", study, "-o", "out")
        rows = self.table("out")
        failed = [row for row in rows if row["status"] == "failed"]
        self.assertTrue(0 < len(failed) < 6, [row["status"] for row in rows])
        self.assertIn("%d failed" % len(failed), said)
        for row in failed:
            self.assertEqual((row["failure"], row["set.mesh.max_elements"]), ("mesh", "10"))
            self.assertEqual(row["volume:reservoir"], "")
            again = self.run_program(self.path("out", "failures", row["realisation"], "project.yaml"), "-o", "again", status=4)
            self.assertIn(row["message"].split(" | ")[0][:60], again)
        self.assertIn("failures/%s/project.yaml" % failed[0]["realisation"], self.content("out", "index.html").decode())

    def test_a_process_that_dies_is_the_failure_of_one_realisation(self):
        self.study(STUDY.replace("realisations: 12", "realisations: 4"))
        printed = self.python("""
import os, sys
from geomesh.ensemble import pool, study, store
s = study.read_study(os.path.abspath("study.yaml"))
kept = store.Store(os.path.abspath("out"), s.digest)
# A worker in whose package realisation 2 ends the process, as running out of memory would.
with open("sitecustomize.py", "w") as out:
    out.write('''
import geomesh.ensemble.realise as realise, os, signal
before = realise.Realiser.result
def result(self, index):
    if index == 2: os.kill(os.getpid(), signal.SIGKILL)
    return before(self, index)
realise.Realiser.result = result
''')
sys.path.insert(0, os.getcwd())
told = []
pool.Pool(s, kept, 2, lambda index, status: told.append((index, status))).run([1, 2, 3, 4])
print(sorted(told), kept.get(2)["failure"], os.path.exists("out/failures/2/project.yaml"))
""")
        self.assertIn("[(1, 'done'), (2, 'failed'), (3, 'done'), (4, 'done')]", printed)
        self.assertIn("the process ended with signal SIGKILL", printed)
        self.assertTrue(printed.strip().endswith("True"))

    def test_a_time_limit_ends_a_realisation(self):
        study = self.study(STUDY.replace("mesh: {refine: none}", "mesh: {size: 20}\ntime_limit: 0.3").replace("realisations: 12", "realisations: 1"))
        said = self.run_program("ensemble", study, "-o", "out", status=4)
        self.assertIn("the time_limit of 0.3 s was over", said)


class Mistakes(EnsembleTest):
    def test_every_mistake_of_a_study_is_told_with_its_line_and_the_word_that_was_meant(self):
        study = self.study("""project: project.yaml
realisations: many
sed: 3
parameters:
  velocity: {normal: [0]}
surfaces:
  top_reservoire: {shift: 3}
  top_reservoir:
    shift: velocty
    perturbation: {sd: 10}
  base_reservoir:
    hold: {wells: [w9]}
throw: {some_fault: 3}
set: {surfaces.nothing.smooth: 3}
""")
        said = self.run_program("ensemble", study, status=USAGE)
        for expected in ("study.yaml:2:15: realisations: a whole number from 1 was expected", "study.yaml:3:1: sed: no such key; did you mean seed?",
                         "study.yaml:5:22: parameters.velocity.normal: a list of 2 numbers was expected",
                         "study.yaml:7:3: surfaces.top_reservoire: no such surface; did you mean top_reservoir?",
                         "surfaces.top_reservoir.shift: 'velocty' is no number and no parameter; did you mean velocity?",
                         "surfaces.top_reservoir.perturbation: `range` is missing", "no such well: w9",
                         "surfaces.base_reservoir: `hold` needs `range`", "throw.some_fault: no such fault; there is none",
                         "the project has no entry called nothing at surfaces"):
            self.assertIn(expected, said)
        self.assertFalse(os.path.exists(os.path.join(self.project, "ensemble")))

    def test_files_that_are_not_there_and_texts_that_are_no_yaml_get_a_plain_message(self):
        self.assertIn("no such file", self.run_program("ensemble", self.study("project: nothing.yaml\nrealisations: 2\n"), status=USAGE))
        self.assertIn("study.yaml:2:1: expected", self.run_program("ensemble", self.study("project: [\n"), status=USAGE))
        self.assertIn("the file is empty", self.run_program("ensemble", self.study(""), status=USAGE))
        self.assertIn("`realisations` is missing", self.run_program("ensemble", self.study("project: project.yaml\n"), status=USAGE))
        self.assertIn("no such file", self.run_program("ensemble", "nothing.yaml", status=USAGE))
        self.assertIn("--jbos", self.run_program("ensemble", self.study(), "--jbos", 2, status=USAGE))
        self.assertIn("counted from 1 to 12", self.run_program("ensemble", self.study(), "--only", "13", status=USAGE))


class Outputs(EnsembleTest):
    def test_grid_hdf5_and_missing_agree_with_the_table(self):
        study = self.study(STUDY.replace("realisations: 12", "realisations: 4"))
        self.assertEqual(self.run_program("ensemble", study, "-o", "out", "--missing", 3).split(), ["1,2,3", "4"])
        self.run_program("ensemble", study, "-o", "out", "--only", "2", "--quiet")
        self.assertEqual(self.run_program("ensemble", study, "-o", "out", "--missing", 3).split(), ["1,3,4"])
        self.run_program("ensemble", study, "-o", "out", "--quiet")
        printed = self.python("""
import csv, sys, numpy
try:
    import h5py
except ImportError:
    print("no h5py"); sys.exit()
rows = list(csv.DictReader(open(%r)))
with h5py.File(%r) as file:
    assert [float(r["volume:reservoir"]) for r in rows] == list(file["volume/reservoir"])
    assert [float(r["parameters.velocity"]) for r in rows] == list(file["drawn/parameters.velocity"])
    total = sum(file["probability/" + name][:] for name in file["probability"])
    assert total.shape == (12, 10, 8) and abs(total - 1).max() < 1e-6
    share = file["probability/reservoir"][:].mean() * 18e9 / numpy.mean(file["volume/reservoir"])
    print(share, len(file["time/cpu_s"]))
""" % (self.path("out", "table.csv"), self.path("out", "results.h5")))
        if "no h5py" not in printed:
            share, times = map(float, printed.split())
            self.assertTrue(0.8 < share < 1.2, share)
            self.assertEqual(times, 4)
        head = self.content("out", "probability.vti").split(b"<AppendedData")[0].decode() + "</VTKFile>"
        image = xml.fromstring(head).find("ImageData")
        self.assertEqual(image.get("WholeExtent"), "0 12 0 10 0 8")
        self.assertIn("probability:reservoir", [array.get("Name") for array in image.iter("DataArray")])

    def test_the_scripts_of_a_slurm_array_make_each_realisation_once(self):
        study = self.study()
        said = self.run_program("ensemble", study, "-o", "out", "--slurm", "--per-task", 5)
        self.assertIn("3 tasks", said)
        script = self.content("out", "slurm", "array.sbatch").decode()
        self.assertIn("#SBATCH --array=1-3", script)
        for task in (3, 1, 2):  # the shell's part of it, without Slurm
            done = subprocess.run(["bash", self.path("out", "slurm", "array.sbatch")], env={**os.environ, "SLURM_ARRAY_TASK_ID": str(task)},
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            self.assertEqual(done.returncode, 0, done.stdout)
        done = subprocess.run(["bash", self.path("out", "slurm", "collect.sbatch")], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.run_program("ensemble", study, "-o", "local", "--quiet")
        self.assertEqual(self.content("out", "table.csv"), self.content("local", "table.csv"))


if __name__ == "__main__":
    main()
