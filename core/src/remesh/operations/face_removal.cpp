// SPDX-License-Identifier: MIT
// Replaces a face by an edge across it. Declared in remesh/operations/improve.hpp.
#include <algorithm>

#include "quality/measure/shape.hpp"
#include "remesh/operations/improve.hpp"

namespace geomesh::remesh {

namespace {

/// Replaces one unconstrained face by the edge between the two vertices opposite it (2-3 flip).
class FaceRemoval {
 public:
  FaceRemoval(Toolbox& tools, CellIndex c, unsigned i)
      : tools_(tools),
        mesh_(tools.mesh),
        removed_{c, mesh_.cells().neighbor_cell(c, i)},
        top_(mesh_.vertices(c)[i]),
        bottom_(mesh_.vertices(removed_[1])[mesh_.cells().neighbor(c, i).face()]),
        face_(mesh_.face(c, i)) {}

  double shape_before(std::size_t k) const { return mesh_.shape_of(removed_[k]); }

  /// Makes the 2-3 flip if the shapes of all new cells are above `least`.
  bool attempt(double least) {
    if (!are_all_above(least)) return false;
    auto& added = tools_.work.added;
    added.clear();
    for (unsigned k = 0; k < 3; ++k)
      added.push_back({{face_[k], face_[(k + 1) % 3], bottom_, top_}, mesh_.component(removed_[0]), {}});
    if (!tools_.exchange(removed_)) return false;
    ++tools_.statistics.face_removals;
    return true;
  }

 private:
  /// Returns whether the three new cells of the 2-3 flip are positive and their shapes above `needed`.
  bool are_all_above(double needed) const {
    const Vec3 &p = mesh_.point(top_), &q = mesh_.point(bottom_);
    if (needed >= 0 && !may_all_be_positive(p, q)) return false;
    for (unsigned k = 0; k < 3; ++k) {
      const Tetrahedron t{face_[k], face_[(k + 1) % 3], bottom_, top_};
      if (!(mesh_.shape(t) > needed) || !mesh_.is_positive(t)) return false;
    }
    return true;
  }

  /// Returns whether the volumes of the three new cells of the 2-3 flip are positive in floating point. This is
  /// computed first, because most often the new edge misses the face and no shape is needed.
  bool may_all_be_positive(const Vec3& p, const Vec3& q) const {
    const Vec3 &x = mesh_.point(face_[0]), &y = mesh_.point(face_[1]), &z = mesh_.point(face_[2]);
    const Vec3 a = x - p, b = y - p, c = z - p, d = q - p;
    return dot(a, cross(b, d)) < 0 && dot(b, cross(c, d)) < 0 && dot(c, cross(a, d)) < 0;
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  std::array<CellIndex, 2> removed_;
  VertexIndex top_, bottom_;
  Triangle face_;
};

}  // namespace

bool remove_face(Toolbox& tools, CellIndex c, unsigned i) {
  if (tools.mesh.tag(c, i).constrained()) return false;
  FaceRemoval removal(tools, c, i);
  return removal.attempt(std::min(removal.shape_before(0), removal.shape_before(1)) * (1 + 1e-6) + 1e-12);
}
bool remove_face_above(Toolbox& tools, CellIndex c, unsigned i, double floor) {
  return !tools.mesh.tag(c, i).constrained() && FaceRemoval(tools, c, i).attempt(floor);
}

}  // namespace geomesh::remesh
