// SPDX-License-Identifier: MIT
#include "remesh/domain/mesh_blocks.hpp"

#include <algorithm>

#include "common/geometry.hpp"
#include "common/parallel.hpp"
#include "geomesh/core/error.hpp"
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

namespace {

constexpr unsigned most_halvings = 6;
/// Position of the cut when vertices are bisected into blocks, for each of the divisions. Later divisions must not cut
/// near the cuts of the first, which are at halves, quarters and eighths.
constexpr std::array<double, MeshBlocks::n_divisions> cuts{0.5, 0.36, 0.64};

std::size_t widest_axis(const DomainMesh& mesh, std::span<const VertexIndex> vertices) {
  Box3 box;
  for (const VertexIndex v : vertices) box.add(mesh.point(v));
  const Vec3 extent = box.max - box.min;
  return extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
}

}  // namespace

MeshBlocks::MeshBlocks(const DomainMesh& mesh, unsigned division, const Rules& rules, unsigned threads)
    : block_(mesh.n_vertices(), 0) {
  std::vector<VertexIndex> vertices;
  vertices.reserve(mesh.n_vertices());
  for (VertexIndex v = 0; v < mesh.n_vertices(); ++v)
    if (mesh.kind(v) != VertexKind::dead) vertices.push_back(v);
  std::vector<std::span<VertexIndex>> ranges{vertices};
  for (unsigned k = 0; k < most_halvings && vertices.size() >= 2 * ranges.size() * rules.vertices_a_block; ++k) {
    std::vector<std::span<VertexIndex>> halves(2 * ranges.size());
    for_each_task(ranges.size(), threads, [&](std::size_t i) {
      const std::span<VertexIndex> all = ranges[i];
      const auto n = static_cast<std::size_t>(cuts.at(division) * static_cast<double>(all.size()));
      const std::size_t axis = widest_axis(mesh, all);
      std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n), all.end(),
                       [&](VertexIndex u, VertexIndex v) {
                         const double x = mesh.point(u)[axis], y = mesh.point(v)[axis];
                         return x != y ? x < y : u < v;
                       });
      halves[2 * i] = all.first(n);
      halves[2 * i + 1] = all.subspan(n);
    });
    ranges = std::move(halves);
  }
  n_blocks_ = ranges.size();
  for_each_task(ranges.size(), threads, [&](std::size_t i) {
    for (const VertexIndex v : ranges[i]) block_[v] = static_cast<Block>(i);
  });
}

std::vector<std::uint8_t> MeshBlocks::find_inner(const DomainMesh& mesh, unsigned threads) const {
  std::vector<std::uint8_t> inner(block_.size(), 1);
  for_each_index(mesh.n_slots(), threads, [&](std::size_t i) {
    const auto c = static_cast<CellIndex>(i);
    if (!mesh.is_live(c)) return;
    const Tetrahedron& t = mesh.vertices(c);
    if (has(block_[t[0]], t)) return;
    for (const VertexIndex v : t) std::atomic_ref(inner[v]).store(0, std::memory_order_relaxed);
  });
  return inner;
}

void FaceClaims::claim(FaceRef f, MeshBlocks::Block block) {
  const auto own = static_cast<std::uint16_t>(block + 1);
  std::uint16_t found = 0;
  if (!owner_[f.code].compare_exchange_strong(found, own) && found != own)
    throw InternalError("two blocks change one face of a cell");
}

bool BlockEdit::owns(const DomainMesh& mesh, std::span<const CellIndex> cells) {
  if (std::all_of(cells.begin(), cells.end(), [&](CellIndex c) { return blocks->has(block, mesh.vertices(c)); }))
    return true;
  was_stopped = true;
  return false;
}

bool BlockEdit::may_exchange(const DomainMesh& mesh, std::span<const CellIndex> removed, std::size_t n_added) {
  if (!owns(mesh, removed)) return false;
  if (free.size() + removed.size() >= n_added) return true;
  was_stopped = true;
  return false;
}

}  // namespace geomesh::remesh
