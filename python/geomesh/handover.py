# SPDX-License-Identifier: GPL-3.0-or-later
"""Converts meshes to objects of meshio and PyVista, with everything that these can hold."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, List, Tuple

import numpy

if TYPE_CHECKING:
    from .mesh import Mesh

_TETRAHEDRON, _TRIANGLE, _LINE = 10, 5, 3  # VTK's numbers of cell types


def unique_names(mesh: "Mesh") -> Dict[Tuple[int, int], str]:
    """Returns names by (dimension, id). A surface with the name of a region, `salt`, becomes `salt.surface`, a curve
    `salt.curve`."""
    taken, names = set(), {}
    for items, dimension, word in ((mesh.regions, 3, "region"), (mesh.surfaces, 2, "surface"), (mesh.curves, 1, "curve")):
        for item in items:
            name = item.name if item.name not in taken else "%s.%s" % (item.name, word)
            while name in taken:
                name += "_"
            taken.add(name)
            names[dimension, item.id] = name
    return names


def _blocks(mesh: "Mesh") -> "List[Tuple[int, int, Any]]":
    """Returns (dimension, id, rows of cells) for each region, surface and curve that has cells, from three dimensions
    down."""
    blocks = []
    for dimension, items, ids in ((3, mesh.regions, mesh.region), (2, mesh.surfaces, mesh.face_surface),
                                  (1, mesh.curves, mesh.curve_of_edge)):
        for item in items:
            rows = numpy.flatnonzero(ids == item.id)
            if len(rows) > 0:
                blocks.append((dimension, item.id, rows))
    return blocks


def _entities(mesh: "Mesh", cells: "List[Tuple[int, int, Any]]") -> Any:
    """Returns for each point (dimension, id) of a Gmsh entity that contains it: the one of lowest dimension, with every
    entity used at least once, because meshio writes only the entities that points name.
    """
    tags = numpy.zeros((len(mesh.points), 2), dtype=numpy.int32)
    for dimension, id, points in cells:
        tags[points.ravel()] = dimension, id
    entities, counts = numpy.unique(tags, axis=0, return_counts=True)
    left = {(int(d), int(i)): int(n) for (d, i), n in zip(entities, counts)}
    for dimension, id, points in cells:
        if (dimension, id) in left:
            continue
        for point in numpy.unique(points):
            own = (int(tags[point, 0]), int(tags[point, 1]))
            if left[own] > 1:
                left[own] -= 1
                left[dimension, id] = 1
                tags[point] = dimension, id
                break
    return tags


def to_meshio(mesh: "Mesh") -> Any:
    import meshio
    kinds = {3: ("tetra", mesh.tetrahedra), 2: ("triangle", mesh.faces), 1: ("line", mesh.curve_edges)}
    blocks = _blocks(mesh)
    cells = [(dimension, id, kinds[dimension][1][rows]) for dimension, id, rows in blocks]
    ids = [numpy.full(len(rows), id, dtype=numpy.int32) for _, id, rows in blocks]
    cell_data = {"gmsh:physical": ids, "gmsh:geometrical": [i.copy() for i in ids], "region": [i.copy() for i in ids]}
    for name, values in mesh.cell_arrays.items():
        cell_data[name] = [values[rows] if dimension == 3 else numpy.full(len(rows), numpy.nan)
                           for dimension, _, rows in blocks]
    names = {name: numpy.array([id, dimension]) for (dimension, id), name in unique_names(mesh).items()}
    points = {"kind": mesh.point_kind, "gmsh:dim_tags": _entities(mesh, cells)}
    points.update(mesh.point_arrays)
    return meshio.Mesh(mesh.points, [(kinds[dimension][0], rows) for dimension, _, rows in cells], point_data=points,
                       cell_data=cell_data, field_data=names)


def _compact(points: Any, rows: Any) -> Tuple[Any, Any, Any]:
    """Returns the points that some cells use, the cells in their numbering, and the rows of the points in the mesh."""
    used, numbers = numpy.unique(rows, return_inverse=True)
    return points[used], numbers.reshape(rows.shape), used


def _flat(rows: Any) -> Any:
    """Concatenates cells, each preceded by its number of points, as VTK stores them."""
    cells = numpy.empty((len(rows), rows.shape[1] + 1), dtype=numpy.int64)
    cells[:, 0] = rows.shape[1]
    cells[:, 1:] = rows
    return cells.ravel()


def _grid(mesh: "Mesh", pyvista: Any) -> Any:
    kinds = numpy.full(len(mesh.tetrahedra), _TETRAHEDRON, dtype=numpy.uint8)
    grid = pyvista.UnstructuredGrid(_flat(mesh.tetrahedra), kinds, mesh.points)
    grid.cell_data["region"] = mesh.region
    for name, by_region in mesh.attributes.items():
        grid.cell_data[name] = numpy.asarray(by_region, dtype=float)[mesh.region - 1]
    for name, values in mesh.cell_arrays.items():
        grid.cell_data[name] = values
    grid.point_data["kind"] = mesh.point_kind
    for name, values in mesh.point_arrays.items():
        grid.point_data[name] = values
    grid.field_data["region_ids"] = numpy.array([r.id for r in mesh.regions])
    grid.field_data["region_names"] = numpy.array([r.name for r in mesh.regions])
    grid.field_data["shift"] = numpy.array(mesh.shift, dtype=float)
    return grid


def _surface(mesh: "Mesh", pyvista: Any, id: int) -> Any:
    rows = mesh.faces_of(id)
    points, triangles, used = _compact(mesh.points, mesh.faces[rows])
    surface = pyvista.PolyData(points, _flat(triangles))
    surface.point_data["mesh_point"] = used
    surface.cell_data["mesh_face"] = rows
    for name in ("region_minus", "region_plus", "patch"):
        surface.cell_data[name] = getattr(mesh, "face_" + name)[rows]
    return surface


def _curve(mesh: "Mesh", pyvista: Any, id: int) -> Any:
    points, edges, used = _compact(mesh.points, mesh.curve_edges[mesh.curve_of_edge == id])
    curve = pyvista.PolyData(points, lines=_flat(edges))
    curve.point_data["mesh_point"] = used
    return curve


def to_pyvista(mesh: "Mesh") -> Any:
    import pyvista
    from . import pyvista_accessor
    pyvista_accessor.register(pyvista)
    whole = pyvista.MultiBlock()
    whole["mesh"] = _grid(mesh, pyvista)
    surfaces, curves = pyvista.MultiBlock(), pyvista.MultiBlock()
    for item in mesh.surfaces:
        if len(mesh.faces_of(item.id)) > 0:
            surfaces[item.name] = _surface(mesh, pyvista, item.id)
    for curve in mesh.curves:
        if (mesh.curve_of_edge == curve.id).any():
            curves[curve.name] = _curve(mesh, pyvista, curve.id)
    whole["surfaces"], whole["curves"] = surfaces, curves
    points = mesh.marked_points
    if points:
        places = pyvista.PolyData(numpy.array([mesh.points[p.vertex] for p in points]))
        places.point_data["name"] = numpy.array([p.name for p in points])
        whole["points"] = places
    return whole
