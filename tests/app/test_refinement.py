# SPDX-License-Identifier: GPL-3.0-or-later
"""Sizes and qualities asked in project files and on the command line: what comes out passes `geomesh check`, keeps its names, and has the
sizes asked."""
import math
import os
import re
import shutil

from geomesh_program import BAD_INPUT, CANNOT_MESH, SOURCE, USAGE, ProgramTest, level, main

LAYERS = """name: layers
box: {min: [0, 0, 0], max: [10, 10, 10]}
surfaces:
  - {name: top, kind: horizon, file: top.ts}
column: [upper, top, lower]
points:
  - {name: gauge, at: [5, 5, 8]}
"""


def kept_surfaces(mesh):
    """The same with surfaces kept exactly, and sizes from their edges, where `mesh` does not speak of it."""
    return mesh if "honour" in mesh or "conforming" in mesh else mesh[:-1] + ", honour: exact}"


def plate_with_holes(half=10, height=3.175, radius=1.9, segments=32, rows=2):
    """OFF of a square plate of rows x rows cells with a round hole in the middle of each. The walls of the holes are needles, as CAD makes them.
    `half` of the side of a cell; `segments` a multiple of 4."""
    rows_of_points, triangles = {}, []

    def vertex(x, y, z):
        return rows_of_points.setdefault((round(x, 9), round(y, 9), z), len(rows_of_points))

    def add_wall(a, b):
        """Seen from outside, a is on the left."""
        triangles.append((vertex(*a, 0), vertex(*b, 0), vertex(*b, height)))
        triangles.append((vertex(*a, 0), vertex(*b, height), vertex(*a, height)))

    def add_top_and_bottom(a, b, c):
        """Counterclockwise from above."""
        triangles.append([vertex(*p, height) for p in (a, b, c)])
        triangles.append([vertex(*p, 0) for p in (a, c, b)])

    def add_cell(x, y):
        ring = [(x + radius * math.cos(2 * math.pi * k / segments), y + radius * math.sin(2 * math.pi * k / segments)) for k in range(segments)]
        corners = [(x + half, y + half), (x - half, y + half), (x - half, y - half), (x + half, y - half)]
        quarter = segments // 4
        for k in range(segments):
            add_wall(ring[(k + 1) % segments], ring[k])
            add_top_and_bottom(corners[k // quarter], ring[(k + 1) % segments], ring[k])
        for q in range(4):
            add_top_and_bottom(corners[q], corners[(q + 1) % 4], ring[(q + 1) * quarter % segments])

    for i in range(rows):
        for j in range(rows):
            add_cell((2 * i + 1) * half, (2 * j + 1) * half)
    end = 2 * half * rows
    for i in range(rows):
        low, high = 2 * half * i, 2 * half * (i + 1)
        for a, b in (((low, 0), (high, 0)), ((end, low), (end, high)), ((high, end), (low, end)), ((0, high), (0, low))):
            add_wall(a, b)
    lines = ["OFF", "%d %d 0" % (len(rows_of_points), len(triangles))]
    lines += ["%r %r %r" % p for p in rows_of_points] + ["3 %d %d %d" % tuple(t) for t in triangles]
    return "\n".join(lines) + "\n"


class Refinement(ProgramTest):
    def layers(self, mesh):
        self.write("top.ts", level("top", 5))
        return self.write("model.yaml", LAYERS + "mesh: " + kept_surfaces(mesh) + "\n")

    def mesh_layers(self, mesh):
        project = self.layers(mesh)
        self.run_program(project, "-o", self.folder)
        check = self.check(self.path("layers.vtu"), "--project", project)
        return self.report(self.path("layers.report.json")), check

    def refined_sample(self, name, mesh, kept=True):
        """A copy of a sample with other keys under `mesh`, meshed and checked, where surfaces are kept against the project; the report and the
        check's."""
        project = self.copy_of_sample(name, kept_surfaces(mesh))
        self.run_program(project, "-o", self.folder)
        mesh = next(self.path(f) for f in os.listdir(self.folder) if f.endswith(".vtu"))
        return self.report(mesh[:-4] + ".report.json"), self.check(mesh, *(["--project", project] if kept else []))

    def test_a_global_size(self):
        report, check = self.mesh_layers("{size: 1}")
        self.assertEqual([s["name"] for s in report["stages"]][-5:], ["estimate", "refine", "improve", "verify", "write"])
        self.assertEqual(self.region_names(check), ["lower", "upper"])
        self.assertAlmostEqual(check["volume"] / 1000, 1, delta=1e-12)
        whole = report["quality"]["whole"]
        self.assertGreater(report["tetrahedra"], 6000)
        self.assertLess(report["tetrahedra"], 14000)
        self.assertGreater(report["refinement"]["edges_within_size"], 0.99)
        self.assertGreater(whole["min_dihedral"]["min"], 15)
        self.assertEqual(sum(r["tetrahedra"] for r in report["quality"]["regions"]), report["tetrahedra"])
        self.assertGreaterEqual(len(report["quality"]["worst"]), 10)
        names = {surface["name"] for surface in report["surfaces"]}
        self.assertTrue({"top", "xmin", "zmax"} <= names)
        self.assertTrue(any(p["name"] == "gauge" for p in report["curves"]), report["curves"])

    def test_sizes_inside_only(self):
        """In a project and on the command line: no points on surfaces for sizes, and the report says so."""
        everywhere, _ = self.mesh_layers("{size: 1}")
        report, check = self.mesh_layers("{size: {global: 1, on_surfaces: false}}")
        self.assertTrue(everywhere["refinement"]["sizes_on_surfaces"])
        self.assertFalse(report["refinement"]["sizes_on_surfaces"])
        self.assertGreater(everywhere["refinement"]["points_on_surfaces"], 300)
        self.assertLess(report["refinement"]["points_on_surfaces"] + report["refinement"]["points_on_curves"], 30)  # a few for the worst elements
        self.assertGreater(report["refinement"]["points_inside"], 40)
        self.assertAlmostEqual(check["volume"] / 1000, 1, delta=1e-12)
        out = self.path("flag.vtu")
        arguments = ("mesh", self.path("top.ts"), "--box", "0,0,0,10,10,10", "--size", "1", "--no-size-on-surfaces", "-o", out)
        self.run_program(*arguments)
        flagged = self.report(self.path("flag.report.json"))["refinement"]
        self.assertFalse(flagged["sizes_on_surfaces"])
        self.assertLess(flagged["points_on_surfaces"] + flagged["points_on_curves"], 30)
        self.run_program(*arguments, "--tolerance", "0.1", status=USAGE)

    def test_sizes_by_unit_surface_curve_and_place(self):
        coarse, _ = self.mesh_layers("{size: {global: 3, gradation: 0.5}}")
        regions = {r["name"]: r["tetrahedra"] for r in coarse["quality"]["regions"]}
        for mesh, region in (("units: {lower: 1}", "lower"), ("surfaces: {zmax: 0.7}", "upper"), ("curves: {xmin*zmin: 0.4}", "lower"),
                             ("near: [{at: gauge, size: 0.2, radius: 0.5}]", "upper")):
            finer, _ = self.mesh_layers("{size: {global: 3, gradation: 0.5, %s}}" % mesh)
            counts = {r["name"]: r["tetrahedra"] for r in finer["quality"]["regions"]}
            self.assertGreater(counts[region], 1.5 * regions[region], mesh)

    def test_names_that_are_not_there(self):
        for mesh, words in (("{size: {units: {uper: 1}}}", "was 'upper' meant? known are lower, upper"), ("{size: {curves: {no_curve: 1}}}", "wells"),
                            ("{size: {surfaces: {no_surface: 1}}}", "zmax")):
            printed = self.run_program(self.layers(mesh), "-o", self.folder, status=USAGE)
            self.assertIn(words, printed)
            self.assert_nothing_written()

    def test_too_many_elements_are_refused_before_the_work(self):
        printed = self.run_program(self.layers("{size: 0.05, max_elements: 100000}"), "-o", self.folder, status=CANNOT_MESH)
        self.assertRegex(printed, "edges of 0.05 m fill the model with about [0-9,]+ elements, more than the limit of 100,000")
        self.assert_nothing_written()

    def test_cell_arrays(self):
        self.mesh_layers("{size: 2, cell_arrays: [size, min_dihedral, aspect]}")
        with open(self.path("layers.vtu"), "rb") as file:
            head = file.read().split(b"<AppendedData")[0]
        for name in (b"size", b"min_dihedral", b"aspect"):
            self.assertIn(b'Name="' + name + b'"', head)

    def test_threads_do_not_matter(self):
        project = self.layers("{size: 1}")
        for n in ("1", "2"):
            self.run_program(project, "-o", self.path(n), "--threads", n)
        for name in ("layers.vtu", "layers.faces.vtp", "layers.curves.vtp"):
            with open(self.path("1", name), "rb") as one, open(self.path("2", name), "rb") as two:
                self.assertEqual(one.read(), two.read(), name)

    def test_command_line(self):
        self.write("top.ts", level("top", 5))
        arguments = ["mesh", "top.ts", "-o", "out.vtu", "--box", "0,0,0,10,10,10"]
        self.run_program(*arguments, "--no-refine", "--size", "1", status=USAGE)
        self.run_program(*arguments, "--mode", "conforming", "--size", "1", "--quality", "best", status=USAGE)
        self.run_program(*arguments, "--mode", "conforming", "--size", "1", "--tolerance", "0.1", status=USAGE)
        self.run_program(*arguments, "--preserve-boundary", "--size", "1", status=USAGE)
        self.run_program(*arguments, "--size", "0", status=USAGE)
        self.assert_nothing_written()
        printed = self.run_program(*arguments, "--size", "1", "--quality", "fast", "--cell-arrays", "size,aspect")
        self.assertIn("dihedral angles", printed)
        self.check(self.path("out.vtu"))
        self.assertGreater(self.report(self.path("out.report.json"))["tetrahedra"], 6000)

    def test_sediment_grains(self):
        report, check = self.refined_sample("sediment-grains", "{refine: default}")
        self.assertEqual(len(check["regions"]), 9)
        quality = report["quality"]
        self.assertGreater(quality["min_dihedral"], 15)
        self.assertLess(quality["max_dihedral"], 150)
        self.assertGreater(quality["whole"]["share_above_24_85"], 0.985)
        self.assertGreater(report["refinement"]["edges_within_size"], 0.9)

    def test_best_on_irregular_grains(self):
        """Surfaces free within 0.2 % of a grain's 200 micrometres: no element below 24.85 degrees, none above 145."""
        tolerance = 0.4
        report, check = self.refined_sample("sediment-grains", "{size: {input_edges: true}, quality: best, honour: tolerance, tolerance: %g}" % tolerance,
                                            kept=False)
        self.assertEqual(len(check["regions"]), 9)
        quality = report["quality"]
        self.assertGreater(quality["min_dihedral"], 24.85)
        self.assertLess(quality["max_dihedral"], 145)
        self.assertLessEqual(report["refinement"]["deviation_result_to_input"], tolerance)
        self.assertLessEqual(report["refinement"]["deviation_input_to_result"], tolerance)
        self.assertGreater(report["refinement"]["edges_within_size"], 0.9)

    def test_edges_have_the_sizes_asked(self):
        """Nine edges in ten between half and twice what was asked, whatever asks."""
        for name, mesh in (("sediment-grains", "{size: {global: 40, surfaces: {grain_1: 12}}}"),
                           ("wells", "{size: {global: 300, curves: {wells: 40}, units: {reservoir: 120}}}"),
                           ("depth-in-feet", "{size: {global: 300, units: {gas: 120}, gap_layers: 2}}")):
            shutil.rmtree(self.path("sample"), ignore_errors=True)
            for file in os.listdir(self.folder):
                if os.path.isfile(self.path(file)):
                    os.remove(self.path(file))
            report, _ = self.refined_sample(name, mesh)
            self.assertGreater(report["refinement"]["edges_within_size"], 0.9, name)
            histogram = report["quality"]["whole"]["edge_size_histogram"]
            self.assertGreater(sum(histogram[2:6]), 0.9 * sum(histogram), name)

    def test_salt_dome(self):
        report, check = self.refined_sample("salt-dome", "{size: {input_edges: false, global: 700, gap_layers: none}}")
        self.assertEqual(self.region_names(check), ["bunter", "chalk", "lower_cretaceous", "salt", "tertiary"])
        self.assertAlmostEqual(check["volume"] / 4e11, 1, delta=1e-12)
        self.assertGreater(report["quality"]["whole"]["share_above_24_85"], 0.5)
        curves = {curve["name"] for curve in report["curves"]}
        self.assertIn("salt*top_chalk", curves)

    def test_crossings_force_no_needles(self):
        """Where surfaces cross, their triangles are cut into needles; what is kept is the triangles that were given."""
        report, _ = self.refined_sample("onlap", "{size: 200}")
        quality = report["quality"]["below_8_degrees"]
        self.assertEqual(quality["tetrahedra"] - quality["forced"], 0)
        self.assertLessEqual(quality["tetrahedra"], 5)
        self.assertGreater(report["quality"]["whole"]["share_above_24_85"], 0.99)

    def test_wells_and_thin_layers(self):
        """Curves, thin layers and faults of the small samples survive refinement, and the mesh passes."""
        for name in ("wells", "depth-in-feet", "fault-junctions"):
            shutil.rmtree(self.path("sample"), ignore_errors=True)
            for file in os.listdir(self.folder):
                if os.path.isfile(self.path(file)):
                    os.remove(self.path(file))
            report, _ = self.refined_sample(name, "{refine: default}")
            quality = report["quality"]["below_8_degrees"]
            self.assertLessEqual(quality["tetrahedra"] - quality["forced"], 5, name)
            self.assertTrue(report["curves"], name)

    def test_sizes_from_a_file(self):
        """The bottom asked for finely by lines of text; then the sizes that a mesh was made with, read back from it."""
        self.write("sizes.csv", "x,y,z,size\n" + "".join(
            "%g,%g,%g,%g\n" % (x, y, z, 0.8 if z == 0 else 3) for x in (0, 4, 10) for y in (0, 4, 10) for z in (0, 4, 10)))
        report, _ = self.mesh_layers("{size: {background: sizes.csv, gap_layers: none, input_edges: false}, cell_arrays: [size]}")
        counts = {r["name"]: r["tetrahedra"] for r in report["quality"]["regions"]}
        self.assertGreater(counts["lower"], 3 * counts["upper"])
        self.assertGreater(report["refinement"]["edges_within_size"], 0.9)
        os.rename(self.path("layers.vtu"), self.path("sizes.vtu"))
        again, _ = self.mesh_layers("{size: {background: sizes.vtu, gap_layers: none, input_edges: false}}")
        self.assertAlmostEqual(again["tetrahedra"] / report["tetrahedra"], 1, delta=0.5)
        self.run_program("mesh", "top.ts", "-o", "out.vtu", "--box", "0,0,0,10,10,10", "--size-from", "sizes.csv")
        self.assertGreater(self.report(self.path("out.report.json"))["tetrahedra"], 1000)
        printed = self.run_program(self.layers("{size: {background: sises.csv}}"), status=USAGE)
        self.assertIn("there is no file 'sises.csv'", printed)
        self.write("sizes.csv", "0 0 0 1\n1 1 1 0\n")
        printed = self.run_program(self.layers("{size: {background: sizes.csv}}"), status=BAD_INPUT)
        self.assertIn("sizes.csv:2: a size above zero was expected", printed)

    def test_conforming_to_a_size_is_delaunay(self):
        report, check = self.mesh_layers("{mode: conforming, size: 1.5}")
        self.assertTrue(report["delaunay"])
        self.assertEqual(report["recovery"]["facets_not_recovered"], [])
        self.assertGreater(report["refinement"]["edges_within_size"], 0.99)
        self.assertEqual(report["voronoi_dual"]["negative_areas"], report["voronoi_dual"]["negative_areas_on_border"])
        self.assertEqual(self.region_names(check), ["lower", "upper"])
        self.check(self.path("layers.vtu"), "--delaunay")
        self.assertNotIn("improve", [s["name"] for s in report["stages"]])
        constrained, _ = self.mesh_layers("{size: 1.5}")
        self.assertNotIn("voronoi_dual", constrained)
        self.check(self.path("layers.vtu"), "--delaunay", status=BAD_INPUT)

    def test_conforming_grains(self):
        report, check = self.refined_sample("sediment-grains", "{mode: conforming, size: {global: 40, input_edges: false}}")
        self.assertTrue(report["delaunay"])
        self.assertEqual(len(check["regions"]), 9)
        self.check(self.path("sediment_grains.vtu"), "--delaunay", "--project", self.path("sample", "project.yaml"))

    def test_solids_do_not_overlap_through_the_outside(self):
        """Sides of its holes are nearer to each other than the tolerance, and nothing is meshed between."""
        solid = self.shared("solids", "plate_holes.STL")
        self.run_program("mesh", solid, "-o", self.path("plate.vtu"), "--tolerance", "0.367", "--quality", "default")
        self.check(self.path("plate.vtu"))

    def test_narrow_holes_do_not_fold(self):
        """The tolerance is half of the holes' radius. Their walls could fold into the holes, where nothing is meshed that would keep them from it."""
        solid = self.path("plate.off")
        with open(solid, "w") as file:
            file.write(plate_with_holes())
        self.run_program("mesh", solid, "-o", self.path("plate.vtu"), "--size", "12.6", "--tolerance", "1")
        self.check(self.path("plate.vtu"), "--surfaces", solid, "--within", "1")
        report = self.report(self.path("plate.report.json"))
        self.assertEqual(report["refinement"]["runs"], 1)
        self.assertEqual(report["refinement"]["off_before"], 0)
        self.assertEqual({s["runs"] for s in report["stages"]}, {1})
        self.assertEqual(report["quality"]["below_8_degrees"]["tetrahedra"], 0)

    def test_kept_needles_force_all_that_is_bad(self):
        """Where much is poor for good, what is done for the mean in the end leaves nothing bad that the needles do not force."""
        solid = self.path("plate.off")
        with open(solid, "w") as file:
            file.write(plate_with_holes(segments=64, rows=1))
        self.run_program("mesh", solid, "-o", self.path("plate.vtu"), "--size", "2", "--quality", "default")
        self.check(self.path("plate.vtu"))
        bad = self.report(self.path("plate.report.json"))["quality"]["below_8_degrees"]
        self.assertGreater(bad["tetrahedra"], 100)
        self.assertEqual(bad["forced"], bad["tetrahedra"])

    def test_a_tolerance_as_large_as_the_model_is_refused(self):
        solid = self.path("plate.off")
        with open(solid, "w") as file:
            file.write(plate_with_holes(segments=8, rows=1))
        told = self.run_program("mesh", solid, "-o", self.path("plate.vtu"), "--size", "2", "--tolerance", "500", status=USAGE)
        self.assertIn("a tolerance of 500 is more than a tenth of the model's diagonal of ", told)
        self.assertFalse(os.path.exists(self.path("plate.vtu")))

    def test_surfaces_within_a_tolerance(self):
        """The project's tolerance is what `check` checks by; a tenth of it is not met."""
        for name, mesh, regions in (("sediment-grains", "{size: {global: 35, input_edges: false}, honour: tolerance, tolerance: 0.5}", 9),
                                    ("faulted-layers", "{size: {global: 700, input_edges: false}, honour: tolerance, tolerance: 5}", 12)):
            shutil.rmtree(self.path("sample"), ignore_errors=True)
            report, check = self.refined_sample(name, mesh)
            self.assertEqual(len(check["regions"]), regions)
            done = "\n".join(check["checks_done"])
            self.assertIn("from mesh to input: proven within", done)
            self.assertIn("from input to mesh", done)
            self.assertIn("region volumes are those of the input", done)
            for region in report["regions"]:
                self.assertAlmostEqual(region["volume"] / region["volume_of_input"], 1, delta=0.02)
            mesh_file = self.path({"sediment-grains": "sediment_grains", "faulted-layers": "faulted_layers"}[name] + ".vtu")
            narrow = self.check(mesh_file, "--project", self.path("sample", "project.yaml"), "--within", "0.05", status=BAD_INPUT)
            self.assertIn("faces_off_their_surface", [fault["id"] for fault in narrow["faults"]])
            for file in os.listdir(self.folder):
                if os.path.isfile(self.path(file)):
                    os.remove(self.path(file))


if __name__ == "__main__":
    main()
