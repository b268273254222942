#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads what the writers wrote with other people's readers and compares it with expectations given as JSON.

read_back.py vtk STEM EXPECTED.json | meshio FILE EXPECTED.json | gmsh FILE EXPECTED.json | schema SCHEMA REPORT
Exit 0: agrees; 1: differs (says where); 77: the reader is not installed.
"""
import json
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import meshio_vtu

SKIPPED = 77


def fail(message):
    print(message)
    sys.exit(1)


def expect(what, got, wanted):
    if got != wanted:
        fail(f"{what}: got {got}, expected {wanted}")


def read_vtk(stem, wanted):
    try:
        import vtk
        from vtk.util.numpy_support import vtk_to_numpy
    except ImportError:
        sys.exit(SKIPPED)

    def load(path, reader):
        reader.SetFileName(path)
        reader.Update()
        return reader.GetOutput()

    def names(data, what):
        field = data.GetFieldData()
        found = {}
        for i in range(field.GetNumberOfArrays()):
            if field.GetArray(i) is None:
                fail(f"{field.GetArrayName(i)} is no array of numbers")
            if field.GetArrayName(i).startswith(what + ":"):
                found[int(field.GetArray(i).GetTuple1(0))] = field.GetArrayName(i)[len(what) + 1:]
        return [found[id] for id in sorted(found)]

    def array(attributes, name, type_name):
        found = attributes.GetArray(name)
        if found is None:
            fail(f"no array {name}")
        expect(f"type of {name}", found.GetDataTypeAsString(), type_name)
        return vtk_to_numpy(found)

    grid = load(stem + ".vtu", vtk.vtkXMLUnstructuredGridReader())
    expect("points", grid.GetNumberOfPoints(), wanted["points"])
    expect("tetrahedra", grid.GetNumberOfCells(), wanted["tetrahedra"])
    expect("point type", grid.GetPoints().GetData().GetDataTypeAsString(), "double")
    expect("region names", names(grid, "region"), wanted["regions"])
    region = array(grid.GetCellData(), "region", "int")
    expect("regions", sorted(set(region.tolist())), list(range(1, len(wanted["regions"]) + 1)))
    array(grid.GetPointData(), "kind", "int")
    array(grid.GetPointData(), "input_vertex", "int")
    got = [list(grid.GetPoint(i)) for i in range(grid.GetNumberOfPoints())]
    expect("coordinates", got, wanted["coordinates"])
    faces = load(stem + ".faces.vtp", vtk.vtkXMLPolyDataReader())
    expect("faces", faces.GetNumberOfPolys(), wanted["faces"])
    for name in ("surface", "surface_set", "patch", "region_minus", "region_plus", "source_triangle"):
        array(faces.GetCellData(), name, "int")
    expect("surface names", names(faces, "surface"), wanted["surfaces"])
    curves = load(stem + ".curves.vtp", vtk.vtkXMLPolyDataReader())
    expect("curve edges", curves.GetNumberOfLines(), wanted["curve_edges"])
    expect("marked points", curves.GetNumberOfVerts(), wanted["marked_points"])
    expect("curve names", names(curves, "curve") + names(curves, "point"), wanted["curves"])
    array(curves.GetCellData(), "curve", "int")


def read_meshio(path, wanted):
    try:
        import meshio
        import numpy
    except ImportError:
        sys.exit(SKIPPED)
    mesh = meshio_vtu.mend(meshio).read(path)
    expect("points", len(mesh.points), wanted["points"])
    if path.endswith(".vtu"):
        expect("same coordinates", mesh.points.tolist(), wanted["coordinates"])
        names = {k: int(v[0]) for k, v in mesh.field_data.items() if k.startswith("region:")}
        expect("regions", names, {"region:" + name: i + 1 for i, name in enumerate(wanted["regions"])})
        counts = numpy.bincount(numpy.concatenate(mesh.cell_data["region"]))
        expect("tetrahedra", int(counts.sum()), wanted["tetrahedra"])
        expect("no region is empty", bool((counts[1:] > 0).all()), True)
        return
    expect("coordinates", sorted(mesh.points.tolist()), sorted(wanted["coordinates"]))
    count = lambda kind: sum(len(c.data) for c in mesh.cells if c.type == kind)
    expect("tetrahedra", count("tetra"), wanted["tetrahedra"])
    if path.endswith(".msh"):
        expect("faces", count("triangle"), wanted["faces"])
        expect("names", sorted(mesh.field_data), sorted(wanted["groups"]))
        for name, (tag, dimension) in ((n, v.tolist()) for n, v in mesh.field_data.items()):
            kind = {0: "vertex", 1: "line", 2: "triangle", 3: "tetra"}[dimension]
            tags = [mesh.cell_data["gmsh:physical"][i] for i, c in enumerate(mesh.cells) if c.type == kind]
            expect(f"elements of {name}", int(sum((t == tag).sum() for t in tags)), wanted["groups"][name])
        return
    for name, n in wanted["groups"].items():
        sets = {k: sum(0 if s is None else len(s) for s in v) for k, v in mesh.cell_sets.items()}
        nodes = {k: len(v) for k, v in mesh.point_sets.items()}
        expect(f"set {name}", sets.get(name, nodes.get(name)), n)


def read_gmsh(path, wanted):
    import os
    import re
    import shutil
    import subprocess
    import tempfile

    if not shutil.which("gmsh"):
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "again.msh")
        # Gmsh reads, then writes the old format 2.2, where counts and names are easy to see.
        run = subprocess.run(["gmsh", path, "-0", "-format", "msh22", "-o", out], capture_output=True, text=True, timeout=100)
        if run.returncode or re.search(r"(?m)^Error", run.stdout + run.stderr):
            fail(run.stdout + run.stderr)
        lines = open(out).read().splitlines()
    at = lines.index("$PhysicalNames")
    names = {}
    for line in lines[at + 2:at + 2 + int(lines[at + 1])]:
        dimension, tag, name = line.split(None, 2)
        names[(int(dimension), int(tag))] = name.strip('"')
    expect("names", sorted(names.values()), sorted(wanted["groups"]))
    at = lines.index("$Elements")
    counts = dict.fromkeys(wanted["groups"], 0)
    for line in lines[at + 2:at + 2 + int(lines[at + 1])]:
        row = [int(w) for w in line.split()]
        counts[names[({15: 0, 1: 1, 2: 2, 4: 3}[row[1]], row[3])]] += 1
    expect("elements by group", counts, wanted["groups"])


def check_schema(schema, report):
    try:
        import jsonschema
    except ImportError:
        sys.exit(SKIPPED)
    try:
        jsonschema.Draft7Validator.check_schema(json.load(open(schema)))
        jsonschema.validate(json.load(open(report)), json.load(open(schema)))
    except jsonschema.exceptions.ValidationError as error:
        fail(f"{list(error.absolute_path)}: {error.message}")


what, first, second = sys.argv[1:4]
if what == "schema":
    check_schema(first, second)
else:
    {"vtk": read_vtk, "meshio": read_meshio, "gmsh": read_gmsh}[what](first, json.load(open(second)))
