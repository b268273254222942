#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Starter inputs, run as they are written; heat through three layers in three solvers against the analytic answer."""
import configparser
import os
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree as tree

import format_readers as readers
from geomesh_program import ProgramTest, level, main

CONDUCTIVITY = {"top": 1.0, "middle": 2.0, "bottom": 4.0}
THICKNESS = {"top": 3.0, "middle": 3.0, "bottom": 4.0}
ABOVE, BELOW = 10.0, 100.0  # as the starters have it


def temperature(z):
    """At height z of 0 to 10: through layers in series the flux is the same."""
    flux = (BELOW - ABOVE) / sum(THICKNESS[u] / CONDUCTIVITY[u] for u in CONDUCTIVITY)
    value, top = ABOVE, 10.0
    for unit in ("top", "middle", "bottom"):
        part = min(THICKNESS[unit], max(0.0, top - z))
        value += flux * part / CONDUCTIVITY[unit]
        top -= THICKNESS[unit]
    return value


class Starters(ProgramTest):
    def model(self, formats, size=3):
        for name, z in (("upper", 7), ("lower", 4)):
            self.write(name + ".ts", level(name, z))
        attributes = "".join("  %s: {conductivity: %g, density: 2500, vp: 4000, vs: 2200}\n" % item for item in CONDUCTIVITY.items())
        self.write("project.yaml", "name: model\nbox: {min: [0, 0, 0], max: [10, 10, 10]}\nsurfaces:\n  - {name: upper, kind: horizon, file: upper.ts}\n"
                   "  - {name: lower, kind: horizon, file: lower.ts}\ncolumn: [top, upper, middle, lower, bottom]\nattributes:\n%smesh: {size: %g}\n"
                   "output: {directory: ., formats: [%s], starter: true}\n" % (attributes, size, formats))
        self.run_program("project.yaml")

    def run_tool(self, *command, timeout=300):
        done = subprocess.run(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=timeout)
        self.assertEqual(done.returncode, 0, done.stdout[-3000:])
        return done.stdout

    @unittest.skipUnless(shutil.which("ccx"), "skipped: calculix-ccx is not installed")
    def test_calculix_runs_the_starter_as_written_to_the_analytic_answer(self):
        self.model("inp")
        self.assertNotIn("*ERROR", self.run_tool("ccx", "model.job"))
        place, found, reading = {}, {}, None
        with open(self.path("model.job.frd")) as file:
            for line in file:
                if line.startswith("    2C"):
                    reading = "nodes"
                elif line.startswith(" -4  NDTEMP"):
                    reading = "heat"
                elif line.startswith(" -3"):
                    reading = None
                elif line.startswith(" -1") and reading == "nodes":
                    place[int(line[3:13])] = float(line[37:49])
                elif line.startswith(" -1") and reading == "heat":
                    found[int(line[3:13])] = float(line[13:25])
        self.assertGreater(len(found), 100)
        for node, value in found.items():
            self.assertAlmostEqual(value, temperature(place[node]), delta=0.01)

    def test_dolfinx_runs_the_starter_as_written_to_the_analytic_answer(self):
        if subprocess.run([sys.executable, "-c", "import dolfinx"], stderr=subprocess.DEVNULL).returncode:
            self.skipTest("skipped: python3-dolfinx is not installed")
        self.model("xdmf")
        self.assertIn("temperature from", self.run_tool(sys.executable, "model.dolfinx.py"))
        self.assertTrue(os.path.exists(self.path("model.temperature.xdmf")))
        self.write("judge.py", "import runpy\nscript = runpy.run_path('model.dolfinx.py')\nmesh, regions, t = script['solve']()\n"
                   "x = t.function_space.tabulate_dof_coordinates()\nprint('ROWS', *['%.17g:%.17g' % (z, v) for z, v in zip(x[:, 2], t.x.array.real)])\n"
                   "print('TAGS', *sorted(set(regions.values.tolist())))\n")
        output = self.run_tool(sys.executable, "judge.py").splitlines()
        rows = [tuple(map(float, word.split(":"))) for line in output if line.startswith("ROWS") for word in line.split()[1:]]
        self.assertGreater(len(rows), 50)
        for z, value in rows:
            self.assertAlmostEqual(value, temperature(z), delta=1e-4)
        self.assertEqual(next(line for line in output if line.startswith("TAGS")), "TAGS 1 2 3")

    def test_opengeosys_starter_names_the_meshes_and_materials_that_are_there(self):
        self.model("ogs")
        root = tree.parse(self.path("model.ogs.prj")).getroot()
        meshes = [m.text for m in root.find("meshes")]
        for mesh in meshes:
            self.assertTrue(os.path.exists(self.path(mesh)), mesh)
        self.assertEqual(meshes[0], "model.ogs.vtu")
        self.assertEqual({c.find("mesh").text + ".vtu" for c in root.iter("boundary_condition")}, set(meshes[1:]))
        self.assertEqual(sorted(meshes[1:]), ["model.ogs.zmax.vtu", "model.ogs.zmin.vtu"])
        names = {int(g["name"]): g["full_name"] for g in self.report(self.path("model.ogs.vtu.json"))["groups"] if g["type"] == "MaterialIDs"}
        for medium in root.iter("medium"):
            values = {p.find("name").text: float(p.find("value").text) for p in medium.iter("property")}
            self.assertEqual(values["diffusion"], CONDUCTIVITY[names.pop(int(medium.get("id")))])
        self.assertEqual(names, {})
        parameters = {p.find("name").text for p in root.iter("parameter") if p.find("name") is not None}
        self.assertLessEqual({c.find("parameter").text for c in root.iter("boundary_condition")}, parameters)

    def test_pylith_starter_names_blocks_and_node_sets_of_the_exodus_file(self):
        self.model("exodus")
        config = configparser.ConfigParser(strict=False, interpolation=None)
        config.read(self.path("model.pylith.cfg"))
        materials = [s for s in config.sections() if s.startswith("pylithapp.problem.materials.")]
        groups = self.report(self.path("model.e.json"))["groups"]
        blocks = {g["id"]: g["name"] for g in groups if g["type"] == "element block"}
        self.assertEqual({int(config[s]["label_value"]): config[s]["description"] for s in materials}, blocks)
        for section in materials:
            self.assertEqual(config[section]["db_auxiliary_field.data"], "[2500*kg/m**3, 2200*m/s, 4000*m/s]")
        nodes = {g["id"]: g["name"] for g in groups if g["type"] == "node set"}
        held = {s.rsplit(".", 1)[1]: (config[s]["label"], int(config[s]["label_value"])) for s in config.sections() if ".bc." in s}
        self.assertEqual({k: v[0] for k, v in held.items()}, {"above": "zmax", "below": "zmin"})
        for name, number in held.values():
            self.assertEqual(nodes[number], name)

    def test_what_the_project_does_not_give_is_said_in_the_starter(self):
        self.write("upper.ts", level("upper", 5))
        self.write("project.yaml", "name: model\nbox: {min: [0, 0, 0], max: [10, 10, 10]}\nsurfaces:\n  - {name: upper, kind: horizon, file: upper.ts}\n"
                   "column: [top, upper, bottom]\nattributes:\n  top: {conductivity: 3}\noutput: {directory: ., formats: [inp], starter: true}\n")
        self.run_program("project.yaml")
        with open(self.path("model.job.inp")) as file:
            text = file.read()
        self.assertIn("** top: conductivity from the project; density not given", text)
        self.assertIn("** bottom: conductivity not given", text)

    @unittest.skipUnless(shutil.which("laplacianFoam"), "skipped: openfoam is not installed")
    def test_openfoam_solves_heat_through_three_layers(self):
        self.model("openfoam, vtu", size=1)
        case = self.path("model.foam")
        mesh = self.foam_mesh(case)
        head = "FoamFile { version 2.0; format ascii; class %s; object %s; }\n"
        patches = {name: "fixedValue; value uniform %g" % value for name, value in (("zmax", ABOVE), ("zmin", BELOW))}
        sides = "".join("%s { type %s; }\n" % (name, patches.get(name, "zeroGradient")) for name in mesh["patches"])
        values = "\n".join("%g" % CONDUCTIVITY[mesh["zone"][c]] for c in range(mesh["cells"]))
        files = {
            "0/T": head % ("volScalarField", "T") + "dimensions [0 0 0 1 0 0 0];\ninternalField uniform 50;\nboundaryField {\n%s}\n" % sides,
            "0/DT": head % ("volScalarField", "DT") + "dimensions [0 2 -1 0 0 0 0];\ninternalField nonuniform List<scalar> %d\n(\n%s\n);\nboundaryField {\n%s}\n" % (
                mesh["cells"], values, "".join("%s { type zeroGradient; }\n" % name for name in mesh["patches"])),
            "constant/transportProperties": head % ("dictionary", "transportProperties") + "DT DT [0 2 -1 0 0 0 0] 1;\n",
            "system/controlDict": head % ("dictionary", "controlDict") + "application laplacianFoam; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; "
                                  "writeControl timeStep; writeInterval 1; writeFormat ascii; writePrecision 10; timeFormat general;\n",
            "system/fvSchemes": head % ("dictionary", "fvSchemes") + "ddtSchemes { default steadyState; } gradSchemes { default leastSquares; } divSchemes { default none; }\n"
                                "laplacianSchemes { default Gauss harmonic corrected; } interpolationSchemes { default linear; } snGradSchemes { default corrected; }\n",
            "system/fvSolution": head % ("dictionary", "fvSolution") + "solvers { T { solver PCG; preconditioner DIC; tolerance 1e-12; relTol 0; } }\n"
                                 "SIMPLE { nNonOrthogonalCorrectors 30; }\n",
        }
        for name, text in files.items():
            path = os.path.join(case, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "w") as file:
                file.write(text)
        environment = dict(os.environ, WM_PROJECT_DIR=os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam"))
        done = subprocess.run(["laplacianFoam", "-case", case], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300, env=environment)
        self.assertEqual(done.returncode, 0, done.stdout[-2000:])
        with open(os.path.join(case, "1", "T")) as file:
            text = file.read().split("internalField")[1]
        found = [float(v) for v in text[text.index("(") + 1:text.index(")")].split()]
        self.assertEqual(len(found), mesh["cells"])
        errors = [abs(value - temperature(z)) for value, z in zip(found, mesh["heights"])]
        # Two-point fluxes between cells of different conductivity are of first order; the mean is far better than the worst.
        self.assertLess(sum(errors) / len(errors), 0.01 * (BELOW - ABOVE))
        self.assertLess(max(errors), 0.06 * (BELOW - ABOVE))

    def foam_mesh(self, case):
        """Patches, zone and height of each cell, from the files of polyMesh."""
        def entries(name):
            with open(os.path.join(case, "constant", "polyMesh", name)) as file:
                return file.read()

        def rows(text):
            body = text[text.index("\n(") + 2:text.rindex(")")]
            return [r.strip("( )") for r in body.strip().splitlines()]
        points = [tuple(map(float, r.split())) for r in rows(entries("points"))]
        faces = [tuple(map(int, r.split("(")[1].split())) for r in rows(entries("faces"))]
        owner, neighbour = ([int(r) for r in rows(entries(name))] for name in ("owner", "neighbour"))
        corners = {}
        for f, cell in list(enumerate(owner)) + list(enumerate(neighbour)):
            corners.setdefault(cell, set()).update(faces[f])
        zone = {}
        text = entries("cellZones")
        for name in CONDUCTIVITY:
            part = text[text.index("\n" + name + "\n"):]
            for cell in part[part.index("(") + 1:part.index(")")].split():
                zone[int(cell)] = name
        import re
        patches = re.findall(r"(?m)^\s*(\w+)\s*\{\s*type patch", entries("boundary"))
        return {"cells": len(corners), "zone": zone, "patches": patches, "heights": [sum(points[p][2] for p in corners[c]) / 4 for c in range(len(corners))]}


class Fields(ProgramTest):
    """Properties from files: exact where they are linear."""

    def model(self, fields, extra=""):
        self.write("upper.ts", level("upper", 5))
        self.write("project.yaml", "name: model\nbox: {min: [0, 0, 0], max: [10, 10, 10]}\nsurfaces:\n  - {name: upper, kind: horizon, file: upper.ts}\n"
                   "column: [top, upper, bottom]\nmesh: {size: 3}\noutput: {directory: ., formats: [vtu], fields: {%s}%s}\n" % (fields, extra))
        return self.run_program("project.yaml", status=None)

    def arrays(self, path):
        try:
            meshio = readers.need("meshio")
        except readers.ReaderMissing:
            self.skipTest("skipped: python3-meshio is not installed")
        mesh = meshio.read(path)
        return mesh, mesh.points[mesh.cells[0].data].mean(axis=1)

    def write_grid(self):
        """value = 0.1 + 0.01 x + 0.02 y on the map, as an Esri grid whose cells are centred on 0, 1, ... 10."""
        rows = [" ".join("%.10g" % (0.1 + 0.01 * x + 0.02 * y) for x in range(-1, 12)) for y in range(11, -2, -1)]
        self.write("poro.asc", "ncols 13\nnrows 13\nxllcorner -1.5\nyllcorner -1.5\ncellsize 1\nNODATA_value -9999\n" + "\n".join(rows) + "\n")

    def write_points(self):
        lines = ["x y z k"] + ["%g %g %g %.17g" % (x, y, z, x + 2 * y - z) for x in (0, 5, 10) for y in (0, 5, 10) for z in (0, 5, 10)]
        self.write("perm.xyz", "\n".join(lines) + "\n")

    def test_a_grid_onto_cells_and_points_in_space_onto_points(self):
        self.write_grid()
        self.write_points()
        self.model("porosity: {file: poro.asc, unit: '1'}, k: {file: perm.xyz, on: points, unit: mD}")
        self.assertEqual(self.last_status, 0)
        mesh, centres = self.arrays(self.path("model.vtu"))
        for value, (x, y, _) in zip(mesh.cell_data["porosity"][0], centres):
            self.assertAlmostEqual(value, 0.1 + 0.01 * x + 0.02 * y, delta=1e-6)
        for value, (x, y, z) in zip(mesh.point_data["k"], mesh.points):
            self.assertAlmostEqual(value, x + 2 * y - z, delta=1e-9)
        fields = {f["name"]: f for f in self.report(self.path("model.vtu.json"))["fields"]}
        self.assertEqual(fields, {"porosity": {"name": "porosity", "on": "cells", "unit": "1"}, "k": {"name": "k", "on": "points", "unit": "mD"}})

    def test_an_origin_is_added_before_the_file_is_asked_and_written_down(self):
        self.write_grid()
        self.model("porosity: {file: poro.asc}", ", origin: [4, 2, 1]")
        self.assertEqual(self.last_status, 0)
        mesh, centres = self.arrays(self.path("model.vtu"))
        for value, (x, y, _) in zip(mesh.cell_data["porosity"][0], centres):
            self.assertAlmostEqual(value, 0.1 + 0.01 * (x + 4) + 0.02 * (y + 2), delta=1e-6)
        self.assertEqual(self.report(self.path("model.vtu.json"))["origin"], [4, 2, 1])

    def test_convert_adds_fields_too(self):
        self.write_grid()
        self.model("")
        self.run_program("convert", "model.vtu", "-o", "again.vtu", "--field", "porosity=poro.asc", "--point-field", "p2=poro.asc")
        mesh, centres = self.arrays(self.path("again.vtu"))
        self.assertIn("p2", mesh.point_data)
        self.assertAlmostEqual(mesh.cell_data["porosity"][0][0], 0.1 + 0.01 * centres[0][0] + 0.02 * centres[0][1], delta=1e-6)

    def test_files_without_values_are_refused(self):
        self.write("empty.xyz", "x y z v\n")
        self.assertIn("values", self.model("k: {file: empty.xyz}"))
        self.assertEqual(self.last_status, 3)
        self.assertIn("one grid", self.model("k: {file: upper.ts}"))
        self.assertEqual(self.last_status, 3)
        self.model("region: {file: empty.xyz}")
        self.assertEqual(self.last_status, 2)


if __name__ == "__main__":
    main()
