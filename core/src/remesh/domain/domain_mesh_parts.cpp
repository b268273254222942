// SPDX-License-Identifier: MIT
// DomainMesh taken apart by components and put together again.
#include <algorithm>
#include <utility>

#include "remesh/domain/mesh_part.hpp"

namespace geomesh::remesh {

namespace {

/// Rows of what is gathered one by one, where first[] tells which was seen already.
VertexIndex row_of(VertexIndex v, std::vector<VertexIndex>& row, std::vector<VertexIndex>& gathered) {
  if (row[v] == no_vertex) {
    row[v] = static_cast<VertexIndex>(gathered.size());
    gathered.push_back(v);
  }
  return row[v];
}

}  // namespace

std::vector<MeshPart> DomainMesh::take_apart() {
  GEOMESH_CHECK(!journal_.is_open());
  std::vector<std::vector<CellIndex>> cells;
  std::vector<CellIndex> row_of_cell(n_slots(), no_cell);
  for (CellIndex c = 0; c < n_slots(); ++c) {
    if (!is_live(c)) continue;
    if (component(c) >= cells.size()) cells.resize(component(c) + std::size_t{1});
    row_of_cell[c] = static_cast<CellIndex>(cells[component(c)].size());
    cells[component(c)].push_back(c);
  }
  std::erase_if(cells, [](const auto& of_component) { return of_component.empty(); });
  std::vector<MeshPart> parts;
  std::vector<VertexIndex> row(n_vertices(), no_vertex);
  for (const std::vector<CellIndex>& of_component : cells) {
    parts.emplace_back();
    fill_part(of_component, row_of_cell, row, parts.back());
  }
  mesh_ = {};
  attributes_ = {};
  std::fill(cell_of_.begin(), cell_of_.end(), no_cell);
  return parts;
}

/// `row` has no_vertex everywhere, and has it again afterwards.
void DomainMesh::fill_part(const std::vector<CellIndex>& cells, const std::vector<CellIndex>& row_of_cell,
                           std::vector<VertexIndex>& row, MeshPart& part) const {
  DomainMesh& mesh = part.mesh;
  mesh.measure_ = measure_;
  for (const CellIndex c : cells) {
    Tetrahedron t = vertices(c);
    for (VertexIndex& v : t) v = row_of(v, row, part.vertices);
    while (mesh.n_vertices() < part.vertices.size()) {
      const VertexIndex v = part.vertices[mesh.n_vertices()];
      mesh.add_vertex(points_[v], kinds_[v], supports_[v]);
    }
    const CellIndex own = mesh.add_cell(t, component(c), shape_of(c));
    mesh.attributes_.tags[own] = attributes_.tags[c];
    for (unsigned i = 0; i < 4; ++i)
      if (const FaceRef n = mesh_.neighbor(c, i); n.valid() && component(n.cell()) == component(c))
        mesh.mesh_.cells()[own].neighbors[i] = FaceRef(row_of_cell[n.cell()], n.face());
    for (const auto& e : edge_vertices)
      if (const Index curve = curve_of(vertices(c)[e[0]], vertices(c)[e[1]]); curve != no_index)
        mesh.curves_.insert({t[e[0]], t[e[1]]}, curve);
  }
  for (const VertexIndex v : part.vertices) row[v] = no_vertex;
}

void DomainMesh::put_together(std::vector<MeshPart> parts) {
  std::size_t n = 0;
  for (const MeshPart& part : parts) n += part.mesh.n_cells();
  reserve(0, n);
  std::vector<std::pair<FaceKey, FaceRef>> open;
  for (MeshPart& given : parts) {
    const MeshPart part = std::exchange(given, {});
    std::vector<VertexIndex> row = part.vertices;
    for (auto v = static_cast<VertexIndex>(row.size()); v < part.mesh.n_vertices(); ++v)
      row.push_back(add_vertex(part.mesh.point(v), part.mesh.kind(v), part.mesh.support(v)));
    append_cells(part.mesh, row, open);
  }
  std::sort(open.begin(), open.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t k = 0; k + 1 < open.size(); ++k)
    if (open[k].first == open[k + 1].first) mesh_.link(open[k].second, open[k + 1].second);
}

/// `open` gets their faces that have no neighbour in the part.
void DomainMesh::append_cells(const DomainMesh& part, const std::vector<VertexIndex>& row,
                              std::vector<std::pair<FaceKey, FaceRef>>& open) {
  std::vector<CellIndex> row_of_cell(part.n_slots(), no_cell);
  CellIndex next = n_slots();
  for (CellIndex c = 0; c < part.n_slots(); ++c)
    if (part.is_live(c)) row_of_cell[c] = next++;
  for (CellIndex c = 0; c < part.n_slots(); ++c) {
    if (!part.is_live(c)) continue;
    Tetrahedron t = part.vertices(c);
    for (VertexIndex& v : t) v = row[v];
    const CellIndex own = add_cell(t, part.component(c), part.shape_of(c));
    attributes_.tags[own] = part.attributes_.tags[c];
    for (unsigned i = 0; i < 4; ++i)
      if (const FaceRef n = part.mesh_.neighbor(c, i); n.valid())
        mesh_.cells()[own].neighbors[i] = FaceRef(row_of_cell[n.cell()], n.face());
      else
        open.push_back({face_key(t, i), FaceRef(own, i)});
  }
}

}  // namespace geomesh::remesh
