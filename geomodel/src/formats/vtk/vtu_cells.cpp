// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/vtk/vtu_cells.hpp"

namespace geomesh::geomodel {

namespace {

/// Order of the nodes of a VTK wedge. The normal of its first face points outwards, that of a prism in the mesh
/// inwards.
constexpr std::array<std::size_t, 6> vtk_wedge{0, 2, 1, 3, 5, 4};

}  // namespace

VtuLayout::VtuLayout(const ModelMesh& mesh, const WriteOptions& options, const MeshPart* part)
    : mesh_(&mesh), part_(part) {
  n_nodes_ = part ? part->nodes.size() : mesh.points.size() + mesh.midpoints.points.size();
  const bool second = !mesh.midpoints.empty();
  nodes_ = second ? decltype(nodes_){10, 6, 6, 3, 1} : decltype(nodes_){4, 6, 3, 2, 1};
  const bool faces = options.single_grid && !part, curves = faces && options.curves;
  const std::array<std::size_t, n_vtu_cell_kinds> n{
      part ? part->cells.size() : mesh.tetrahedra.size(), part ? 0 : mesh.prisms.size(), faces ? mesh.faces.size() : 0,
      curves ? mesh.curve_edges.size() : 0, curves ? mesh.marked_points.size() : 0};
  first_cell_[0] = first_entry_[0] = 0;
  for (std::size_t k = 0; k < n_vtu_cell_kinds; ++k) {
    first_cell_[k + 1] = first_cell_[k] + n[k];
    first_entry_[k + 1] = first_entry_[k] + n[k] * nodes_[k];
  }
}

std::uint8_t VtuLayout::type(std::size_t cell) const {
  constexpr std::array<std::uint8_t, n_vtu_cell_kinds> first_order{10, 13, 5, 3, 1}, second_order{24, 13, 22, 21, 1};
  const std::size_t k = find(first_cell_, cell);
  return mesh_->midpoints.empty() ? first_order[k] : second_order[k];
}

std::int64_t VtuLayout::end_of(std::size_t cell) const {
  const std::size_t k = find(first_cell_, cell);
  return static_cast<std::int64_t>(first_entry_[k] + (cell - first_cell_[k] + 1) * nodes_[k]);
}

VertexIndex VtuLayout::node(std::size_t entry) const {
  return part_ ? part_->local(node_of_mesh(entry)) : node_of_mesh(entry);
}

VertexIndex VtuLayout::node_of_mesh(std::size_t entry) const {
  const std::size_t k = find(first_entry_, entry), at = entry - first_entry_[k];
  const std::size_t i = at % nodes_[k], row = part_ ? part_->cells[at / nodes_[k]] : at / nodes_[k];
  const Midpoints& mid = mesh_->midpoints;
  switch (static_cast<VtuCells>(k)) {
    case VtuCells::tetrahedra:
      return i < 4 ? mesh_->tetrahedra[row][i] : mid.of_tetrahedron[row][i - 4];
    case VtuCells::prisms:
      return mesh_->prisms[row].vertices[vtk_wedge[i]];
    case VtuCells::faces:
      return i < 3 ? mesh_->faces[row].vertices[i] : mid.of_face[row][i - 3];
    case VtuCells::edges:
      return i == 0 ? mesh_->curve_edges[row].a : i == 1 ? mesh_->curve_edges[row].b : mid.of_curve_edge[row];
    case VtuCells::points:
      break;
  }
  return mesh_->marked_points[row].v;
}

std::int32_t VtuLayout::id(std::size_t cell) const {
  return visit(cell, [&](VtuCells kind, std::size_t row) {
    switch (kind) {
      case VtuCells::tetrahedra:
        return mesh_->tet_region[row];
      case VtuCells::prisms:
        return mesh_->prisms[row].layer;
      case VtuCells::faces:
        return mesh_->faces[row].surface;
      case VtuCells::edges:
        return mesh_->curve_edges[row].curve;
      case VtuCells::points:
        break;
    }
    return mesh_->marked_points[row].id;
  });
}

}  // namespace geomesh::geomodel
