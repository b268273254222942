// SPDX-License-Identifier: MIT
#include "remesh/passes/vertex_blocks.hpp"

#include <algorithm>

namespace geomesh::remesh {

namespace {

constexpr unsigned n_halvings = 3;
constexpr std::size_t least_to_part = 4096;  ///< vertices; fewer are one block
constexpr std::uint8_t fixed = 255, shared = 254;

}  // namespace

VertexBlocks::VertexBlocks(const DomainMesh& mesh, std::vector<VertexIndex> movable)
    : mesh_(mesh), block_(mesh.n_vertices(), fixed) {
  halve(movable, movable.size() < least_to_part ? 0 : n_halvings);
  part_from_neighbours();
  parts_.resize(n_blocks_);
  for (const VertexIndex v : mesh.vertices_by_cells())
    if (block_[v] == shared)
      between_.push_back(v);
    else if (block_[v] != fixed)
      parts_[block_[v]].push_back(v);
}

/// By the median of the widest coordinate, again and again.
void VertexBlocks::halve(std::span<VertexIndex> vertices, unsigned times) {
  if (times == 0) {
    for (const VertexIndex v : vertices) block_[v] = n_blocks_;
    ++n_blocks_;
    return;
  }
  const unsigned axis = widest_axis(vertices);
  const auto middle = vertices.begin() + static_cast<std::ptrdiff_t>(vertices.size() / 2);
  std::nth_element(vertices.begin(), middle, vertices.end(), [&](VertexIndex u, VertexIndex v) {
    const double x = mesh_.point(u)[axis], y = mesh_.point(v)[axis];
    return x != y ? x < y : u < v;
  });
  halve({vertices.begin(), middle}, times - 1);
  halve({middle, vertices.end()}, times - 1);
}

unsigned VertexBlocks::widest_axis(std::span<const VertexIndex> vertices) const {
  Vec3 low = mesh_.point(vertices[0]), high = low;
  for (const VertexIndex v : vertices)
    for (unsigned i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], mesh_.point(v)[i]);
      high[i] = std::max(high[i], mesh_.point(v)[i]);
    }
  unsigned axis = 0;
  for (unsigned i = 1; i < 3; ++i)
    if (high[i] - low[i] > high[axis] - low[axis]) axis = i;
  return axis;
}

void VertexBlocks::part_from_neighbours() {
  std::vector<std::uint8_t> beside_other(block_.size(), false);
  for (CellIndex c = 0; c < mesh_.n_slots(); ++c) {
    if (!mesh_.is_live(c)) continue;
    std::uint8_t first = fixed;
    bool mixed = false;
    for (const VertexIndex v : mesh_.vertices(c)) {
      if (block_[v] == fixed) continue;
      if (first == fixed) first = block_[v];
      mixed |= block_[v] != first;
    }
    if (!mixed) continue;
    for (const VertexIndex v : mesh_.vertices(c)) beside_other[v] = true;
  }
  for (VertexIndex v = 0; v < block_.size(); ++v)
    if (beside_other[v] && block_[v] != fixed) block_[v] = shared;
}

}  // namespace geomesh::remesh
