#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The first command gives a mesh that a solver can use: every sample and template as shipped passes `check --project --solver`, has no poor
element that nothing forces, and CalculiX solves linear heat conduction and linear elasticity on it (skipped, saying so, where it is absent)."""
import math
import os
import re
import shutil
import subprocess

from geomesh_program import SOURCE, USAGE, ProgramTest, level, main, plane_ts

SAMPLES = sorted(name for name in os.listdir(os.path.join(SOURCE, "samples"))
                 if os.path.exists(os.path.join(SOURCE, "samples", name, "project.yaml")))
TEMPLATES = ["layers", "faulted", "salt-dome", "from-gocad", "topography-and-wells"]
# Settled stacks of units that thin out over kilometres, at `quality: fast`: thin elements are a solver's to bear, not all worth a search.
THIN_STACKS = ["basin", "blank-grids", "reservoir"]
LEAST_ANGLE_OF_FORCED = 3  # degrees: wedges and thin layers of the samples, cut off within the tolerance
LEAST_ANGLE_OF_THIN = 1    # degrees: what solvers bear
UNFORCED_OF_THIN = 1e-3    # share of the elements


class SolverReady(ProgramTest):
    bare = False

    def ask_for_inp(self, project):
        with open(project) as file:
            text = file.read()
        with open(project, "w") as file:
            file.write(re.sub(r"(?m)^output:.*$", "output: {directory: out, formats: [vtu, inp]}", text))

    def solve(self, stem):
        """Heat from the bottom to the top, and the model's own weight on a fixed bottom: both by the iterative solver."""
        if not shutil.which("ccx"):
            return
        groups = self.report(stem + ".inp.json")["groups"]
        nodes = {group["full_name"]: group["name"] for group in groups if group["type"] == "nset"}
        units = [group["name"] for group in groups if group["type"] == "elset"]
        top = next(name for name in ("zmax", "relief") if name in nodes)
        head = "*INCLUDE, INPUT=%s.inp\n*MATERIAL, NAME=rock\n*CONDUCTIVITY\n2.5\n*ELASTIC\n1e10, 0.25\n*DENSITY\n2500\n" % os.path.basename(stem)
        head += "".join("*SOLID SECTION, MATERIAL=rock, ELSET=%s\n" % unit for unit in units) + "*STEP\n"
        decks = {"heat": "*HEAT TRANSFER, STEADY STATE, SOLVER=ITERATIVE CHOLESKY\n*BOUNDARY\n%s, 11, 11, 100\n%s, 11, 11, 0\n" %
                         (nodes["zmin"], nodes[top]),
                 "elasticity": "*STATIC, SOLVER=ITERATIVE CHOLESKY\n*BOUNDARY\n%s, 1, 3, 0\n*DLOAD\n" % nodes["zmin"] +
                               "".join("%s, GRAV, 9.81, 0, 0, -1\n" % unit for unit in units)}
        quantities = {"heat": "NT", "elasticity": "U"}
        for name, deck in decks.items():
            folder = os.path.dirname(stem)
            with open(os.path.join(folder, name + ".inp"), "w") as file:
                file.write(head + deck + "*NODE FILE\n%s\n*END STEP\n" % quantities[name])
            done = subprocess.run(["ccx", name], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=250,
                                  env=dict(os.environ, OMP_NUM_THREADS="1"))
            self.assertEqual(done.returncode, 0, name + done.stdout[-2000:])
            self.assertIn("Job finished", done.stdout, name)
            for word in ("nonpositive jacobian", "too many cutbacks", "*ERROR"):
                self.assertNotIn(word, done.stdout, name)
            with open(os.path.join(folder, name + ".frd")) as file:
                self.assertNotIn("NaN", file.read(), name)

    def assert_ready(self, project):
        self.ask_for_inp(project)
        printed = self.run_program(project, "-o", self.path("out"))
        self.assertIn("fit for solvers", printed)
        mesh = next(self.path("out", name) for name in os.listdir(self.path("out")) if name.endswith(".vtu"))
        check = self.check(mesh, "--project", project, "--solver")
        self.assertTrue(check["solver"]["passes"])
        report = self.report(mesh[:-4] + ".report.json")
        quality = report["quality"]
        bad = quality["below_8_degrees"]
        is_thin = os.path.basename(mesh)[:-4].replace("_", "-") in THIN_STACKS
        self.assertLessEqual(bad["tetrahedra"] - bad["forced"], UNFORCED_OF_THIN * report["tetrahedra"] if is_thin else 0)
        self.assertGreater(quality["min_dihedral"], LEAST_ANGLE_OF_THIN if is_thin else LEAST_ANGLE_OF_FORCED)
        if "derived from the model" in printed:
            self.assertGreater(report["tetrahedra"], 40_000)
            self.assertLess(report["tetrahedra"], 300_000)
        over_asked = report["tetrahedra"] / report["refinement"]["estimated_tetrahedra"]
        self.assertGreater(over_asked, 0.7)
        self.assertLess(over_asked, 1.4)
        self.assertLessEqual(max(report["refinement"]["deviation_result_to_input"], report["refinement"]["deviation_input_to_result"]),
                             report["input"]["mesh"]["tolerance"])
        self.solve(mesh[:-4])


def of_sample(name):
    def test(self):
        self.assert_ready(self.copy_of_sample(name, None))
    return test


def of_template(name):
    def test(self):
        self.run_program("init", self.path("made"), "--template", name)
        self.assert_ready(self.path("made", "project.yaml"))
    return test


for sample in SAMPLES:
    setattr(SolverReady, "test_sample_%s" % sample.replace("-", "_"), of_sample(sample))
for template in TEMPLATES:
    setattr(SolverReady, "test_template_%s" % template.replace("-", "_"), of_template(template))


class Defaults(ProgramTest):
    bare = False
    layers = "box: {min: [0, 0, 0], max: [10, 10, 10]}\nsurfaces:\n  - {name: top, kind: horizon, file: top.ts}\ncolumn: [upper, top, lower]\n"

    def run_layers(self, mesh):
        self.write("top.ts", level("top", 5))
        printed = self.run_program(self.write("layers.yaml", self.layers + mesh), "-o", self.folder)
        return printed, self.report(self.path("layers.report.json"))

    def test_the_bare_triangulation_says_that_it_is_no_mesh_for_a_solver(self):
        printed, report = self.run_layers("mesh: {refine: none}\n")
        self.assertIn("no mesh for a solver", printed)
        self.assertLess(report["tetrahedra"], 100)

    def test_without_a_size_one_is_derived_and_told(self):
        printed, report = self.run_layers("")
        self.assertIn("elements to come: about 100,000 with edges of 0.48 m", printed)
        self.assertTrue(any("no size is requested" in note for note in report["notes"]), report["notes"])
        self.assertGreater(report["tetrahedra"], 60_000)
        self.assertLess(report["tetrahedra"], 140_000)
        self.assertEqual(report["input"]["mesh"]["honour"], "tolerance")
        self.assertAlmostEqual(report["input"]["mesh"]["tolerance"], 0.48 / 20)

    def test_bad_cells_that_the_last_proof_of_surfaces_makes_are_mended(self):
        """Where a surface is too far from the input the proof puts a vertex, here beside another: four cells below 8 degrees, one of them imposed by nothing."""
        project = self.copy_of_sample("exploration", None)
        with open(project) as file:
            text = file.read()
        self.assertIn("global: 2500,", text)
        with open(project, "w") as file:
            file.write(text.replace("global: 2500,", "global: 2525,"))
        self.run_program(project, "-o", self.path("out"), "-q")
        bad = self.report(self.path("out", "exploration.report.json"))["quality"]["below_8_degrees"]
        self.assertEqual(bad["tetrahedra"] - bad["forced"], 0)

    def test_a_surface_that_overshoots_another_by_a_little_ends_on_it(self):
        """Two faults, one of which passes the other by a thousandth of the size: no element is flat but where all is kept; the checker agrees."""
        self.write("a.ts", plane_ts("a", [(5, 1, 1), (5, 9, 1), (5, 9, 9), (5, 1, 9)]))
        self.write("b.ts", plane_ts("b", [(1, 5, 2), (5.0005, 5, 2), (5.0005, 5, 8), (1, 5, 8)]))
        text = "box: {min: [0, 0, 0], max: [10, 10, 10]}\nsurfaces:\n  - {name: a, kind: fault, file: a.ts}\n  - {name: b, kind: fault, file: b.ts}\n"
        fit_by_mesh = {"": True, "mesh: {size: 1, tolerance: 0.01}\n": True, "mesh: {size: 2, honour: exact}\n": False}
        for mesh, is_fit in fit_by_mesh.items():
            printed = self.run_program(self.write("faults.yaml", text + mesh), "-o", self.folder)
            report = self.report(self.path("faults.report.json"))
            self.assertEqual(report["solver"]["passes"], is_fit, printed)
            self.assertEqual(any("were merged at" in note for note in report["notes"]), is_fit)
            self.assertEqual(report["quality"]["min_dihedral"] > 20, is_fit, report["quality"])
            self.check(self.path("faults.vtu"), "--project", self.path("faults.yaml"))
        self.assertTrue(report["quality"]["min_dihedral"] < 1)

    def test_surfaces_count_where_the_size_is_derived(self):
        """Forty levels in a box: by the volume alone several times as many elements would come out."""
        text = "box: {min: [0, 0, 0], max: [10, 10, 10]}\nsurfaces:\n"
        for k in range(40):
            self.write("h%d.ts" % k, level("h%d" % k, 0.25 * k + 0.125))
            text += "  - {name: h%d, kind: horizon, file: h%d.ts}\n" % (k, k)
        printed = self.run_program(self.write("levels.yaml", text), "-o", self.folder)
        self.assertIn("derived from the model", printed)
        report = self.report(self.path("levels.report.json"))
        self.assertLess(report["tetrahedra"], 140_000)
        by_volume = (math.sqrt(72) * 1000 / 100_000) ** (1 / 3)  # the edge of a regular tetrahedron of that volume
        self.assertGreater(report["input"]["mesh"]["size"], 1.1 * by_volume)
        self.assertAlmostEqual(report["input"]["mesh"]["tolerance"], report["input"]["mesh"]["size"] / 20, delta=1e-9)
        self.check(self.path("levels.vtu"), "--project", self.path("levels.yaml"))

    def test_kept_surfaces_are_kept(self):
        _, report = self.run_layers("mesh: {size: 2, honour: exact}\n")
        self.assertEqual(report["input"]["mesh"]["honour"], "exact")
        self.assertLess(report["refinement"]["deviation_result_to_input"], 1e-12)

    def test_an_old_tolerance_is_a_length(self):
        _, report = self.run_layers("mesh: {size: 2, tolerance: 0.25}\n")
        self.assertEqual(report["input"]["mesh"]["tolerance"], 0.25)

    def test_check_for_solvers_finds_a_flat_element(self):
        """A tetrahedron whose height is 1e-12 of its edges, of another tool: valid, and unfit."""
        self.write("flat.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0.3 0.3 1e-12\n$EndNodes\n"
                               "$Elements\n1\n1 4 2 1 1 1 2 3 4\n$EndElements\n")
        self.run_program("check", "flat.msh")
        printed = self.run_program("check", "flat.msh", "--solver", status=3)
        self.assertIn("unfit_for_solvers", printed)
        self.run_program("check", "flat.msh", "--solvers", status=USAGE)

    def test_time_steps_are_seconds_where_velocities_are_given(self):
        _, report = self.run_layers("mesh: {size: 2}\n")
        steps = report["solver"]
        self.assertFalse(steps["has_velocities"])
        _, report = self.run_layers("mesh: {size: 2}\nattributes:\n  upper: {vp: 2000}\n  lower: {vp: 2000}\n")
        self.assertTrue(report["solver"]["has_velocities"])
        self.assertAlmostEqual(report["solver"]["time_step"] * 2000 / steps["time_step"], 1)
        self.assertGreaterEqual(report["solver"]["time_step_without_worst_ten"], report["solver"]["time_step"])


if __name__ == "__main__":
    main()
