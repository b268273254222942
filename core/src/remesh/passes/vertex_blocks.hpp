// SPDX-License-Identifier: MIT
/// @file
/// Vertices parted in space, so that those of different blocks can be moved at once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

/// No vertex in a block shares a cell with a vertex that is in another block or between blocks. Each list is in the
/// order of the cells. Blocks depend on the mesh alone. O(n).
class VertexBlocks {
 public:
  VertexBlocks(const DomainMesh& mesh, std::vector<VertexIndex> movable);
  const std::vector<std::vector<VertexIndex>>& parts() const { return parts_; }
  const std::vector<VertexIndex>& between() const { return between_; }

 private:
  void halve(std::span<VertexIndex> vertices, unsigned times);
  unsigned widest_axis(std::span<const VertexIndex> vertices) const;
  void part_from_neighbours();

  const DomainMesh& mesh_;
  std::vector<std::uint8_t> block_;  // by vertex
  std::uint8_t n_blocks_ = 0;
  std::vector<std::vector<VertexIndex>> parts_;
  std::vector<VertexIndex> between_;
};

}  // namespace geomesh::remesh
