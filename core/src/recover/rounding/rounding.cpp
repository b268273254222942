// SPDX-License-Identifier: MIT
#include "recover/rounding/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "common/sort_unique.hpp"
#include "recover/model/recovery_budget.hpp"
#include "recover/operations/cavity_retriangulation.hpp"
#include "recover/operations/exact_points.hpp"
#include "recover/rounding/chebyshev_centre.hpp"
#include "recover/rounding/kernel_of_star.hpp"
#include "recover/steiner_removal/point_removal.hpp"

namespace geomesh::recover {

namespace {

/// A direction in which a Steiner point with exact coordinates may move, and the step of place_moved() for unit length.
struct Freedom {
  Vec3 direction, step;
};

/// The star of a vertex with an exact place, described by the heights of the vertex over the faces of its link.
class Star {
 public:
  Star(ConstrainedMesh& mesh, VertexIndex x) : mesh_(mesh), x_(x) { mesh.star(x, cells_); }

  bool is_positive() const {
    return std::all_of(cells_.begin(), cells_.end(), [&](CellIndex c) {
      return !mesh_.cells().is_ghost(c) && mesh_.positive(mesh_.cells().vertices(c));
    });
  }

  /// Returns how far to move the vertex in each direction so that the least height over the star's faces is greatest;
  /// nothing if there is no gain.
  std::optional<std::array<double, 3>> best_steps(std::span<const Freedom> freedoms) const {
    std::vector<LinearHeight> heights;
    for (const CellIndex c : cells_) {
      const LinearHeight h = height_of(c, freedoms);
      if (!(h.at > 0) || !std::isfinite(length(Vec3{h.slope[0], h.slope[1], h.slope[2]}))) return std::nullopt;
      heights.push_back(h);
    }
    const unsigned n_directions = static_cast<unsigned>(freedoms.size());
    const std::array<double, 3> steps = chebyshev_centre(heights, n_directions, recovery_budget.centring_steps);
    if (!(least_height(heights, steps) > recovery_budget.centring_gain * least_height(heights, {})))
      return std::nullopt;
    return steps;
  }

 private:
  LinearHeight height_of(CellIndex c, std::span<const Freedom> freedoms) const {
    const unsigned i = mesh_.cells().index_of(c, x_);
    const Tetrahedron& v = mesh_.cells().vertices(c);
    const auto& f = face_vertices[i];
    const Vec3 n = cross(mesh_.offset(v[f[0]], v[f[1]]), mesh_.offset(v[f[0]], v[f[2]]));
    const double area = length(n);
    const double volume = mesh_.exact_places().rough_volume(mesh_.points(), {v[f[0]], v[f[1]], v[f[2]], x_});
    LinearHeight out{volume / area, {}};
    for (std::size_t k = 0; k < freedoms.size(); ++k) out.slope[k] = dot(n, freedoms[k].direction) / area;
    return out;
  }

  ConstrainedMesh& mesh_;
  VertexIndex x_;
  std::vector<CellIndex> cells_;
};

std::vector<Freedom> freedoms(const ConstrainedMesh& mesh, VertexIndex x) {
  const ExactPlace& place = mesh.exact_places().of(x);
  if (!place.is_on_line() && !place.is_in_plane())
    return {{{1, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 0, 1}}};
  const Vec3 u = mesh.offset(place.frame[0], place.frame[1]);
  const double length = std::sqrt(dot(u, u));
  std::vector<Freedom> out{{(1 / length) * u, {1 / length, 0, 0}}};
  if (place.is_on_line()) return out;
  const Vec3 v = mesh.offset(place.frame[0], place.frame[2]);
  const double along = dot(u, v) / dot(u, u);
  const Vec3 w = v - along * u;
  const double height = std::sqrt(dot(w, w));
  out.push_back({(1 / height) * w, {-along / height, 1 / height, 0}});
  return out;
}

void centre(ConstrainedMesh& mesh, VertexIndex x) {
  const std::vector<Freedom> ways = freedoms(mesh, x);
  const Star star(mesh, x);
  const auto steps = star.best_steps(ways);
  if (!steps) return;
  Vec3 move;
  for (std::size_t k = 0; k < ways.size(); ++k) move = move + (*steps)[k] * ways[k].step;
  const ExactPlace before = mesh.exact_places().of(x);
  for (double part = 1; part > recovery_budget.least_centring_part; part /= 2) {
    ExactPlace place = place_moved(mesh, x, part * move);
    if (!place.is_safe()) continue;
    mesh.move_point(x, std::move(place));
    if (star.is_positive()) return;
    mesh.move_point(x, before);
  }
}

/// Rounds an exact point to the nearest double, or to a double an ulp or two away, so that all cells of its star are
/// positive. Returns false if there is no such double.
bool round_point(ConstrainedMesh& mesh, VertexIndex x) {
  const Star star(mesh, x);
  const ExactPlace exact = mesh.exact_places().of(x);
  const Vec3 near = exact.nearest();
  for (int ulps = 0; ulps <= recovery_budget.ulps; ++ulps)
    for (int code = 0; code < (ulps == 0 ? 1 : 27); ++code) {
      Vec3 p = near;
      for (std::size_t i = 0, rest = static_cast<std::size_t>(code); i < 3; ++i, rest /= 3)
        for (int k = 0; k < ulps && rest % 3 != 0; ++k)
          p[i] = std::nextafter(
              p[i], rest % 3 == 1 ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity());
      mesh.move_point(x, p);
      if (star.is_positive()) return true;
    }
  mesh.move_point(x, exact);
  return false;
}

}  // namespace

namespace {

/// Moves the rounded Steiner points beside x to better centred doubles, which can give x more room.
void make_room(Recovery& recovery, VertexIndex x) {
  ConstrainedMesh& mesh = recovery.mesh;
  for (const VertexIndex y : mesh.neighbors(x)) {
    if (y < first_added(recovery) || mesh.is_exact(y) || is_on_boundary(recovery, y)) continue;
    const Vec3 before = mesh.point(y);
    ExactPlace place;
    for (std::size_t i = 0; i < 3; ++i) place.coordinates[i] = mesh.coordinate(y, i);
    mesh.move_point(y, std::move(place));
    centre(mesh, y);
    if (!round_point(mesh, y)) mesh.move_point(y, before);
  }
}

/// Returns the vertices with exact places that are part of the result: not those in no cell or outside the model.
std::vector<VertexIndex> vertices_to_round(Recovery& recovery) {
  const ConstrainedMesh& mesh = recovery.mesh;
  std::vector<VertexIndex> out;
  for (VertexIndex v = first_added(recovery); v < mesh.points().size(); ++v)
    if (mesh.is_exact(v) && mesh.in_mesh(v)) out.push_back(v);
  if (out.empty()) return out;
  const std::vector<std::uint8_t> outside = cells_outside(mesh);
  std::erase_if(out, [&](VertexIndex v) { return !is_on_boundary(recovery, v) && outside[mesh.cell_of(v)] != 0; });
  return out;
}

/// Moves x to any double from which its whole star is visible, however thin the star is. Points of segments and facets
/// are not moved, because they must remain near these.
bool round_anywhere_in_star(Recovery& recovery, VertexIndex x) {
  ConstrainedMesh& mesh = recovery.mesh;
  if (is_on_boundary(recovery, x)) return false;
  std::vector<CellIndex> cells;
  mesh.star(x, cells);
  const auto kernel = kernel_of_star(mesh, cells, x);
  if (!kernel) return false;
  const Star star(mesh, x);
  const ExactPlace exact = mesh.exact_places().of(x);
  const auto fits = [&](const Vec3& p) {
    mesh.move_point(x, p);
    return star.is_positive();
  };
  if (find_double_inside(*kernel, fits)) return true;
  mesh.move_point(x, exact);
  return false;
}

/// Returns places beside a star at which there may be more room than inside: the centres of the adjacent cells that no
/// locked face separates from the star.
std::vector<Vec3> places_about(const ConstrainedMesh& mesh, const std::vector<CellIndex>& star, VertexIndex x) {
  std::vector<CellIndex> cells;
  for (const CellIndex c : star) {
    const FaceRef link(c, mesh.cells().index_of(c, x));
    const CellIndex beyond = mesh.cells().mirror(link).cell();
    if (!mesh.is_locked(link) && !mesh.cells().is_ghost(beyond)) cells.push_back(beyond);
  }
  sort_unique(cells);
  std::vector<Vec3> out;
  for (const CellIndex c : cells) {
    Vec3 sum;
    for (const VertexIndex v : mesh.cells().vertices(c)) sum = sum + mesh.point(v);
    out.push_back(0.25 * sum);
  }
  return out;
}

/// Replaces an inner point by a double outside its star, which grows across faces not visible from the new point.
bool round_elsewhere(Recovery& recovery, VertexIndex x) {
  ConstrainedMesh& mesh = recovery.mesh;
  if (is_on_boundary(recovery, x)) return false;
  std::vector<CellIndex> star;
  mesh.star(x, star);
  const Cavity cavity(recovery, star, x);
  const VertexIndex y = mesh.add_point(mesh.point(x));
  recovery.constraints.vertices.resize(mesh.points().size(), {VertexOrigin::inside, no_index});
  for (const Vec3& place : places_about(mesh, star, x)) {
    mesh.move_point(y, place);
    Cavity trial = cavity;
    const auto filling = trial.star_from(y, recovery_budget.rounding_growths);
    if (!filling) continue;
    mesh.replace(trial.cells(), *filling);
    mesh.forget(x);
    return true;
  }
  mesh.drop_last_point();
  recovery.constraints.vertices.pop_back();
  return false;
}

}  // namespace

std::vector<VertexIndex> round_exact_points(Recovery& recovery) {
  ConstrainedMesh& mesh = recovery.mesh;
  std::vector<VertexIndex> left = vertices_to_round(recovery);
  for (unsigned round = 0; round < recovery_budget.rounding_rounds && !left.empty(); ++round) {
    recovery.context.check_cancelled();
    for (unsigned sweep = 0; sweep < recovery_budget.centring_sweeps; ++sweep)
      for (const VertexIndex v : left) centre(mesh, v);
    std::erase_if(left, [&](VertexIndex v) { return round_point(mesh, v); });
    for (const VertexIndex v : left) make_room(recovery, v);
  }
  std::erase_if(left, [&](VertexIndex v) { return round_elsewhere(recovery, v); });
  return left;
}

void round_anywhere_in_stars(Recovery& recovery, std::vector<VertexIndex>& left) {
  std::erase_if(left, [&](VertexIndex v) { return round_anywhere_in_star(recovery, v); });
}

}  // namespace geomesh::recover
