# SPDX-License-Identifier: GPL-3.0-or-later
"""Determines in which unit the centre of each cell of a grid lies, and how often over all realisations."""
import base64
import zlib

import numpy

OUTSIDE = 255
_MOST_PAIRS = 2_000_000  # pairs of a tetrahedron and a grid cell that are tested at a time, to bound memory


def units_at(mesh, grid, names):
    """Returns uint8 of shape (nx, ny, nz): the row in `names` of the unit at each cell's centre, OUTSIDE if there is
    none."""
    row_of = {region.id: names.index(region.unit) for region in mesh.regions}
    if len(names) >= OUTSIDE:
        raise ValueError("a grid of units holds %d units at most" % (OUTSIDE - 1))
    rows = numpy.array([row_of.get(i, OUTSIDE) for i in range(max(row_of) + 1)], dtype=numpy.uint8)
    spacing = numpy.array(grid.spacing())
    points = (mesh.points + numpy.array(mesh.shift) - numpy.array(grid.low)) / spacing - 0.5  # centres of grid cells get integer coordinates
    found = numpy.full(numpy.prod(grid.cells), len(mesh.tetrahedra), dtype=numpy.int64)
    for start, end in _batches(points, mesh.tetrahedra, grid.cells):
        _mark(points[mesh.tetrahedra[start:end]], start, grid.cells, found)
    unit = numpy.append(rows[mesh.region], numpy.uint8(OUTSIDE))
    return unit[found].reshape(grid.cells)


def _ranges(corners, cells):
    """Returns, along each axis, the first and last grid cell whose centre is in the box around each tetrahedron."""
    low = numpy.ceil(corners.min(axis=1) - 1e-9).astype(numpy.int64)
    high = numpy.floor(corners.max(axis=1) + 1e-9).astype(numpy.int64)
    return numpy.maximum(low, 0), numpy.minimum(high, numpy.array(cells) - 1)


def _batches(points, tetrahedra, cells):
    low, high = _ranges(points[tetrahedra], cells)
    sums = numpy.cumsum(numpy.prod(numpy.maximum(high - low + 1, 0), axis=1))
    start = 0
    while start < len(tetrahedra):
        before = sums[start - 1] if start else 0
        end = max(start + 1, int(numpy.searchsorted(sums, before + _MOST_PAIRS, side="right")))
        yield start, end
        start = end


def _mark(corners, first, cells, found):
    """Enters into `found`, for the centre of each grid cell, the tetrahedron of lowest index (counted from `first`)
    that contains it, so that the result is unique for a centre on a face."""
    low, high = _ranges(corners, cells)
    extent = numpy.maximum(high - low + 1, 0)
    counts = numpy.prod(extent, axis=1)
    tet = numpy.repeat(numpy.arange(len(corners)), counts)
    if len(tet) == 0:
        return
    within = numpy.arange(len(tet)) - numpy.repeat(numpy.cumsum(counts) - counts, counts)
    k = within % extent[tet, 2]
    j = within // extent[tet, 2] % extent[tet, 1]
    i = within // (extent[tet, 2] * extent[tet, 1])
    place = low[tet] + numpy.stack([i, j, k], axis=1)
    inside = _is_inside(corners, tet, place)
    cell = (place[inside, 0] * cells[1] + place[inside, 1]) * cells[2] + place[inside, 2]
    numpy.minimum.at(found, cell, tet[inside] + first)


def _is_inside(corners, tet, place):
    inside = numpy.ones(len(tet), dtype=bool)
    for a, b, c, d in ((1, 2, 3, 0), (0, 3, 2, 1), (0, 1, 3, 2), (0, 2, 1, 3)):
        normal = numpy.cross(corners[:, b] - corners[:, a], corners[:, c] - corners[:, a])
        side = numpy.sign((normal * (corners[:, d] - corners[:, a])).sum(axis=1))
        normal *= side[:, None]
        bound = 1e-9 * numpy.abs(normal).sum(axis=1)
        offset = (normal * corners[:, a]).sum(axis=1)
        inside &= sum(normal[tet, axis] * place[:, axis] for axis in range(3)) - offset[tet] >= -bound[tet]
    return inside


def packed(units):
    """Encodes a grid that holds the row of a rock unit in each cell as short text."""
    return base64.b64encode(zlib.compress(numpy.ascontiguousarray(units).tobytes(), 6)).decode()


def unpacked(text, cells):
    return numpy.frombuffer(zlib.decompress(base64.b64decode(text)), dtype=numpy.uint8).reshape(cells)


class Probability:
    """Counts, for each cell of a grid, in how many realisations each rock unit is there."""

    def __init__(self, grid):
        self._grid = grid
        self.counts = {}
        self.n = 0

    def add(self, text, names):
        units = unpacked(text, self._grid.cells)
        self.n += 1
        for row, name in enumerate(names):
            here = (units == row).astype(numpy.int32)
            self.counts[name] = self.counts[name] + here if name in self.counts else here

    def of(self, name):
        return self.counts[name] / float(self.n) if name in self.counts else numpy.zeros(self._grid.cells)

    def entropy(self, names):
        """Returns the entropy of the units at each cell in bits: 0 where all realisations agree."""
        total = numpy.zeros(self._grid.cells)
        for name in names:
            p = self.of(name)
            total -= p * numpy.log2(numpy.where(p > 0, p, 1.0))
        return total


def vti_text(grid, arrays):
    """Returns a compressed VTK image of cell arrays as bytes."""
    parts, blocks, offset = [], [], 0
    for name, values in arrays:
        raw = numpy.asarray(values, dtype="<f4").transpose(2, 1, 0).tobytes()  # VTK stores x fastest
        content = zlib.compress(raw, 6)
        head = numpy.array([1, len(raw), len(raw), len(content)], dtype="<u4").tobytes()
        parts.append('        <DataArray type="Float32" Name="%s" format="appended" offset="%d"/>\n' % (_escaped(name), offset))
        text = base64.b64encode(head) + base64.b64encode(content)
        blocks.append(text)
        offset += len(text)
    extent = "0 %d 0 %d 0 %d" % grid.cells
    head = ('<?xml version="1.0"?>\n<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt32" '
            'compressor="vtkZLibDataCompressor">\n  <ImageData WholeExtent="%s" Origin="%.17g %.17g %.17g" Spacing="%.17g %.17g %.17g">\n'
            '    <Piece Extent="%s">\n      <CellData>\n' % ((extent,) + tuple(grid.low) + grid.spacing() + (extent,)))
    tail = "      </CellData>\n    </Piece>\n  </ImageData>\n  <AppendedData encoding=\"base64\">\n_"
    return (head + "".join(parts) + tail).encode() + b"".join(blocks) + b"\n  </AppendedData>\n</VTKFile>\n"


def _escaped(name):
    return name.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
