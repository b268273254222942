# SPDX-License-Identifier: GPL-3.0-or-later
"""The checker sees every corruption: whole outputs of a model with horizons, a fault with a tip, salt, two wells, a named point, a group and
an attribute are broken in one way each, written as files and given to `geomesh check --project`, which must name the fault. Three meshes:
as the surfaces are, refined, and with surfaces remeshed within a tolerance."""
import concurrent.futures
import copy
import json
import os
import shutil
import subprocess

import corruptions_of_geometry  # noqa: F401  they register themselves
import corruptions_of_values  # noqa: F401
from corruption import CORRUPTIONS
from geomesh_program import BAD_INPUT, DONE, PROGRAM, SOURCE, ProgramTest, level, main, plane_ts, triangles_ts
from checked_model import Model

PROJECT = """name: m
box: {min: [0, 0, -2000], max: [3000, 3000, 0]}
surfaces:
  - {name: top_reservoir,  kind: horizon, file: top_reservoir.ts}
  - {name: base_reservoir, kind: horizon, file: base_reservoir.ts}
  - {name: fault, kind: fault, file: fault.ts}
  - {name: salt, kind: body, file: salt.ts, cuts: all}
wells:
  - {name: w1, file: w1.pl}
  - {name: w2, file: w2.pl}
points: [{name: gauge, at: [2500, 500, -300]}]
column: [overburden, top_reservoir, reservoir, base_reservoir, underburden]
groups: {rock: [reservoir, underburden]}
attributes: {reservoir: {porosity: 0.2}, overburden: {porosity: 0.1}}
rules: {stack: keep}  # where the stack is settled small regions join others, and suffixes and ids are not checked
mesh: %s
output: {directory: out, formats: [vtu]}
"""
SHAPES = "min_dihedral, max_dihedral, radius_ratio, mean_ratio, aspect"
MESHES = {"plain": "{mode: constrained, refine: none, cell_arrays: [%s]}" % SHAPES,
          "refined": "{size: 900, honour: exact, quality: fast, cell_arrays: [size, %s]}" % SHAPES,
          "within": "{size: 900, honour: tolerance, tolerance: 2, quality: fast, cell_arrays: [size, %s]}" % SHAPES}


class Checker(ProgramTest):
    def write_project(self, mesh):
        surfaces = os.path.join(SOURCE, "samples", "wells", "surfaces")
        for name in ("top_reservoir.ts", "base_reservoir.ts", "w1.pl", "w2.pl"):
            shutil.copy(os.path.join(surfaces, name), self.folder)
        self.write("fault.ts", plane_ts("fault", [(700, -60, -2100), (700, 2000, -2100), (700, 2000, 100), (700, -60, 100)]))
        x, y, z, r = 2300.0, 2200.0, -1400.0, 300.0
        points = [(x - r, y, z), (x + r, y, z), (x, y - r, z), (x, y + r, z), (x, y, z - r), (x, y, z + r)]
        triangles = [(1, 3, 5), (3, 0, 5), (0, 2, 5), (2, 1, 5), (3, 1, 4), (0, 3, 4), (2, 0, 4), (1, 2, 4)]
        self.write("salt.ts", triangles_ts("salt", points, triangles))
        return self.write("project.yaml", PROJECT % mesh)

    def check_files(self, folder, project):
        """Names of the faults that the check finds in a folder; it must exit with 3 where there are any."""
        file = os.path.join(folder, "check.json")
        done = subprocess.run([PROGRAM, "check", os.path.join(folder, "m.vtu"), "--project", project, "--report", file], timeout=self.timeout,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if not os.path.exists(file):
            raise AssertionError(done.stdout)
        with open(file) as report:
            faults = [fault["id"] for fault in json.load(report)["faults"]]
        self.assertEqual(done.returncode, BAD_INPUT if faults else DONE)
        return faults

    def see_all(self, mesh):
        project = self.write_project(MESHES[mesh])
        self.run_program(project, "-o", self.path("out"), "--quiet")
        whole = Model(self.path("out"))
        whole.write(self.path("whole"))
        self.assertEqual(self.check_files(self.path("whole"), project), [], "the whole output passes")

        def see(name):
            break_it, _ = CORRUPTIONS[name]
            model = copy.deepcopy(whole)
            break_it(model)
            model.write(self.path(name))
            return self.check_files(self.path(name), project)

        self.assertGreaterEqual(len(CORRUPTIONS), 60)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            found = dict(zip(CORRUPTIONS, pool.map(see, CORRUPTIONS)))
        for name, faults in found.items():
            with self.subTest(corruption=name):
                self.assertTrue(set(CORRUPTIONS[name][1]) & set(faults), "expected one of %s, found %s" % (CORRUPTIONS[name][1], faults))
        print("%s: %d corruptions, each found" % (mesh, len(found)))

    def test_every_corruption_of_a_plain_mesh_is_named(self):
        self.see_all("plain")

    def test_every_corruption_of_a_refined_mesh_is_named(self):
        self.see_all("refined")

    def test_every_corruption_of_a_mesh_within_a_tolerance_is_named(self):
        self.see_all("within")

    def test_a_region_that_touches_no_horizon_has_the_unit_of_its_vertical(self):
        """Beyond a level fault: a horizon above it, one below it, or both."""
        for heights, column, names in (((3,), ["sand", "h0", "shale"], ["sand__1", "sand__2", "shale"]), ((7,), ["sand", "h0", "shale"], ["sand", "shale__1", "shale__2"]),
                                       ((8, 2), ["sand", "h0", "lime", "h1", "shale"], ["lime__1", "lime__2", "lime__3", "sand", "shale"])):
            with self.subTest(heights=heights):
                faults = {"f": 5} if len(heights) == 1 else {"f": 4, "g": 6}
                entries = []
                for kind, names_and_heights in (("horizon", {"h%d" % k: z for k, z in enumerate(heights)}), ("fault", faults)):
                    for name, z in names_and_heights.items():
                        self.write(name + ".ts", level(name, z))
                        entries.append("{name: %s, kind: %s, file: %s.ts}" % (name, kind, name))
                project = self.write("vertical.yaml", "name: v\nbox: {min: [0, 0, 0], max: [10, 10, 10]}\nsurfaces: [%s]\ncolumn: [%s]\nrules: {stack: keep}\n"
                                     "mesh: {mode: constrained, refine: none}\noutput: {directory: out, formats: [vtu]}\n" % (", ".join(entries), ", ".join(column)))
                self.run_program(project)
                self.assertEqual(self.region_names(self.check(self.path("out", "v.vtu"), "--project", project)), names)

    def write_pyramid_and_fault(self, folder, height, peak, top):
        """Horizon h1 is flat at `height`, h2 below it rises to `peak`, and the fault f to `top`. Returns the project file."""
        os.makedirs(self.path(folder), exist_ok=True)
        corners = [(-10, -10, 300), (1010, -10, 300), (1010, 1010, 300), (-10, 1010, 300)]
        self.write(folder + "/h1.ts", triangles_ts("h1", [(x, y, height) for x, y, _ in corners], [(0, 1, 2), (0, 2, 3)]))
        self.write(folder + "/h2.ts", triangles_ts("h2", [*corners, (600, 400, peak)], [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]))
        self.write(folder + "/f.ts", triangles_ts("f", [(100, -10, -10), (100, 1010, -10), (100, 1010, top), (100, -10, top)], [(0, 1, 2), (0, 2, 3)]))
        return self.write(folder + "/project.yaml", """name: m
box: {min: [0, 0, 0], max: [1000, 1000, 1000]}
surfaces: [{name: h1, kind: horizon, file: h1.ts}, {name: h2, kind: horizon, file: h2.ts}, {name: f, kind: fault, file: f.ts}]
rules: {stack: keep}
mesh: {mode: constrained, refine: none}
output: {directory: out, formats: [vtu]}
""")

    def test_a_crossing_deeper_than_the_tolerance_is_due_and_no_other(self):
        """In the mesh nothing reaches h1, and all is within 10 m of the inputs. There h2 and f pass through h1: by 8 m, or one of them by 15 m."""
        self.run_program(self.write_pyramid_and_fault("mesh", 508, 506, 506))
        for peak, top, faults in ((508, 508, set()), (515, 508, {"curves_off"}), (508, 515, {"curves_off"})):
            project = self.write_pyramid_and_fault("%d_%d" % (peak, top), 500, peak, top)
            with self.subTest(peak=peak, top=top):
                self.run_program("check", self.path("mesh", "out", "m.vtu"), "--project", project, "--within", "10", "--report", self.path("check.json"), status=None)
                found = {fault["id"] for fault in self.report(self.path("check.json"))["faults"]}
                self.assertEqual(found - {"wrong_input_vertices"}, faults)  # the mesh keeps the vertices of its own input


if __name__ == "__main__":
    main()
