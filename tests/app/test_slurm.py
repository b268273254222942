#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""geomesh ensemble --slurm: its scripts on a real slurmctld and slurmd of one node give the table of a local run."""
import os
import subprocess
import unittest

import slurm_daemons
from geomesh_program import ProgramTest, main
from test_ensemble import STUDY, can_run

N_REALISATIONS, PER_TASK, N_TASKS = 12, 5, 3


class SlurmArray(ProgramTest):
    bare = False

    def setUp(self):
        super().setUp()
        missing = slurm_daemons.why_not() or can_run()
        if missing:
            self.skipTest("skipped: " + missing)
        self.study = os.path.join(os.path.dirname(self.copy_of_sample("wells", None)), "study.yaml")
        with open(self.study, "w") as out:
            out.write(STUDY)

    def content(self, *parts):
        with open(self.path(*parts), "rb") as file:
            return file.read()

    def submit(self, slurm):
        done = subprocess.run(["sh", self.path("out", "slurm", "submit.sh"), "-p", "all"], env=slurm.environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def logs(self):
        names = sorted(name for name in os.listdir(self.path("out", "slurm")) if name.endswith(".log"))
        return "\n".join(self.content("out", "slurm", name).decode(errors="replace") for name in names)

    def test_an_array_on_real_daemons_gives_the_table_of_a_local_run(self):
        said = self.run_program("ensemble", self.study, "-o", "out", "--slurm", "--per-task", PER_TASK)
        self.assertIn("%d tasks" % N_TASKS, said)
        with slurm_daemons.Slurm() as slurm:
            self.submit(slurm)
            slurm.wait_for_jobs(200)
        self.assertTrue(os.path.exists(self.path("out", "table.csv")), self.logs())
        self.run_program("ensemble", self.study, "-o", "local", "--quiet")
        self.assertEqual(self.content("out", "table.csv"), self.content("local", "table.csv"))
        self.assertEqual(self.content("out", "table.csv").count(b"\n"), N_REALISATIONS + 1)

    def test_tasks_that_were_cancelled_are_made_by_submitting_again(self):
        self.run_program("ensemble", self.study, "-o", "out", "--slurm", "--per-task", PER_TASK)
        with slurm_daemons.Slurm(cpus=1) as slurm:  # one after the other
            self.submit(slurm)
            array = min(int(line) for line in slurm.ask("squeue", "-h", "-o", "%A").split())
            slurm.ask("scancel", *("%d_%d" % (array, task) for task in range(2, N_TASKS + 1)))
            slurm.wait_for_jobs(200)
            self.assertLess(self.content("out", "table.csv").count(b"\n"), N_REALISATIONS + 1)
            self.submit(slurm)
            slurm.wait_for_jobs(200)
        self.run_program("ensemble", self.study, "-o", "local", "--quiet")
        self.assertEqual(self.content("out", "table.csv"), self.content("local", "table.csv"))


if __name__ == "__main__":
    main()
