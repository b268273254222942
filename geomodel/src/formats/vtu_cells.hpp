// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Cells of a VTU, one number for all: tetrahedra, prisms, and with one grid for all also faces, edges of curves and
/// named points.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel {

enum class VtuCells : std::size_t { tetrahedra, prisms, faces, edges, points };
inline constexpr std::size_t n_vtu_cell_kinds = 5;

class VtuLayout {
 public:
  VtuLayout(const ModelMesh& mesh, const WriteOptions& options);

  std::size_t n_cells() const { return first_cell_.back(); }
  std::size_t n_entries() const { return first_entry_.back(); }
  /// `f(kind, row in that kind)` of a cell.
  template <class F>
  auto visit(std::size_t cell, F&& f) const {
    const std::size_t k = find(first_cell_, cell);
    return f(static_cast<VtuCells>(k), cell - first_cell_[k]);
  }
  std::uint8_t type(std::size_t cell) const;
  std::int64_t end_of(std::size_t cell) const;  ///< VTK's offset: where the cell's nodes end
  VertexIndex node(std::size_t entry) const;
  std::int32_t id(std::size_t cell) const;  ///< of the region, layer, surface, curve or point

 private:
  using Firsts = std::array<std::size_t, n_vtu_cell_kinds + 1>;
  static std::size_t find(const Firsts& firsts, std::size_t i) {
    std::size_t k = 0;
    while (i >= firsts[k + 1]) ++k;
    return k;
  }
  const ModelMesh* mesh_;
  std::array<std::size_t, n_vtu_cell_kinds> nodes_;
  Firsts first_cell_, first_entry_;
};

}  // namespace geomesh::geomodel
