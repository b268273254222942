#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""One mesh on MPI ranks: its parts pass the check, come out the same twice, and are as good as the serial mesh."""
import glob
import hashlib
import json
import math
import os
import re
import shutil
import subprocess
import sys

from geomesh_program import BAD_INPUT, CANNOT_MESH, PROGRAM, SOURCE, USAGE, ProgramTest, has_module, main
from vtk_files import VtkFile

RANKS_PROGRAM = os.path.join(os.path.dirname(PROGRAM), "geomesh-mpi")
NAME = "faulted_layers"
FORMATS = "[vtu, exodus, msh]" if has_module("exodus") else "[vtu, msh]"


def least_dihedral_angle(corners):
    """The least angle in degrees between two faces of a tetrahedron."""
    normals = []
    for i in range(4):
        a, b, c = (corners[j] for j in range(4) if j != i)
        u, v = ([q - p for p, q in zip(a, other)] for other in (b, c))
        normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        outward = -1 if sum(n * (q - p) for n, p, q in zip(normal, a, corners[i])) > 0 else 1
        normals.append([outward * n / math.hypot(*normal) for n in normal])
    return 180 - math.degrees(math.acos(max(-1, min(sum(p * q for p, q in zip(normals[i], normals[j])) for i in range(4) for j in range(i)))))


def worst_angles(files):
    """The least dihedral angles of the elements of all files, the smallest first."""
    angles = []
    for file in files:
        mesh = VtkFile.read(file)
        p, cells = mesh["Points", "Points"].values, mesh["Cells", "connectivity"].values
        ghosts = [array.values for array in mesh.arrays if array.name == "vtkGhostType" and array.section == "CellData"]
        for k in range(len(cells) // 4):
            if not ghosts or ghosts[0][k] == 0:
                angles.append(least_dihedral_angle([p[3 * v:3 * v + 3] for v in cells[4 * k:4 * k + 4]]))
    return sorted(angles)


class RanksTest(ProgramTest):
    bare = False
    timeout = 600

    def setUp(self):
        super().setUp()
        if not os.path.exists(RANKS_PROGRAM):
            self.skipTest("skipped: geomesh-mpi was not built: no MPI or no METIS")
        if not shutil.which("mpirun"):
            self.skipTest("skipped: mpirun is not installed")

    def mpirun(self, ranks, *words, status=0, **environment):
        # Open MPI loses memory, in modules that are unloaded when LeakSanitizer looks.
        environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", ASAN_OPTIONS="detect_leaks=0", **environment)
        done = subprocess.run(["mpirun", "--oversubscribe", "-n", str(ranks), *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              timeout=self.timeout, cwd=self.folder, env=environment)
        self.assertEqual(done.returncode, status, done.stdout)
        return done.stdout

    def project(self, size, formats=FORMATS, more=""):
        folder = self.path("model")
        if not os.path.exists(folder):
            shutil.copytree(os.path.join(SOURCE, "samples", "faulted-layers"), folder, ignore=shutil.ignore_patterns("out"))
        with open(os.path.join(folder, "project.yaml")) as file:
            text = file.read()
        path = os.path.join(folder, "small.yaml")
        with open(path, "w") as file:
            file.write(re.sub(r"(?m)^output:.*$", "mesh: {size: %g%s}\noutput: {directory: out, formats: %s}" % (size, more, formats), text))
        return path

    def mesh(self, ranks, project, out):
        self.mpirun(ranks, RANKS_PROGRAM, project, "-o", self.path(out), "-q")
        self.check_schema(self.path(out, NAME + ".report.json"))
        return self.report(self.path(out, NAME + ".report.json"))

    def check_schema(self, report):
        """By docs/ranks-report.schema.json, where python3-jsonschema is installed."""
        no_jsonschema = 77
        done = subprocess.run([sys.executable, os.path.join(SOURCE, "tests", "geomodel", "read_back.py"), "schema",
                               os.path.join(SOURCE, "docs", "ranks-report.schema.json"), report], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertIn(done.returncode, (0, no_jsonschema), done.stdout)

    def digests(self, out):
        """Of all files but the report, which has times."""
        found = {}
        for path in glob.glob(self.path(out, "*")):
            if not path.endswith((".report.json", ".check.json")):
                with open(path, "rb") as file:
                    found[os.path.basename(path)] = hashlib.sha256(file.read()).hexdigest()
        return found


class OneMesh(RanksTest):
    def test_parts_of_every_format_pass_the_check_and_come_out_the_same_twice(self):
        project = self.project(250)
        for ranks in (1, 2, 4):
            with self.subTest(ranks=ranks):
                report = self.mesh(ranks, project, "a%d" % ranks)
                self.assertEqual(len(report["by_rank"]), ranks)
                self.assertEqual(sum(r["tetrahedra"] for r in report["by_rank"]), report["tetrahedra"])
                self.assertEqual(sum(r["tetrahedra"] for r in report["regions"]), report["tetrahedra"])
                self.assertEqual(report["faces_between_ranks"] > 0, ranks > 1)
                self.assertAlmostEqual(sum(r["volume"] for r in report["regions"]) / 9e10, 1, delta=1e-12)
                for name in (".pvtu", "_1.msh", *((".e.%d.0" % ranks,) if has_module("exodus") else ())):
                    found = self.check(self.path("a%d" % ranks, NAME + name), *(("--project", project) if name == ".pvtu" else ()))
                    self.assertEqual(sum(r["tetrahedra"] for r in found["regions"]), report["tetrahedra"], name)
                self.mesh(ranks, project, "b%d" % ranks)
                first = self.digests("a%d" % ranks)
                self.assertGreaterEqual(len(first), len(FORMATS.split(",")) * ranks)
                self.assertEqual(first, self.digests("b%d" % ranks))
        self.see_wrong_shapes_in_the_report(project, "a2")
        for ranks in (2, 4):
            self.assertEqual(self.digests("a%d" % ranks)[NAME + ".faces.vtp"], self.digests("a1")[NAME + ".faces.vtp"], "surfaces do not depend on the ranks")

    def see_wrong_shapes_in_the_report(self, project, out):
        path = self.path(out, NAME + ".report.json")
        report = self.report(path)
        report["quality"]["mean_ratio"] *= 1.0001
        with open(path, "w") as file:
            json.dump(report, file)
        self.assertIn("report_differs", self.run_program("check", self.path(out, NAME + ".pvtu"), "--project", project, status=BAD_INPUT))

    def test_sizes_by_depth_and_from_a_file_are_those_of_the_serial_mesh(self):
        with open(self.path("sizes.txt"), "w") as file:
            file.write("".join("%d %d %d %d\n" % (x, y, z, 150 if x < 3000 else 400) for x in (0, 2500, 3500, 6000) for y in (0, 5000) for z in (-3000, 0)))
        for name, size in (("depth", "by_depth: [[0, 180], [3000, 400]]"), ("file", "background: %s" % self.path("sizes.txt"))):
            with self.subTest(sizes=name):
                project = self.project(500, "[vtu]")
                with open(project) as file:
                    text = file.read()
                with open(project, "w") as file:
                    file.write(text.replace("size: 500", "size: {global: 500, %s}" % size))
                self.run_program(project, "-o", self.path("serial"))
                serial, report = self.report(self.path("serial", NAME + ".report.json")), self.mesh(3, project, "ranks")
                self.assertAlmostEqual(report["tetrahedra"] / serial["tetrahedra"], 1, delta=0.05)
                self.check(self.path("ranks", NAME + ".pvtu"), "--project", project)

    def test_the_verdict_for_solvers_is_that_of_the_check(self):
        report = self.mesh(3, self.project(300, "[vtu]"), "out")
        self.run_program("check", self.path("out", NAME + ".pvtu"), "--solver", "--report", self.path("check.json"))
        found, verdict = self.report(self.path("check.json"))["solver"], report["solver"]
        self.assertTrue(verdict["passes"])
        for count in ("not_positive", "fail_implicit", "fail_iterative", "fail_two_point_flux"):
            self.assertEqual(verdict[count], found[count], count)
            self.assertEqual(sum(r[count] for r in report["by_rank"]), found[count], count)
        for measure in ("least_volume", "least_volume_16_digits", "least_edge", "least_edge_over_diagonal", "min_dihedral", "max_dihedral", "time_step"):
            self.assertAlmostEqual(verdict[measure] / found[measure], 1, delta=1e-12, msg=measure)
        self.assertEqual(verdict["sharpest"]["place"], found["sharpest"]["place"])

    def test_the_worst_elements_are_no_worse_than_those_of_the_serial_mesh(self):
        sample = os.path.join(SOURCE, "samples", "exploration")  # where surfaces force poor elements that the serial run mends by moving them
        shutil.copytree(sample, self.path("worst"), ignore=shutil.ignore_patterns("out"))
        project = self.path("worst", "project.yaml")
        with open(project) as file:
            text = file.read()
        with open(project, "w") as file:
            file.write(re.sub(r"formats: *\[[^]]*\]", "formats: [vtu]", text))
        self.run_program(project, "-o", self.path("serial"))
        self.mpirun(2, RANKS_PROGRAM, project, "-o", self.path("out"), "-q")
        serial, ranks = (worst_angles(glob.glob(self.path(folder, "*.vtu"))) for folder in ("serial", "out"))
        # Single elements that the input forces differ by chance, in either direction.
        self.assertGreater(sum(ranks[:10]), 0.98 * sum(serial[:10]))
        self.assertGreater(sum(ranks[:100]), 0.98 * sum(serial[:100]))

    def compare(self, size, ranks):
        project = self.project(size, "[vtu]")
        self.run_program(project, "-o", self.path("serial"))
        serial = self.report(self.path("serial", NAME + ".report.json"))
        report = self.mesh(ranks, project, "ranks")
        self.assertAlmostEqual(report["tetrahedra"] / serial["tetrahedra"], 1, delta=0.05)
        shapes, quality = serial["quality"]["whole"], report["quality"]
        self.assertGreater(quality["min_dihedral"]["mean"], 0.98 * shapes["min_dihedral"]["mean"])
        self.assertGreater(quality["radius_ratio"]["mean"], 0.98 * shapes["radius_ratio"]["mean"])
        self.assertGreater(quality["mean_ratio"], 0.98 * shapes["mean_ratio"]["mean"])
        self.assertGreater(quality["min_dihedral"]["min"], 15)
        area = {s["name"]: s["area"] for s in serial["surfaces"]}
        for surface in report["surfaces"]:
            if area[surface["name"]] > 0:
                self.assertAlmostEqual(surface["area"] / area[surface["name"]], 1, delta=2e-3, msg=surface["name"])
        volume = {r["name"]: r["volume"] for r in serial["regions"]}
        self.assertEqual(sorted(volume), sorted(r["name"] for r in report["regions"]))
        for region in report["regions"]:
            self.assertAlmostEqual(region["volume"] / volume[region["name"]], 1, delta=2e-3, msg=region["name"])
        return report

    def test_shapes_are_those_of_the_serial_mesh_within_two_per_cent(self):
        self.assertLess(self.compare(160, 4)["tetrahedra"], 5e5)

    def test_a_large_mesh_whose_edges_are_halved_is_as_good(self):
        report = self.compare(98, 2)
        self.assertGreater(report["tetrahedra"], 1e6)
        self.assertLess(report["sparse_tetrahedra"], 1e5)
        self.check(self.path("ranks", NAME + ".pvtu"))

    def test_a_project_with_a_page_is_meshed_without_it_and_is_told_so(self):
        report = self.mesh(2, self.project(400, "[vtu, html]"), "out")
        self.assertIn("the format html is left out", " ".join(report["warnings"]))
        self.assertFalse(os.path.exists(self.path("out", NAME + ".html")))
        self.assertIn("html", self.mpirun(2, RANKS_PROGRAM, self.project(400, "[html]"), "-o", self.path("page"), "-q", status=USAGE))

    def test_dolfinx_reads_the_parts_and_solves_to_the_serial_answer(self):
        if subprocess.run([sys.executable, "-c", "import dolfinx, mpi4py, vtk"], stderr=subprocess.DEVNULL).returncode:
            self.skipTest("skipped: python3-dolfinx, python3-mpi4py or python3-vtk9 is not installed")
        report = self.mesh(4, self.project(300, "[vtu]"), "out")
        answers = []
        for processes in (1, 2, 4):
            output = self.mpirun(processes, sys.executable, os.path.join(SOURCE, "tests", "app", "poisson_on_ranks.py"), self.path("out", NAME), 4)
            integral, volume, cells = re.search(r"INTEGRAL (\S+) VOLUME (\S+) CELLS (\d+)", output).groups()
            self.assertEqual(int(cells), report["tetrahedra"])
            self.assertAlmostEqual(float(volume) / 9e10, 1, delta=1e-9)
            answers.append(float(integral))
        self.assertGreater(answers[0], 0)
        for answer in answers[1:]:
            self.assertAlmostEqual(answer / answers[0], 1, delta=1e-8)
        self.run_program(self.project(300, "[vtu], partitions: 4"), "-o", self.path("serial"))
        output = self.mpirun(2, sys.executable, os.path.join(SOURCE, "tests", "app", "poisson_on_ranks.py"), self.path("serial", NAME), 4)
        self.assertAlmostEqual(float(re.search(r"INTEGRAL (\S+)", output).group(1)) / answers[0], 1, delta=0.01, msg="another mesh of the same sizes")


class Refused(RanksTest):
    def files(self):
        return [name for _, _, names in os.walk(self.path("out")) for name in names]

    def test_a_rank_that_fails_ends_all_with_its_message_and_no_file(self):
        for rank in (0, 2):
            output = self.mpirun(3, RANKS_PROGRAM, self.project(400), "-o", self.path("out"), "-q", status=CANNOT_MESH, GEOMESH_MPI_FAIL_ON_RANK=str(rank))
            self.assertIn("error on rank %d: this rank fails" % rank, output)
            self.assertEqual(os.listdir(self.path("out")), [])
        self.mesh(3, self.project(400), "out")
        self.assertIn(NAME + ".pvtu", self.files())
        self.assertFalse(os.path.exists(self.path("out", "." + NAME + ".unfinished")))

    def test_what_is_not_there_on_ranks_is_refused_by_name(self):
        for formats, more, word in (("[med]", "", "med"), ("[vtu]", ", target_elements: 10000", "target_elements"), ("[vtu]", ", time_budget: 5", "time_budget"),
                                    ("[vtu]", ", mode: conforming", "conforming")):
            output = self.mpirun(2, RANKS_PROGRAM, self.project(400, formats, more), "-o", self.path("out"), "-q", status=USAGE)
            self.assertIn(word, output)
            self.assertIn("in one process", output)
        self.assertIn("not there", self.mpirun(2, RANKS_PROGRAM, self.project(400, "[vtu], partitions: 3"), "-o", self.path("out"), status=USAGE))
        self.assertIn("no such file", self.mpirun(2, RANKS_PROGRAM, "nowhere.yaml", status=USAGE))
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    main()
