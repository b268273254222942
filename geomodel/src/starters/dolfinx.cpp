// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a starter script for dolfinx, run as `python3 STEM.dolfinx.py`. It runs with dolfinx 0.5; functions that later
// versions renamed are tried under their later names first.
#include "geomesh/geomodel/writers.hpp"
#include "starters/starter_model.hpp"
#include "starters/starters.hpp"
#include "writers/text_buffer.hpp"

namespace geomesh::geomodel {

namespace {

constexpr const char* head = R"py(import os

import numpy
import ufl
from dolfinx import fem, io
from dolfinx.fem.petsc import LinearProblem
from mpi4py import MPI
from petsc4py.PETSc import ScalarType

folder = os.path.dirname(os.path.abspath(__file__))
functionspace = getattr(fem, "functionspace", None) or fem.FunctionSpace
)py";

constexpr const char* body = R"py(

def read_mesh():
    """The mesh with the tags of its regions and faces."""
    with io.XDMFFile(MPI.COMM_WORLD, os.path.join(folder, name + ".xdmf"), "r") as file:
        mesh = file.read_mesh(name="mesh")
        regions = file.read_meshtags(mesh, name="mesh")
    mesh.topology.create_connectivity(2, 3)
    with io.XDMFFile(MPI.COMM_WORLD, os.path.join(folder, name + ".facets.xdmf"), "r") as file:
        return mesh, regions, file.read_meshtags(mesh, name="facet_tags")


def by_region(mesh, regions, values):
    """A function that is constant in each cell."""
    function = fem.Function(functionspace(mesh, ("DG", 0)))
    for tag, (_, value) in values.items():
        function.x.array[regions.indices[regions.values == tag]] = value
    return function


def solve():
    """Temperature in steady state."""
    mesh, regions, facets = read_mesh()
    space = functionspace(mesh, ("CG", 1))
    conditions = []
    for tags, value in fixed:
        on = facets.indices[numpy.isin(facets.values, tags)]
        conditions.append(fem.dirichletbc(ScalarType(value), fem.locate_dofs_topological(space, 2, on), space))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    k = by_region(mesh, regions, conductivity)
    source = fem.Constant(mesh, ScalarType(0))
    problem = LinearProblem(ufl.inner(k * ufl.grad(u), ufl.grad(v)) * ufl.dx, source * v * ufl.dx, bcs=conditions,
                            petsc_options={"ksp_type": "cg", "pc_type": "jacobi", "ksp_rtol": 1e-10})
    return mesh, regions, problem.solve()


if __name__ == "__main__":
    mesh, regions, temperature = solve()
    temperature.name = "temperature"
    with io.XDMFFile(mesh.comm, os.path.join(folder, name + ".temperature.xdmf"), "w") as file:
        file.write_mesh(mesh)
        file.write_function(temperature)
    print("temperature from %g to %g" % (temperature.x.array.min(), temperature.x.array.max()))
)py";

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

void add_condition(const StarterModel& model, const std::string& surface, double temperature, TextBuffer& text) {
  text << "    ([";
  bool is_first = true;
  for (const StarterGroup& group : model.groups_of(surface, "tag")) {
    text << (is_first ? "" : ", ") << group.id;
    is_first = false;
  }
  text << "], " << temperature << "),\n";
}

}  // namespace

std::filesystem::path write_dolfinx_starter(const ModelMesh& mesh, const std::filesystem::path& stem) {
  const std::filesystem::path mesh_file = stem.string() + ".xdmf", file = stem.string() + ".dolfinx.py";
  const StarterModel model = starter_model(mesh, mesh_file, "tag");
  TextBuffer text;
  text << "#!/usr/bin/python3\n\"\"\"Steady heat flow through the model, by dolfinx. Lengths are in " << mesh.unit
       << ", materials in SI units.\"\"\"\n"
       << head << "name = " << quoted(stem.filename().string()) << "\n# Tag of a region: its name, W/(m K).\n"
       << "conductivity = {\n";
  for (const StarterRegion& region : model.regions)
    text << "    " << region.group.id << ": (" << quoted(region.group.full_name) << ", "
         << region.material.conductivity.value << "),  # " << origin_of(region.material.conductivity) << "\n";
  text << "}\n# Tags of the faces of " << model.highest;
  if (model.lowest != model.highest) text << " and of " << model.lowest;
  text << ", with their temperature.\nfixed = [\n";
  add_condition(model, model.highest, temperature_above, text);
  if (model.lowest != model.highest) add_condition(model, model.lowest, temperature_below, text);
  text << "]\n" << body;
  write_text_file(file, text.text());
  return file;
}

}  // namespace geomesh::geomodel
