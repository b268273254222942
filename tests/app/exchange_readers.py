# SPDX-License-Identifier: GPL-3.0-or-later
"""Readers of the formats of single programs and of surfaces, as format_readers.py has them of the rest.

By meshio, gmsh, netgen, VTK and h5py where these read the format; else by parsers written from the format's document alone, which know nothing of
how geomesh writes.
"""
import json
import os
import re
import struct

from format_readers import DIMENSION, Found, add_by_tag, measure, need


def numbered(sidecar):
    return {(g["dimension"], g["id"]): g["name"] for g in sidecar["groups"] if "id" in g}


def meshio_flac3d(path, _sidecar):
    """meshio keeps the numbers of zones behind those of faces, over all blocks."""
    meshio, numpy = need("meshio"), need("numpy")
    mesh = meshio.read(path)
    found = Found(len(mesh.points))
    first = numpy.cumsum([0] + [len(c.data) for c in mesh.cells])
    for key, parts in mesh.cell_sets.items():
        flag, name, slot = key.split(":")
        assert slot == "1" or flag == "face" or name, key
        cells = [c.data[numpy.asarray(part, dtype=int) - first[i]] for i, (c, part) in enumerate(zip(mesh.cells, parts)) if len(part)]
        (found.regions if flag == "zone" else found.faces)[name] = measure(mesh.points, numpy.concatenate(cells))
    return found


def meshio_avs(path, sidecar):
    """The tetrahedra, and the faces of the file beside it; what idnode0 says of these is held against the mesh."""
    meshio, numpy = need("meshio"), need("numpy")
    mesh, faces = meshio.read(path), meshio.read(path[:-len(".avs")] + ".faces.avs")
    found = Found(len(mesh.points))
    rows = numpy.asarray(faces.point_data["idnode0"]).astype(int) - 1
    assert (mesh.points[rows] == faces.points).all()
    for m in (mesh, faces):
        add_by_tag(found, m.points, [(DIMENSION[c.type], c.data, m.cell_data["avsucd:material"][i].astype(int)) for i, c in enumerate(m.cells)], numbered(sidecar))
    return found


def vtk_avs(path, sidecar):
    vtk, numpy = need("vtk"), need("numpy")
    from vtk.util.numpy_support import vtk_to_numpy
    reader = vtk.vtkAVSucdReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    found = Found(len(points))
    # VTK keeps the order of the file, in which tetrahedra turn the other way.
    add_by_tag(found, points, [(3, cells[:, [0, 1, 3, 2]], vtk_to_numpy(grid.GetCellData().GetArray("Material Id")))], numbered(sidecar))
    return found


def meshio_medit(path, sidecar):
    meshio = need("meshio")
    mesh = meshio.read(path)
    found = Found(len(mesh.points))
    add_by_tag(found, mesh.points, [(DIMENSION[c.type], c.data, mesh.cell_data["medit:ref"][i]) for i, c in enumerate(mesh.cells)], numbered(sidecar))
    return found


def gmsh_medit(path, sidecar):
    """Gmsh reads references as tags of entities, which its format 4.1 keeps."""
    import shutil
    import tempfile
    from format_readers import run_tool
    meshio = need("meshio")
    with tempfile.TemporaryDirectory() as folder:
        source, out = os.path.join(folder, "m.mesh"), os.path.join(folder, "again.msh")
        shutil.copy(path, source)
        run_tool("gmsh", source, "-0", "-format", "msh41", "-save_all", "-o", out)
        mesh = meshio.read(out)
    found = Found(len(mesh.points))
    add_by_tag(found, mesh.points, [(DIMENSION[c.type], c.data, mesh.cell_data["gmsh:geometrical"][i]) for i, c in enumerate(mesh.cells) if c.type in DIMENSION],
               numbered(sidecar))
    return found


def sizes_of(path):
    """Of a .sol or .solb."""
    numpy = need("numpy")
    if path.endswith(".sol"):
        with open(path) as file:
            words = file.read().split()
        at = words.index("SolAtVertices")
        n = int(words[at + 1])
        assert words[at + 2:at + 4] == ["1", "1"] and words[at + 4 + n] == "End"
        return numpy.array(words[at + 4:at + 4 + n], dtype=float)
    with open(path, "rb") as file:
        data = file.read()
    assert struct.unpack_from("<iiiqi", data) == (1, 3, 3, 24, 3)
    keyword, after, n, kinds, kind = struct.unpack_from("<iqiii", data, 24)
    assert (keyword, kinds, kind) == (62, 1, 1) and struct.unpack_from("<iq", data, after) == (54, 0) and len(data) == after + 12
    return numpy.frombuffer(data, dtype="<f8", count=n, offset=48)


def comsol(path, _sidecar):
    """By "The COMSOL File Formats" alone: words of the file in order, comments behind # left out."""
    numpy = need("numpy")
    with open(path) as file:
        words = " ".join(line.split("#")[0] for line in file).split()
    at = 0

    def number():
        nonlocal at
        at += 1
        return int(words[at - 1])

    def text():
        nonlocal at
        n = number()
        at += 1
        assert len(words[at - 1]) == n, words[at - 1]
        return words[at - 1]

    def array(n, kind):
        nonlocal at
        at += n
        return numpy.array(words[at - n:at], dtype=kind)

    assert (number(), number()) == (0, 1)
    tags = [text() for _ in range(number())]
    kinds = [text() for _ in range(number())]
    assert len(tags) == len(kinds) == len(set(tags)) and set(kinds) == {"obj"}
    assert [number() for _ in range(3)] == [0, 0, 1] and text() == "Mesh" and number() == 4 and number() == 3
    n, lowest = number(), number()
    points = array(3 * n, float).reshape(-1, 3)
    found, cells = Found(n), {}
    for _ in range(number()):
        kind, width, count = text(), number(), number()
        dimension = {"vtx": 0, "edg": 1, "tri": 2, "tet": 3}[kind]
        rows = array(width * count, int).reshape(-1, width) - lowest
        assert number() == count
        cells[dimension] = rows, array(count, int)
    assert cells[3][1].min() == 1 and all(cells[d][1].min() == 0 for d in (0, 1, 2) if d in cells)
    for tag in tags[1:]:
        assert [number() for _ in range(3)] == [0, 0, 1] and text() == "Selection" and number() == 0
        label, of, dimension = text(), text(), number()
        assert of == tags[0]
        entities = array(number(), int)
        own = numpy.isin(cells[dimension][1], entities)
        if dimension:
            {1: found.curves, 2: found.faces, 3: found.regions}[dimension][label] = measure(points, cells[dimension][0][own])
        else:
            found.nodes[label] = int(own.sum())
    assert at == len(words)
    return found


def feflow(path, _sidecar):
    """As OpenGeoSys reads a .fem: lines by keyword, sets as single numbers and ranges, lines that go on behind a tab."""
    numpy = need("numpy")
    with open(path) as file:
        lines = file.read().split("\n")
    assert lines[0].startswith("PROBLEM:") and lines[1].startswith("CLASS (v.7")
    assert int(lines[2].split()[3]) == 3
    at = lines.index("DIMENS") + 1
    n_nodes, n_elements, per_element = (int(w) for w in lines[at].split()[:3])
    assert per_element == 0
    at = lines.index("VARNODE") + 1
    assert lines[at].split() == [str(n_elements), "4", "4"]
    rows = numpy.array([[int(w) for w in line.split()] for line in lines[at + 1:at + 1 + n_elements]])
    assert (rows[:, 0] == 6).all()
    cells = rows[:, 1:] - 1
    at = lines.index("XYZCOOR") + 1
    points = numpy.array([[float(w) for w in line.split(",")] for line in lines[at:at + n_nodes]])
    found = Found(n_nodes)
    for keyword, end in (("ELEMENTALSETS", "NODALSETS"), ("NODALSETS", "END")):
        text = "\n".join(lines[lines.index(keyword) + 1:lines.index(end)]).replace("\n\t", " ")
        for line in text.splitlines():
            assert line.startswith(" ")
            name, *words = line.split()
            numbers = []
            for word in words:
                first, _, last = word.partition("-")
                numbers += range(int(first), int(last or first) + 1)
            if keyword == "NODALSETS":
                found.nodes[name] = len(set(numbers))
            else:
                found.regions[name] = measure(points, cells[numpy.array(numbers) - 1])
    return found


def gocad_solid(path, _sidecar):
    """By the GOCAD ASCII format: volumes, surfaces in parts, and each region's side of a part."""
    numpy = need("numpy")
    points, volumes, surfaces, parts, sides, now = {}, {}, {}, [], {}, None
    with open(path) as file:
        lines = [line.split() for line in file]
    assert lines[0] == ["GOCAD", "TSolid", "1"] and lines[-1] == ["END"] and ["ZPOSITIVE", "Elevation"] in lines
    for words in lines:
        if words[0] == "TVOLUME":
            now = volumes.setdefault(words[1], [])
        elif words[0] == "VRTX":
            points[int(words[1])] = [float(w) for w in words[2:]]
        elif words[0] == "TETRA":
            now.append([int(w) - 1 for w in words[1:]])
        elif words[0] == "SURFACE":
            now = surfaces.setdefault(words[1], [])
        elif words[0] == "TFACE":
            parts.append([])
            assert int(words[1]) == len(parts)
        elif words[0] == "TRGL":
            now.append([int(w) - 1 for w in words[1:]])
            parts[-1].append(now[-1])
        elif words[0] == "MODEL_REGION":
            sides[words[1]] = (words[2][0], int(words[2][1:]))
    assert sorted(points) == list(range(1, len(points) + 1))
    places = numpy.array([points[i] for i in sorted(points)])
    found = Found(len(places))
    for name, cells in volumes.items():
        found.regions[name] = measure(places, cells)
        sign, part = sides[name]
        corners = {tuple(sorted(t[:i] + t[i + 1:])): t[i] for t in cells for i in range(4)}
        a, b, c = parts[part - 1][0]
        tip = places[corners[tuple(sorted((a, b, c)))]]
        side = numpy.dot(numpy.cross(places[b] - places[a], places[c] - places[a]), tip - places[a])
        assert (side > 0) == (sign == "+"), name
    for name, cells in surfaces.items():
        found.faces[name] = measure(places, cells)
    return found


def gocad_surfaces(path, _sidecar):
    numpy = need("numpy")
    found = Found(0)
    with open(path) as file:
        objects = file.read().split("END\n")
    assert objects.pop() == ""
    for text in objects:
        name = re.search(r"(?m)^name:(.*)$", text).group(1)
        rows = [line.split() for line in text.splitlines()]
        assert rows[0] == ["GOCAD", "TSurf", "1"]
        points = {int(r[1]): [float(w) for w in r[2:]] for r in rows if r[0] == "VRTX"}
        places = numpy.array([points[i] for i in sorted(points)])
        assert sorted(points) == list(range(1, len(points) + 1))
        found.faces[name] = measure(places, [[int(w) - 1 for w in r[1:]] for r in rows if r[0] == "TRGL"])
    return found


def meshio_obj(path, sidecar):
    meshio, numpy = need("meshio"), need("numpy")
    mesh = meshio.read(path)
    with open(path) as file:
        names = [line.split()[1] for line in file if line.startswith("g ")]
    found = Found(len(mesh.points))
    for cells, ids in zip(mesh.cells, mesh.cell_data["obj:group_ids"]):
        assert len(set(numpy.asarray(ids).tolist())) == 1
        found.faces[names[int(ids[0])]] = measure(mesh.points, cells.data)
    return found


def stl_text(path, _sidecar):
    """Solid by solid; each facet's normal is that of its corners."""
    numpy = need("numpy")
    found = Found(0)
    with open(path) as file:
        text = file.read()
    for name, body, end in re.findall(r"(?ms)^solid (\S+)\n(.*?)^endsolid (\S+)$", text):
        assert name == end
        corners = numpy.array(re.findall(r"vertex (\S+) (\S+) (\S+)", body), dtype=float).reshape(-1, 3, 3)
        normals = numpy.array(re.findall(r"facet normal (\S+) (\S+) (\S+)", body), dtype=float)
        cross = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        assert ((cross * normals).sum(axis=1) > 0.999999 * numpy.linalg.norm(cross, axis=1)).all()
        found.faces[name] = measure(corners.reshape(-1, 3), numpy.arange(3 * len(corners)).reshape(-1, 3))
    return found


class Glb:
    """By the glTF 2.0 specification, without any glTF code."""

    def __init__(self, path):
        numpy = need("numpy")
        with open(path, "rb") as file:
            data = file.read()
        magic, version, length, size, kind = struct.unpack_from("<4sIIII", data)
        assert (magic, version, length, kind, size % 4) == (b"glTF", 2, len(data), 0x4E4F534A, 0)
        self.json = json.loads(data[20:20 + size])
        binary_size, kind = struct.unpack_from("<II", data, 20 + size)
        assert kind == 0x004E4942 and 28 + size + binary_size == len(data)
        self._binary = data[28 + size:]
        assert self.json["buffers"] == [{"byteLength": binary_size}] and self.json["asset"]["version"] == "2.0"
        root = self.json["nodes"][self.json["scenes"][self.json["scene"]]["nodes"][0]]
        self.matrix = numpy.array(root["matrix"], dtype=float).reshape(4, 4).T
        self.nodes = [self.json["nodes"][i] for i in root["children"]]
        self.centre = numpy.array(self.json["scenes"][0]["extras"]["centre"])
        self.points = self.array(0).astype(float)
        bounds = self.json["accessors"][0]
        assert (self.points.min(axis=0) == bounds["min"]).all() and (self.points.max(axis=0) == bounds["max"]).all()

    def array(self, i):
        numpy = need("numpy")
        accessor = self.json["accessors"][i]
        view = self.json["bufferViews"][accessor["bufferView"]]
        kind, width = {5126: "<f4", 5125: "<u4"}[accessor["componentType"]], {"SCALAR": 1, "VEC3": 3}[accessor["type"]]
        start = view["byteOffset"] + accessor.get("byteOffset", 0)
        assert start % 4 == 0 and accessor.get("byteOffset", 0) + 4 * width * accessor["count"] <= view["byteLength"]
        return numpy.frombuffer(self._binary, dtype=kind, count=width * accessor["count"], offset=start).reshape(-1, width)


def glb(path, _sidecar):
    numpy = need("numpy")
    file = Glb(path)
    found = Found(len(file.points))
    for node in file.nodes:
        parts = [file.array(p["indices"]).reshape(-1, 3) for p in file.json["meshes"][node["mesh"]]["primitives"]]
        found.faces[node["name"]] = measure(file.points, numpy.concatenate(parts))
    return found


class Puml:
    """SeisSol's layout, by its documentation."""
    FACES = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))

    def __init__(self, path):
        h5py, numpy = need("h5py"), need("numpy")
        with h5py.File(path, "r") as file:
            self.points, self.cells, self.group, bits = (numpy.asarray(file[name]) for name in ("geometry", "connect", "group", "boundary"))
            self.kinds = [str(file[name].dtype) for name in ("geometry", "connect", "group", "boundary")]
        self.conditions = numpy.stack([(bits >> (8 * i)) & 0xFF for i in range(4)], axis=1)

    def faces_with(self, condition):
        """Sorted corners of faces, once for each tetrahedron that has the condition there."""
        cell, face = need("numpy").nonzero(self.conditions == condition)
        return [self.cells[c][list(self.FACES[f])] for c, f in zip(cell, face)]


def seissol(path, sidecar):
    file = Puml(path)
    found = Found(len(file.points))
    add_by_tag(found, file.points, [(3, file.cells, file.group)], {(3, g["id"]): g["name"] for g in sidecar["groups"] if g["type"] == "group"})
    return found


def vtk_hdf(path, sidecar):
    vtk = need("vtk")
    if not hasattr(vtk, "vtkHDFReader"):
        from format_readers import ReaderMissing
        raise ReaderMissing("a VTK that reads VTKHDF")
    from vtk.util.numpy_support import vtk_to_numpy
    reader = vtk.vtkHDFReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData())
    found = Found(len(points))
    kinds, ids = vtk_to_numpy(grid.GetCellTypesArray()), vtk_to_numpy(grid.GetCellData().GetArray("region"))
    offsets, nodes = vtk_to_numpy(grid.GetCells().GetOffsetsArray()), vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    blocks = []
    for kind, dimension, width in ((10, 3, 4), (24, 3, 10), (5, 2, 3), (3, 1, 2)):
        own = (kinds == kind).nonzero()[0]
        if len(own):
            blocks.append((dimension, [nodes[offsets[c]:offsets[c] + width] for c in own], ids[own]))
    add_by_tag(found, points, blocks, numbered(sidecar))
    return found
