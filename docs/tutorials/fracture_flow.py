#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady flow through a matrix with conductive fractures, by dolfinx: `python3 fracture_flow.py out/network`.

Reads the mesh that `formats: [xdmf]` writes. Pressure is continuous across a fracture, which holds where fractures conduct much better
than the matrix; each fracture then carries a flux in its plane, of its transmissivity (conductivity times aperture).
"""
import sys

import numpy
import ufl
from dolfinx import fem, io
from dolfinx import mesh as grids
from dolfinx.fem import petsc
from mpi4py import MPI
from petsc4py.PETSc import ScalarType

functionspace = getattr(fem, "functionspace", None) or fem.FunctionSpace
FRACTURE = 1


def read(stem):
    """The mesh, and the rows of its fractures' faces. Sides of the box are tagged too and have one cell each."""
    with io.XDMFFile(MPI.COMM_WORLD, stem + ".xdmf", "r") as file:
        mesh = file.read_mesh(name="mesh")
    mesh.topology.create_connectivity(2, 3)
    with io.XDMFFile(MPI.COMM_WORLD, stem + ".facets.xdmf", "r") as file:
        facets = file.read_meshtags(mesh, name="facet_tags")
    cells = mesh.topology.connectivity(2, 3)
    return mesh, numpy.array([f for f in facets.indices if len(cells.links(f)) == 2], dtype=numpy.int32)


def solve(stem, transmissivity, inlet, is_outlet, conductivity=lambda x: numpy.ones(len(x)), outlet_pressure=0, degree=1):
    """Pressure for a flux of 1 a unit of area into the part of the sides that lies in the box `inlet` (its two corners).

    `is_outlet` and `conductivity` take places, one a row. `degree` is that of the elements: pressures near the tips of fractures are much better
    with 2.
    """
    mesh, fractures = read(stem)
    sides = grids.exterior_facet_indices(mesh.topology)
    middle = grids.compute_midpoints(mesh, 2, sides)
    outlet = sides[is_outlet(middle)]
    tags = grids.meshtags(mesh, 2, numpy.sort(fractures), numpy.full(len(fractures), FRACTURE, dtype=numpy.int32))
    inside, side = ufl.Measure("dS", mesh, subdomain_data=tags), ufl.Measure("ds", mesh, metadata={"quadrature_degree": 8})

    space = functionspace(mesh, ("CG", degree))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    k = fem.Function(functionspace(mesh, ("DG", 0)))
    n_cells = mesh.topology.index_map(3).size_local
    k.x.array[:] = conductivity(grids.compute_midpoints(mesh, 3, numpy.arange(n_cells, dtype=numpy.int32)))
    normal = ufl.FacetNormal(mesh)("+")

    def in_plane(w):
        return ufl.grad(w)("+") - ufl.dot(ufl.grad(w)("+"), normal) * normal

    one = fem.Constant(mesh, ScalarType(1))
    at, into = ufl.SpatialCoordinate(mesh), one
    for axis in range(3):
        for sign, limit in ((1, inlet[0][axis]), (-1, -inlet[1][axis])):
            into = ufl.conditional(ufl.ge(sign * at[axis], limit), into, 0.0)
    flow = k * ufl.dot(ufl.grad(u), ufl.grad(v)) * ufl.dx
    flow += fem.Constant(mesh, ScalarType(transmissivity)) * ufl.dot(in_plane(u), in_plane(v)) * inside(FRACTURE)
    fixed = fem.locate_dofs_topological(space, 2, outlet)
    pressure = petsc.LinearProblem(flow, into * v * side,
                                   bcs=[fem.dirichletbc(ScalarType(outlet_pressure), fixed, space)],
                                   petsc_options={"ksp_type": "cg", "ksp_rtol": 1e-10, "pc_type": "hypre"}).solve()

    def integral(form):
        return fem.assemble_scalar(fem.form(form))

    vector = getattr(pressure.x, "petsc_vec", None) or pressure.vector
    matrix = petsc.assemble_matrix(fem.form(flow))
    matrix.assemble()
    out = matrix.createVecLeft()
    matrix.mult(vector, out)  # what leaves through each node of the outlet, with the sign changed
    area = integral(into * side)
    return {"pressure": pressure, "cells": n_cells, "inflow": area, "outflow": -out.array[fixed],
            "outlets": space.tabulate_dof_coordinates()[fixed], "inlet_pressure": integral(into * pressure * side) / area,
            "fracture_area": integral(one * inside(FRACTURE))}


if __name__ == "__main__":
    far = 1e12
    found = solve(sys.argv[1], 100, ((-far, -far, -far), (1e-9, far, far)), lambda x: x[:, 0] > x[:, 0].max() - 1e-9)
    print("inflow %g, outflow %g, pressure at the inlet %g" % (found["inflow"], found["outflow"].sum(), found["inlet_pressure"]))
