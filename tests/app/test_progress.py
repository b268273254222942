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


if __name__ == "__main__":
    unittest.main()
