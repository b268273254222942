# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads and writes the VTK XML files of geomesh (appended raw data, zlib, 64-bit headers, short arrays as text). Standard library only.

    file = VtkFile.read("model.faces.vtp")
    file["CellData", "patch"].values[3] = 7
    file.write("broken.faces.vtp")
"""
import re
import struct
import zlib

CODES = {"Int8": "b", "UInt8": "B", "Int32": "i", "UInt32": "I", "Int64": "q", "UInt64": "Q", "Float32": "f", "Float64": "d"}


class VtkArray:
    """`values`: numbers, or texts for an array of strings."""

    def __init__(self, section, name, kind, components, values):
        self.section, self.name, self.kind, self.components, self.values = section, name, kind, components, values

    def encoded(self):
        if self.kind == "String":
            return b"".join(text.encode() + b"\0" for text in self.values)
        return struct.pack("<%d%s" % (len(self.values), CODES[self.kind]), *self.values)

    def decode(self, data):
        if self.kind == "String":
            self.values = [text.decode() for text in data.split(b"\0")[:-1]]
        else:
            self.values = list(struct.unpack("<%d%s" % (len(data) // struct.calcsize(CODES[self.kind]), CODES[self.kind]), data))


class VtkFile:
    def __init__(self, kind, arrays):
        self.kind, self.arrays = kind, arrays

    def __getitem__(self, key):
        """The array of a section ("PointData", "CellData", "FieldData", "Points", "Cells", "Verts", "Lines", "Polys") and name."""
        return next(array for array in self.arrays if (array.section, array.name) == key)

    def has(self, section, name):
        return any((array.section, array.name) == (section, name) for array in self.arrays)

    def remove(self, section, name):
        self.arrays = [array for array in self.arrays if (array.section, array.name) != (section, name)]

    @staticmethod
    def read(path):
        with open(path, "rb") as file:
            content = file.read()
        at = content.index(b"<AppendedData")
        start = content.index(b"_", at) + 1
        file = VtkFile(re.search(rb'VTKFile type="(\w+)"', content).group(1).decode(), [])
        section = None
        for tag in re.finditer(rb"<(/?)(\w+)([^>]*)>", content[:at]):
            name = tag.group(2).decode()
            if name in ("PointData", "CellData", "FieldData", "Points", "Cells", "Verts", "Lines", "Strips", "Polys"):
                section = name
            if name not in ("DataArray", "Array") or tag.group(1):
                continue
            attributes = dict(re.findall(r'(\w+)="([^"]*)"', tag.group(3).decode()))
            array = VtkArray(section, attributes["Name"], attributes["type"], int(attributes.get("NumberOfComponents", 1)), [])
            if attributes.get("format") == "ascii":
                number = float if array.kind.startswith("Float") else int
                array.values = [number(word) for word in content[tag.end():content.index(b"<", tag.end())].split()]
            else:
                array.decode(uncompressed(content, start + int(attributes["offset"])))
            file.arrays.append(array)
        if file.kind == "PolyData":
            file.arrays += [VtkArray(cells, name, "Int64", 1, []) for cells in ("Verts", "Lines", "Strips", "Polys")
                            for name in ("connectivity", "offsets") if not file.has(cells, name)]
        return file

    def n_points(self):
        return len(self["Points", "Points"].values) // 3

    def write(self, path):
        body, offset, lines = [], 0, {}
        for array in self.arrays:
            data = compressed(array.encoded())
            word = "Array" if array.kind == "String" else "DataArray"
            tuples = ' NumberOfTuples="%d"' % (len(array.values) // array.components) if array.section == "FieldData" else ""
            components = ' NumberOfComponents="%d"' % array.components if array.components > 1 else ""
            lines.setdefault(array.section, []).append('<%s type="%s" Name="%s"%s%s format="appended" offset="%d"/>' %
                                                       (word, array.kind, array.name, components, tuples, offset))
            body.append(data)
            offset += len(data)
        counts = 'NumberOfPoints="%d"' % self.n_points()
        if self.kind == "UnstructuredGrid":
            counts += ' NumberOfCells="%d"' % len(self["Cells", "types"].values)
        else:
            for section in ("Verts", "Lines", "Strips", "Polys"):
                counts += ' NumberOf%s="%d"' % (section, len(self[section, "offsets"].values))
        xml = ['<VTKFile type="%s" version="1.0" byte_order="LittleEndian" header_type="UInt64" compressor="vtkZLibDataCompressor">' % self.kind,
               "<%s>" % self.kind, "<FieldData>", *lines.pop("FieldData", []), "</FieldData>", "<Piece %s>" % counts]
        for section, arrays in lines.items():
            xml += ["<%s>" % section, *arrays, "</%s>" % section]
        xml += ["</Piece>", "</%s>" % self.kind, '<AppendedData encoding="raw">', ""]
        with open(path, "wb") as file:
            file.write("\n".join(xml).encode() + b"_" + b"".join(body) + b"\n</AppendedData>\n</VTKFile>\n")


def uncompressed(content, at):
    n_blocks, _, _ = struct.unpack_from("<3Q", content, at)
    sizes = struct.unpack_from("<%dQ" % n_blocks, content, at + 24)
    at += 24 + 8 * n_blocks
    data = b""
    for size in sizes:
        data += zlib.decompress(content[at:at + size])
        at += size
    return data


def compressed(data):
    if not data:
        return struct.pack("<3Q", 0, 0, 0)
    packed = zlib.compress(data, 1)
    return struct.pack("<4Q", 1, len(data), 0, len(packed)) + packed
