// SPDX-License-Identifier: MIT
#include "quality/causes.hpp"

#include <algorithm>

#include "common/geometry.hpp"
#include "quality/measure/measures.hpp"
#include "quality/measure/shape.hpp"
#include "search/closest_point.hpp"

namespace geomesh {

namespace {

constexpr double share_of_size = 0.25;      // gaps narrower than this share of the target size impose bad elements
constexpr double angle_at_short_edge = 20;  // input angles below this many degrees impose short edges

}  // namespace

InputCreases find_creases(const PiecewiseLinearComplex& plc, const QualityOptions& options) {
  if (options.facet_patch.empty() || !(options.tolerance > 0)) return {};
  return {plc, options.facet_patch, options.forcing_angle, options.tolerance};
}

CauseFinder::CauseFinder(const ConstrainedTetrahedralization& mesh, const QualityOptions& options,
                         const InputCreases& creases)
    : mesh_(mesh),
      options_(options),
      stars_(mesh, options.facet_patch, &creases),
      gaps_(stars_, options.forcing_angle, options.tolerance == 0),
      angles_(mesh.points.size(), MeetingAngle{.degrees = -1}) {}

const MeetingAngle& CauseFinder::angle_at(VertexIndex v) {
  if (angles_[v].degrees < 0) angles_[v] = stars_.least_angle(v);
  return angles_[v];
}

bool CauseFinder::explain_by_angle(WorstElement& w) {
  MeetingAngle least{.degrees = options_.forcing_angle};
  for (const VertexIndex v : mesh_.tetrahedra[w.tetrahedron])
    if (angle_at(v).degrees < least.degrees) least = angle_at(v);
  if (!(least.degrees < options_.forcing_angle)) return false;
  w.cause = ShapeCause::input_angle;
  w.forcing_angle = least.degrees;
  w.facet_a = least.facet_a, w.facet_b = least.facet_b;
  w.segment_a = least.segment_a, w.segment_b = least.segment_b;
  return true;
}

void CauseFinder::explain_by_gap(WorstElement& w) const {
  const SizeField* const asked = options_.asked ? options_.asked : options_.size;
  if (!asked) return;
  const double limit = share_of_size * asked->at(w.place, mesh_.component[w.tetrahedron]);
  const Gap gap = gap_of(w.tetrahedron);
  if (!(gap.width < limit)) return;
  w.cause = ShapeCause::thin_gap;
  w.gap = gap.width;
  w.facet_a = gap.facet_a, w.facet_b = gap.facet_b;
  w.segment_a = gap.segment_a, w.segment_b = gap.segment_b;
}

void CauseFinder::explain(WorstElement& w) {
  if (!explain_by_angle(w)) explain_by_gap(w);
}

bool CauseFinder::are_ends_of_near_curves(const ShortEdge& e, bool have_common_neighbour) const {
  const auto at_a = stars_.edges(e.a), at_b = stars_.edges(e.b);
  if (at_a.empty() || at_b.empty()) return false;
  const bool is_along = std::any_of(at_a.begin(), at_a.end(), [&](const SoupEdge& s) { return s.other == e.b; });
  return is_along ? at_a.size() != 2 && at_b.size() != 2 : !have_common_neighbour;
}

bool CauseFinder::is_needed_on_curve(VertexIndex v, double tolerance) const {
  const auto at_v = stars_.edges(v);
  if (at_v.size() != 2) return true;
  const Vec3 &a = mesh_.points[at_v[0].other], &b = mesh_.points[at_v[1].other];
  return distance(mesh_.points[v], search::closest_on_segment(mesh_.points[v], a, b)) > tolerance;
}

bool CauseFinder::is_between_bends(const ShortEdge& e) const {
  const auto at_a = stars_.edges(e.a);
  if (std::none_of(at_a.begin(), at_a.end(), [&](const SoupEdge& s) { return s.other == e.b; })) return false;
  double tolerance = options_.tolerance;
  if (options_.tolerance_share > 0) tolerance = std::min(tolerance, options_.tolerance_share * e.size);
  return is_needed_on_curve(e.a, tolerance) && is_needed_on_curve(e.b, tolerance);
}

void CauseFinder::explain(ShortEdge& e, std::span<const Index> cells, double share) {
  std::vector<VertexIndex> about{e.a, e.b};  // ends of the short edge, and vertices where curves from both ends meet
  for (const SoupEdge& x : stars_.edges(e.a))
    for (const SoupEdge& y : stars_.edges(e.b))
      if (x.other == y.other) about.push_back(x.other);
  double least = angle_at_short_edge;
  for (const VertexIndex v : about) least = std::min(least, angle_at(v).degrees);
  if (least < angle_at_short_edge) {
    e.cause = EdgeCause::input_angle;
    e.forcing_angle = least;
  } else if (are_ends_of_near_curves(e, about.size() > 2)) {
    e.cause = EdgeCause::near_curves;
  } else if (is_between_bends(e)) {
    e.cause = EdgeCause::bends;
  } else {
    for (const Index c : cells) {
      const double width = gap_of(c).width;
      if (!(width < share * e.size)) continue;
      e.cause = EdgeCause::thin_gap;
      e.gap = width;
      return;
    }
  }
}

std::optional<double> angle_if_bad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double bad_angle) {
  // Skips most cells by the dihedral measure, which is never above the sine of the least dihedral angle.
  if (remesh::shape_of_cell<remesh::DihedralMeasure>(a, b, c, d) > remesh::DihedralMeasure::of_angle(bad_angle))
    return std::nullopt;
  const double least = tetrahedron_shape(a, b, c, d).min_dihedral;
  return least < bad_angle ? std::optional(least) : std::nullopt;
}

std::vector<Index> unforced_bad_elements(const ConstrainedTetrahedralization& mesh, const QualityOptions& options,
                                         const InputCreases& creases, std::span<const Index> judged) {
  std::vector<WorstElement> bad;
  for (const Index row : judged) {
    const Tetrahedron& t = mesh.tetrahedra[row];
    const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]], &d = mesh.points[t[3]];
    const std::optional<double> least = angle_if_bad(a, b, c, d, options.bad_angle);
    if (!least) continue;
    WorstElement& w = bad.emplace_back();
    w.tetrahedron = row;
    w.min_dihedral = *least;
    w.place = 0.25 * (a + b + c + d);
  }
  if (bad.empty()) return {};
  CauseFinder causes(mesh, options, creases);
  for (WorstElement& w : bad) causes.explain(w);
  std::erase_if(bad, [](const WorstElement& w) { return w.cause != ShapeCause::free; });
  std::stable_sort(bad.begin(), bad.end(),
                   [](const WorstElement& a, const WorstElement& b) { return a.min_dihedral < b.min_dihedral; });
  std::vector<Index> rows;
  for (const WorstElement& w : bad) rows.push_back(w.tetrahedron);
  return rows;
}

}  // namespace geomesh
