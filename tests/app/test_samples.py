# SPDX-License-Identifier: GPL-3.0-or-later
"""The samples run as they are, and their meshes pass."""
import json
import math
import os
import re
import shutil
import subprocess
import sys

from geomesh_program import SOURCE, ProgramTest, main


class Samples(ProgramTest):
    def run_with_expected(self, name):
        """Meshes a sample that has an expected.json: regions by unit (the name without the suffix by place) and their volumes."""
        report, check = self.mesh_sample(name)
        with open(os.path.join(SOURCE, "samples", name, "expected.json")) as file:
            stated = json.load(file)
        expected, within = stated["units"], stated.get("within", 1e-9)
        found = {}
        for region in check["regions"]:
            found.setdefault(re.sub(r"__\d+$", "", region["name"]), []).append(region["volume"])
        self.assertEqual(sorted(found), sorted(expected))
        for unit, volumes in expected.items():
            self.assertEqual(len(found[unit]), len(volumes), unit)
            names = [unit] if len(volumes) == 1 else ["%s__%d" % (unit, place + 1) for place in range(len(volumes))]
            self.assertEqual(sorted(set(names) & set(self.region_names(check))), sorted(names))
            for volume, wanted in zip(sorted(found[unit]), volumes):
                self.assertAlmostEqual(volume / wanted, 1, delta=within, msg=unit)
        return report, check

    def test_layer_cake_with_pinch_outs(self):
        self.run_with_expected("layer-cake")

    def test_fault_junctions(self):
        self.run_with_expected("fault-junctions")

    def test_turned_box(self):
        """Sides are named by the box's own axes; the well is cut where it leaves the box."""
        report, _ = self.run_with_expected("turned-box")
        areas = {surface["name"]: surface["area"] for surface in report["surfaces"]}
        for side, area in (("xmin", 6e6), ("xmax", 6e6), ("ymin", 9e6), ("ymax", 9e6), ("zmin", 6e6), ("zmax", 6e6)):
            self.assertAlmostEqual(areas[side] / area, 1, delta=1e-12, msg=side)
        well = [curve["length"] for curve in report["curves"] if curve["name"] == "w1"]
        self.assertAlmostEqual(well[0], 900 + 1500 / math.cos(math.radians(30)) * math.hypot(1, 400 / 2500), delta=1e-6)
        self.assertTrue(any("w1" in warning and "outside the box" in warning for warning in report["warnings"]))

    def test_outcrops(self):
        """Horizons end on the topography, and nothing of the box above it is left."""
        report, _ = self.run_with_expected("outcrops")
        top = [surface for surface in report["surfaces"] if surface["name"] == "zmax"]
        self.assertEqual([surface["area"] for surface in top], [0])
        self.assertTrue(any("top_marl has no face" in warning for warning in report["warnings"]), report["warnings"])

    def test_salt_at_surface(self):
        report, _ = self.run_with_expected("salt-at-surface")
        self.assertTrue(any("pieces of salt above relief removed" in note for note in report["notes"]), report["notes"])

    def test_ragged_throw(self):
        """Names by fault block; the same volumes as where the blocks end on the fault."""
        report, _ = self.run_with_expected("ragged-throw")
        self.assertTrue(any("top_basement: 2 overshooting pieces removed" in note for note in report["notes"]), report["notes"])

    def test_dying_throw(self):
        """Throw that dies out towards the end of a fault: horizons without free border, cut off on both sides of the fault, whole beyond it."""
        report, _ = self.run_with_expected("dying-throw")
        self.assertEqual(report["warnings"], [])
        lengths = {curve["name"]: curve["length"] for curve in report["curves"]}
        self.assertNotIn("top_sand.border", lengths)
        self.assertNotIn("top_basement.border", lengths)
        # Two cut-offs where there is throw, from y = 0 to 2400, one from there to the end of the fault.
        self.assertAlmostEqual(lengths["fault*top_sand"], 2600 + math.hypot(2400, 400, 0.6 * 400), delta=100)
        self.assertAlmostEqual(lengths["fault.tip"], 3000 * math.hypot(1, 0.6), delta=1e-3)

    def test_unconformity(self):
        self.run_with_expected("unconformity")

    def test_onlap(self):
        self.run_with_expected("onlap")

    def test_normal_fault(self):
        self.run_with_expected("normal-fault")

    def test_rooted_salt(self):
        self.run_with_expected("rooted-salt")

    def test_depth_in_feet(self):
        self.run_with_expected("depth-in-feet")

    def test_lon_lat(self):
        report, _ = self.run_with_expected("lon-lat")
        self.assertEqual(report["input"]["crs"]["mesh"], "utm 32N")
        self.assertTrue(any("converted from geographic to utm 32N" in note for note in report["notes"]), report["notes"])

    def test_wells(self):
        report, _ = self.run_with_expected("wells")
        wells = {curve["name"]: curve["length"] for curve in report["curves"] if curve["kind"] == "well"}
        self.assertEqual(sorted(wells), ["w1", "w2"])
        self.assertAlmostEqual(wells["w1"], 1450, delta=1e-6)

    def test_well_tops(self):
        """Moved horizons have the volumes of an elimination apart from the program, and the mesh passes through the tops."""
        report, _ = self.run_with_expected("well-tops")
        tops = report["tops"]
        self.assertEqual([(top["well"], top["horizon"]) for top in tops],
                         [("w1", "top_sand"), ("w2", "top_sand"), ("w3", "top_sand"), ("w1", "base_sand"), ("w3", "base_sand")])
        self.assertEqual(tops[0]["place"], [900, 900, -968])
        for top in tops:
            self.assertGreater(abs(top["misfit_given"]), 1, top)
            for stage in ("misfit_fitted", "misfit_meshed"):
                self.assertLess(abs(top[stage]), 1e-6, top)

    def test_well_tops_within_a_tolerance(self):
        report, _ = self.mesh_sample("well-tops", mesh="{size: 150, tolerance: 3}")
        for top in report["tops"]:
            self.assertLess(abs(top["misfit_meshed"]), 3.1, top)

    def test_tops_of_what_is_not_there_are_told(self):
        project = self.copy_of_sample("well-tops", None)
        with open(os.path.join(os.path.dirname(project), "surfaces", "tops.csv"), "a") as file:
            file.write("w9,top_sand,100\nw1,top_coal,100\nw1,top_sand,5000\n")
        self.run_program(project, "-o", self.folder)
        warnings = " ".join(self.report(self.path("well_tops.report.json"))["warnings"])
        for words in ("no well is called w9", "no horizon is called top_coal", "the well does not reach 5000"):
            self.assertIn(words, warnings)

    def test_implicit_fold(self):
        """Level sets of one field, cut by a fault: the volumes of the trilinear field, counted at 5 million places apart from the program."""
        report, check = self.mesh_sample("implicit-fold")
        volumes = {}
        for region in check["regions"]:
            unit = re.sub(r"__\d+$", "", region["name"])
            volumes[unit] = volumes.get(unit, 0) + region["volume"]
        for unit, volume in (("cover", 1.14496e9), ("sand", 1.68425e8), ("marl", 5.93862e8), ("shale", 1.09275e9)):
            self.assertAlmostEqual(volumes[unit] / volume, 1, delta=0.005, msg=unit)
        self.assertEqual(sum("proven to be within" in note for note in report["notes"]), 3, report["notes"])

    def test_fracture_network(self):
        """Each disc has its area, and the families their number and density."""
        report, _ = self.mesh_sample("fracture-network")
        areas = {surface["name"]: surface["area"] for surface in report["surfaces"]}
        self.assertAlmostEqual(areas["branch"] / (math.pi * 25 ** 2), 1, delta=1e-9)
        self.assertLess(areas["border"], math.pi * 20 ** 2 * 0.9)  # ends outside of the block
        self.assertEqual(sum(name.startswith("flat_") for name in areas), 6)
        steep = sum(area for name, area in areas.items() if name.startswith("steep_"))
        self.assertGreater(steep, 0.02e6 * (1 - 1e-9))
        self.assertLess(steep, 0.02e6 + math.pi * 30 ** 2)

    def test_sediment_grains(self):
        self.run_with_expected("sediment-grains")

    def test_a_hundred_grains(self):
        """From the sample's generator."""
        script = os.path.join(SOURCE, "samples", "sediment-grains", "make_surfaces.py")
        subprocess.run([sys.executable, script, "--grains", "100", "--output", self.path("grains")], check=True, timeout=60)
        project = self.path("grains", "project.yaml")
        self.run_program(project, "-o", self.folder)
        check = self.check(self.path("sediment_grains.vtu"), "--project", project)
        self.assertEqual(len(check["regions"]), 101)

    def test_salt_dome(self):
        report, check = self.run_with_expected("salt-dome")
        self.assertEqual(self.region_names(report), self.region_names(check))
        self.assertAlmostEqual(check["volume"] / 4e11, 1, delta=1e-12)
        clipping = report["displacement"]["clipping"]
        for surface in clipping["surfaces"]:
            if surface["surface"] in ("top_chalk", "base_chalk", "top_bunter"):
                self.assertGreater(surface["area_by_bodies"], 1e6, surface)
                self.assertGreater(surface["area_by_box"], 1e6, surface)
        inside = {region["name"]: region["inside"] for region in report["regions"]}
        self.assertEqual(inside["salt"], ["salt"])
        self.assertEqual(inside["chalk"], [])

    def test_salt_dome_in_conforming_mode(self):
        project = self.copy_of_sample("salt-dome", "{mode: conforming}")
        self.run_program(project, "-o", self.path("out"))
        report = self.report(self.path("out", "salt_dome.report.json"))
        self.assertEqual(report["recovery"]["facets_not_recovered"], [])
        triangles = sum(surface["triangles"] for surface in report["input"]["surfaces"])
        self.assertTrue(report["recovery"]["tetrahedra_final"] <= 8 * triangles, "%d triangles" % triangles)
        self.check(self.path("out", "salt_dome.vtu"), "--project", project, "--delaunay")

    def test_faulted_layers(self):
        report, check = self.run_with_expected("faulted-layers")
        units = [name + "__" + str(block) for name in ("basement", "cover", "sand", "shale") for block in (1, 2, 3)]
        self.assertEqual(self.region_names(check), units)
        self.assertAlmostEqual(check["volume"] / 9e10, 1, delta=1e-12)
        self.assertTrue(any(curve["kind"] == "fault_tip" and "north_fault" in curve["name"] for curve in report["curves"]), report["curves"])
        self.assertEqual(report["warnings"], [])

    def test_generators_write_what_is_committed(self):
        """The scripts make the very files that stand in the tree (in a copy of it)."""
        import filecmp
        import shutil
        copy = self.path("samples")
        shutil.copytree(os.path.join(SOURCE, "samples"), copy, ignore=shutil.ignore_patterns("out"))
        for name in sorted(os.listdir(copy)):
            script = os.path.join(copy, name, "make_surfaces.py")
            if not os.path.exists(script):
                continue
            shutil.rmtree(os.path.join(copy, name, "surfaces"))
            expected = os.path.join(copy, name, "expected.json")
            if os.path.exists(expected):
                os.remove(expected)
            subprocess.run([sys.executable, script], check=True, timeout=60)
            original = os.path.join(SOURCE, "samples", name, "surfaces")
            files = sorted(os.listdir(original))
            self.assertEqual(sorted(os.listdir(os.path.join(copy, name, "surfaces"))), files)
            _, differ, missing = filecmp.cmpfiles(original, os.path.join(copy, name, "surfaces"), files, shallow=False)
            self.assertEqual((differ, missing), ([], []), name)
            if os.path.exists(os.path.join(SOURCE, "samples", name, "expected.json")):
                self.assertTrue(filecmp.cmp(os.path.join(SOURCE, "samples", name, "expected.json"), expected, shallow=False), name)


if __name__ == "__main__":
    main()
