#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The completions of bash, zsh and fish offer the commands and the options that the program has, with its words."""
import os
import re
import shutil
import subprocess
import sys
import unittest

from geomesh_program import PROGRAM, SOURCE, ProgramTest

COMMANDS = {"mesh", "delaunay", "check", "convert", "info", "init", "picture", "ensemble"}
# _arguments and _describe of zsh print what they are handed.
ZSH = """words=(geomesh %s); CURRENT=%d; _files() { : }; _describe() { print -rl -- $geomesh_commands }; _arguments() { print -rl -- "$@" }; . ./_geomesh"""
BASH = """COMP_WORDS=(geomesh %s); COMP_CWORD=%d; . ./geomesh.bash; _geomesh; printf '%%s\\n' "${COMPREPLY[@]}" """
FISH = """source ./geomesh.fish; complete -C "geomesh %s" """


class Completions(ProgramTest):
    def setUp(self):
        super().setUp()
        maker = os.path.join(SOURCE, "packaging", "make_shell_files.py")
        subprocess.run([sys.executable, maker, PROGRAM, "1.0", "2000-01-01", self.folder], check=True)

    def offered(self, shell, code):
        if not shutil.which(shell):
            self.skipTest(shell + " is not installed")
        done = subprocess.run([shell, *(["-f"] if shell == "zsh" else []), "-c", code], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.stderr, "")
        return done.stdout.splitlines()

    def options_of_check(self):
        return set(re.findall(r"(?m)^  (?:-\w,)?(--[a-z-]+)", self.run_program("check", "--help")))

    def test_bash(self):
        self.assertLessEqual(COMMANDS, set(self.offered("bash", BASH % ("''", 1))))
        self.assertEqual(set(self.offered("bash", BASH % ("check --", 2))), self.options_of_check())

    def test_zsh(self):
        commands = dict(line.split(":", 1) for line in self.offered("zsh", ZSH % ("", 2)))
        self.assertEqual(set(commands), COMMANDS)
        self.assertIn("any tool's", commands["check"])
        options = [line for line in self.offered("zsh", ZSH % ("check --", 3)) if line.startswith("--")]
        self.assertEqual({line.split("[")[0] for line in options}, self.options_of_check())
        self.assertTrue(all(line.endswith("]") for line in options), options)

    def test_fish(self):
        commands = dict(line.split("\t", 1) for line in self.offered("fish", FISH % "") if "\t" in line)
        self.assertEqual(set(commands), COMMANDS)
        self.assertIn("any tool's", commands["check"])
        self.assertEqual({line.split("\t")[0] for line in self.offered("fish", FISH % "check --")}, self.options_of_check())


if __name__ == "__main__":
    unittest.main()
