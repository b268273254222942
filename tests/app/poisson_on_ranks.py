#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the parts of a mesh by dolfinx, each process some of them, and prints the integral of the solution of -div grad u = 1, u = 0 outside.

    mpirun -n N poisson_on_ranks.py NAME PARTS
"""
import sys

import dolfinx
import numpy as np
import ufl
import vtk
from mpi4py import MPI
from petsc4py import PETSc
from vtk.util.numpy_support import vtk_to_numpy


def own_of(path):
    """Own cells of a part by global points; own points with their numbers and places."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    at_points, at_cells = grid.GetPointData(), grid.GetCellData()
    numbers = vtk_to_numpy(at_points.GetArray("GlobalPointIds"))
    is_own_point = vtk_to_numpy(at_points.GetArray("vtkGhostType")) == 0
    is_own_cell = vtk_to_numpy(at_cells.GetArray("vtkGhostType")) == 0
    return numbers[cells[is_own_cell]].astype(np.int64), numbers[is_own_point].astype(np.int64), vtk_to_numpy(grid.GetPoints().GetData())[is_own_point]


def main():
    name, parts = sys.argv[1], int(sys.argv[2])
    comm = MPI.COMM_WORLD
    found = [own_of("%s.part%d.vtu" % (name, k)) for k in range(comm.rank, parts, comm.size)]
    cells, numbers, places = (np.concatenate([f[i] for f in found]) for i in range(3))
    # dolfinx takes points in blocks of rising numbers, process by process.
    total = comm.allreduce(len(numbers))
    first = [total * r // comm.size for r in range(comm.size + 1)]
    to = np.searchsorted(first, numbers, side="right") - 1
    came = comm.alltoall([(numbers[to == r], places[to == r]) for r in range(comm.size)])
    block = np.empty((first[comm.rank + 1] - first[comm.rank], 3))
    for n, x in came:
        block[n - first[comm.rank]] = x
    domain = ufl.Mesh(ufl.VectorElement("Lagrange", ufl.Cell("tetrahedron", geometric_dimension=3), 1))
    mesh = dolfinx.mesh.create_mesh(comm, cells, block, domain)
    space = dolfinx.fem.FunctionSpace(mesh, ("Lagrange", 1))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    mesh.topology.create_connectivity(2, 3)
    outside = dolfinx.mesh.exterior_facet_indices(mesh.topology)
    zero = dolfinx.fem.dirichletbc(PETSc.ScalarType(0), dolfinx.fem.locate_dofs_topological(space, 2, outside), space)
    source = dolfinx.fem.Constant(mesh, PETSc.ScalarType(1e-6))
    solved = dolfinx.fem.petsc.LinearProblem(ufl.inner(ufl.grad(u), ufl.grad(v)) * ufl.dx, source * v * ufl.dx, bcs=[zero],
                                             petsc_options={"ksp_type": "cg", "pc_type": "jacobi", "ksp_rtol": 1e-12}).solve()
    integral = comm.allreduce(dolfinx.fem.assemble_scalar(dolfinx.fem.form(solved * ufl.dx)))
    volume = comm.allreduce(dolfinx.fem.assemble_scalar(dolfinx.fem.form(dolfinx.fem.Constant(mesh, PETSc.ScalarType(1)) * ufl.dx)))
    if comm.rank == 0:
        print("INTEGRAL %.15g VOLUME %.15g CELLS %d" % (integral.real, volume.real, mesh.topology.index_map(3).size_global))


main()
