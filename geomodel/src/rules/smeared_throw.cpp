// SPDX-License-Identifier: GPL-3.0-or-later
// Ramps are found in stretches along the fault, from the slopes of triangles across it. Heights are carried by planes
// that are fitted with weights to the nodes of one side near the place (moving least squares; Levin, The approximation
// power of moving least-squares, Math. Comp. 67, 1998).
#include "rules/smeared_throw.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "common/union_find.hpp"
#include "naming/region_facts.hpp"
#include "naming/sheets.hpp"
#include "naming/sums.hpp"
#include "stack/single_valued.hpp"

namespace geomesh::geomodel {
namespace {

// Lengths in median edges of the horizon in the map.
constexpr double stretch_length = 8;
constexpr double ring_width = 8, furthest = 16;
// Where the slope beside a ramp is taken from on, nearer where others are near.
constexpr std::array<long, 3> rings{8, 5, 3};
constexpr double margin_of_ramp = 1;
constexpr double fit_radius = 3;
constexpr std::size_t fewest_in_ring = 6;
constexpr double sure_of_spread = 3;      // of slopes in the rings
constexpr double sure_of_difference = 2;  // of the slopes on the two sides
constexpr double least_slope = 0.02;      // steeper than beside the ramp
constexpr double ramp_ends_at = 0.1;      // of its greatest slope
constexpr double share_of_stretches = 0.25;
constexpr double most_of_step = 2, least_of_step = 0.25;  // of the ramps, for the throw restored
constexpr double least_of_sides = 0.1;
constexpr std::size_t least_sheet = 24;  // triangles; fewer between ramps belong to them

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Vec2 in_map(const Vec3& p) { return {p.x, p.y}; }
double map_distance(const Vec3& p, const Vec3& q) { return std::hypot(p.x - q.x, p.y - q.y); }

double median_map_edge(const TriangulatedSurface& s) {
  std::vector<double> lengths;
  for (const Triangle& t : s.triangles)
    for (std::size_t i = 0; i < 3; ++i) lengths.push_back(map_distance(s.points[t[i]], s.points[t[(i + 1) % 3]]));
  return lengths.empty() ? 0 : median(std::move(lengths));
}

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 u = b - a;
  const double uu = dot(u, u);
  return uu > 0 ? a + std::clamp(dot(p - a, u) / uu, 0.0, 1.0) * u : a;
}

/// A place beside a fault.
struct Beside {
  double distance;
  double across;   ///< in the map at the place's own height, positive above the fault
  double along;    ///< the strike
  Vec2 direction;  ///< of `across`
  bool is_within;  ///< not beyond the fault's end
};

/// A fault's triangles as planes; beyond its ends the nearest one goes on.
class FaultPlanes {
 public:
  explicit FaultPlanes(const TriangulatedSurface& fault) {
    const UpwardSides up = orient_upward(fault);
    Vec3 sum{};
    for (Index t = 0; t < fault.triangles.size(); ++t) {
      const Triangle& v = fault.triangles[t];
      Face face{{fault.points[v[0]], fault.points[v[1]], fault.points[v[2]]}, {}, {}};
      const Vec3 n =
          (up.as_stored[t] ? 1.0 : -1.0) * cross(face.corners[1] - face.corners[0], face.corners[2] - face.corners[0]);
      sum = sum + n;
      if (!(std::hypot(n.x, n.y) > 0)) continue;
      face.normal = (1 / norm(n)) * n;
      for (const Vec3& p : face.corners) face.bounds.add(p);
      faces_.push_back(face);
    }
    const double level = std::hypot(sum.x, sum.y);
    if (level > 0) strike_ = {-sum.y / level, sum.x / level};
  }

  /// Nothing further off than reach.
  std::optional<Beside> at(const Vec3& p, double reach) const {
    const Face* nearest = nullptr;
    double least = reach;
    bool is_within = false;
    for (const Face& f : faces_) {
      bool is_far = false;
      for (std::size_t i = 0; i < 3; ++i)
        is_far = is_far || p[i] < f.bounds.min[i] - least || p[i] > f.bounds.max[i] + least;
      if (is_far) continue;
      const auto [distance, is_over] = distance_to(f, p);
      if (distance >= least) continue;
      least = distance, nearest = &f, is_within = is_over;
    }
    if (nearest == nullptr) return std::nullopt;
    const Vec3& n = nearest->normal;
    const double level = std::hypot(n.x, n.y);
    return Beside{least,
                  dot(p - nearest->corners[0], n) / level,
                  strike_.x * p.x + strike_.y * p.y,
                  {n.x / level, n.y / level},
                  is_within};
  }

 private:
  struct Face {
    std::array<Vec3, 3> corners;
    Vec3 normal;
    Box3 bounds;
  };
  static std::pair<double, bool> distance_to(const Face& f, const Vec3& p) {
    const double off = dot(p - f.corners[0], f.normal);
    const Vec3 foot = p - off * f.normal;
    const Vec3 n = cross(f.corners[1] - f.corners[0], f.corners[2] - f.corners[0]);
    bool is_over = true;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &a = f.corners[i], &b = f.corners[(i + 1) % 3];
      is_over = is_over && dot(cross(b - a, foot - a), n) >= 0;
      nearest = std::min(nearest, norm(p - nearest_on_segment(p, a, b)));
    }
    if (is_over) return {std::abs(off), true};
    const bool is_beside = nearest <= 1.1 * std::abs(off);  // over a bend between two triangles
    return {nearest, is_beside};
  }

  std::vector<Face> faces_;
  Vec2 strike_{1, 0};
};

/// The slope of a triangle of the horizon across the fault.
struct SlopeBeside {
  double across, slope;
};

/// How far a ramp reaches on the two sides of the fault, in edges.
struct RampWidth {
  double below = 0, above = 0;
};

/// The ramp in one stretch. Nothing where the slope beside it is not known on both sides.
struct StretchRamp {
  bool is_ramp = false;
  double step = 0;  ///< its height, in edges
  RampWidth width;
};
std::optional<StretchRamp> ramp_within(const std::vector<SlopeBeside>& slopes, long ring_from) {
  std::vector<double> ring[2], off;
  std::map<long, std::vector<double>> bins;
  for (const SlopeBeside& s : slopes) {
    const double d = std::abs(s.across);
    if (d > static_cast<double>(ring_from) && d <= static_cast<double>(ring_from) + ring_width)
      ring[s.across > 0 ? 1 : 0].push_back(s.slope);
    if (d < static_cast<double>(ring_from)) bins[static_cast<long>(std::floor(s.across))].push_back(s.slope);
  }
  if (ring[0].size() < fewest_in_ring || ring[1].size() < fewest_in_ring) return std::nullopt;
  const double low = median(ring[0]), high = median(ring[1]);
  for (const double s : ring[0]) off.push_back(std::abs(s - low));
  for (const double s : ring[1]) off.push_back(std::abs(s - high));
  constexpr double normal_by_median = 1.4826, half_ring = 0.5 * ring_width;
  const double middle = static_cast<double>(ring_from) + half_ring;
  const double spread = normal_by_median * median(off);
  std::map<long, double> excess;
  for (const auto& [bin, values] : bins) {
    const double place = static_cast<double>(bin) + 0.5;
    excess[bin] = median(values) - (low + (high - low) * (place + middle) / (2 * middle));
  }
  long steepest = 0;
  double greatest = 0;
  for (const long bin : {-1L, 0L, -2L, 1L})
    if (excess.contains(bin) && std::abs(excess[bin]) > std::abs(greatest)) steepest = bin, greatest = excess[bin];
  StretchRamp found;
  found.is_ramp =
      std::abs(greatest) > std::max({sure_of_spread * spread, sure_of_difference * std::abs(high - low), least_slope});
  if (!found.is_ramp) return found;
  const auto is_steep = [&](long bin) {
    return excess.contains(bin) && excess[bin] / greatest > std::max(ramp_ends_at, spread / std::abs(greatest));
  };
  long first = steepest, last = steepest;
  while (is_steep(first - 1)) --first;
  while (is_steep(last + 1)) ++last;
  for (long bin = first; bin <= last; ++bin) found.step += std::abs(excess[bin]);
  if (first <= 1 - ring_from || last >= ring_from - 2) return StretchRamp{};  // a slope of the horizon, and no ramp
  found.width = {std::max(0.0, static_cast<double>(-first)), std::max(0.0, static_cast<double>(last + 1))};
  return found;
}

std::optional<StretchRamp> ramp_in(const std::vector<SlopeBeside>& slopes) {
  for (const long ring_from : rings)
    if (const auto found = ramp_within(slopes, ring_from)) return found;
  return std::nullopt;
}

/// The ramp along a fault, by stretches.
struct Ramp {
  std::map<long, RampWidth> at;
  std::vector<double> steps;  ///< m, by stretch that has it
  std::size_t n_stretches = 0;
  double length = 0;  ///< of the stretches that have it
  bool is_there() const {
    return !at.empty() && static_cast<double>(at.size()) >= share_of_stretches * static_cast<double>(n_stretches);
  }
  /// That of the stretch and its neighbours, else of the nearest one.
  RampWidth width(long stretch) const {
    RampWidth widest;
    long nearest = at.begin()->first;
    for (const auto& [k, width] : at) {
      if (std::abs(k - stretch) < std::abs(nearest - stretch)) nearest = k;
      if (std::abs(k - stretch) > 1) continue;
      widest = {std::max(widest.below, width.below), std::max(widest.above, width.above)};
    }
    return widest.below + widest.above > 0 ? widest : at.at(nearest);
  }
};

long stretch_at(double along, double edge) { return std::lround(along / (stretch_length * edge)); }

/// Triangles that are nearer to one of the others do not count.
Ramp find_ramp(const TriangulatedSurface& horizon, const FaultPlanes& fault, const std::vector<FaultPlanes>& others,
               double edge) {
  std::map<long, std::vector<SlopeBeside>> stretches;
  std::map<long, std::pair<double, double>> ends;
  for (const Triangle& t : horizon.triangles) {
    const Vec3 &a = horizon.points[t[0]], &b = horizon.points[t[1]], &c = horizon.points[t[2]];
    const Vec3 n = cross(b - a, c - a);
    if (n.z == 0) continue;
    const Vec3 centre = (1.0 / 3) * (a + b + c);
    const auto beside = fault.at(centre, furthest * edge);
    if (!beside || !beside->is_within) continue;
    const bool is_of_other = std::any_of(others.begin(), others.end(), [&](const FaultPlanes& other) {
      return other.at(centre, beside->distance).has_value();
    });
    if (is_of_other) continue;
    auto& [from, to] = ends.try_emplace(stretch_at(beside->along, edge), beside->along, beside->along).first->second;
    from = std::min(from, beside->along), to = std::max(to, beside->along);
    const double slope = -(n.x * beside->direction.x + n.y * beside->direction.y) / n.z;
    stretches[stretch_at(beside->along, edge)].push_back({beside->across / edge, slope});
  }
  Ramp ramp;
  for (const auto& [k, slopes] : stretches) {
    const auto found = ramp_in(slopes);
    if (!found) continue;
    ++ramp.n_stretches;
    if (!found->is_ramp) continue;
    ramp.at[k] = found->width;
    ramp.steps.push_back(found->step * edge);
    ramp.length += ends.at(k).second - ends.at(k).first;
  }
  return ramp;
}

/// Nodes of a horizon by cells of the map.
class NodeCells {
 public:
  NodeCells(const TriangulatedSurface& s, double cell) : s_(s), cell_(cell) {}
  void add(VertexIndex v) { cells_[key(in_map(s_.points[v]))].push_back(v); }
  template <class F>
  void for_each_near(const Vec3& p, double radius, F&& visit) const {
    const auto [i0, j0] = key({p.x - radius, p.y - radius});
    const auto [i1, j1] = key({p.x + radius, p.y + radius});
    for (long i = i0; i <= i1; ++i)
      for (long j = j0; j <= j1; ++j) {
        const auto at = cells_.find({i, j});
        if (at == cells_.end()) continue;
        for (const VertexIndex v : at->second) visit(v, map_distance(p, s_.points[v]));
      }
  }

 private:
  std::pair<long, long> key(const Vec2& p) const {
    return {std::lround(std::floor(p.x / cell_)), std::lround(std::floor(p.y / cell_))};
  }
  const TriangulatedSurface& s_;
  double cell_;
  std::map<std::pair<long, long>, std::vector<VertexIndex>> cells_;
};

/// The height at p of the plane through the nodes about the nearest one, within reach of p.
std::optional<double> carried_height(const TriangulatedSurface& s, const NodeCells& nodes, const Vec3& p, double reach,
                                     double edge) {
  double nearest = reach;
  nodes.for_each_near(p, reach, [&](VertexIndex, double d) { nearest = std::min(nearest, d); });
  if (!(nearest < reach)) return std::nullopt;
  const double radius = fit_radius * edge;
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d side = Eigen::Vector3d::Zero();
  std::size_t n = 0;
  nodes.for_each_near(p, nearest + 2 * radius, [&](VertexIndex v, double d) {
    if (d > nearest + 2 * radius) return;
    const double off = (d - nearest) / radius, weight = std::exp(-off * off);
    const Vec3 q = s.points[v] - p;
    const Eigen::Vector3d terms(1, q.x / edge, q.y / edge);
    matrix += weight * terms * terms.transpose();
    side += weight * q.z * terms;
    ++n;
  });
  if (n < fewest_in_ring) return std::nullopt;
  const Eigen::Vector3d fitted = matrix.completeOrthogonalDecomposition().solve(side);
  return p.z + fitted[0];
}

/// One horizon and the faults whose ramps it has.
class Restorer {
 public:
  Restorer(TriangulatedSurface& horizon, const std::vector<const TriangulatedSurface*>& faults,
           const std::vector<const TriangulatedSurface*>& others, const BuildLog& log)
      : horizon_(horizon),
        faults_(faults),
        log_(log),
        edge_(median_map_edge(horizon)),
        in_strip_(horizon.triangles.size(), 0) {
    for (const TriangulatedSurface* fault : faults) {
      planes_.emplace_back(*fault);
      std::vector<FaultPlanes> beside;
      for (const auto* list : {&faults, &others})
        for (const TriangulatedSurface* other : *list)
          if (other != fault) beside.emplace_back(*other);
      n_across_.push_back(0);
      ramps_.push_back(find_ramp(horizon, planes_.back(), beside, edge_));
    }
  }

  bool any() const {
    return std::any_of(ramps_.begin(), ramps_.end(), [](const Ramp& r) { return r.is_there(); });
  }

  RestoredThrow restore() {
    const TriangulatedSurface before = horizon_;
    nearest_fault_.assign(horizon_.points.size(), {no_index, std::numeric_limits<double>::infinity()});
    for (std::size_t f = 0; f < faults_.size(); ++f) mark_strip(f);
    find_sheets();
    RestoredThrow restored;
    const std::vector<Triangle> given = horizon_.triangles;
    horizon_.triangles.clear();
    for (Index t = 0; t < given.size(); ++t)
      if (!in_strip_[t]) {
        horizon_.triangles.push_back(given[t]);
        restored.sheet.push_back(sheet_[t]);
      }
    restored.n_given = static_cast<Index>(horizon_.triangles.size());
    for (const Index sheet : numbers_) carry(given, sheet, restored);
    std::vector<ThrowRestored> throws;
    for (std::size_t f = 0; f < faults_.size(); ++f) throws.push_back(throw_at(f));
    for (std::size_t f = 0; f < faults_.size(); ++f)
      if (ramps_[f].is_there() && !throws[f].fits(ramps_[f])) {
        log_.warnings.push_back("horizon " + horizon_.name + ": throw smeared across " + faults_[f]->name +
                                " is not restored, and the ramps stay: what lies beside it gives a throw of " +
                                to_text(throws[f].mean) + " m on average, the ramp " +
                                to_text(median(ramps_[f].steps)) + " m");
        horizon_ = before;
        return {};
      }
    tell(throws, given.size() - restored.n_given);
    return restored;
  }

 private:
  void mark_strip(std::size_t f) {
    const double reach = furthest * edge_;
    std::vector<std::optional<Beside>> beside(horizon_.points.size());
    std::vector<std::uint8_t> inside(horizon_.points.size(), 0);
    for (std::size_t v = 0; v < beside.size(); ++v) {
      beside[v] = planes_[f].at(horizon_.points[v], reach);
      if (!beside[v]) continue;
      auto& [fault, least] = nearest_fault_[v];
      if (std::abs(beside[v]->across) < least) fault = static_cast<Index>(f), least = std::abs(beside[v]->across);
      if (!ramps_[f].is_there()) continue;
      const RampWidth width = ramps_[f].width(stretch_at(beside[v]->along, edge_));
      inside[v] = beside[v]->across > -(width.below + margin_of_ramp) * edge_ &&
                  beside[v]->across < (width.above + margin_of_ramp) * edge_;
      widest_ = std::max(widest_, (width.below + width.above + 2 * margin_of_ramp) * edge_);
    }
    for (Index t = 0; t < in_strip_.size(); ++t) {
      bool is_above = false, is_below = false;
      for (const VertexIndex v : horizon_.triangles[t]) {
        if (inside[v]) in_strip_[t] = 1;
        is_above = is_above || (beside[v] && beside[v]->across >= 0);
        is_below = is_below || (beside[v] && beside[v]->across <= 0);
      }
      if (is_above && is_below) in_strip_[t] = 1, ++n_across_[f];
    }
  }

  /// Sheets of what is left, by their first triangles; those of a few triangles go with the strips.
  void find_sheets() {
    const std::vector<VertexIndex> merged = merge_equal_points(horizon_.points);
    UnionFind joined(in_strip_.size());
    std::map<std::pair<VertexIndex, VertexIndex>, Index> first;
    for (Index t = 0; t < in_strip_.size(); ++t)
      for (std::size_t i = 0; !in_strip_[t] && i < 3; ++i) {
        const VertexIndex a = merged[horizon_.triangles[t][i]], b = merged[horizon_.triangles[t][(i + 1) % 3]];
        const auto [at, is_new] = first.emplace(std::pair(std::min(a, b), std::max(a, b)), t);
        if (!is_new) joined.unite(at->second, t);
      }
    std::map<Index, std::size_t> size;
    sheet_.assign(in_strip_.size(), no_index);
    for (Index t = 0; t < sheet_.size(); ++t)
      if (!in_strip_[t]) ++size[sheet_[t] = joined.find(t)];
    for (Index t = 0; t < sheet_.size(); ++t)
      if (!in_strip_[t] && size[sheet_[t]] < least_sheet) in_strip_[t] = 1;
    for (const auto& [sheet, n] : size)
      if (n >= least_sheet) numbers_.push_back(sheet);
  }

  /// The sheet goes on over the strips beside it.
  void carry(const std::vector<Triangle>& given, Index sheet, RestoredThrow& restored) {
    std::vector<std::uint8_t> is_own(nearest_fault_.size(), 0);
    NodeCells nodes(horizon_, fit_radius * edge_);
    for (Index t = 0; t < given.size(); ++t)
      for (std::size_t i = 0; !in_strip_[t] && sheet_[t] == sheet && i < 3; ++i)
        if (!is_own[given[t][i]]) is_own[given[t][i]] = 1, nodes.add(given[t][i]);
    std::map<VertexIndex, std::optional<VertexIndex>> carried;  // by given node
    const auto row_of = [&](VertexIndex v) -> std::optional<VertexIndex> {
      if (is_own[v]) return v;
      const auto [at, is_new] = carried.try_emplace(v);
      if (!is_new) return at->second;
      Vec3 p = horizon_.points[v];
      const auto height = carried_height(horizon_, nodes, p, widest_ + 2 * edge_, edge_);
      if (!height) return std::nullopt;
      p.z = *height;
      at->second = static_cast<VertexIndex>(horizon_.points.size());
      horizon_.points.push_back(p);
      heights_[v].push_back(p.z);
      return at->second;
    };
    for (Index t = 0; t < given.size(); ++t) {
      if (!in_strip_[t]) continue;
      Triangle made{};
      bool is_whole = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto row = row_of(given[t][i]);
        is_whole = is_whole && row;
        made[i] = row.value_or(0);
      }
      if (!is_whole) continue;
      horizon_.triangles.push_back(made);
      restored.sheet.push_back(sheet);
    }
  }

  struct ThrowRestored {
    std::size_t n = 0;
    double least = std::numeric_limits<double>::infinity(), mean = 0, largest = 0;
    bool fits(const Ramp& ramp) const {
      return n > 0 && largest <= most_of_step * *std::max_element(ramp.steps.begin(), ramp.steps.end()) &&
             mean >= least_of_step * median(ramp.steps);
    }
  };
  ThrowRestored throw_at(std::size_t fault) const {
    ThrowRestored found;
    double sum = 0;
    for (const auto& [v, heights] : heights_) {
      if (nearest_fault_[v].first != fault || nearest_fault_[v].second > edge_ || heights.size() != 2) continue;
      const double across = std::abs(heights[0] - heights[1]);
      found.least = std::min(found.least, across), found.largest = std::max(found.largest, across);
      sum += across, ++found.n;
    }
    if (found.n > 0) found.mean = sum / static_cast<double>(found.n);
    return found;
  }

  void tell_no_ramp(std::size_t f) const {
    log_.warnings.push_back("horizon " + horizon_.name + ": it runs on across " + faults_[f]->name +
                            " and no ramp was found there (in " + std::to_string(ramps_[f].n_stretches) +
                            " stretches along it): it is parted with the throw of its nodes beside the fault");
  }

  void tell(const std::vector<ThrowRestored>& throws, std::size_t n_taken) const {
    for (std::size_t f = 0; f < faults_.size(); ++f) {
      if (!ramps_[f].is_there()) {
        if (n_across_[f] > 0) tell_no_ramp(f);
        continue;
      }
      double width = 0;
      for (const auto& [k, w] : ramps_[f].at) width += (w.below + w.above) * edge_;
      log_.notes.push_back("horizon " + horizon_.name + ": throw smeared across " + faults_[f]->name + " over " +
                           to_text(ramps_[f].length) + " m along it (" + std::to_string(ramps_[f].at.size()) + " of " +
                           std::to_string(ramps_[f].n_stretches) + " stretches), " +
                           to_text(width / static_cast<double>(ramps_[f].at.size())) +
                           " m wide on average; restored: least " + to_text(throws[f].least) + ", mean " +
                           to_text(throws[f].mean) + ", largest " + to_text(throws[f].largest) + " m");
    }
    log_.notes.push_back("horizon " + horizon_.name + ": " + std::to_string(n_taken) +
                         " triangles along its faults made anew from both sides");
  }

  TriangulatedSurface& horizon_;
  const std::vector<const TriangulatedSurface*>& faults_;
  const BuildLog& log_;
  double edge_, widest_ = 0;
  std::vector<FaultPlanes> planes_;
  std::vector<Ramp> ramps_;
  std::vector<std::size_t> n_across_;                    ///< triangles that cross each fault
  std::vector<std::uint8_t> in_strip_;                   ///< per given triangle
  std::vector<std::pair<Index, double>> nearest_fault_;  ///< per given node, with the distance across
  std::vector<Index> sheet_, numbers_;                   ///< per given triangle; those that are there
  std::map<VertexIndex, std::vector<double>> heights_;   ///< carried from each side, by given node
};

}  // namespace

bool has_smeared_throw(const TriangulatedSurface& horizon, const TriangulatedSurface& fault,
                       const std::vector<const TriangulatedSurface*>& others) {
  if (!is_single_valued(horizon)) return false;
  std::vector<FaultPlanes> beside;
  for (const TriangulatedSurface* other : others)
    if (other != &fault) beside.emplace_back(*other);
  return find_ramp(horizon, FaultPlanes(fault), beside, median_map_edge(horizon)).is_there();
}

bool lies_on_both_sides(const TriangulatedSurface& horizon, const TriangulatedSurface& fault) {
  if (!is_single_valued(horizon)) return false;
  const FaultPlanes planes(fault);
  double above = 0, below = 0;
  for (const Triangle& t : horizon.triangles) {
    const Vec3 &a = horizon.points[t[0]], &b = horizon.points[t[1]], &c = horizon.points[t[2]];
    const auto beside = planes.at((1.0 / 3) * (a + b + c), std::numeric_limits<double>::infinity());
    if (beside) (beside->across > 0 ? above : below) += triangle_area(a, b, c);
  }
  return std::min(above, below) > least_of_sides * (above + below);
}

RestoredThrow restore_smeared_throw(TriangulatedSurface& horizon, const std::vector<const TriangulatedSurface*>& faults,
                                    const std::vector<const TriangulatedSurface*>& others, const BuildLog& log) {
  if (!is_single_valued(horizon)) return {};
  Restorer restorer(horizon, faults, others, log);
  if (!restorer.any()) return {};
  return restorer.restore();
}

}  // namespace geomesh::geomodel
