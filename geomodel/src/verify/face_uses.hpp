// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the tetrahedra and constrained faces that share each triangle of a mesh.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geomesh/core/pod_array.hpp"
#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// A face of a tetrahedron, or a constrained face, in two words, because sorting takes most of the verification time.
class FaceUse {
 public:
  /// Upper limit on the numbers of points, tetrahedra and constrained faces.
  static constexpr std::uint64_t limit = std::uint64_t{1} << 31;

  /// Packs a face into two words. `row` is the index of the tetrahedron or constrained face. Preconditions: the
  /// vertices are ascending; vertices and `row` are below `limit`. `even` is whether sorting the vertices kept their
  /// cyclic order.
  FaceUse(const Triangle& vertices, Index row, bool is_listed, bool even)
      : first_(std::uint64_t{vertices[0]} << 32 | vertices[1]),
        last_(std::uint64_t{vertices[2]} << 33 | std::uint64_t{is_listed} << 32 | std::uint64_t{row} << 1 |
              std::uint64_t{even}) {}
  FaceUse() = default;

  VertexIndex least_vertex() const { return static_cast<VertexIndex>(first_ >> 32); }
  /// Index of the tetrahedron to which the face belongs, or of the constrained face in the mesh's list.
  Index row() const { return static_cast<Index>((last_ & 0xffffffff) >> 1); }
  bool is_listed() const { return (last_ >> 32 & 1) != 0; }
  bool even() const { return (last_ & 1) != 0; }
  bool same_triangle(const FaceUse& o) const { return first_ == o.first_ && last_ >> 33 == o.last_ >> 33; }

  /// Orders faces by their vertices. Of equal triangles, faces of tetrahedra precede constrained faces, each by index.
  friend bool operator<(const FaceUse& p, const FaceUse& q) {
    return p.first_ != q.first_ ? p.first_ < q.first_ : p.last_ < q.last_;
  }

 private:
  std::uint64_t first_ = 0, last_ = 0;
};

/// All faces of a mesh, divided into blocks by their smallest vertex. Within a block the faces are ascending, so that
/// equal triangles are adjacent, those of tetrahedra first. The blocks depend on the mesh alone. Precondition: all
/// vertex indices are in range, and counts are below FaceUse::limit. O(n), and k log k for the k faces with the same
/// smallest vertex; 16 bytes per face.
class FaceUses {
 public:
  FaceUses(const ModelMesh& mesh, unsigned threads);
  std::size_t n_blocks() const { return begin_.size() - 1; }
  std::span<const FaceUse> block(std::size_t b) const { return {uses_.data() + begin_[b], begin_[b + 1] - begin_[b]}; }

 private:
  PodArray<FaceUse> uses_;
  std::vector<std::size_t> begin_;  ///< by block of faces: index of its first face; at the end the number of faces
};

}  // namespace geomesh::geomodel
