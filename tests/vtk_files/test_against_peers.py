#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Our readers of VTK's files against VTK's own and meshio's, value by value.

Files are written by VTK (every data mode, compressor, header type and byte order; legacy files of both layouts of cells) and by meshio.
What vtk_dump, which is our readers, finds in each is compared with what VTK's reader finds: points, cells, types of cells, and every
array with its type, without a tolerance. Files that are cut off or changed anywhere are refused or read, and never end the program.
"""
import itertools
import json
import os
import random
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
except ImportError as reason:
    print("skipped: no VTK for Python (%s)" % reason)
    sys.exit(0)
try:
    import meshio
except ImportError:
    meshio = None

DUMP = os.environ["GEOMESH_VTK_DUMP"]
NUMBERS = {"int8": (vtk.vtkSignedCharArray, -128, 127), "uint8": (vtk.vtkUnsignedCharArray, 0, 255), "int16": (vtk.vtkShortArray, -2**15, 2**15 - 1),
           "uint16": (vtk.vtkUnsignedShortArray, 0, 2**16 - 1), "int32": (vtk.vtkIntArray, -2**31, 2**31 - 1),
           "uint32": (vtk.vtkUnsignedIntArray, 0, 2**32 - 1), "int64": (vtk.vtkLongArray, -2**62, 2**62), "uint64": (vtk.vtkUnsignedLongArray, 0, 2**63)}
ODD_NAME = "double \u00e9 100% (x)"  # VTK does not escape what XML reserves
# Corners of types of cells; 0: any number from the least.
GRID_TYPES = {1: 1, 3: 2, 5: 3, 7: 0, 9: 4, 10: 4, 12: 8, 13: 6, 14: 5, 21: 3, 22: 6, 24: 10}


def dump(paths):
    done = subprocess.run([DUMP] + paths, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if done.returncode != 0:
        raise AssertionError("vtk_dump ended with %d: %s" % (done.returncode, done.stderr[-500:]))
    return [json.loads(line) for line in done.stdout.decode().splitlines()]


def text_of(quoted):
    return quoted.encode("latin-1").decode("utf-8", "surrogateescape")


class Maker:
    """Data sets with arrays of all types."""

    def __init__(self, seed):
        self.dice = random.Random(seed)

    def points(self, n, kind):
        points = vtk.vtkPoints()
        points.SetDataType(kind)
        for _ in range(n):
            points.InsertNextPoint([self.dice.uniform(-1, 1) * 10 ** self.dice.randint(-3, 6) for _ in range(3)])
        return points

    def numbers(self, name, n, components, make, least=None, most=None):
        array = make()
        array.SetName(name)
        array.SetNumberOfComponents(components)
        for _ in range(n):
            for _ in range(components):
                value = self.dice.uniform(-1e6, 1e6) if least is None else self.dice.choice([least, most, self.dice.randint(least, most)])
                array.InsertNextValue(value)
        return array

    def add_arrays(self, data, n, with_texts):
        for name, (make, least, most) in NUMBERS.items():
            data.AddArray(self.numbers(name, n, self.dice.choice([1, 2, 3]), make, least, most))
        data.AddArray(self.numbers("single", n, self.dice.choice([1, 3]), vtk.vtkFloatArray))
        data.AddArray(self.numbers(ODD_NAME, n, 1, vtk.vtkDoubleArray))
        data.AddArray(self.numbers("bits", n, 1, vtk.vtkBitArray, 0, 1))
        data.AddArray(self.numbers("ids", n, 1, vtk.vtkIdTypeArray, 0, 1000))
        if with_texts:
            texts = vtk.vtkStringArray()
            texts.SetName("words")
            for i in range(n):
                texts.InsertNextValue("%s %d" % (self.dice.choice(["Kalk", "salt & clay", "x" * 70, "a"]), i))
            data.AddArray(texts)

    def fill(self, data, with_texts):
        self.add_arrays(data.GetPointData(), data.GetNumberOfPoints(), False)
        self.add_arrays(data.GetCellData(), data.GetNumberOfCells(), with_texts)
        self.add_arrays(data.GetFieldData(), 3, with_texts)
        return data

    def corners(self, n, n_points):
        ids = vtk.vtkIdList()
        for i in self.dice.sample(range(n_points), n):
            ids.InsertNextId(i)
        return ids

    def grid(self, with_texts=True, n_points=40, n_cells=30):
        grid = vtk.vtkUnstructuredGrid()
        grid.SetPoints(self.points(n_points, self.dice.choice([vtk.VTK_FLOAT, vtk.VTK_DOUBLE])))
        for _ in range(n_cells):
            kind = self.dice.choice(list(GRID_TYPES))
            grid.InsertNextCell(kind, self.corners(GRID_TYPES[kind] or self.dice.randint(3, 7), n_points))
        return self.fill(grid, with_texts)

    def poly(self, with_texts=True, n_points=40):
        poly = vtk.vtkPolyData()
        poly.SetPoints(self.points(n_points, self.dice.choice([vtk.VTK_FLOAT, vtk.VTK_DOUBLE])))
        for put, least, most in ((poly.SetVerts, 1, 3), (poly.SetLines, 2, 5), (poly.SetPolys, 3, 6), (poly.SetStrips, 3, 6)):
            cells = vtk.vtkCellArray()
            for _ in range(self.dice.randint(0, 8)):
                cells.InsertNextCell(self.corners(self.dice.randint(least, most), n_points))
            put(cells)
        return self.fill(poly, with_texts)


def values_of(array):
    if isinstance(array, vtk.vtkStringArray):
        return [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    if isinstance(array, vtk.vtkBitArray):
        return [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    return vtk_to_numpy(array).reshape(-1).tolist()


def table_of(data):
    table = {}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(i)
        table[array.GetName()] = (array.GetNumberOfComponents(), values_of(array))
    return table


def cells_of(data):
    ids = vtk.vtkIdList()
    cells = []
    for i in range(data.GetNumberOfCells()):
        data.GetCellPoints(i, ids)
        kind = data.GetCellType(i)
        cells.append((kind, [ids.GetId(k) for k in range(ids.GetNumberOfIds())]))
    return cells


class AgainstPeers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        os.makedirs(os.environ.get("GEOMESH_WORK_DIR", "."), exist_ok=True)
        cls.folder = tempfile.TemporaryDirectory(dir=os.environ.get("GEOMESH_WORK_DIR"))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def compare_table(self, path, ours, theirs):
        found = {text_of(c["name"]): (c["components"], [text_of(v) for v in c["values"]] if c["type"] == "string" else c["values"]) for c in ours}
        self.assertEqual(set(found), set(theirs), path)
        for name in theirs:
            if found[name] != theirs[name]:  # NaN is not itself
                self.assertEqual(found[name][0], theirs[name][0], "%s: components of %s" % (path, name))
                numpy.testing.assert_array_equal(found[name][1], theirs[name][1], "%s: %s" % (path, name))

    def compare(self, path, ours, data):
        self.assertNotIn("error", ours, "%s: %s" % (path, ours.get("error")))
        points = vtk_to_numpy(data.GetPoints().GetData()).astype(float).reshape(-1).tolist() if data.GetNumberOfPoints() else []
        self.assertEqual(ours["points"], points, path)
        first = ours["first"]
        self.assertEqual([(t, ours["corners"][first[i]:first[i + 1]]) for i, t in enumerate(ours["types"])], cells_of(data), path)
        self.compare_table(path, ours["point_data"], table_of(data.GetPointData()))
        self.compare_table(path, ours["cell_data"], table_of(data.GetCellData()))
        self.compare_table(path, ours["field_data"], table_of(data.GetFieldData()))

    def write_xml(self, data, path, mode, compressor, header, order):
        writer = vtk.vtkXMLPolyDataWriter() if data.IsA("vtkPolyData") else vtk.vtkXMLUnstructuredGridWriter()
        {"ascii": writer.SetDataModeToAscii, "binary": writer.SetDataModeToBinary}.get(mode, writer.SetDataModeToAppended)()
        writer.SetEncodeAppendedData(mode == "base64")
        writer.SetCompressorType(compressor)
        writer.SetHeaderType(header)
        writer.SetBlockSize(512)
        (writer.SetByteOrderToBigEndian if order == "big" else writer.SetByteOrderToLittleEndian)()
        writer.SetFileName(path)
        writer.SetInputData(data)
        self.assertEqual(writer.Write(), 1)

    def read_by_vtk(self, path):
        if path.endswith(".vtk"):
            reader = vtk.vtkPolyDataReader() if "poly" in os.path.basename(path) else vtk.vtkUnstructuredGridReader()
            reader.ReadAllScalarsOn(), reader.ReadAllVectorsOn(), reader.ReadAllFieldsOn(), reader.ReadAllNormalsOn()
            reader.ReadAllTensorsOn(), reader.ReadAllTCoordsOn(), reader.ReadAllColorScalarsOn()
        else:
            reader = vtk.vtkXMLPolyDataReader() if path.endswith(".vtp") else vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(path)
        reader.Update()
        return reader.GetOutput()

    def compare_all(self, paths, least):
        self.assertGreaterEqual(len(paths), least)
        for path, ours in zip(paths, dump(paths)):
            self.compare(path, ours, self.read_by_vtk(path))

    def test_xml_files_of_vtk_in_every_encoding(self):
        paths = []
        makers = (("grid", "vtu"), ("poly", "vtp"))
        for (kind, ending), mode, compressor, header, order in itertools.product(
                makers, ("ascii", "binary", "raw", "base64"), range(4), (32, 64), ("little", "big")):
            path = self.path("%s_%s_%d_%d_%s.%s" % (kind, mode, compressor, header, order, ending))
            maker = Maker(path.rsplit("/", 1)[1])
            self.write_xml(maker.grid() if kind == "grid" else maker.poly(), path, mode, compressor, header, order)
            paths.append(path)
        self.compare_all(paths, 128)

    def test_xml_files_of_several_pieces_and_of_none(self):
        maker, paths = Maker("pieces"), []
        for mode in ("ascii", "binary", "raw", "base64"):
            path = self.path("several_%s.vtu" % mode)
            writer = vtk.vtkXMLUnstructuredGridWriter()
            {"ascii": writer.SetDataModeToAscii, "binary": writer.SetDataModeToBinary}.get(mode, writer.SetDataModeToAppended)()
            writer.SetEncodeAppendedData(mode == "base64")
            writer.SetFileName(path)
            writer.SetInputData(maker.grid(n_points=200, n_cells=90))
            writer.SetNumberOfPieces(3)
            writer.Write()
            paths.append(path)
            for name, empty in (("empty_%s.vtu" % mode, vtk.vtkUnstructuredGrid()), ("empty_%s.vtp" % mode, vtk.vtkPolyData())):
                self.write_xml(empty, self.path(name), mode, 1, 64, "little")
                paths.append(self.path(name))
        self.compare_all(paths, 12)

    def test_legacy_files_of_vtk(self):
        paths = []
        for kind, version, binary, round_ in itertools.product(("grid", "poly"), (42, 51), (False, True), range(8)):
            path = self.path("%s_%d_%d_%d.vtk" % (kind, version, binary, round_))
            maker = Maker(path.rsplit("/", 1)[1])
            data = maker.grid() if kind == "grid" else maker.poly()
            self.set_attributes(data.GetPointData(), round_)
            self.set_attributes(data.GetCellData(), round_)
            writer = vtk.vtkPolyDataWriter() if kind == "poly" else vtk.vtkUnstructuredGridWriter()
            writer.SetFileVersion(version)
            (writer.SetFileTypeToBinary if binary else writer.SetFileTypeToASCII)()
            writer.SetFileName(path)
            writer.SetInputData(data)
            self.assertEqual(writer.Write(), 1)
            paths.append(path)
        self.compare_all(paths, 64)

    def set_attributes(self, data, round_):
        """Scalars, vectors, normals, tensors and texture coordinates are written by keywords of their own."""
        if round_ % 2 == 0:
            data.SetActiveScalars("int16")
        maker, n = Maker(round_), data.GetArray(0).GetNumberOfTuples()
        for name, components, activate in (("vec", 3, data.SetActiveVectors), ("nor", 3, data.SetActiveNormals), ("ten", 9, data.SetActiveTensors),
                                           ("tex", 2, data.SetActiveTCoords)):
            if maker.dice.random() < 0.5:
                data.AddArray(maker.numbers(name, n, components, vtk.vtkFloatArray))
                activate(name)

    @unittest.skipUnless(meshio, "skipped: no meshio")
    def test_files_of_meshio(self):
        paths, dice = [], random.Random(7)
        for round_ in range(3):
            points = numpy.array([[dice.uniform(-9, 9) for _ in range(3)] for _ in range(20)])
            cells = [("tetra", numpy.array([dice.sample(range(20), 4) for _ in range(9)])), ("triangle", numpy.array([dice.sample(range(20), 3) for _ in range(5)]))]
            data = {"a": [numpy.arange(9.0), numpy.arange(5.0)], "b": [numpy.arange(9), numpy.arange(5)]}
            mesh = meshio.Mesh(points, cells, point_data={"p": numpy.arange(20.0), "v": points * 2}, cell_data=data)
            for name, options in (("zlib", {}), ("ascii", {"binary": False}), ("plain", {"compression": None}), ("lzma", {"compression": "lzma"}),
                                  ("uint64", {"header_type": "UInt64"})):
                paths.append(self.path("meshio_%d_%s.vtu" % (round_, name)))
                meshio.write(paths[-1], mesh, file_format="vtu", **options)
            for version, binary in itertools.product(("vtk42", "vtk51"), (False, True)):
                paths.append(self.path("meshio_%d_%s_%d.vtk" % (round_, version, binary)))
                meshio.write(paths[-1], mesh, file_format=version, binary=binary)
        self.compare_all(paths, 27)

    def test_damaged_files_are_refused_or_read_and_never_end_the_program(self):
        dice, maker, sources = random.Random(11), Maker("damage"), []
        for i, (mode, compressor) in enumerate(itertools.product(("ascii", "binary", "raw", "base64"), (0, 1, 2, 3))):
            sources.append(self.path("whole_%d.vtu" % i))
            self.write_xml(maker.grid(n_points=12, n_cells=6), sources[-1], mode, compressor, 64, "little")
        for i, (version, binary) in enumerate(itertools.product((42, 51), (False, True))):
            writer = vtk.vtkUnstructuredGridWriter()
            writer.SetFileVersion(version)
            (writer.SetFileTypeToBinary if binary else writer.SetFileTypeToASCII)()
            sources.append(self.path("whole_%d.vtk" % i))
            writer.SetFileName(sources[-1])
            writer.SetInputData(maker.grid(n_points=12, n_cells=6))
            writer.Write()
        paths = []
        for source in sources:
            with open(source, "rb") as file:
                content = file.read()
            for round_ in range(25):
                damaged = bytearray(content)
                if round_ % 5 == 0:
                    del damaged[dice.randrange(len(damaged)):]
                for _ in range(dice.randint(1, 6)):
                    if damaged:
                        damaged[dice.randrange(len(damaged))] = dice.choice([dice.randrange(256), ord("9"), ord("-"), 255])
                paths.append("%s_%d%s" % (source[:-4], round_, source[-4:]))
                with open(paths[-1], "wb") as file:
                    file.write(damaged)
        verdicts = dump(paths)
        self.assertEqual(len(verdicts), len(paths))
        self.assertTrue(any("error" in v for v in verdicts) and any("error" not in v for v in verdicts))


if __name__ == "__main__":
    unittest.main()
