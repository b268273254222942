// SPDX-License-Identifier: GPL-3.0-or-later
// Heights are carried by planes that are fitted with weights to the nodes of one side near the place (moving least
// squares; Levin, The approximation power of moving least-squares, Math. Comp. 67, 1998).
#include "rules/smeared_throw.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "common/union_find.hpp"
#include "naming/region_facts.hpp"
#include "naming/sheets.hpp"
#include "rules/throw/throw_ramp.hpp"
#include "stack/single_valued.hpp"

namespace geomesh::geomodel {
namespace {

// Lengths in median edges of the horizon in the map.
constexpr double margin_of_ramp = 1;
constexpr double fit_radius = 3;
constexpr std::size_t fewest_to_fit = 6;
constexpr double most_of_step = 2, least_of_step = 0.25;  // of the ramps, for the throw restored
constexpr std::size_t least_sheet = 24;                   // triangles; fewer between ramps belong to them

Vec2 in_map(const Vec3& p) { return {p.x, p.y}; }
double map_distance(const Vec3& p, const Vec3& q) { return std::hypot(p.x - q.x, p.y - q.y); }

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
  if (n < fewest_to_fit) return std::nullopt;
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
        n_across_(faults.size(), 0),
        in_strip_(horizon.triangles.size(), 0) {
    for (const TriangulatedSurface* fault : faults) faces_.emplace_back(*fault);
    for (const TriangulatedSurface* other : others)
      if (std::find(faults.begin(), faults.end(), other) == faults.end()) faces_.emplace_back(*other);
    for (std::size_t f = 0; f < faults.size(); ++f) ramps_.push_back(find_ramp(horizon, faces_, f, edge_));
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
    const double reach = furthest_beside * edge_;
    std::vector<std::optional<Beside>> beside(horizon_.points.size());
    std::vector<std::uint8_t> inside(horizon_.points.size(), 0);
    for (std::size_t v = 0; v < beside.size(); ++v) {
      beside[v] = faces_[f].beside(horizon_.points[v], reach);
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
  std::vector<FaultFaces> faces_;  ///< of the horizon's faults, then of the others
  std::vector<Ramp> ramps_;
  std::vector<std::size_t> n_across_;                    ///< triangles that cross each fault
  std::vector<std::uint8_t> in_strip_;                   ///< per given triangle
  std::vector<std::pair<Index, double>> nearest_fault_;  ///< per given node, with the distance across
  std::vector<Index> sheet_, numbers_;                   ///< per given triangle; those that are there
  std::map<VertexIndex, std::vector<double>> heights_;   ///< carried from each side, by given node
};

}  // namespace

RestoredThrow restore_smeared_throw(TriangulatedSurface& horizon, const std::vector<const TriangulatedSurface*>& faults,
                                    const std::vector<const TriangulatedSurface*>& others, const BuildLog& log) {
  if (!is_single_valued(horizon)) return {};
  Restorer restorer(horizon, faults, others, log);
  if (!restorer.any()) return {};
  return restorer.restore();
}

}  // namespace geomesh::geomodel
