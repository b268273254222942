// SPDX-License-Identifier: MIT
// Divides a DomainMesh into its components and joins them again.
#include <algorithm>
#include <atomic>
#include <utility>

#include "common/parallel.hpp"
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

/// A source mesh of copied cells, with the numbers of its vertices and cells in the target mesh.
struct DomainMesh::CellCopies {
  const DomainMesh& from;
  const std::vector<VertexIndex>& row;
  const std::vector<CellIndex>& row_of_cell;
};

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

/// Fills a part of the mesh with cells of one component. `row` holds no_vertex for every vertex before and after.
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
    const CellIndex own = mesh.add_cell({row[t[0]], row[t[1]], row[t[2]], row[t[3]]}, component(c), shape_of(c));
    GEOMESH_CHECK(own == row_of_cell[c]);
    mesh.copy_cell({*this, row, row_of_cell}, c, open);
    for (const auto& e : edge_vertices)
      if (const Index curve = curve_of(t[e[0]], t[e[1]]); curve != no_index)
        mesh.curves_.insert({row[t[e[0]]], row[t[e[1]]]}, curve);
  }
  for (const VertexIndex v : part.vertices) row[v] = no_vertex;
}

void DomainMesh::put_together(std::vector<MeshPart> parts, unsigned threads) {
  std::size_t n = 0;
  for (const MeshPart& part : parts) n += part.mesh.n_cells();
  reserve(0, n);
  std::vector<OpenFace> open;
  for (MeshPart& part : parts) append(std::exchange(part, {}), thread_count(threads), open);
  link_faces(std::move(open));
}

/// Adds the cells and new vertices of a part. `open` receives the faces at which it may be connected with other parts.
void DomainMesh::append(const MeshPart part, unsigned threads, std::vector<OpenFace>& open) {
  constexpr std::size_t chunk = 16384;
  const DomainMesh& mesh = part.mesh;
  std::vector<VertexIndex> row = part.vertices;
  for (auto v = static_cast<VertexIndex>(row.size()); v < mesh.n_vertices(); ++v)
    row.push_back(add_vertex(mesh.point(v), mesh.kind(v), mesh.support(v)));
  std::vector<CellIndex> row_of_cell(mesh.n_slots(), no_cell);
  CellIndex end = n_slots();
  for (const CellIndex c : mesh.live_cells()) row_of_cell[c] = end++;
  mesh_.grow_to(end);
  attributes_.grow_to(end);
  std::vector<std::vector<OpenFace>> found((mesh.n_slots() + chunk - 1) / chunk);
  for_each_task(found.size(), threads, [&](std::size_t k) {
    for (std::size_t c = k * chunk; c < std::min<std::size_t>(mesh.n_slots(), (k + 1) * chunk); ++c)
      if (row_of_cell[c] != no_cell) copy_cell({mesh, row, row_of_cell}, static_cast<CellIndex>(c), found[k]);
  });
  for (const auto& of_chunk : found) open.insert(open.end(), of_chunk.begin(), of_chunk.end());
  // Each vertex refers to its cell of highest index, which belongs to the part that was added last.
  for_each_index(mesh.n_slots(), threads, [&](std::size_t c) {
    if (row_of_cell[c] == no_cell) return;
    for (const VertexIndex v : mesh.vertices(static_cast<CellIndex>(c))) {
      std::atomic_ref last(cell_of_[row[v]]);
      CellIndex known = last.load(std::memory_order_relaxed);
      while ((known == no_cell || known < row_of_cell[c]) &&
             !last.compare_exchange_weak(known, row_of_cell[c], std::memory_order_relaxed)) {
      }
    }
  });
  for (const VertexIndex v : row) changed_[v] = clock_;
}

/// Copies a cell into its slot and links it with neighbours of its component. `open` receives its other faces.
void DomainMesh::copy_cell(const CellCopies& copies, CellIndex c, std::vector<OpenFace>& open) {
  const DomainMesh& from = copies.from;
  const CellIndex own = copies.row_of_cell[c];
  TetMesh::Cell cell = from.mesh_.cells()[c];
  for (VertexIndex& v : cell.vertices) v = copies.row[v];
  attributes_.component[own] = from.attributes_.component[c];
  attributes_.tags[own] = from.attributes_.tags[c];
  attributes_.shape[own] = from.attributes_.shape[c];
  for (unsigned i = 0; i < 4; ++i) {
    FaceRef& n = cell.neighbors[i];
    if (n.valid() && from.component(n.cell()) == from.component(c)) {
      n = FaceRef(copies.row_of_cell[n.cell()], n.face());
    } else {
      n = {};
      open.push_back({face_key(cell.vertices, i), FaceRef(own, i)});
    }
  }
  mesh_.cells()[own] = cell;
  mesh_.flags(own) = 0;
}

}  // namespace geomesh::remesh
