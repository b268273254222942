# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady flow through a matrix with fractures, by mixed elements of lowest order in hybrid form: fluxes are conserved in every cell.

Raviart-Thomas elements of order 0 in tetrahedra and in the triangles of fractures. Both sides of a fracture and the fracture itself have
pressures of their own, so that it may conduct or block. Where fractures cross, the fluxes into an edge add up to zero (Boon, Nordbotten
and Yotov, Robust discretization of flow in fractured porous media, SIAM Journal on Numerical Analysis 56, 2018). numpy, scipy, petsc4py.
"""
import collections

import numpy
from petsc4py import PETSc
from scipy import sparse

Mesh = collections.namedtuple("Mesh", "points tetrahedra triangles")  # the triangles of the fractures
Fractures = collections.namedtuple("Fractures", "transmissivity exchange")  # exchange: flux a unit of area and of pressure, each side


def faces_of(cells):
    """The faces' vertices, and per cell the face opposite to each vertex."""
    n = cells.shape[1]
    every = numpy.sort(numpy.stack([numpy.delete(cells, i, axis=1) for i in range(n)], axis=1), axis=2).reshape(-1, n - 1)
    faces, number = numpy.unique(every, axis=0, return_inverse=True)
    return faces, number.reshape(len(cells), n)


def local_fluxes(points, cells, conductivity):
    """Per cell the matrix of fluxes out of its faces for pressures on them: inverse of the mass matrix of (x - v_i) / (d size)."""
    corners = points[cells]
    d = cells.shape[1] - 1
    sides = corners[:, 1:] - corners[:, :1]
    size = numpy.sqrt(numpy.linalg.det(numpy.einsum("cik,cjk->cij", sides, sides))) / (6 if d == 3 else 2)
    from_middle = corners - corners.mean(axis=1, keepdims=True)
    spread = (from_middle ** 2).sum(axis=(1, 2)) / ((d + 1) * (d + 2))  # mean of |x - middle|^2
    products = numpy.einsum("cik,cjk->cij", from_middle, from_middle) + spread[:, None, None]
    return numpy.linalg.inv(products / (d * d * size * conductivity)[:, None, None])


def areas(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return 0.5 * numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1)


class System:
    """A symmetric matrix as a sum of blocks."""

    def __init__(self, n):
        self.n, self.parts = n, []

    def add(self, nodes, blocks):
        n = nodes.shape[1]
        self.parts.append((blocks.ravel(), numpy.repeat(nodes, n, axis=1).ravel(), numpy.tile(nodes, (1, n)).ravel()))

    def add_cells(self, faces, centres, fluxes):
        """Cells with a pressure in the middle: flux out = fluxes (middle - faces)."""
        block = numpy.zeros((len(faces), faces.shape[1] + 1, faces.shape[1] + 1))
        block[:, :-1, :-1] = fluxes
        block[:, :-1, -1] = block[:, -1, :-1] = -fluxes.sum(axis=2)
        block[:, -1, -1] = fluxes.sum(axis=(1, 2))
        self.add(numpy.concatenate([faces, centres[:, None]], axis=1), block)

    def solve(self, load, fixed, value):
        """Pressures, and what each fixed one takes out."""
        values, rows, columns = (numpy.concatenate(part) for part in zip(*self.parts))
        matrix = sparse.coo_matrix((values, (rows, columns)), shape=(self.n, self.n)).tocsr()
        free = numpy.setdiff1d(numpy.arange(self.n), fixed)
        pressure = numpy.full(self.n, float(value))
        pressure[free] = conjugate_gradients(matrix[free][:, free], (load - matrix[:, fixed] @ pressure[fixed])[free])
        return pressure, (load - matrix @ pressure)[fixed]


def conjugate_gradients(matrix, load):
    solver = PETSc.KSP().create()
    operator = PETSc.Mat().createAIJ(matrix.shape, csr=(matrix.indptr, matrix.indices, matrix.data))
    solver.setOperators(operator)
    solver.setType("cg")
    solver.getPC().setType("hypre")
    solver.setTolerances(rtol=1e-11, max_it=5000)
    x, b = operator.createVecs()
    b.setArray(load)
    solver.solve(b, x)
    if solver.getConvergedReason() <= 0:
        raise RuntimeError("the pressures did not converge (PETSc's reason %d)" % solver.getConvergedReason())
    return x.getArray().copy()


def solve(mesh, conductivity, fractures, is_inlet, is_outlet, outlet_pressure=0.0):
    """A flux of 1 a unit of area into the inlet. `is_inlet`, `is_outlet`: of middles of faces on the sides, one a row."""
    points, tetrahedra, triangles = mesh
    faces, face_of = faces_of(tetrahedra)
    edges, edge_of = faces_of(triangles)
    row = {tuple(face): i for i, face in enumerate(faces)}
    own = numpy.array([row[tuple(t)] for t in numpy.sort(triangles, axis=1)])
    # Unknowns: cells; faces, of fractures one side; the other side; fractures; their edges.
    counts = [len(tetrahedra), len(faces), len(own), len(own), len(edges)]
    cells, sides, others, inside, lines = (start + numpy.arange(n) for start, n in zip(numpy.cumsum([0] + counts), counts))
    other_of = numpy.full(len(faces), -1)
    other_of[own] = others
    unknown = sides[face_of]
    _, first = numpy.unique(face_of.ravel(), return_index=True)
    is_second = numpy.ones(face_of.size, dtype=bool)
    is_second[first] = False
    moved = is_second.reshape(face_of.shape) & (other_of[face_of] >= 0)
    unknown[moved] = other_of[face_of[moved]]

    system, load = System(sum(counts)), numpy.zeros(sum(counts))
    system.add_cells(unknown, cells, local_fluxes(points, tetrahedra, conductivity))
    system.add_cells(lines[edge_of], inside, local_fluxes(points, triangles, numpy.full(len(own), fractures.transmissivity)))
    for side in (sides[own], others):
        exchange = fractures.exchange * areas(points, triangles)
        system.add(numpy.stack([side, inside], axis=1), exchange[:, None, None] * numpy.array([[1, -1], [-1, 1]]))
    border = numpy.flatnonzero(numpy.bincount(face_of.ravel()) == 1)
    middles, size = points[faces[border]].mean(axis=1), areas(points, faces[border])
    inlet, outlet = is_inlet(middles), is_outlet(middles)
    load[sides[border[inlet]]] = size[inlet]
    pressure, out = system.solve(load, sides[border[outlet]], outlet_pressure)
    return {"pressure": pressure[cells], "inflow": size[inlet].sum(), "outflow": out, "outlets": middles[outlet],
            "inlet_pressure": (pressure[sides[border[inlet]]] * size[inlet]).sum() / size[inlet].sum()}
