#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""geomesh check --project of files for solvers: what stands under each name there is what stands under it in the .vtu beside."""
import json
import os
import re
import shutil

from geomesh_program import ProgramTest, has_module, level, main, triangles_ts

MODEL = {
    "name": "m", "box": {"min": [0, 0, 0], "max": [10, 10, 10]},
    "surfaces": [{"name": "h", "kind": "horizon", "file": "h.ts"}, {"name": "f", "kind": "fault", "file": "f.ts"}],
    "column": ["upper", "h", "lower"], "groups": {"all": ["upper", "lower"]}, "wells": [{"name": "w", "file": "w.pl"}],
    "points": [{"name": "gauge", "at": [2, 2, 2]}], "mesh": {"size": 2.5},
}
ENDINGS = {"msh": ".msh", "msh22": ".msh", "inp": ".inp", "exodus": ".e", "med": ".med"}


class SolverFilesChecked(ProgramTest):
    def setUp(self):
        """Fault f ends inside `lower`, on both sides of which nothing else differs."""
        super().setUp()
        self.write("h.ts", level("h", 6.3, -1, 11))
        self.write("f.ts", triangles_ts("f", [(2.5, 3, 1.5), (7.5, 3.5, 1.5), (7.5, 3.5, 4.5), (2.5, 3, 4.5)], [(0, 1, 2), (0, 2, 3)]))
        self.write("w.pl", "GOCAD PLine 1\nHEADER {\nname:w\n}\nILINE\nVRTX 1 8 8 10\nVRTX 2 8 8 4\nSEG 1 2\nEND\n")

    def mesh(self, form, **output):
        self.project = self.write("m.yaml", json.dumps({**MODEL, "output": {"directory": "out", "formats": ["vtu", form], **output}}))
        shutil.rmtree(self.path("out"), ignore_errors=True)
        self.run_program(self.project)
        return self.path("out", "m" + ENDINGS[form])

    def checked(self, mesh, status=0):
        return self.check(mesh, "--project", self.project, status=status)

    def assert_passes(self, mesh):
        report = self.checked(mesh)
        self.assertIn("what stands under each name was held against m.vtu", " ".join(report["checks_done"]))
        self.assertEqual(report["faults"], [])
        self.assertEqual({region["name"] for region in report["regions"]}, {"upper", "lower"})

    def faults_after(self, form, change, **output):
        """What is told, in one text, once `change` had its way with the text of the file."""
        mesh = self.mesh(form, **output)
        with open(mesh, encoding="utf-8") as file:
            text = file.read()
        changed = change(text)
        self.assertNotEqual(changed, text)
        with open(mesh, "w", encoding="utf-8") as file:
            file.write(changed)
        return "\n".join(fault["what"] for fault in self.checked(mesh, status=3)["faults"] if fault["id"] == "not_as_in_vtu")

    @staticmethod
    def first_line_after(text, head):
        """The line after this one, and the text without it."""
        before, after = text.split(head)
        line, rest = after.split("\n", 1)
        return line, before + head + rest

    def forms(self):
        return [form for form in ENDINGS if has_module(form)]

    def test_what_is_written_passes(self):
        for form in self.forms():
            for output in ({}, {"order": 2}, {"groups": "pieces"}, {"inner_faces": False}, {"curves": False}, {"split": ["f"]}, {"origin": [100, 50, 5]}):
                with self.subTest(f"{form} {output}"):
                    self.assert_passes(self.mesh(form, **output))

    def test_a_fault_inside_a_unit_is_seen_without_a_vtu(self):
        """Regions do not tell of it, the file's own triangles do."""
        mesh = self.mesh("msh")
        for name in os.listdir(self.path("out")):
            if not name.startswith("m.msh"):
                os.remove(self.path("out", name))
        self.assertIn("names were not held against m.vtu: it is not there", self.checked(mesh)["checks_done"])

    def test_a_vtu_of_another_tool_tells_nothing_of_names(self):
        mesh = self.mesh("msh")
        os.remove(self.path("out", "m.vtu.json"))
        self.assertIn("no file of geomesh, with m.vtu.json beside it", " ".join(self.checked(mesh)["checks_done"]))

    def test_names_exchanged(self):
        def exchange(a, b):
            return lambda text: re.sub(f"\\b({a}|{b})\\b", lambda found: b if found.group() == a else a, text)

        self.assertIn("elements of region 'upper' are here or in m.vtu alone", self.faults_after("msh", exchange("upper", "lower")))
        self.assertIn("faces of surface 'xmin' are here or in m.vtu alone", self.faults_after("msh", exchange("xmin", "xmax")))
        self.assertIn("elements of region 'upper' are here or in m.vtu alone", self.faults_after("inp", exchange("upper", "lower")))
        self.assertIn("faces of surface 'xmin' are here or in m.vtu alone", self.faults_after("inp", exchange("xmin", "xmax")))

    def test_a_name_that_is_gone(self):
        told = self.faults_after("inp", lambda text: text.replace("NSET=w\n", "NSET=other\n"))
        self.assertIn("nodes of 'w' are in m.vtu, and nothing has that name here", told)
        self.assertIn("nodes of 'other' are here, and nothing has that name in m.vtu", told)

    def test_an_element_in_another_set(self):
        """The first element of `lower` goes to the end of `upper`."""
        head = "*ELEMENT, TYPE=C3D4, ELSET=lower\n"

        def move(text):
            line, rest = self.first_line_after(text, head)
            return rest.replace(head, line + "\n" + head)

        told = self.faults_after("inp", move)
        self.assertIn("1 elements of region 'upper' are here or in m.vtu alone", told)
        self.assertIn("1 elements of region 'lower' are here or in m.vtu alone", told)

    def test_a_face_that_is_gone(self):
        def drop(text):
            return self.first_line_after(text, "*SURFACE, NAME=xmin.faces, TYPE=ELEMENT\n")[1]

        self.assertIn("1 faces of surface 'xmin' are here or in m.vtu alone", self.faults_after("inp", drop))

    def test_a_node_in_the_middle_of_an_edge_that_is_elsewhere(self):
        """The last node of a file of second order, by a hair of its x."""
        def move(text):
            lines = text.split("\n")
            row = next(k for k in range(3, len(lines)) if lines[k].startswith("*")) - 1
            number, x, *others = lines[row].split(",")
            lines[row] = ",".join([number, " " + repr(float(x) + 1e-9), *others])
            return "\n".join(lines)

        self.assertIn("nodes in the middle of edges are here or in m.vtu alone", self.faults_after("inp", move, order=2))

    def test_a_node_that_is_elsewhere(self):
        def move(text):
            number = re.search(r"\*NODE[^\n]*\n(?:[^*\n][^\n]*\n)*?\s*(\d+),\s*10,\s*10,\s*10\s*\n", text).group(1)
            return re.sub(rf"(\n\s*{number},\s*10,\s*10,\s*)10\s*\n", r"\g<1>10.000001\n", text)

        self.assertIn("1 points are at no point of m.vtu", self.faults_after("inp", move))


if __name__ == "__main__":
    main()
