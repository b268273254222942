// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks, groups and labels of the mesh as solver files hold it.
#include <algorithm>
#include <catch2/catch.hpp>

#include "hand_made.hpp"
#include "solver_mesh/solver_mesh.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

/// Three layers; every other face of the first surface lies on the second one, too.
ModelMesh mesh_with_shared_faces() {
  ModelMesh mesh = three_layer_mesh(2);
  const auto both = static_cast<std::int32_t>(mesh.surface_sets.size());
  mesh.surface_sets.push_back({mesh.surfaces[0].id, mesh.surfaces[1].id});
  bool takes = true;
  for (ModelMesh::Face& face : mesh.faces)
    if (face.surface == mesh.surfaces[0].id) {
      if (takes) face.surface_set = both;
      takes = !takes;
    }
  return mesh;
}

std::size_t n_faces_of_set(const ModelMesh& mesh, std::int32_t set) {
  return static_cast<std::size_t>(
      std::count_if(mesh.faces.begin(), mesh.faces.end(), [&](const auto& f) { return f.surface_set == set; }));
}

std::size_t n_cells_of(const SolverMesh& mesh, const CellGroup& group) {
  std::size_t n = 0;
  for (const std::size_t b : group.blocks) n += mesh.blocks[b].n_cells();
  return n;
}

}  // namespace

TEST_CASE("labels give each cell one number, whatever groups are asked for", "[writers]") {
  const ModelMesh model = mesh_with_shared_faces();
  const auto groups = GENERATE(GroupChoice::whole, GroupChoice::pieces, GroupChoice::both);
  WriteOptions options;
  options.groups = groups;
  const SolverMesh mesh = make_solver_mesh(model, options);
  std::vector<int> n_labels(mesh.blocks.size(), 0);
  for (const CellGroup& label : mesh.labels)
    for (const std::size_t b : label.blocks) {
      ++n_labels[b];
      CHECK(dimension_of(mesh.blocks[b].shape) == label.dimension);
    }
  CHECK(std::all_of(n_labels.begin(), n_labels.end(), [](int n) { return n == 1; }));
  std::vector<std::int32_t> ids;
  for (const CellGroup& label : mesh.labels) ids.push_back(label.id);
  std::sort(ids.begin(), ids.end());
  CHECK(std::adjacent_find(ids.begin(), ids.end()) == ids.end());

  // Faces of both surfaces are a label of their own; those of one surface have its id, if not its pieces are asked for.
  const std::string shared = model.surfaces[0].name + "+" + model.surfaces[1].name;
  std::size_t n_shared = 0, n_alone = 0;
  for (const CellGroup& label : mesh.labels) {
    if (label.members.size() == 2) {
      CHECK((groups == GroupChoice::pieces || label.full_name == shared));
      n_shared += n_cells_of(mesh, label);
    }
    if (label.members == std::vector{model.surfaces[0].id}) {
      CHECK((label.id == model.surfaces[0].id) == (groups != GroupChoice::pieces));
      n_alone += n_cells_of(mesh, label);
    }
  }
  CHECK(n_shared == n_faces_of_set(model, static_cast<std::int32_t>(model.surface_sets.size()) - 1));
  CHECK(n_alone == n_faces_of_set(model, 0));
}

TEST_CASE("groups of whole surfaces share the faces that lie on both", "[writers]") {
  const ModelMesh model = mesh_with_shared_faces();
  const SolverMesh mesh = make_solver_mesh(model, {});
  for (std::size_t s = 0; s < 2; ++s) {
    const auto group = std::find_if(mesh.groups.begin(), mesh.groups.end(),
                                    [&](const CellGroup& g) { return g.id == model.surfaces[s].id; });
    REQUIRE(group != mesh.groups.end());
    const auto both = static_cast<std::int32_t>(model.surface_sets.size()) - 1;
    CHECK(n_cells_of(mesh, *group) ==
          n_faces_of_set(model, static_cast<std::int32_t>(s)) + n_faces_of_set(model, both));
  }
}
