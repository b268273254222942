# SPDX-License-Identifier: GPL-3.0-or-later
"""Other people's readers, each giving what it found in a mesh file in one form, so that one test serves all.

Found: regions, faces, curves: name -> (number of cells, volume, area or length); nodes: name -> number of nodes; points: number.
A reader whose library is not installed raises ReaderMissing.
"""
import re
import shutil
import subprocess
import sys
import tempfile
import os

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from meshio_vtu import mend as mended_meshio


class ReaderMissing(Exception):
    pass


class Found:
    def __init__(self, points):
        self.points, self.regions, self.faces, self.curves, self.nodes = points, {}, {}, {}, {}


def need(module):
    try:
        found = __import__(module)
    except ImportError:
        raise ReaderMissing(module) from None
    return mended_meshio(found) if module == "meshio" else found


def measure(points, cells):
    """Number and signed volume of tetrahedra, or area of triangles, or length of edges; of second order by the corners."""
    numpy = need("numpy")
    cells = numpy.asarray(cells)
    if len(cells) == 0:
        return 0, 0.0
    width = {10: 4, 6: 3, 3: 3, 4: 4, 2: 2}[cells.shape[1]]
    corner = [points[cells[:, i]] for i in range(width)]
    if width == 2:
        return len(cells), float(numpy.linalg.norm(corner[1] - corner[0], axis=1).sum())
    normal = numpy.cross(corner[1] - corner[0], corner[2] - corner[0])
    if width == 3:
        return len(cells), float(numpy.linalg.norm(normal, axis=1).sum() / 2)
    volumes = (normal * (corner[3] - corner[0])).sum(axis=1) / 6
    # A tetrahedron may be so flat that only exact arithmetic knows its sign.
    if volumes.min() < -1e-12 * volumes.max():
        raise AssertionError("%d tetrahedra are turned inside out" % (volumes < 0).sum())
    return len(cells), float(volumes.sum())


DIMENSION = {"vertex": 0, "line": 1, "line3": 1, "triangle": 2, "triangle6": 2, "tetra": 3, "tetra10": 3}


def add_by_tag(found, points, blocks, names):
    """`blocks`: (dimension, cells, tags); `names`: (dimension, tag) -> name."""
    numpy = need("numpy")
    gathered = {}
    for dimension, cells, tags in blocks:
        cells = numpy.asarray(cells)[:, :dimension + 1]  # the corners
        for tag in sorted(set(numpy.asarray(tags).tolist())):
            gathered.setdefault((dimension, tag), []).append(numpy.asarray(cells)[numpy.asarray(tags) == tag])
    for (dimension, tag), parts in gathered.items():
        name = names.get((dimension, tag))
        if name is None or dimension == 0:
            continue
        {1: found.curves, 2: found.faces, 3: found.regions}[dimension][name] = measure(points, numpy.concatenate(parts))


def meshio_gmsh(path, _sidecar):
    meshio = need("meshio")
    mesh = meshio.read(path)
    found = Found(len(mesh.points))
    names = {(int(v[1]), int(v[0])): k for k, v in mesh.field_data.items()}
    add_by_tag(found, mesh.points, [(DIMENSION[c.type], c.data, mesh.cell_data["gmsh:physical"][i]) for i, c in enumerate(mesh.cells)
                                    if c.type in DIMENSION], names)
    return found


def meshio_vtu(path, sidecar):
    meshio, numpy = need("meshio"), need("numpy")
    mesh = meshio.read(path)
    found = Found(len(mesh.points))
    array = next(iter(mesh.cell_data))
    first = 1 if array == "MaterialIDs" else 0
    names = {(g["dimension"], g["id"]): g["name"] for g in sidecar["groups"] if "id" in g}
    add_by_tag(found, mesh.points, [(DIMENSION[c.type], c.data, mesh.cell_data[array][i] + first) for i, c in enumerate(mesh.cells)], names)
    for name, values in mesh.point_data.items():
        if name.startswith("nodes:"):
            found.nodes[name[6:]] = int(numpy.asarray(values).sum())
    return found


def meshio_inp(path, _sidecar):
    meshio, numpy = need("meshio"), need("numpy")
    mesh = meshio.read(path)
    found = Found(len(mesh.points))
    for name, rows in mesh.cell_sets.items():
        cells = [c.data[numpy.asarray(r, dtype=int)] for c, r in zip(mesh.cells, rows) if r is not None and len(r) and c.type in DIMENSION]
        if cells:
            found.regions[name] = measure(mesh.points, numpy.concatenate(cells))
    for name, rows in mesh.point_sets.items():
        found.nodes[name] = len(rows)
    return found


def meshio_med(path, _sidecar):
    meshio, numpy = need("meshio"), need("numpy")
    need("h5py")
    mesh = meshio.read(path)
    found = Found(len(mesh.points))
    cells_of = {}
    for i, c in enumerate(mesh.cells):
        tags = numpy.asarray(mesh.cell_data["cell_tags"][i])
        # meshio keeps MED's order of corners, which turns the other way than VTK's.
        data = c.data[:, [0, 2, 1, 3]] if c.type == "tetra" else c.data
        for tag in sorted(set(tags.tolist())):
            for name in mesh.cell_tags.get(tag, []):
                cells_of.setdefault((DIMENSION[c.type], name), []).append(data[tags == tag])
    for (dimension, name), parts in cells_of.items():
        if dimension:
            {1: found.curves, 2: found.faces, 3: found.regions}[dimension][name] = measure(mesh.points, numpy.concatenate(parts))
    tags = numpy.asarray(mesh.point_data.get("point_tags", []))
    for tag, names in mesh.point_tags.items():
        for name in names:
            found.nodes[name] = found.nodes.get(name, 0) + int((tags == tag).sum())
    return found


def run_tool(name, *arguments):
    """Runs a program of Debian; what it complains of fails the test."""
    if not shutil.which(name):
        raise ReaderMissing(name)
    run = subprocess.run([name, *arguments], capture_output=True, text=True, timeout=100)
    if run.returncode or re.search(r"(?m)^Error", run.stdout + run.stderr):
        raise AssertionError(run.stdout + run.stderr)


def gmsh(path, _sidecar):
    """Gmsh reads the file, and writes it in its format 2.2, where counts and names are easy to see."""
    numpy = need("numpy")
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "again.msh")
        run_tool("gmsh", path, "-0", "-format", "msh22", "-o", out)
        with open(out) as file:
            lines = file.read().splitlines()
    at = lines.index("$Nodes")
    rows = [line.split() for line in lines[at + 2:at + 2 + int(lines[at + 1])]]
    number = {int(r[0]): i for i, r in enumerate(rows)}
    points = numpy.array([[float(x) for x in r[1:]] for r in rows])
    found = Found(len(points))
    names = {}
    if "$PhysicalNames" in lines:
        at = lines.index("$PhysicalNames")
        for line in lines[at + 2:at + 2 + int(lines[at + 1])]:
            dimension, tag, name = line.split(None, 2)
            names[(int(dimension), int(tag))] = name.strip('"')
    at = lines.index("$Elements")
    dimension_of = {15: 0, 1: 1, 8: 1, 2: 2, 9: 2, 4: 3, 11: 3}
    cells, tags = {}, {}
    for line in lines[at + 2:at + 2 + int(lines[at + 1])]:
        row = [int(w) for w in line.split()]
        if row[1] in dimension_of:
            key = (dimension_of[row[1]], row[1])
            cells.setdefault(key, []).append([number[n] for n in row[3 + row[2]:]])
            tags.setdefault(key, []).append(row[3])
    add_by_tag(found, points, [(d, cells[(d, k)], tags[(d, k)]) for d, k in cells], names)
    return found


def group_numbers(sidecar, dimension):
    return [(g["name"], g["id"]) for g in sidecar["groups"] if g["dimension"] == dimension]


def getfem_gmsh22(path, sidecar):
    """Volumes and areas by GetFEM's own integration. It has a face between two regions once from each side."""
    getfem, numpy = need("getfem"), need("numpy")
    getfem.util("warning level", 0)
    mesh = getfem.Mesh("import", "gmsh", path)
    method = getfem.MeshIm(mesh, getfem.Integ("IM_TETRAHEDRON(2)"))
    found = Found(mesh.nbpts())
    for name, number in group_numbers(sidecar, 3):
        found.regions[name] = mesh.region(number).shape[1], float(getfem.asm_generic(method, 0, "1", number))
    outer, own = {tuple(c) for c in mesh.outer_faces().T.tolist()}, 1 + max(mesh.regions())
    for name, number in group_numbers(sidecar, 2):
        n = area = 0
        for share, is_outer in ((1, True), (0.5, False)):
            sides = [c for c in mesh.region(number).T.tolist() if (tuple(c) in outer) == is_outer]
            if sides:
                mesh.set_region(own, numpy.array(sides).T)
                n, area = n + share * len(sides), area + share * float(getfem.asm_generic(method, 0, "1", own))
                mesh.delete_region(own)
        found.faces[name] = n, area
    return found


def netgen_gmsh22(path, _sidecar):
    """Netgen prints as it reads. Materials, faces and edges have their names in the mesh."""
    numpy = need("numpy")
    need("netgen")
    from netgen.read_gmsh import ReadGmsh
    mesh = ReadGmsh(path)
    points = numpy.array([[p[k] for k in range(3)] for p in mesh.Points()])
    found = Found(len(points))
    for elements, give, into in ((mesh.Elements3D(), lambda i: mesh.GetMaterial(i), found.regions), (mesh.Elements2D(), lambda i: mesh.GetBCName(i - 1), found.faces),
                                 (mesh.Elements1D(), lambda i: mesh.GetCD2Name(i - 1), found.curves)):
        cells = {}
        for e in elements:
            nodes = [p.nr - 1 for p in (e.points if into is found.curves else e.vertices)]
            cells.setdefault(give(e.index), []).append(nodes)
        for name, own in cells.items():
            into[name] = measure(points, own)
    return found


FREEFEM = """load "gmsh"
mesh3 Th = gmshload3("%s");
cout.precision(17);
cout << "points " << Th.nv << endl;
fespace Ph(Th, P03d);
Ph own = region;
%s"""


def freefem_gmsh22(path, sidecar):
    """FreeFem++ gives numbers alone; volumes and areas are by its own integration."""
    lines = []
    for name, number in group_numbers(sidecar, 3):
        lines.append('cout << "region %s " << int3d(Th, qfV=qfV1)((own == %d) * 1.) << " " << int3d(Th, qfV=qfV1)((own == %d) / volume) << endl;' % (name, number, number))
    for name, number in group_numbers(sidecar, 2):
        lines.append('cout << "face %s " << int2d(Th, %d)(1.) << " 0" << endl;' % (name, number))
    with tempfile.TemporaryDirectory() as folder:
        script = os.path.join(folder, "read.edp")
        with open(script, "w") as file:
            file.write(FREEFEM % (path, "\n".join(lines)))
        if not shutil.which("FreeFem++-nw"):
            raise ReaderMissing("freefem++")
        # Debian's program looks for its plugins in another folder than Debian's library has them in.
        run = subprocess.run(["FreeFem++-nw", "-nw", "-v", "0", script], capture_output=True, text=True, timeout=100,
                             env=dict(os.environ, FF_LOADPATH="/usr/lib/freefem++"))
    if "Load error" in run.stdout + run.stderr:
        raise ReaderMissing("libfreefem++")
    if run.returncode:
        raise AssertionError(run.stdout + run.stderr)
    found = Found(int(re.search(r"(?m)^points (\d+)", run.stdout).group(1)))
    for kind, name, size, n in re.findall(r"(?m)^(region|face) (\S+) (\S+) (\S+)", run.stdout):
        {"region": found.regions, "face": found.faces}[kind][name] = round(float(n)), float(size)
    return found


def netcdf_exodus(path, _sidecar):
    """By the netCDF library and the Exodus II conventions, without any Exodus code."""
    netCDF4, numpy = need("netCDF4"), need("numpy")
    file = netCDF4.Dataset(path)

    def names(variable):
        return [bytes(c for c in row.filled(b"\0").tobytes() if c).decode() for row in file.variables[variable][:]] if variable in file.variables else []

    points = numpy.stack([numpy.asarray(file.variables["coord" + x][:]) for x in "xyz"], axis=1)
    found = Found(len(points))
    blocks = []
    for i, name in enumerate(names("eb_names")):
        if "connect%d" % (i + 1) not in file.variables:
            continue  # a block without elements, in a part
        cells = numpy.asarray(file.variables["connect%d" % (i + 1)][:]) - 1
        blocks.append(cells)
        if cells.shape[1] in (4, 10):
            found.regions[name] = measure(points, cells)
    widths = {c.shape[1] for c in blocks}
    corners = numpy.concatenate([c[:, :4] for c in blocks])
    side_nodes = numpy.array([[0, 1, 3], [1, 2, 3], [0, 3, 2], [0, 2, 1]])
    for i, name in enumerate(names("ss_names")):
        if "elem_ss%d" % (i + 1) not in file.variables:
            found.faces[name] = (0, 0.0)  # a set without sides, in a part
            continue
        elements = numpy.asarray(file.variables["elem_ss%d" % (i + 1)][:]) - 1
        sides = numpy.asarray(file.variables["side_ss%d" % (i + 1)][:]) - 1
        found.faces[name] = measure(points, numpy.take_along_axis(corners[elements], side_nodes[sides], axis=1))
    for i, name in enumerate(names("ns_names")):
        nodes = "node_ns%d" % (i + 1)
        found.nodes[name] = len(file.variables[nodes][:]) if nodes in file.variables else 0
    assert widths <= {4, 6, 10}
    return found


def vtk_exodus(path, _sidecar):
    vtk, numpy = need("vtk"), need("numpy")
    from vtk.util.numpy_support import vtk_to_numpy
    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    for kind in (vtk.vtkExodusIIReader.SIDE_SET, vtk.vtkExodusIIReader.NODE_SET):
        for i in range(reader.GetNumberOfObjects(kind)):
            reader.SetObjectStatus(kind, i, 1)
    reader.Update()
    found = Found(reader.GetOutput().GetNumberOfPoints())
    for kind, name_of, into in ((0, "regions", "regions"), (4, "side", "faces"), (7, "node", "nodes")):
        group = reader.GetOutput().GetBlock(kind)
        for i in range(group.GetNumberOfBlocks() if group else 0):
            name = group.GetMetaData(i).Get(vtk.vtkCompositeDataSet.NAME())
            name = name.split(" Size: ")[0].split("Unnamed block ID: ")[-1]
            data = group.GetBlock(i)
            if into == "nodes":
                found.nodes[name] = data.GetNumberOfPoints()
                continue
            points = vtk_to_numpy(data.GetPoints().GetData())
            cells = [[data.GetCell(c).GetPointId(k) for k in range(data.GetCell(c).GetNumberOfPoints())] for c in range(data.GetNumberOfCells())]
            if cells and len(cells[0]) in (3, 4, 6, 10) and not (into == "regions" and len(cells[0]) == 6):
                getattr(found, into)[name] = measure(points, numpy.array(cells))
    return found


def tetgen(path, sidecar):
    """TetGen reads the files and writes what it holds; that is looked at. It keeps numbers of nodes, attributes and markers."""
    numpy = need("numpy")
    with tempfile.TemporaryDirectory() as folder:
        stem = os.path.join(folder, "m")
        for ending in (".node", ".ele", ".face", ".edge"):
            shutil.copy(path[:-len(".ele")] + ending, stem + ending)
        run_tool("tetgen", "-r", stem)
        tables = {e: numpy.loadtxt(stem + ".1" + e, skiprows=1) for e in (".node", ".ele", ".face", ".edge")}
    points = tables[".node"][:, 1:4]
    found = Found(len(points))
    names = {(g["dimension"], g["id"]): g["name"] for g in sidecar["groups"]}
    blocks = []
    for ending, dimension in ((".ele", 3), (".face", 2), (".edge", 1)):
        table = tables[ending].astype(int)
        blocks.append((dimension, table[:, 1:dimension + 2] - 1, table[:, dimension + 2]))
    add_by_tag(found, points, blocks, names)
    return found


def h5py_xdmf(path, sidecar):
    """By the XDMF text and h5py, without any XDMF code."""
    h5py, numpy = need("h5py"), need("numpy")
    import xml.etree.ElementTree as tree
    stem = path[:-len(".xdmf")]
    found = None
    for ending, dimension in ((".xdmf", 3), (".facets.xdmf", 2), (".edges.xdmf", 1)):
        if not os.path.exists(stem + ending):
            continue
        items = [i.text.strip() for i in tree.parse(stem + ending).getroot().iter("DataItem")]
        arrays = []
        for item in items:
            file, where = item.split(":/")
            with h5py.File(os.path.join(os.path.dirname(path), file), "r") as h5:
                arrays.append(numpy.asarray(h5[where]))
        cells, points, tags = arrays
        found = found or Found(len(points))
        names = {(g["dimension"], g["id"]): g["name"] for g in sidecar["groups"]}
        add_by_tag(found, points, [(dimension, cells, tags)], names)
    return found


def meshio_xdmf(path, sidecar):
    meshio = need("meshio")
    need("h5py")
    stem = path[:-len(".xdmf")]
    found = None
    names = {(g["dimension"], g["id"]): g["name"] for g in sidecar["groups"]}
    for ending in (".xdmf", ".facets.xdmf"):
        mesh = meshio.read(stem + ending)
        found = found or Found(len(mesh.points))
        array = next(iter(mesh.cell_data))
        add_by_tag(found, mesh.points, [(DIMENSION[c.type], c.data, mesh.cell_data[array][i]) for i, c in enumerate(mesh.cells)], names)
    return found


def vtk_vtu(path, sidecar):
    vtk, numpy = need("vtk"), need("numpy")
    from vtk.util.numpy_support import vtk_to_numpy
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData())
    found = Found(len(points))
    array = grid.GetCellData().GetArray(0)
    ids = vtk_to_numpy(array) + (1 if array.GetName() == "MaterialIDs" else 0)
    names = {(g["dimension"], g["id"]): g["name"] for g in sidecar["groups"] if "id" in g}
    blocks = {}
    dimension_of = {10: 3, 24: 3, 5: 2, 22: 2, 3: 1, 21: 1}
    for c in range(grid.GetNumberOfCells()):
        kind = grid.GetCellType(c)
        if kind in dimension_of:
            cell = grid.GetCell(c)
            cells, tags = blocks.setdefault(kind, ([], []))
            cells.append([cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())])
            tags.append(ids[c])
    add_by_tag(found, points, [(dimension_of[k], v[0], v[1]) for k, v in blocks.items()], names)
    return found
