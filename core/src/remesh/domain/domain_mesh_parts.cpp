// SPDX-License-Identifier: MIT
// DomainMesh taken apart by components and put together again.
#include <algorithm>
#include <utility>

#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

std::vector<MeshPart> DomainMesh::take_apart() {
  GEOMESH_CHECK(!journal_.is_open);
  std::vector<std::vector<CellIndex>> cells;
  std::vector<CellIndex> row_of_cell(n_slots(), no_cell);
  for (const CellIndex c : live_cells()) {
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
  std::vector<OpenFace> open;
  for (const CellIndex c : cells) {
    const Tetrahedron& t = vertices(c);
    for (const VertexIndex v : t)
      if (row[v] == no_vertex) {
        row[v] = mesh.add_vertex(points_[v], kinds_[v], supports_[v]);
        part.vertices.push_back(v);
      }
    mesh.copy_cell(*this, c, row, row_of_cell, open);
    for (const auto& e : edge_vertices)
      if (const Index curve = curve_of(t[e[0]], t[e[1]]); curve != no_index)
        mesh.curves_.insert({row[t[e[0]]], row[t[e[1]]]}, curve);
  }
  for (const VertexIndex v : part.vertices) row[v] = no_vertex;
}

void DomainMesh::put_together(std::vector<MeshPart> parts) {
  std::size_t n = 0;
  for (const MeshPart& part : parts) n += part.mesh.n_cells();
  reserve(0, n);
  std::vector<OpenFace> open;
  for (MeshPart& given : parts) {
    const MeshPart part = std::exchange(given, {});
    const DomainMesh& mesh = part.mesh;
    std::vector<VertexIndex> row = part.vertices;
    for (auto v = static_cast<VertexIndex>(row.size()); v < mesh.n_vertices(); ++v)
      row.push_back(add_vertex(mesh.point(v), mesh.kind(v), mesh.support(v)));
    std::vector<CellIndex> row_of_cell(mesh.n_slots(), no_cell);
    CellIndex next = n_slots();
    for (const CellIndex c : mesh.live_cells()) row_of_cell[c] = next++;
    for (const CellIndex c : mesh.live_cells()) copy_cell(mesh, c, row, row_of_cell, open);
  }
  link_faces(std::move(open));
}

/// Links with cells of its component, whose rows are known; `open` gets the other faces.
void DomainMesh::copy_cell(const DomainMesh& from, CellIndex c, const std::vector<VertexIndex>& row,
                           const std::vector<CellIndex>& row_of_cell, std::vector<OpenFace>& open) {
  Tetrahedron t = from.vertices(c);
  for (VertexIndex& v : t) v = row[v];
  const CellIndex own = add_cell(t, from.component(c), from.shape_of(c));
  attributes_.tags[own] = from.attributes_.tags[c];
  for (unsigned i = 0; i < 4; ++i)
    if (const FaceRef n = from.mesh_.neighbor(c, i); n.valid() && from.component(n.cell()) == from.component(c))
      mesh_.cells()[own].neighbors[i] = FaceRef(row_of_cell[n.cell()], n.face());
    else
      open.push_back({face_key(t, i), FaceRef(own, i)});
}

}  // namespace geomesh::remesh
