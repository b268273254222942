#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Projects with one extreme number (tests/fuzz/extreme_numbers.py): a mesh or a message, never a crash, ten seconds to a refusal at most. One in
a hundred in every run of the tests, all by night."""
import copy
import json
import os
import resource
import sys

from geomesh_program import BAD_INPUT, CANNOT_MESH, NIGHTLY, PROGRAM, SLOWNESS, SOURCE, USAGE, ProgramTest, main

sys.path.insert(0, os.path.join(SOURCE, "tests", "fuzz"))
import extreme_numbers  # noqa: E402

EVERY = 1 if NIGHTLY else 100
MEMORY = 0 if SLOWNESS > 1 else 4 << 30  # sanitizers reserve terabytes


class ExtremeNumbers(ProgramTest):
    bare = False

    def test_one_extreme_number_is_meshed_or_refused(self):
        outcomes = set()
        for k, (name, files) in enumerate(extreme_numbers.projects()):
            if k % EVERY:
                continue
            with self.subTest(project=name):
                status, seconds, printed = extreme_numbers.run(files, self.folder, PROGRAM, extreme_numbers.SECONDS_TO_MESH * SLOWNESS, MEMORY)
                self.assertEqual(extreme_numbers.fault_of(status, seconds, printed, SLOWNESS), "", printed)
                outcomes.add(extreme_numbers.OUTCOMES.get(status))
        self.assertGreaterEqual(outcomes, {"meshed", "refused"})

    def test_every_key_that_takes_a_number_is_tried(self):
        with open(os.path.join(SOURCE, "docs", "project.schema.json"), encoding="utf-8") as file:
            schema = json.load(file)
        self.assertGreater(len(extreme_numbers.keys_of_numbers(schema)), 80)
        self.assertEqual(extreme_numbers.keys_not_covered(schema), [])

    def refused(self, mesh, status):
        return self.refused_project(dict(extreme_numbers.BASES["settled"], mesh=mesh), status)

    def refused_project(self, project, status):
        """What is printed of it, within two seconds."""
        text = "".join("%s: %s\n" % (key, extreme_numbers.written(part)) for key, part in {"name": "m", **project}.items())
        got, seconds, printed = extreme_numbers.run({"project.yaml": text}, self.folder, PROGRAM, extreme_numbers.SECONDS_TO_MESH * SLOWNESS, MEMORY)
        self.assertEqual(got, status, printed)
        self.assertLess(seconds, 2 * SLOWNESS)
        return printed

    def seconds_of(self, *arguments):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        self.run_program(*arguments)
        return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before

    def test_many_surfaces_of_one_file_are_read_in_linear_time(self):
        """10,000 were out of memory after 34 s, where 200 took 0.09 s."""
        for kind in ("one entry", "an entry each"):
            seconds = {}
            for n in (1000, 8000):
                self.write("f.ts", "".join("GOCAD TSurf 1\nHEADER {\nname:s%d\n}\nTFACE\nVRTX 1 %d 0 0\nVRTX 2 %d.3 1 0\nVRTX 3 %d.2 0 1\nTRGL 1 2 3\nEND\n"
                                           % (k, k, k, k) for k in range(n)))
                entries = ['{name: f, kind: fault, file: f.ts, object: "*"}'] if kind == "one entry" else [
                    "{name: f%d, kind: fault, file: f.ts, object: s%d}" % (k, k) for k in range(n)]
                project = self.write("m.yaml", "name: m\nbox: {min: [-1, -1, -1], max: [9000, 2, 2]}\nsurfaces:\n" + "".join("  - %s\n" % e for e in entries))
                seconds[n] = self.seconds_of(project, "--stop-after", "read")
            with self.subTest(kind):
                self.assertLess(seconds[8000], 20 * seconds[1000] + 1)

    def test_many_named_points_on_one_line_are_meshed_in_linear_time(self):
        """200,000 did not end: each point's groups were sought among those of all."""
        seconds = {}
        for n in (5000, 40000):
            points = ", ".join("{name: p%d, at: [0, 0, %.7f]}" % (k, -0.9 + 1.8 * k / n) for k in range(n))
            project = self.write("m.yaml", "name: m\nbox: {min: [-1, -1, -1], max: [1, 1, 1]}\nsurfaces: []\nmesh: {refine: none}\npoints: [%s]\n" % points)
            seconds[n] = self.seconds_of(project, "--quiet")
        self.assertLess(seconds[40000], 15 * seconds[5000])

    def test_a_size_beyond_the_model_is_refused_with_one_that_would_do(self):
        printed = self.refused({"size": 70000}, USAGE)
        self.assertIn("mesh.size: edges of 70,000 are longer than the model, whose longest edge is 1,000; 48 would come to about 100,000", printed)

    def test_a_size_below_a_millionth_of_the_model_is_refused(self):
        self.assertIn("shorter than a millionth of the model", self.refused({"size": 1e-5}, USAGE))
        self.assertIn("mesh.size.units.b", self.refused({"size": {"global": 100, "units": {"b": 1e-9}}}, USAGE))

    def test_a_gradation_that_bounds_nothing_is_refused(self):
        """1.8e308 ended in an internal error: the size a metre from its source was infinite."""
        for gradation, said in (("1.7976931348623157e308", "not graded at all"), ("5e-324", "the same everywhere")):
            self.assertIn(said, self.refused({"size": {"global": 100, "gradation": gradation}}, USAGE))

    def test_fractures_that_would_be_too_many_are_refused_before_one_is_drawn(self):
        """They were drawn one by one, in up to 78 s."""
        base = copy.deepcopy(extreme_numbers.BASES["network"])
        for family, key, value, said in ((0, "radius", {"min": 1e-3, "max": 300, "exponent": 2.5}, "needs about"),
                                         (0, "radius", {"min": 100, "max": 1e30, "exponent": 2.5}, "hardly a disc meets it"),
                                         (1, "radius", "5e-324", "cannot be distinguished from a point")):
            project = copy.deepcopy(base)
            project["fractures"]["families"][family][key] = value
            with self.subTest(said):
                self.assertIn(said, self.refused_project(project, USAGE))

    def test_fractures_that_cross_too_often_are_refused_with_the_number_of_their_crossings(self):
        """Neither a mesh nor a message came within ten minutes."""
        project = copy.deepcopy(extreme_numbers.BASES["network"])
        project["fractures"]["families"][0]["p32"] = 1.0
        printed = self.refused_project(project, CANNOT_MESH)
        self.assertRegex(printed, "cross each other in about 1,[0-9]00,000 lines and 1[0-9],000,000 points")

    def test_a_box_that_no_element_fits_in_is_refused(self):
        """It took 23 s, and all memory."""
        base = dict(extreme_numbers.BASES["background"], box={"min": [0, 0, -1000], "max": ["1e30", 1000, 0]})
        base["surfaces"] = [{**s, "extend": "flat"} for s in base["surfaces"]]  # else the horizons are far too short for it
        self.assertIn("the model is 1,000 thick and 1e+30 long", self.refused_project(base, USAGE))

    def test_a_field_far_larger_than_its_tolerance_is_refused(self):
        """Its cells were bisected up to their limit, in 32 s."""
        base = dict(extreme_numbers.BASES["inputs"])
        base["surfaces"] = [{**s, "spacing": "1e300"} if s["name"] == "top" else s for s in base["surfaces"]]
        self.assertIn("too much to follow a surface in", self.refused_project(base, BAD_INPUT))

    def test_a_model_a_million_times_as_deep_as_wide_is_refused(self):
        """It was not meshed within 100 s, where about 2,000 elements had been told."""
        base = dict(extreme_numbers.BASES["target"])
        base["box"] = {**base["box"], "bottom": -9e8}
        self.assertIn("no mesh has elements for both", self.refused_project(base, USAGE))

    def test_a_field_of_a_thin_sheet_is_refused(self):
        """The first cells of a sheet took 24 GB, cubes as small as it is thin; a surface along a beam of them as much."""
        for spacing in (["1e-4", 100, 100], [1e8, 100, 100]):
            base = dict(extreme_numbers.BASES["inputs"])
            base["surfaces"] = [{**s, "spacing": spacing} if s["name"] == "deep" else s for s in base["surfaces"]]
            with self.subTest(spacing=spacing):
                self.assertIn("too thin a sheet", self.refused_project(base, BAD_INPUT))

    def test_a_field_that_touches_the_top_of_the_box_is_meshed(self):
        """Triangles along the line where it does have two equal corners, beside which continuing did not end."""
        base = dict(extreme_numbers.BASES["inputs"])
        base["surfaces"] = [{**s, "value": "1e-30"} if s["name"] == "top" else s for s in base["surfaces"]]
        text = "".join("%s: %s\n" % (key, extreme_numbers.written(part)) for key, part in {"name": "m", **base}.items())
        status, _, printed = extreme_numbers.run({"project.yaml": text}, self.folder, PROGRAM, extreme_numbers.SECONDS_TO_MESH * SLOWNESS, MEMORY)
        self.assertEqual(status, 0, printed)
        self.assertIn("units of the column have regions", printed)

    def test_a_size_for_too_many_elements_is_refused_at_once_with_their_number(self):
        """Counting stopped soon after the limit before, after a minute of building, and its number was told: 100,000,102."""
        printed = self.refused({"size": 0.3}, CANNOT_MESH)
        self.assertIn("fill the model with about 414,814,814,815 elements, more than the limit of 50,000,000", printed)
        self.assertIn("edges of 6.073 m are the least", printed)


if __name__ == "__main__":
    main()
