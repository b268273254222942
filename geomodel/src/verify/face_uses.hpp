// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which tetrahedra and which listed faces stand on each triangle of a mesh.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geomesh/core/pod_array.hpp"
#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// A face of a tetrahedron, or a listed face, in two words: sorting them is what verification mostly does.
class FaceUse {
 public:
  static constexpr std::uint64_t limit = std::uint64_t{1} << 31;  ///< of points, tetrahedra and listed faces

  /// Precondition: vertices ascend; they and the row are below the limit. `even`: whether the cyclic order of the
  /// vertices was that of the ascending ones.
  FaceUse(const Triangle& vertices, Index row, bool is_listed, bool even)
      : first_(std::uint64_t{vertices[0]} << 32 | vertices[1]),
        last_(std::uint64_t{vertices[2]} << 33 | std::uint64_t{is_listed} << 32 | std::uint64_t{row} << 1 |
              std::uint64_t{even}) {}
  FaceUse() = default;

  VertexIndex least_vertex() const { return static_cast<VertexIndex>(first_ >> 32); }
  Index row() const { return static_cast<Index>((last_ & 0xffffffff) >> 1); }  ///< of the tetrahedron or listed face
  bool is_listed() const { return (last_ >> 32 & 1) != 0; }
  bool even() const { return (last_ & 1) != 0; }
  bool same_triangle(const FaceUse& o) const { return first_ == o.first_ && last_ >> 33 == o.last_ >> 33; }

  /// By vertices, then those of tetrahedra first, then by row.
  friend bool operator<(const FaceUse& p, const FaceUse& q) {
    return p.first_ != q.first_ ? p.first_ < q.first_ : p.last_ < q.last_;
  }

 private:
  std::uint64_t first_ = 0, last_ = 0;
};

/// All faces of a mesh, parted into blocks by their least vertex. Within a block the uses ascend, so that uses of one
/// triangle stand side by side, tetrahedra first. The blocks depend on the mesh alone.
///
/// Precondition: all vertex indices are in range, and counts below FaceUse::limit. O(n), and k log k for the k
/// uses of each least vertex; 16 bytes a use.
class FaceUses {
 public:
  FaceUses(const ModelMesh& mesh, unsigned threads);
  std::size_t n_blocks() const { return begin_.size() - 1; }
  std::span<const FaceUse> block(std::size_t b) const { return {uses_.data() + begin_[b], begin_[b + 1] - begin_[b]}; }

 private:
  PodArray<FaceUse> uses_;
  std::vector<std::size_t> begin_;  ///< by block; one more
};

}  // namespace geomesh::geomodel
