#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run says while it works."""
import json
import os
import pty
import re
import subprocess
import unittest

from geomesh_program import PROGRAM, ProgramTest


class Progress(ProgramTest):
    def events(self, *arguments):
        done = subprocess.run([PROGRAM, *arguments, "--json-progress"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              timeout=self.timeout, cwd=self.folder, check=True)
        return [json.loads(line) for line in done.stderr.splitlines()], done.stdout

    def test_json_progress_is_one_object_a_line_with_every_stage_begun_and_ended_in_order(self):
        events, printed = self.events(self.sample("salt-dome"), "-o", self.path("out"))
        stages = [(e["stage"], e["begins"]) for e in events if e["event"] == "stage"]
        self.assertEqual(stages[0], ("read", True))
        self.assertEqual(stages[-1], ("write", False))
        self.assertEqual(stages[::2], [(name, True) for name, _ in stages[1::2]])
        self.assertTrue(any(e["event"] == "log" for e in events))
        self.assertIn("tetrahedra", printed, "results stay on the standard output")

    def test_refinement_counts_elements_against_its_estimate(self):
        events, _ = self.events("mesh", os.path.join(os.path.dirname(self.sample("salt-dome")), "surfaces", "salt.ts"), "-o", "salt.vtu",
                                "--size", "70", "--quality", "fast")
        counts = [e for e in events if e["event"] == "progress" and e["stage"] == "refine" and e["done"] > 0]
        self.assertTrue(counts, "a stage of some seconds tells how far it is")
        for event in counts:
            self.assertGreaterEqual(event["total"], event["done"])

    def test_writing_tells_how_many_of_its_formats_are_done(self):
        project = self.copy_of_sample("faulted-layers", "{size: 200}")
        with open(project) as file:
            text = file.read().replace("formats: [vtu]", "formats: [vtu, msh, inp, exodus]")
        with open(project, "w") as file:
            file.write(text)
        events, _ = self.events(project, "-o", self.path("out"), "--threads", "1")
        for stage in ("verify", "write"):
            counts = [(e["done"], e["total"]) for e in events if e["event"] == "progress" and e["stage"] == stage]
            self.assertEqual(counts, sorted(counts), stage)
            self.assertTrue(all(done <= total and total > 0 for done, total in counts), counts)

    def test_on_a_terminal_the_running_stage_is_redrawn_and_the_finished_one_stays(self):
        leader, follower = pty.openpty()
        child = subprocess.Popen([PROGRAM, self.sample("layer-cake"), "-o", self.path("out")], stdout=subprocess.DEVNULL, stderr=follower)
        os.close(follower)
        said = b""
        while True:
            try:
                piece = os.read(leader, 65536)
            except OSError:
                break
            if not piece:
                break
            said += piece
        os.close(leader)
        self.assertEqual(child.wait(), 0)
        text = said.decode()
        self.assertRegex(text, r"read       \.\.\.\r\x1b\[K")
        for stage in ("read", "intersect", "delaunay", "verify", "write"):
            self.assertTrue(re.search(r"%s +[0-9.]+ (s|min)" % stage, text), stage)

    def run_apart(self, *arguments):
        """Standard output and standard error of a run that ends well."""
        done = subprocess.run([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=self.timeout, check=True)
        return done.stdout.splitlines(), done.stderr.splitlines()

    def test_a_run_ends_with_eleven_lines_however_many_units_and_parts_there_are(self):
        for sample, units in (("faulted-layers", ["cover", "sand", "shale", "basement"]), ("layer-cake", [])):
            printed, said = self.run_apart(self.copy_of_sample(sample, None), "-o", self.path(sample))
            self.assertLessEqual(len(printed), 11, sample)
            for unit in units:
                self.assertTrue(any(re.match(r"  %s +[0-9,]+ tetrahedra +[0-9.]+ km3   in 3 parts: %s__1 to %s__3$" % (unit, unit, unit), line)
                                    for line in printed), unit)
            self.assertNotIn("#", "".join(said), sample)
        self.assertTrue(any("and 35 smaller units" in line for line in printed), printed)

    def test_what_is_left_out_of_ten_lines_is_printed_when_asked_for(self):
        project = self.copy_of_sample("faulted-layers", None)
        short, warned = self.run_apart(project, "-o", self.path("out"))
        long, warned_all = self.run_apart(project, "-o", self.path("out"), "--verbose")
        for region in self.report(self.path("out", "faulted_layers.report.json"))["regions"]:
            self.assertTrue(any(" %s " % region["name"] in line for line in long), region["name"])
        self.assertTrue(any("time step" in line for line in long))
        self.assertFalse(any("time step" in line for line in short))
        self.assertEqual(sum(line.startswith("warning: ") for line in warned), 1, warned)
        self.assertEqual(sum(line.startswith("warning: ") for line in warned_all), 4, warned_all)
        self.assertTrue(any(line.startswith("  and 3 more like ") for line in warned), warned)
        self.assertEqual([line for line in warned if line.endswith(" warnings:")], ["4 warnings:"])


if __name__ == "__main__":
    unittest.main()
