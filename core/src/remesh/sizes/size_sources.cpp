// SPDX-License-Identifier: MIT
#include "remesh/sizes/size_sources.hpp"

#include <cmath>
#include <limits>

namespace geomesh::remesh {

void cover_triangle(const std::array<Vec3, 3>& corners, const AskedSize& asked, std::vector<SizeSource>& sources) {
  const auto& [a, b, c] = corners;
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  const int n = std::clamp(static_cast<int>(std::ceil(longest / (2 * asked.size))), 1, 100);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
      sources.push_back({(1 - u - v) * a + u * b + v * c, asked.size, asked.radius + 0.75 * (longest / n)});
    }
}

void cover_curves(const DomainMesh& mesh, const std::vector<AskedSize>& asked, std::vector<SizeSource>& sources) {
  for (const auto& [from, to] : mesh.curve_edges())
    for (const Index s : mesh.curve_class(mesh.curve_of(from, to)).segments) {
      if (s >= asked.size() || !(asked[s].size > 0)) continue;
      const Vec3 a = mesh.point(from), b = mesh.point(to);
      const double l = distance(a, b);
      const int n = std::clamp(static_cast<int>(std::ceil(l / (2 * asked[s].size))), 1, 10000);
      for (int i = 0; i <= n; ++i)
        sources.push_back({a + (static_cast<double>(i) / n) * (b - a), asked[s].size, asked[s].radius + 0.5 * l / n});
    }
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The face through which a ray leaves a cell, and the distance along the ray at which it does.
struct Exit {
  FaceRef face;
  double at = infinity;
  Vec3 normal;
};

constexpr unsigned no_face = 4;

/// Finds where the ray leaves the cell. `entered` is the face through which it has entered, or no_face.
Exit leave(const DomainMesh& mesh, CellIndex cell, unsigned entered, const Vec3& origin, const Vec3& direction) {
  Exit first;
  for (unsigned k = 0; k < 4; ++k) {
    if (k == entered) continue;
    const FaceRef f(cell, k);
    const Triangle t = mesh.face(f);
    const Vec3 m = mesh.normal(t);
    const double speed = -dot(m, direction);
    if (!(speed > 0)) continue;
    const double at = dot(m, origin - mesh.point(t[0])) / speed;
    if (at < first.at) first = {f, at, m};
  }
  return first;
}

/// Finds the next constrained face on a ray that starts in the cell or on its face `entered`. Returns no face if none
/// is reached within 500 cells. `visit` is called for each cell with the distance at which the ray leaves it.
template <class Visit>
Exit next_surface(const DomainMesh& mesh, CellIndex cell, unsigned entered, const Vec3& origin, const Vec3& direction,
                  const Visit& visit) {
  constexpr unsigned most_steps = 500;
  for (unsigned step = 0; step < most_steps; ++step) {
    const Exit out = leave(mesh, cell, entered, origin, direction);
    if (!out.face.valid()) return {};
    visit(cell, out.at);
    if (mesh.tag(out.face).constrained()) return out;
    const FaceRef beyond = mesh.cells().mirror(out.face);
    cell = beyond.cell();
    entered = beyond.face();
  }
  return {};
}

void pass(CellIndex, double) {}

/// A constrained face and another one opposite it, on the normal of the first at one of its points.
struct Facing {
  FaceRef face;
  Vec3 origin, normal;   ///< `normal`: unit normal of the first face, into its cell
  double width;          ///< distance of the opposite face from `origin` along `normal`
  Vec3 normal_of_other;  ///< unit normal of the opposite face, pointing away from the first face
};

/// Returns whether two surfaces that face each other meet within the distance `reach`, near the line in which the
/// planes of their faces intersect. Needles along the curve at which they meet may keep the faces from having common
/// vertices.
bool meet_within(const DomainMesh& mesh, const Facing& facing, double reach) {
  // Surfaces may meet up to this far from the line in which their planes intersect, relative to its distance.
  constexpr double share = 0.5;
  const Vec3 &n = facing.normal, m = facing.normal_of_other;
  // direction in the plane of the first face towards the line in which the planes of the two faces meet
  const Vec3 down = m - dot(m, n) * n;
  const double slope = length(down) / dot(m, n);
  if (!(facing.width > 0 && slope * reach >= facing.width)) return false;
  const Vec3 meeting = facing.origin + (facing.width / slope) * unit(down);
  const Vec3 halfway = facing.origin + (0.5 * facing.width) * n;
  CellIndex cell = no_cell;  // at halfway
  next_surface(mesh, facing.face.cell(), facing.face.face(), facing.origin, n, [&](CellIndex c, double at) {
    if (cell == no_cell && at >= 0.5 * facing.width) cell = c;
  });
  if (cell == no_cell) return false;
  const double way = distance(halfway, meeting);
  const Exit end = next_surface(mesh, cell, no_face, halfway, (1 / way) * (meeting - halfway), pass);
  return std::abs(end.at - way) <= share * way;
}

}  // namespace

double gap_width(const DomainMesh& mesh, FaceRef face, const Vec3& origin, double corner_reach) {
  constexpr double least_cosine = 0.5;
  const Triangle from = mesh.face(face);
  const Vec3 normal = unit(mesh.normal(from));
  const Exit out = next_surface(mesh, face.cell(), face.face(), origin, normal, pass);
  if (!out.face.valid()) return infinity;
  const Triangle to = mesh.face(out.face);
  const Vec3 normal_of_other = -1.0 * unit(out.normal);
  const bool is_corner = std::ranges::any_of(to, [&](VertexIndex v) { return std::ranges::count(from, v) > 0; });
  const bool is_facing = dot(normal_of_other, normal) > least_cosine;
  const double width = std::max(out.at, 0.0);
  if (is_corner || !is_facing) return infinity;
  return meet_within(mesh, {face, origin, normal, width, normal_of_other}, corner_reach) ? infinity : width;
}

}  // namespace geomesh::remesh
