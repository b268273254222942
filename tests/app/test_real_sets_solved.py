# SPDX-License-Identifier: GPL-3.0-or-later
"""CalculiX solves heat conduction and elasticity on what the default makes of the real sets (scripts/solver-ready). One set is solved in every
run of the tests, all by night."""
import importlib.machinery
import importlib.util
import os
import pathlib
import shutil
import unittest

from geomesh_program import NIGHTLY, SOURCE, ProgramTest, main
from test_solver_ready import SolverReady

NAMES = ("SALT", "MJVA", "SNFA", "Claudius", "modelA4", "map") if NIGHTLY else ("SALT",)


def solver_ready_script():
    loader = importlib.machinery.SourceFileLoader("solver_ready", os.path.join(SOURCE, "scripts", "solver-ready"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("solver_ready", loader))
    loader.exec_module(module)
    return module


@unittest.skipUnless(shutil.which("ccx"), "skipped: calculix-ccx is not installed")
class RealSetsSolved(ProgramTest):
    timeout = 600
    solve = SolverReady.solve

    def test_calculix_solves_what_the_default_makes(self):
        self.shared("faults")
        solved = []
        for name, project in solver_ready_script().written_projects(pathlib.Path(self.folder)):
            if name.split(" ", 1)[1] not in NAMES:
                continue
            with self.subTest(set=name):
                with open(project, "a") as file:
                    file.write("output: {directory: %s, formats: [vtu, inp]}\n" % project.stem)
                self.run_program(project)
                self.solve(self.path(project.stem, project.stem))
                solved.append(name)
        self.assertEqual(len(solved), len(NAMES))


del SolverReady  # its own tests run elsewhere

if __name__ == "__main__":
    main()
