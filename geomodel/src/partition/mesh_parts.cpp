// SPDX-License-Identifier: GPL-3.0-or-later
#include "partition/mesh_parts.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "partition/metis.hpp"
#include "solver_mesh/face_sides.hpp"

namespace geomesh::geomodel {

VertexIndex MeshPart::local(VertexIndex row) const {
  const auto found = std::lower_bound(nodes.begin(), nodes.end(), row);
  return found != nodes.end() && *found == row ? static_cast<VertexIndex>(found - nodes.begin()) : no_vertex;
}

template <class F>
void MeshParts::for_each_node(std::size_t cell, F&& f) const {
  for (const VertexIndex v : mesh_.tetrahedra[cell]) f(v);
  if (!mesh_.midpoints.empty())
    for (const VertexIndex v : mesh_.midpoints.of_tetrahedron[cell]) f(v);
}

MeshParts::MeshParts(const ModelMesh& mesh, std::int32_t n_parts)
    : mesh_(mesh), n_parts_(n_parts), across_(tetrahedra_across(mesh.tetrahedra)) {
  part_of_cell_ = parts_by_metis(across_, n_parts);
  own_.resize(static_cast<std::size_t>(n_parts));
  for (std::size_t t = 0; t < part_of_cell_.size(); ++t) own_[static_cast<std::size_t>(part_of_cell_[t])].push_back(t);
  find_parts_at_nodes();
  find_ghosts();
}

MeshParts::MeshParts(const ModelMesh& mesh, GivenPart given)
    : mesh_(mesh), n_parts_(given.n_parts), given_(std::move(given)), is_given_(true) {
  across_ = tetrahedra_across(mesh.tetrahedra);
  part_of_cell_ = given_.part_of_cell;
  first_ = std::move(given_.first_at_node);
  parts_at_ = std::move(given_.parts_at);
  own_.resize(static_cast<std::size_t>(n_parts_));
  ghosts_.resize(own_.size());
  const auto here = static_cast<std::size_t>(given_.number);
  for (std::size_t t = 0; t < part_of_cell_.size(); ++t)
    (part_of_cell_[t] == given_.number ? own_ : ghosts_)[here].push_back(t);
  std::size_t first = 0;
  for (const Region& region : mesh.regions) {
    first_of_region_.push_back(first);
    first += region.n_tetrahedra;
  }
}

std::vector<std::int32_t> MeshParts::parts_here() const {
  if (is_given_) return {given_.number};
  std::vector<std::int32_t> all(static_cast<std::size_t>(n_parts_));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::size_t MeshParts::n_nodes_of_whole() const {
  return is_given_ ? given_.n_nodes : mesh_.points.size() + mesh_.midpoints.points.size();
}

std::size_t MeshParts::n_cells_of_whole() const { return is_given_ ? given_.n_cells : mesh_.tetrahedra.size(); }

std::size_t MeshParts::n_cells_of_region(std::int32_t id) const {
  return mesh_.regions[static_cast<std::size_t>(id - 1)].n_tetrahedra;
}

std::size_t MeshParts::number_in_region(std::size_t row, std::size_t row_in_block) const {
  if (!is_given_) return row_in_block;
  return cell_number(row) - first_of_region_[static_cast<std::size_t>(mesh_.tet_region[row] - 1)];
}

void MeshParts::find_parts_at_nodes() {
  const std::size_t n_nodes = mesh_.points.size() + mesh_.midpoints.points.size();
  std::vector<std::size_t> end(n_nodes + 1, 0);
  for (std::size_t t = 0; t < part_of_cell_.size(); ++t) for_each_node(t, [&](VertexIndex v) { ++end[v + 1]; });
  for (std::size_t v = 0; v < n_nodes; ++v) end[v + 1] += end[v];
  std::vector<std::int32_t> all(end.back());
  std::vector<std::size_t> fill(end.begin(), end.end() - 1);
  for (std::size_t t = 0; t < part_of_cell_.size(); ++t)
    for_each_node(t, [&](VertexIndex v) { all[fill[v]++] = part_of_cell_[t]; });
  first_.assign(1, 0);
  for (std::size_t v = 0; v < n_nodes; ++v) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(end[v]);
    const auto last = all.begin() + static_cast<std::ptrdiff_t>(end[v + 1]);
    std::sort(begin, last);
    parts_at_.insert(parts_at_.end(), begin, std::unique(begin, last));
    first_.push_back(parts_at_.size());
  }
}

void MeshParts::find_ghosts() {
  ghosts_.resize(own_.size());
  std::vector<std::int32_t> others;
  for (std::size_t t = 0; t < part_of_cell_.size(); ++t) {
    others.clear();
    for (const VertexIndex v : mesh_.tetrahedra[t])
      for (const std::int32_t p : parts_at(v))
        if (p != part_of_cell_[t]) others.push_back(p);
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    for (const std::int32_t p : others) ghosts_[static_cast<std::size_t>(p)].push_back(t);
  }
}

MeshPart MeshParts::part(std::int32_t number, Ghosts ghosts) const {
  const auto k = static_cast<std::size_t>(number);
  MeshPart part{number, own_[k], own_[k].size(), {}};
  if (ghosts == Ghosts::one_layer) part.cells.insert(part.cells.end(), ghosts_[k].begin(), ghosts_[k].end());
  for (const std::size_t t : part.cells) for_each_node(t, [&](VertexIndex v) { part.nodes.push_back(v); });
  std::sort(part.nodes.begin(), part.nodes.end());
  part.nodes.erase(std::unique(part.nodes.begin(), part.nodes.end()), part.nodes.end());
  return part;
}

std::vector<BorderFace> MeshParts::border_faces(std::int32_t number) const {
  std::vector<BorderFace> faces;
  for (const std::size_t t : own_[static_cast<std::size_t>(number)])
    for (unsigned i = 0; i < 4; ++i)
      if (const std::size_t other = across_[t][i]; other != no_neighbour && part_of_cell_[other] != number)
        faces.push_back({t, i, part_of_cell_[other]});
  const auto key = [this](const BorderFace& f) {
    const std::size_t own = cell_number(f.cell), other = cell_number(across_[f.cell][f.opposite]);
    return std::tuple(f.other_part, std::min(own, other), std::max(own, other));
  };
  std::sort(faces.begin(), faces.end(), [&](const BorderFace& a, const BorderFace& b) { return key(a) < key(b); });
  return faces;
}

}  // namespace geomesh::geomodel
