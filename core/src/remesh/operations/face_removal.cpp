// SPDX-License-Identifier: MIT
// Removal of a face by an edge across it, declared in remesh/operations/improve.hpp.
#include <algorithm>
#include <optional>

#include "quality/measure/shape.hpp"
#include "remesh/operations/improve.hpp"

namespace geomesh::remesh {

namespace {

class FaceRemoval {
 public:
  FaceRemoval(Toolbox& tools, CellIndex c, unsigned i)
      : tools_(tools), mesh_(tools.mesh), removed_{c, no_cell}, i_(i) {}

  bool attempt() {
    if (mesh_.tag(removed_[0], i_).constrained()) return false;
    const double worst =
        std::min(mesh_.shape_of(removed_[0]), mesh_.shape_of(mesh_.topology().neighbor_cell(removed_[0], i_)));
    return attempt(worst * (1 + 1e-6) + 1e-12);
  }

  bool attempt(double floor) {
    if (mesh_.tag(removed_[0], i_).constrained()) return false;
    find_cells();
    return worth_of_new(floor).has_value() && replace();
  }

  bool attempt(const MeanGoal& goal) {
    if (mesh_.tag(removed_[0], i_).constrained()) return false;
    const double s = mesh_.shape_of(removed_[0]), t = mesh_.shape_of(mesh_.topology().neighbor_cell(removed_[0], i_));
    const CellQuality& measure = mesh_.measure();
    const double needed = measure.worth(s) + measure.worth(t) + goal.mean + MeanGoal::least_gain;
    if (needed > measure.most_of_three()) return false;
    find_cells();
    const auto sum = worth_of_new(goal.least_after(std::min(s, t)));
    return sum && *sum > needed && replace();
  }

 private:
  void find_cells() {
    const FaceRef mirror = mesh_.topology().neighbor(removed_[0], i_);
    removed_[1] = mirror.cell();
    const Tetrahedron& t = mesh_.vertices(removed_[0]);
    top_ = t[i_], bottom_ = mesh_.vertices(mirror.cell())[mirror.face()];
    face_ = {t[face_vertices[i_][0]], t[face_vertices[i_][1]], t[face_vertices[i_][2]]};
  }

  /// Sum of the worths of the three new cells; nothing where one is not above `needed` or not positive.
  std::optional<double> worth_of_new(double needed) const {
    const Vec3 &p = mesh_.point(top_), &q = mesh_.point(bottom_);
    if (needed >= 0 && !may_all_be_positive(p, q)) return std::nullopt;
    double sum = 0;
    for (unsigned k = 0; k < 3; ++k) {
      const Vec3 &x = mesh_.point(face_[k]), &y = mesh_.point(face_[(k + 1) % 3]);
      const double s = mesh_.measure().shape(x, y, q, p);
      if (!(s > needed) || !is_positive(x, y, q, p)) return std::nullopt;
      sum += mesh_.measure().worth(s);
    }
    return sum;
  }

  /// The volumes that shapes are made of, before the first shape: mostly the edge passes beside the face.
  bool may_all_be_positive(const Vec3& p, const Vec3& q) const {
    const Vec3 &x = mesh_.point(face_[0]), &y = mesh_.point(face_[1]), &z = mesh_.point(face_[2]);
    const Vec3 a = x - p, b = y - p, c = z - p, d = q - p;
    return dot(a, cross(b, d)) < 0 && dot(b, cross(c, d)) < 0 && dot(c, cross(a, d)) < 0;
  }

  bool replace() {
    auto& added = tools_.work.added;
    added.clear();
    for (unsigned k = 0; k < 3; ++k)
      added.push_back({{face_[k], face_[(k + 1) % 3], bottom_, top_}, mesh_.component(removed_[0]), {}});
    mesh_.replace(removed_, added, tools_.work.created);
    ++tools_.statistics.face_removals;
    return true;
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  std::array<CellIndex, 2> removed_;
  unsigned i_;
  VertexIndex top_ = no_vertex, bottom_ = no_vertex;
  Triangle face_{};
};

}  // namespace

bool remove_face(Toolbox& tools, CellIndex c, unsigned i) { return FaceRemoval(tools, c, i).attempt(); }
bool remove_face_above(Toolbox& tools, CellIndex c, unsigned i, double floor) {
  return FaceRemoval(tools, c, i).attempt(floor);
}
bool remove_face_for_mean(Toolbox& tools, CellIndex c, unsigned i, const MeanGoal& goal) {
  return FaceRemoval(tools, c, i).attempt(goal);
}

}  // namespace geomesh::remesh
