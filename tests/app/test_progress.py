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
            text = file.read().replace("formats: [vtu]", "formats: [vtu, msh, inp, tetgen]")
        with open(project, "w") as file:
            file.write(text)
        events, _ = self.events(project, "-o", self.path("out"), "--threads", "1")
        for stage in ("verify", "write"):
            counts = [(e["done"], e["total"]) for e in events if e["event"] == "progress" and e["stage"] == stage]
            self.assertEqual(counts, sorted(counts), stage)
            self.assertTrue(all(done <= total and total > 0 for done, total in counts), counts)

    def on_a_terminal(self, *arguments, status=0, **environment):
        """All that a run prints where both streams are a terminal."""
        leader, follower = pty.openpty()
        variables = {key: value for key, value in os.environ.items() if key != "NO_COLOR"}
        child = subprocess.Popen([PROGRAM, *arguments], stdout=follower, stderr=follower, cwd=self.folder,
                                 env={**variables, "TERM": "xterm", **environment})
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
        self.assertEqual(child.wait(), status, said)
        return said.decode()

    def test_on_a_terminal_the_running_stage_is_redrawn_and_the_finished_one_stays(self):
        text = self.on_a_terminal(self.sample("layer-cake"), "-o", self.path("out"))
        self.assertRegex(text, r"read       \.\.\.\r\x1b\[K")
        for stage in ("read", "intersect", "mesh", "verify", "write"):
            self.assertTrue(re.search(r"%s +[0-9.]+ (s|min)" % stage, text), stage)

    def test_the_line_of_a_step_begins_with_its_name(self):
        """It began as "delaunay" and ended as "mesh"."""
        self.assertNotIn("delaunay", self.on_a_terminal(self.sample("outcrops"), "-o", self.path("out")))

    def test_a_stage_tells_how_many_notes_it_has(self):
        """The last of them stood there by chance."""
        folder = self.path("m")
        self.run_program("init", folder, "--template", "faulted")
        _, said = self.run_apart(os.path.join(folder, "project.yaml"), "-o", self.path("out"))
        build = next(line for line in said if line.startswith("build"))
        self.assertRegex(build, r"^build +[0-9.]+ s   \d+ notes about surfaces \(--verbose prints them\)$")

    def project_with_warnings(self, mesh):
        """Four points that lie outside of the model: a warning each."""
        project = self.copy_of_sample("faulted-layers", mesh)
        with open(project, "a") as file:
            file.write("points: [%s]\n" % ", ".join("{name: p%d, at: [9000, 2000, %d]}" % (i, -100 * i) for i in range(4)))
        return project

    def test_colours_on_a_terminal_alone_and_not_where_nobody_wants_them(self):
        """Errors red, warnings yellow, a good verdict green."""
        project = self.project_with_warnings("{size: 600}")
        text = self.on_a_terminal(project, "-o", self.path("out"))
        self.assertRegex(text, "\x1b\\[33;1mwarning:\x1b\\[0m ")
        self.assertRegex(text, "\x1b\\[32;1m[^\n]*fit for solvers")
        self.assertRegex(text, "\x1b\\[33;1m[^\n]*; 4 warnings about the model")
        self.assertRegex(self.on_a_terminal(self.copy_of_sample("faulted-layers", "{size: 600}"), "-o", self.path("out")),
                         "\x1b\\[32;1m[^\n]*; no warnings about the model")
        self.assertRegex(self.on_a_terminal("no-such.yaml", status=2), "\x1b\\[31;1merror:\x1b\\[0m no such")
        for environment in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
            self.assertNotIn("\x1b[3", self.on_a_terminal("no-such.yaml", status=2, **environment))
        self.assertNotIn("\x1b", "".join(sum(self.run_apart(project, "-o", self.path("out")), [])))

    def test_the_stages_of_the_engine_are_one_line_unless_all_is_asked_for(self):
        project = self.copy_of_sample("outcrops", "{size: 400}")
        _, said = self.run_apart(project, "-o", self.path("out"))
        names = [line.split()[0] for line in said if re.match(r"[a-z]+ +[0-9.]+ (s|min)", line)]
        self.assertEqual(names, ["read", "build", "intersect", "mesh", "estimate", "refine", "improve", "verify", "write"])
        _, said = self.run_apart(project, "-o", self.path("out"), "-v")
        for stage in ("delaunay", "recover", "classify"):
            self.assertTrue(any(line.startswith(stage) for line in said), stage)
        self.assertEqual(self.run_apart(project, "-o", self.path("out"), "-q")[0], [])

    def test_the_last_line_tells_how_to_look_at_what_was_made(self):
        """An address that a browser opens, with blanks as it wants them, and a command that can be pasted."""
        folder = self.path("my out")
        project = self.copy_of_sample("layer-cake", "{size: 600}")
        with open(project) as file:
            text = file.read()
        with open(project, "w") as file:
            file.write(re.sub(r"formats: \[[^]]*\]", "formats: [vtu, html]", text))
        printed, _ = self.run_apart(project, "-o", folder)
        self.assertIn("open file://" + folder.replace(" ", "%20") + "/layer_cake.html", printed[-1])
        self.assertIn("geomesh picture '%s/layer_cake.vtu' -o '%s/layer_cake.png'" % (folder, folder), printed[-1])

    def test_help_is_plain(self):
        for words in (["mesh", "--help"], ["convert", "--help"], ["--help-project"], ["init", "--help"]):
            text = self.run_program(*words)
            for jargon in ("ENUM", "UINT", "TEXT", "->", "{"):
                self.assertNotIn(jargon, text, words)
        self.assertIn("layers, faulted, salt-dome, from-gocad, topography-and-wells", self.run_program("init", "--help"))
        self.assertIn("Usage: geomesh [OPTIONS] PROJECT.yaml", self.run_program("--help-project"))
        self.assertEqual(self.run_program("-V"), self.run_program("--version"))

    def run_apart(self, *arguments):
        """Standard output and standard error of a run that ends well."""
        done = subprocess.run([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=self.timeout, check=True)
        return done.stdout.splitlines(), done.stderr.splitlines()

    def test_a_run_ends_with_twelve_lines_however_many_units_and_parts_there_are(self):
        for sample, units in (("faulted-layers", ["cover", "sand", "shale", "basement"]), ("layer-cake", [])):
            printed, said = self.run_apart(self.copy_of_sample(sample, None), "-o", self.path(sample))
            self.assertLessEqual(len(printed), 12, sample)
            for unit in units:
                self.assertTrue(any(re.match(r"  %s +[0-9,]+ tetrahedra +[0-9.]+ km3   in 3 parts: %s__1 to %s__3$" % (unit, unit, unit), line)
                                    for line in printed), unit)
            self.assertNotIn("#", "".join(said), sample)
        self.assertTrue(any("and 35 smaller units" in line for line in printed), printed)

    def test_what_is_left_out_of_these_lines_is_printed_when_asked_for(self):
        project = self.project_with_warnings(None)
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
