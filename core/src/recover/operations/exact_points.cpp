// SPDX-License-Identifier: MIT
#include "recover/operations/exact_points.hpp"

#include <algorithm>
#include <cmath>

namespace geomesh::recover {

using exact::LongExpansion;

namespace {

LongExpansion volume(const ConstrainedMesh& mesh, VertexIndex a, VertexIndex b, VertexIndex c, VertexIndex d) {
  return mesh.exact_places().volume(mesh.points(), {a, b, c, d});
}

/// Finds the parameter of v on the line first-last if it is known because v is an end or was placed on the line.
bool find_parameter(const ConstrainedMesh& mesh, VertexIndex v, VertexIndex first, VertexIndex last,
                    LongExpansion& out) {
  if (v == first || v == last) {
    out = v == first ? LongExpansion() : LongExpansion(1);
    return true;
  }
  if (!mesh.is_exact(v)) return false;
  const ExactPlace& place = mesh.exact_places().of(v);
  if (!place.is_on_line() || place.frame[0] != first || place.frame[1] != last) return false;
  out = place.parameter;
  return true;
}

ExactPlace on_line(const ConstrainedMesh& mesh, VertexIndex first, VertexIndex last, LongExpansion parameter) {
  ExactPlace out;
  out.frame = {first, last, no_vertex};
  for (std::size_t i = 0; i < 3; ++i) {
    const LongExpansion start = mesh.coordinate(first, i);
    out.coordinates[i] = start + parameter * (mesh.coordinate(last, i) - start);
  }
  out.parameter = std::move(parameter);
  return out;
}

}  // namespace

LongExpansion crossing_parameter(const ConstrainedMesh& mesh, VertexIndex a, VertexIndex b, const Triangle& plane,
                                 double error) {
  const LongExpansion at_a = volume(mesh, plane[0], plane[1], plane[2], a),
                      at_b = volume(mesh, plane[0], plane[1], plane[2], b);
  return exact::quotient(at_a, at_a - at_b, error);
}

ExactPlace place_on_line(const ConstrainedMesh& mesh, VertexIndex a, VertexIndex b, const LongExpansion& t,
                         double error) {
  VertexIndex first = a, last = b;
  for (const VertexIndex v : {a, b})
    if (mesh.is_exact(v) && mesh.exact_places().of(v).is_on_line()) {
      first = mesh.exact_places().of(v).frame[0];
      last = mesh.exact_places().of(v).frame[1];
      break;
    }
  LongExpansion from, to;
  if (!find_parameter(mesh, a, first, last, from) || !find_parameter(mesh, b, first, last, to)) {
    first = a;
    last = b;
    from = LongExpansion();
    to = LongExpansion(1);
  }
  const LongExpansion width = to - from;
  const double part = std::min(std::fabs(t.estimate()), std::fabs((LongExpansion(1) - t).estimate()));
  return on_line(mesh, first, last, (from + t * width).without_below(error * part * std::fabs(width.estimate())));
}

ExactPlace place_in_plane(const ConstrainedMesh& mesh, const Triangle& plane, VertexIndex below, VertexIndex above,
                          double error) {
  const LongExpansion w0 = volume(mesh, below, above, plane[1], plane[2]),
                      w1 = volume(mesh, below, above, plane[2], plane[0]),
                      w2 = volume(mesh, below, above, plane[0], plane[1]), sum = w0 + w1 + w2;
  const LongExpansion u = exact::quotient(w1, sum, error), v = exact::quotient(w2, sum, error);
  ExactPlace out;
  out.frame = plane;
  for (std::size_t i = 0; i < 3; ++i) {
    const LongExpansion o = mesh.coordinate(plane[0], i);
    out.coordinates[i] = o + u * (mesh.coordinate(plane[1], i) - o) + v * (mesh.coordinate(plane[2], i) - o);
  }
  return out;
}

ExactPlace place_moved(const ConstrainedMesh& mesh, VertexIndex x, const Vec3& step) {
  const ExactPlace& place = mesh.exact_places().of(x);
  if (place.is_on_line()) {
    const double least = 0x1p-60 * std::fabs(step.x);
    return on_line(mesh, place.frame[0], place.frame[1],
                   (place.parameter + LongExpansion(step.x)).without_below(least));
  }
  if (!place.is_in_plane()) return place_beside(mesh, x, step);
  ExactPlace out = place;
  for (std::size_t i = 0; i < 3; ++i) {
    const LongExpansion o = mesh.coordinate(place.frame[0], i);
    out.coordinates[i] = out.coordinates[i] + (mesh.coordinate(place.frame[1], i) - o) * step.x +
                         (mesh.coordinate(place.frame[2], i) - o) * step.y;
  }
  return out;
}

ExactPlace place_beside(const ConstrainedMesh& mesh, VertexIndex x, const Vec3& step) {
  const double least = 0x1p-60 * std::max({std::fabs(step.x), std::fabs(step.y), std::fabs(step.z)});
  ExactPlace out;
  for (std::size_t i = 0; i < 3; ++i)
    out.coordinates[i] = (mesh.coordinate(x, i) + LongExpansion(step[i])).without_below(least);
  return out;
}

}  // namespace geomesh::recover
