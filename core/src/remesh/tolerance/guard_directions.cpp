// SPDX-License-Identifier: MIT
/// Prevents folds of surfaces, which cells prevent only where both sides of a surface are meshed.
#include <algorithm>
#include <cmath>

#include "quality/measure/shape.hpp"
#include "remesh/tolerance/surface_guard.hpp"

namespace geomesh::remesh {

double SurfaceGuard::direction_cosine(const SurfaceFace& f) const {
  const auto& [a, b, c] = f.corners;
  const Vec3 n = cross(b - a, c - a);
  const double l = length(n);
  return l > 0 ? dot((1 / l) * n, normal(f.patch, (1.0 / 3) * (a + b + c))) : 1;
}

bool SurfaceGuard::are_turned_alike(Index patch, const std::vector<SurfaceFace>& faces,
                                    const std::vector<Index>& over) const {
  double side = 0;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (faces[k].patch != patch) continue;
    if (over[k] == no_index) return false;
    const auto& [a, b, c] = faces[k].corners;
    const double s = dot(cross(b - a, c - a), given_->normal(over[k], (1.0 / 3) * (a + b + c)));
    if (!(s * side >= 0) || s == 0) return false;
    side = s < 0 ? -1 : 1;
  }
  return true;
}

/// Returns whether no new face turns away from the reference surface. If curves are kept, new faces have the same
/// border as the removed ones and wind around it in the same way. If the reference surface is a single smooth layer
/// over each new face, no new face is steep to it, and all are oriented to the same side of it, this is also the side
/// of the removed faces. In this case the directions need not be computed.
bool SurfaceGuard::keeps_direction(const std::vector<SurfaceFace>& before, const std::vector<SurfaceFace>& after,
                                   const std::vector<Index>& over, bool curves_stay) const {
  constexpr double least_cosine = 0.2;  // 78 degrees
  struct Direction {
    Index patch;
    bool is_that_of_sheet = false;
    // sum and least of the cosines between normals of removed faces and of the reference
    double sum = 0, least = least_cosine;
  };
  std::vector<Direction> directions;
  const auto direction_of = [&](Index patch) -> const Direction& {
    const auto known =
        std::find_if(directions.begin(), directions.end(), [&](const Direction& d) { return d.patch == patch; });
    if (known != directions.end()) return *known;
    Direction& d = directions.emplace_back(Direction{patch});
    d.is_that_of_sheet = curves_stay && are_turned_alike(patch, after, over);
    if (d.is_that_of_sheet) return d;
    for (const SurfaceFace& b : before) {
      if (b.patch != patch) continue;
      const double cosine = direction_cosine(b);
      d.sum += cosine;
      d.least = std::min(d.least, std::abs(cosine));
    }
    return d;
  };
  return std::all_of(after.begin(), after.end(), [&](const SurfaceFace& f) {
    if (f.patch >= oriented_.size() || !oriented_[f.patch]) return true;
    const Direction& d = direction_of(f.patch);
    return d.is_that_of_sheet || (d.sum < 0 ? -1 : 1) * direction_cosine(f) >= d.least;
  });
}

}  // namespace geomesh::remesh
