// SPDX-License-Identifier: GPL-3.0-or-later
// Which faults displace a horizon, found from its points on both sides of each; declared in
// geomesh/geomodel/model_rules.hpp.
//
// Near a fault, within eight of the horizon's edges, places of the horizon are taken in stretches along the strike.
// With large triangles it is eight twentieths of the fault's length. In each, two planes of the same dip are fitted to
// the points of the two sides; their distance along the vertical is the throw there. A fault counts where the throw is
// more than three times the points' spread about the planes in at least a quarter of the stretches. A point counts for
// the fault that is nearest to it alone. A fault counts, too, where it alone lies between two sheets of the horizon
// that both come near it: who gives blocks has parted them there. It does not count where others part the same sheets
// with less of them on the wrong side. Cost: points of such horizons times triangles of faults.
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "geomesh/geomodel/model_rules.hpp"
#include "naming/region_facts.hpp"
#include "naming/sheets.hpp"
#include "naming/sums.hpp"
#include "rules/throw/sheet_sides.hpp"
#include "rules/throw/throw_ramp.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double band_of_edges = 8;     // edges of the horizon on each side of a fault
constexpr double stretch_of_edges = 8;  // along the strike
constexpr double least_stretches =
    0.05;                       // spacing of places, of the fault's length: large triangles are looked at between
constexpr int most_parts = 64;  // of a triangle's side
constexpr std::size_t fewest_a_side = 3;  // points of a stretch
constexpr double sure_of_spread = 3;      // of the points about the planes
constexpr double least_of_edges = 1e-3;   // of throw: less is rounding
constexpr double share_of_stretches = 0.25;
constexpr double share_of_points = 0.75;  // that are fitted; the others may be overshoot
constexpr double spread_of_all = 1.9;     // by that of the nearest three quarters, of normal errors
constexpr int rounds_of_fit = 6;

/// A point of the horizon beside a fault.
struct BesidePoint {
  double across, along, height;
};

/// The distance of the two planes, and how the points spread about them; nothing where a side has too few points. The
/// quarter of the points that is furthest off does not count: blocks overshoot the fault.
struct StretchThrow {
  double throw_there, spread;
};
std::optional<StretchThrow> throw_of(std::vector<BesidePoint> points) {
  const Vec3 origin{points[0].across, points[0].along, points[0].height};
  for (BesidePoint& p : points) p.along -= origin.y, p.height -= origin.z;
  Eigen::Vector4d fitted = Eigen::Vector4d::Zero();  // height above, height below, dip across, dip along
  const auto off = [&](const BesidePoint& p) {
    return std::abs(fitted[p.across > 0 ? 0 : 1] + fitted[2] * p.across + fitted[3] * p.along - p.height);
  };
  std::size_t n = points.size();
  for (int round = 0; round < rounds_of_fit; ++round) {
    const auto n_above =
        static_cast<std::size_t>(std::count_if(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(n),
                                               [](const BesidePoint& p) { return p.across > 0; }));
    if (n_above < fewest_a_side || n - n_above < fewest_a_side) return std::nullopt;
    Eigen::MatrixXd terms(static_cast<Eigen::Index>(n), 4);
    Eigen::VectorXd heights(static_cast<Eigen::Index>(n));
    for (std::size_t k = 0; k < n; ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      terms.row(row) << (points[k].across > 0 ? 1.0 : 0.0), (points[k].across > 0 ? 0.0 : 1.0), points[k].across,
          points[k].along;
      heights[row] = points[k].height;
    }
    fitted = terms.completeOrthogonalDecomposition().solve(heights);
    std::sort(points.begin(), points.end(),
              [&](const BesidePoint& p, const BesidePoint& q) { return off(p) < off(q); });
    n = static_cast<std::size_t>(share_of_points * static_cast<double>(points.size()));
  }
  double squares = 0;
  for (std::size_t k = 0; k < n; ++k) squares += off(points[k]) * off(points[k]);
  return StretchThrow{fitted[0] - fitted[1], spread_of_all * std::sqrt(squares / static_cast<double>(n))};
}

double median_edge(const TriangulatedSurface& surface) {
  std::vector<double> lengths;
  for (const Triangle& t : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) lengths.push_back(norm(surface.points[t[i]] - surface.points[t[(i + 1) % 3]]));
  return lengths.empty() ? 0 : median(std::move(lengths));
}

/// What was found of one fault.
struct Found {
  std::size_t n_stretches = 0, n_with_throw = 0;
  double greatest = 0;
  double share() const {
    return n_stretches == 0 ? 0 : static_cast<double>(n_with_throw) / static_cast<double>(n_stretches);
  }
  bool displaces() const { return n_with_throw > 0 && share() >= share_of_stretches; }
};

/// Points on the triangle, about `spacing` apart: the centres of equal parts of it.
template <class F>
void for_each_sample(const std::array<Vec3, 3>& corners, double spacing, F&& visit) {
  const Vec3 u = corners[1] - corners[0], v = corners[2] - corners[0];
  const double longest = std::max({norm(u), norm(v), norm(corners[2] - corners[1])});
  const int n = std::clamp(static_cast<int>(std::ceil(longest / spacing)), 1, most_parts);
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) visit(corners[0] + ((i + 1.0 / 3) / n) * u + ((j + 1.0 / 3) / n) * v);
}

/// By fault: the places of the horizon that are nearest to it, by stretches along its strike.
std::vector<Found> throws_of(const TriangulatedSurface& horizon, const std::vector<FaultFaces>& faults) {
  double edge = median_edge(horizon);
  for (const FaultFaces& fault : faults) edge = std::min(edge, least_stretches * fault.extent());
  const double reach = band_of_edges * edge;
  std::vector<std::map<long, std::vector<BesidePoint>>> stretches(faults.size());
  const auto add = [&](const Vec3& p) {
    std::size_t own = faults.size();
    double across = reach;
    for (std::size_t f = 0; f < faults.size(); ++f)
      if (const auto d = faults[f].distance_over(p, std::abs(across))) own = f, across = *d;
    if (own == faults.size()) return;
    const double along = faults[own].along_strike(p);
    stretches[own][std::lround(along / (stretch_of_edges * edge))].push_back({across, along, p.z});
  };
  for (const Triangle& t : horizon.triangles) {
    const std::array<Vec3, 3> corners{horizon.points[t[0]], horizon.points[t[1]], horizon.points[t[2]]};
    const bool is_near = std::any_of(faults.begin(), faults.end(),
                                     [&](const FaultFaces& fault) { return fault.may_be_near(corners, reach); });
    if (is_near) for_each_sample(corners, edge, add);
  }
  std::vector<Found> found(faults.size());
  for (std::size_t f = 0; f < faults.size(); ++f)
    for (const auto& [at, points] : stretches[f]) {
      const auto there = throw_of(points);
      if (!there) continue;
      ++found[f].n_stretches;
      if (std::abs(there->throw_there) <= std::max(sure_of_spread * there->spread, least_of_edges * edge)) continue;
      ++found[f].n_with_throw;
      found[f].greatest = std::max(found[f].greatest, std::abs(there->throw_there));
    }
  return found;
}

}  // namespace

void find_throws(const std::vector<TriangulatedSurface>& surfaces, ModelRules& rules, std::vector<std::string>& notes,
                 std::vector<std::string>& warnings) {
  const bool any = std::any_of(rules.surfaces.begin(), rules.surfaces.end(),
                               [](const SurfaceRules& rule) { return rule.throw_auto; });
  if (!any) return;
  std::vector<FaultFaces> faults;
  std::vector<const TriangulatedSurface*> fault_surfaces;
  std::vector<std::string> names;
  for (const TriangulatedSurface& s : surfaces)
    if (s.kind == SurfaceKind::fault && !s.triangles.empty()) {
      faults.emplace_back(s);
      fault_surfaces.push_back(&s);
      names.push_back(s.name);
    }
  for (std::size_t s = 0; s < rules.surfaces.size(); ++s) {
    if (!rules.surfaces[s].throw_auto) continue;
    const std::vector<Found> found = throws_of(surfaces[s], faults);
    std::vector<double> evidence;
    for (const Found& f : found) evidence.push_back(f.share());
    const std::vector<SheetSides::Parting> parting = parting_of(surfaces[s], fault_surfaces, evidence);
    const std::vector<std::string> known = rules.surfaces[s].throw_at;  // by fault polygons
    for (std::size_t f = 0; f < found.size(); ++f) {
      if (std::find(known.begin(), known.end(), names[f]) != known.end()) continue;
      if (!found[f].displaces() && rules.surfaces[s].cut_smeared && has_smeared_throw(surfaces[s], faults, f)) {
        rules.surfaces[s].throw_at.push_back(names[f]);
        notes.push_back("horizon " + surfaces[s].name + ": throw across " + names[f] +
                        " found from the data, smeared along it");
        continue;
      }
      if (found[f].n_stretches == 0) continue;
      const std::string of = " of " + std::to_string(found[f].n_stretches) + " stretches along it";
      if (parting[f] == SheetSides::Parting::as_others) {
        notes.push_back("horizon " + surfaces[s].name + ": " + names[f] + " is not taken for one with throw: " +
                        "other faults lie between the same sheets, and fit them better");
      } else if (found[f].displaces()) {
        rules.surfaces[s].throw_at.push_back(names[f]);
        notes.push_back("horizon " + surfaces[s].name + ": throw across " + names[f] +
                        " found from the data, at most " + to_text(found[f].greatest) + " m, in " +
                        std::to_string(found[f].n_with_throw) + of);
      } else if (parting[f] == SheetSides::Parting::alone) {
        rules.surfaces[s].throw_at.push_back(names[f]);
        notes.push_back("horizon " + surfaces[s].name + ": " + names[f] + " lies between sheets of it, and parts them");
      } else {
        notes.push_back("horizon " + surfaces[s].name + ": no throw across " + names[f] +
                        " (more than the spread of the points in " + std::to_string(found[f].n_with_throw) + of + ")");
      }
    }
    if (rules.surfaces[s].throw_at.empty())
      warnings.push_back("horizon " + surfaces[s].name +
                         ": throw_at is auto, and no fault was found across which it has throw; name the faults");
  }
}

}  // namespace geomesh::geomodel
