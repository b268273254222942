#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""SIGINT and SIGTERM at random moments of every stage: the run ends within two seconds with the status of the signal."""
import json
import os
import random
import signal
import subprocess
import time
import unittest

from geomesh_program import NIGHTLY, PROGRAM, SLOWNESS, ProgramTest, main

STATUS = {signal.SIGINT: 130, signal.SIGTERM: 143}
SECONDS = 2 * SLOWNESS
ROUNDS = 20 if NIGHTLY else 1  # of one signal to each stage, SIGINT and SIGTERM in turn


class Signals(ProgramTest):
    bare = False

    def stages_of(self, arguments):
        """Each stage with its seconds, from a whole run."""
        done = subprocess.run([PROGRAM, *arguments, "--json-progress"], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              text=True, check=True, timeout=self.timeout)
        events = [json.loads(line) for line in done.stderr.splitlines()]
        seconds = {}
        for event in events:
            if event["event"] == "stage" and not event["begins"]:
                seconds[event["stage"]] = max(event["seconds"], seconds.get(event["stage"], 0))
        return seconds

    def signal_in(self, arguments, stage, delay, number):
        """Seconds from a signal in the stage to the end, and the exit status; None where the run was over before."""
        run = subprocess.Popen([PROGRAM, *arguments, "--json-progress"], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                               text=True)
        with run.stderr:
            for line in run.stderr:
                event = json.loads(line)
                if event["event"] == "stage" and event["stage"] == stage and event["begins"]:
                    break
            time.sleep(delay)
            if run.poll() is not None:
                return None
            run.send_signal(number)
            sent = time.monotonic()
            run.stderr.read()
            run.wait(timeout=60 * SLOWNESS)
        return time.monotonic() - sent, run.returncode

    def interrupt_all_stages(self, least, *arguments):
        dice = random.Random(7)
        answered = 0
        for k, (stage, seconds) in enumerate(ROUNDS * list(self.stages_of(arguments).items())):
            number = list(STATUS)[k % 2]
            outcome = self.signal_in(arguments, stage, dice.uniform(0, seconds), number)
            if outcome is None or outcome[1] == 0:  # done before the signal came
                continue
            with self.subTest(stage=stage, signal=number):
                self.assertLess(outcome[0], SECONDS)
                self.assertEqual(outcome[1], STATUS[number])
            answered += 1
        self.assertGreater(answered, least)

    @unittest.skipUnless(NIGHTLY, "skipped: by night, as all of its stages are long")
    def test_a_project_of_a_settled_basin(self):
        self.interrupt_all_stages(3, self.copy_of_sample("basin", None), "-o", self.path("out"))

    def test_a_project_with_salt(self):
        self.interrupt_all_stages(3, self.copy_of_sample("salt-dome", "{size: 500}"), "-o", self.path("out"))

    def test_many_points(self):
        dice = random.Random(1)
        self.write("p.xyz", "".join("%r %r %r\n" % (dice.random(), dice.random(), dice.random()) for _ in range(100_000)))
        self.interrupt_all_stages(1, "delaunay", "p.xyz", "-o", "p.vtu", "--threads", "1")


if __name__ == "__main__":
    main()
