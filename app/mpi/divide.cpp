// SPDX-License-Identifier: GPL-3.0-or-later
#include "divide.hpp"

#include <algorithm>
#include <cmath>

#include "corners.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "partition/metis.hpp"
#include "solver_mesh/face_sides.hpp"

namespace geomesh::app {

namespace {

using geomodel::Neighbours;

/// Number of elements of size one that meshing makes in a unit volume, 30 % more than regular tetrahedra would be; and
/// number of regular triangles of size one in a unit area.
constexpr double elements_a_cube = 11, faces_a_square = 2.3;

double cube(double x) { return x * x * x; }

class Divider {
 public:
  Divider(const SparseModel& model, int n_ranks)
      : model_(model), n_ranks_(n_ranks), across_(geomodel::tetrahedra_across(model.mesh.tetrahedra)) {
    for (const auto& face : model.mesh.faces) constrained_.push_back(sorted_corners(face.vertices));
    std::sort(constrained_.begin(), constrained_.end());
  }

  std::vector<std::int32_t> run() {
    part_ = geomodel::parts_by_metis(across_, n_ranks_, weights());
    smooth();
    return std::move(part_);
  }

 private:
  const Vec3& point(std::size_t t, unsigned i) const { return model_.mesh.points[model_.mesh.tetrahedra[t][i]]; }
  Corners face(std::size_t t, unsigned i) const { return sorted_corners(face_at(model_.mesh.tetrahedra[t], i)); }
  bool is_constrained(std::size_t t, unsigned i) const {
    return std::binary_search(constrained_.begin(), constrained_.end(), face(t, i));
  }
  /// Estimates how many elements refinement makes in a tetrahedron from the target sizes at its corners and centre.
  double elements(std::size_t t) const {
    const Vec3 middle = 0.25 * ((point(t, 0) + point(t, 1)) + (point(t, 2) + point(t, 3)));
    double density = 0.5 / cube(model_.size.at(middle, model_.component[t]));
    for (unsigned i = 0; i < 4; ++i) density += 0.125 / cube(model_.size.at(point(t, i), model_.component[t]));
    const Vec3 a = point(t, 1) - point(t, 0), b = point(t, 2) - point(t, 0), c = point(t, 3) - point(t, 0);
    return elements_a_cube * density * dot(cross(a, b), c) / 6;
  }
  double faces(std::size_t t, unsigned i) const {
    if (is_constrained(t, i)) return 0;
    // The corners are in ascending order, so that both tetrahedra at the face estimate the same number of elements.
    const Corners at = face(t, i);
    const Vec3 &a = model_.mesh.points[at[0]], &b = model_.mesh.points[at[1]], &c = model_.mesh.points[at[2]];
    const Vec3 n = cross(b - a, c - a);
    const double h = model_.size.at((1.0 / 3) * (a + b + c), model_.component[t]);
    return faces_a_square * 0.5 * std::sqrt(dot(n, n)) / (h * h);
  }
  geomodel::PartWeights weights() const {
    geomodel::PartWeights weights;
    for (std::size_t t = 0; t < across_.size(); ++t) {
      weights.of_cell.push_back(std::max(1.0, elements(t)));
      std::array<double, 4> cut{};
      for (unsigned i = 0; i < 4; ++i)
        if (across_[t][i] != geomodel::no_neighbour) cut[i] = std::max(1.0, faces(t, i));
      weights.of_face.push_back(cut);
    }
    return weights;
  }
  /// Moves each tetrahedron that has two or more faces on another part, and more than on its own, to that part.
  void smooth() {
    constexpr unsigned rounds = 4;
    for (unsigned round = 0; round < rounds; ++round)
      for (std::size_t t = 0; t < part_.size(); ++t) {
        unsigned n_own = 0;
        for (unsigned i = 0; i < 4; ++i) n_own += is_free(t, i) && part_[across_[t][i]] == part_[t];
        for (unsigned i = 0; i < 4; ++i) {
          if (!is_free(t, i) || part_[across_[t][i]] == part_[t]) continue;
          const std::int32_t other = part_[across_[t][i]];
          unsigned n_other = 0;
          for (unsigned k = 0; k < 4; ++k) n_other += is_free(t, k) && part_[across_[t][k]] == other;
          if (n_other < 2 || n_other <= n_own) continue;
          part_[t] = other;
          break;
        }
      }
  }
  bool is_free(std::size_t t, unsigned i) const {
    return across_[t][i] != geomodel::no_neighbour && !is_constrained(t, i);
  }

  const SparseModel& model_;
  int n_ranks_;
  std::vector<Neighbours> across_;
  std::vector<Corners> constrained_;
  std::vector<std::int32_t> part_;
};

}  // namespace

std::vector<std::int32_t> divide(const SparseModel& model, int n_ranks) {
  if (n_ranks == 1) return std::vector<std::int32_t>(model.mesh.tetrahedra.size(), 0);
  return Divider(model, n_ranks).run();
}

}  // namespace geomesh::app
