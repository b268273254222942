# SPDX-License-Identifier: GPL-3.0-or-later
"""How a run behaves: threads, stopping early, interrupts, what is left behind, check as a checker of other meshes."""
import filecmp
import os
import signal
import subprocess
import time

from geomesh_program import BAD_INPUT, INTERRUPTED, PROGRAM, SLOWNESS, USAGE, ProgramTest, box_surface, main, triangles_ts


class Runs(ProgramTest):
    def test_threads_give_identical_files(self):
        for threads in (1, 2, 4):
            self.run_program(self.sample("salt-dome"), "-o", self.path(str(threads)), "--threads", threads, "--quiet")
        for ending in (".vtu", ".faces.vtp", ".curves.vtp"):
            name = "salt_dome" + ending
            for threads in ("2", "4"):
                self.assertTrue(filecmp.cmp(self.path("1", name), self.path(threads, name), shallow=False), f"{name}, {threads} threads")

    def test_stop_after(self):
        stages = ["read", "build", "intersect", "delaunay", "recover", "classify"]
        for stage in ("read", "intersect", "delaunay"):
            folder = self.path(stage)
            self.run_program(self.sample("faulted-layers"), "-o", folder, "--stop-after", stage)
            names = [entry["name"] for entry in self.report(os.path.join(folder, "faulted_layers.report.json"))["stages"]]
            self.assertEqual(names[-1], stage)
            self.assertEqual(names, [name for name in stages if name in names])
            self.assertFalse(os.path.exists(os.path.join(folder, "faulted_layers.vtu")))
        self.assertEqual(sorted(os.listdir(self.path("intersect"))), ["faulted_layers.report.json", "faulted_layers.soup.curves.vtp",
                                                                      "faulted_layers.soup.vtp", "faulted_layers.spots.vtp"])

    def test_the_soup_tells_where_everything_comes_from(self):
        try:
            import vtk
        except ImportError:
            self.skipTest("python3-vtk9 is not installed")

        def load(ending):
            reader = vtk.vtkXMLPolyDataReader()
            reader.SetFileName(self.path("out", "salt_dome.soup" + ending))
            reader.Update()
            return reader.GetOutput()

        def field(data, name):
            array = data.GetFieldData().GetAbstractArray(name)
            return [array.GetValue(i) for i in range(array.GetNumberOfValues())]

        self.run_program(self.sample("salt-dome"), "-o", self.path("out"), "--stop-after", "intersect")
        soup, curves = load(".vtp"), load(".curves.vtp")
        offsets, surfaces = field(soup, "origin_offsets"), field(soup, "origin_surfaces")
        self.assertEqual(len(offsets), soup.GetNumberOfCells() + 1)
        self.assertEqual((offsets[0], offsets[-1]), (0, len(surfaces)))
        self.assertEqual(len(field(soup, "origin_triangles")), len(surfaces))
        def named(data, prefix):
            """Of field arrays PREFIX:NAME: what is in them by name. Arrays of strings stop a much used Python reader."""
            fields = data.GetFieldData()
            names = [fields.GetArrayName(i) for i in range(fields.GetNumberOfArrays())]
            return {name[len(prefix) + 1:]: field(data, name) for name in names if name.startswith(prefix + ":")}

        cell_curve = curves.GetCellData().GetArray("curve")
        found_curves = {c[0]: (name.split(" ", 1)) for name, c in named(curves, "curve").items()}
        names, kinds = [found_curves[c][1] for c in sorted(found_curves)], [found_curves[c][0] for c in sorted(found_curves)]
        surface_names = {s[0]: name for name, s in named(soup, "surface").items()}
        at_edge = {}  # curve names by the coordinates of an edge's ends
        for c in range(curves.GetNumberOfCells()):
            points = curves.GetCell(c).GetPoints()
            at_edge.setdefault(frozenset(points.GetPoint(i) for i in range(2)), set()).add(names[int(cell_curve.GetValue(c))])
        self.assertEqual({kinds[names.index(n)] for found in at_edge.values() for n in found} - {"intersection", "border", "well"}, set())
        meeting = {}  # surfaces of the facets at an edge
        for f in range(soup.GetNumberOfCells()):
            points = soup.GetCell(f).GetPoints()
            for i in range(3):
                edge = frozenset((points.GetPoint(i), points.GetPoint((i + 1) % 3)))
                meeting.setdefault(edge, set()).update(surface_names[int(s)] for s in surfaces[offsets[f]:offsets[f + 1]])
        for edge, found in meeting.items():
            if len(found) == 2:
                self.assertIn("*".join(sorted(found)), at_edge.get(edge, set()))

    def test_stop_after_an_unknown_stage(self):
        self.assertIn("intersect", self.run_program(self.sample("salt-dome"), "--stop-after", "lunch", status=USAGE))

    def test_quiet_prints_nothing_where_nothing_is_wrong(self):
        points, triangles = box_surface((0, 0, 0), (1, 2, 3))
        self.write("box.ts", triangles_ts("box", points, triangles))
        self.assertEqual(self.run_program("mesh", "box.ts", "-o", "box.vtu", "--quiet"), "")
        self.assertEqual(self.check(self.path("box.vtu"), "--surfaces", self.path("box.ts"))["volume"], 6)

    def test_the_report_as_a_page(self):
        points, triangles = box_surface((0, 0, 0), (1, 2, 3))
        self.write("box.ts", triangles_ts("box", points, triangles))
        self.run_program("mesh", "box.ts", "-o", "box.html", "--quiet")
        with open(self.path("box.html"), encoding="utf-8") as file:
            page = file.read()
        self.assertTrue(page.startswith("<!doctype html>") and page.rstrip().endswith("</html>"))
        self.assertIn("6 m3", page)
        self.assertFalse(os.path.exists(self.path("box.vtu")))

    def test_progress_line_per_stage(self):
        printed = self.run_program(self.sample("faulted-layers"), "-o", self.folder)
        for stage in ("read", "intersect", "mesh", "verify", "write"):
            self.assertTrue(any(line.startswith(stage) for line in printed.splitlines()), printed)

    def interrupt(self, number, status):
        """Signals a run at several moments; each ends with the status and leaves nothing, or was done before."""
        interrupted = 0
        for stage, delay in (("", 0.02), ("", 0.1), ("read", 0), ("intersect", 0), ("mesh", 0), ("refine", 0)):
            folder = self.path("after_%s%g" % (stage, delay))
            run = subprocess.Popen([PROGRAM, self.sample("salt-dome"), "-o", folder], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            while stage and not run.stderr.readline().startswith(stage):  # a stage is told as soon as it is done
                self.assertIsNone(run.poll())
            time.sleep(delay)
            run.send_signal(number)
            run.stderr.read()
            run.wait(timeout=60 * SLOWNESS)
            run.stderr.close()
            left = os.listdir(folder) if os.path.exists(folder) else []
            if run.returncode == 0:
                self.assertIn("salt_dome.vtu", left)
                continue
            self.assertIn(run.returncode, (status, -number))  # a signal before the handler stands kills the program
            interrupted += run.returncode == status
            self.assertFalse([name for name in left if name.endswith(".part")], left)
            for name in left:  # what is there is complete
                if name.endswith(".vtu"):
                    self.check(os.path.join(folder, name))
        self.assertGreater(interrupted, 0)

    def test_interrupt(self):
        self.interrupt(signal.SIGINT, INTERRUPTED)

    def test_terminate(self):
        self.interrupt(signal.SIGTERM, 143)


class Check(ProgramTest):
    def test_faults_are_named_and_the_status_is_three(self):
        # One tetrahedron turned inside out, as another tool's Gmsh 2.2 file.
        self.write("bad.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
                              "$Elements\n1\n1 4 2 1 1 1 3 2 4\n$EndElements\n")
        printed = self.run_program("check", "bad.msh", status=BAD_INPUT)
        self.assertIn("inverted_tetrahedra", printed)
        self.assertIn("does not pass", printed)

    def test_a_sound_mesh_of_another_tool(self):
        self.write("good.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
                               "$Elements\n1\n1 4 2 1 1 1 2 3 4\n$EndElements\n")
        self.assertIn("passes", self.run_program("check", "good.msh", "--delaunay"))


class Init(ProgramTest):
    def test_the_project_that_init_writes_runs(self):
        self.run_program("init", self.path("mine"))
        projects = [name for name in os.listdir(self.path("mine")) if name.endswith(".yaml")]
        self.assertEqual(len(projects), 1)
        project = self.path("mine", projects[0])
        self.run_program(project, "-o", self.path("out"))
        meshes = [name for name in os.listdir(self.path("out")) if name.endswith(".vtu")]
        self.check(self.path("out", meshes[0]), "--project", project)


if __name__ == "__main__":
    main()
