// SPDX-License-Identifier: MIT
#include "quality/causes.hpp"

#include <algorithm>

#include "quality/measure/measures.hpp"
#include "quality/measure/shape.hpp"

namespace geomesh {

namespace {

constexpr double share_of_size = 0.25;  // gaps below this share of the asked size force

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
  const Gap gap = gaps_.narrowest(w.tetrahedron, options_.gaps_stay ? 0 : 2 * options_.tolerance);
  if (!(gap.width < limit)) return;
  w.cause = ShapeCause::thin_gap;
  w.gap = gap.width;
  w.facet_a = gap.facet_a, w.facet_b = gap.facet_b;
  w.segment_a = gap.segment_a, w.segment_b = gap.segment_b;
}

void CauseFinder::explain(WorstElement& w) {
  if (!explain_by_angle(w)) explain_by_gap(w);
}

std::vector<Index> unforced_bad_elements(const ConstrainedTetrahedralization& mesh, const QualityOptions& options,
                                         const InputCreases& creases, std::size_t n_judged) {
  std::vector<WorstElement> bad;
  const double limit = remesh::DihedralMeasure::of_angle(options.bad_angle);
  for (Index row = 0; row < std::min(n_judged, mesh.tetrahedra.size()); ++row) {
    const Tetrahedron& t = mesh.tetrahedra[row];
    const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]], &d = mesh.points[t[3]];
    if (remesh::shape_of_cell<remesh::DihedralMeasure>(a, b, c, d) > limit)
      continue;  // quick: the measure is not above the least sine
    const double least = tetrahedron_shape(a, b, c, d).min_dihedral;
    if (!(least < options.bad_angle)) continue;
    WorstElement& w = bad.emplace_back();
    w.tetrahedron = row;
    w.min_dihedral = least;
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
