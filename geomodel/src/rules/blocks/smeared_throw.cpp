// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/blocks/smeared_throw.hpp"

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
#include "rules/planar/single_valued.hpp"
#include "rules/throw/carried_heights.hpp"
#include "rules/throw/fault_crossings.hpp"
#include "rules/throw/throw_ramp.hpp"

namespace geomesh::geomodel {
namespace {

// Margin on either side of a ramp (throw smeared by gridding), in median edge lengths of the horizon in the map.
constexpr double margin_of_ramp = 1;
// Largest and smallest throw accepted in place of ramps, as fractions of the ramps' height.
constexpr double most_of_step = 2, least_of_step = 0.25;
// Least number of triangles of a connected part of the horizon; smaller parts between ramps count as parts of ramps.
constexpr std::size_t least_sheet = 24;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Keeps only the triangles of a fault on one side, the one with most of the fault, of the surface at which it ends.
/// Triangles that cross that surface are subdivided down to the size `least`.
class StoppedFault {
 public:
  StoppedFault(TriangulatedSurface& reach, const TriangulatedSurface& stop, double least)
      : reach_(reach), stop_(stop), least_(least) {
    for (const Triangle& t : std::vector<Triangle>(std::move(reach.triangles))) sort(t);
    reach.triangles = std::move(on_side_[area_[1] > area_[0] ? 1 : 0]);
  }

 private:
  const Vec3& point(VertexIndex v) const { return reach_.points[v]; }
  void sort(const Triangle& t) {
    const bool side = stop_.is_above(point(t[0]));
    const double longest =
        std::max({norm(point(t[1]) - point(t[0])), norm(point(t[2]) - point(t[1])), norm(point(t[0]) - point(t[2]))});
    const bool crosses = stop_.is_above(point(t[1])) != side || stop_.is_above(point(t[2])) != side;
    if (crosses && longest > least_) return divide(t);
    const bool of_centre = stop_.is_above((1.0 / 3) * (point(t[0]) + point(t[1]) + point(t[2])));
    on_side_[of_centre ? 1 : 0].push_back(t);
    area_[of_centre ? 1 : 0] += triangle_area(point(t[0]), point(t[1]), point(t[2]));
  }
  void divide(const Triangle& t) {
    Triangle middle{};
    for (std::size_t i = 0; i < 3; ++i) {
      middle[i] = static_cast<VertexIndex>(reach_.points.size());
      const Vec3 p = 0.5 * (point(t[i]) + point(t[(i + 1) % 3]));
      reach_.points.push_back(p);
    }
    for (std::size_t i = 0; i < 3; ++i) sort({t[i], middle[i], middle[(i + 2) % 3]});
    sort(middle);
  }

  TriangulatedSurface& reach_;
  FaultSides stop_;
  double least_;
  std::array<std::vector<Triangle>, 2> on_side_;
  std::array<double, 2> area_{0, 0};
};

/// Returns the fault without its extension, and without its parts beyond the surface at which it ends.
TriangulatedSurface reach_of(const RampFault& ramp, double edge) {
  TriangulatedSurface reach = *ramp.fault.surface;
  if (ramp.fault.first_made < reach.triangles.size()) reach.triangles.resize(ramp.fault.first_made);
  if (ramp.stop != nullptr) StoppedFault(reach, *ramp.stop, edge);
  return reach;
}

class Restorer {
 public:
  Restorer(TriangulatedSurface& horizon, const std::vector<RampFault>& faults,
           const std::vector<const TriangulatedSurface*>& others, const BuildLog& log)
      : horizon_(horizon),
        log_(log),
        edge_(median_map_edge(horizon)),
        n_across_(faults.size(), 0),
        in_strip_(horizon.triangles.size(), 0) {
    for (const RampFault& ramp : faults) {
      faults_.push_back(ramp.fault.surface);
      reaches_.push_back(reach_of(ramp, edge_));
      ends_inside_.push_back(ramp.fault.first_made < ramp.fault.surface->triangles.size());
    }
    std::vector<ThrowFault> parting;
    for (std::size_t f = 0; f < faults.size(); ++f) {
      const auto n = static_cast<Index>(reaches_[f].triangles.size());
      parting.push_back(faults[f].stop != nullptr ? ThrowFault{&reaches_[f], n} : faults[f].fault);
      faces_.emplace_back(reaches_[f]);
    }
    crossing_ = find_crossings(horizon, 0, parting, everywhere);
    for (const TriangulatedSurface* other : others)
      if (std::find(faults_.begin(), faults_.end(), other) == faults_.end()) faces_.emplace_back(*other);
    for (std::size_t f = 0; f < faults.size(); ++f) ramps_.push_back(find_ramp(horizon, faces_, f, edge_));
  }

  bool any() const {
    return std::any_of(ramps_.begin(), ramps_.end(), [](const Ramp& r) { return r.is_there(); });
  }

  RestoredThrow restore() {
    const TriangulatedSurface before = horizon_;
    nearest_fault_.assign(horizon_.points.size(), {no_index, std::numeric_limits<double>::infinity()});
    across_.assign(horizon_.points.size(), Vec2{0, 0});
    for (std::size_t f = 0; f < faults_.size(); ++f) mark_strip(f);
    find_sheets();
    RestoredThrow restored;
    const std::vector<Triangle>& given = restored.before = horizon_.triangles;
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
                                " is not restored, and the ramps are kept: what lies beside it gives a throw of " +
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
      if (beside[v] && ends_inside_[f] && !beside[v]->is_within) beside[v].reset();
      if (!beside[v]) continue;
      auto& [fault, least] = nearest_fault_[v];
      if (std::abs(beside[v]->across) < least) {
        fault = static_cast<Index>(f), least = std::abs(beside[v]->across);
        across_[v] = beside[v]->direction;
      }
      if (!ramps_[f].is_there()) continue;
      const RampWidth width = ramps_[f].width(stretch_at(beside[v]->along, edge_));
      inside[v] = beside[v]->across > -(width.below + margin_of_ramp) * edge_ &&
                  beside[v]->across < (width.above + margin_of_ramp) * edge_;
      widest_ = std::max(widest_, (width.below + width.above + 2 * margin_of_ramp) * edge_);
    }
    for (Index t = 0; t < in_strip_.size(); ++t) {
      if (goes_round(t)) continue;
      bool is_above = false, is_below = false;
      for (const VertexIndex v : horizon_.triangles[t]) {
        if (inside[v]) in_strip_[t] = 1;
        is_above = is_above || (beside[v] && beside[v]->across >= 0);
        is_below = is_below || (beside[v] && beside[v]->across <= 0);
      }
      if (is_above && is_below) in_strip_[t] = 1, ++n_across_[f];
      if (crossing_[t] == Crossing::fault) in_strip_[t] = 1;
    }
  }

  /// Returns whether the triangle lies beyond the fault's tip; such triangles are kept and connect both sides.
  bool goes_round(Index t) const { return crossing_[t] == Crossing::continuation; }
  bool is_of_sheet(Index t) const { return !in_strip_[t] && !goes_round(t); }

  /// Finds the connected parts of the horizon that are left after ramps were removed, each identified by its first
  /// triangle. Parts of a few triangles are removed with the ramps.
  void find_sheets() {
    const std::vector<Triangle> triangles = merged_triangles(horizon_);
    UnionFind joined(in_strip_.size());
    std::map<std::pair<VertexIndex, VertexIndex>, Index> first;
    for (Index t = 0; t < in_strip_.size(); ++t)
      for (std::size_t i = 0; is_of_sheet(t) && i < 3; ++i) {
        const VertexIndex a = triangles[t][i], b = triangles[t][(i + 1) % 3];
        if (a == b) continue;
        const auto [at, is_new] = first.emplace(std::pair(std::min(a, b), std::max(a, b)), t);
        if (!is_new) joined.unite(at->second, t);
      }
    std::map<Index, std::size_t> size;
    sheet_.assign(in_strip_.size(), BuiltRows::of_every_block);
    for (Index t = 0; t < sheet_.size(); ++t)
      if (is_of_sheet(t)) ++size[sheet_[t] = joined.find(t)];
    for (Index t = 0; t < sheet_.size(); ++t)
      if (is_of_sheet(t) && size[sheet_[t]] < least_sheet) in_strip_[t] = 1;
    for (const auto& [sheet, n] : size)
      if (n >= least_sheet) numbers_.push_back(sheet);
  }

  /// Extends a connected part of the horizon over the area beside it from which the ramp was removed.
  void carry(const std::vector<Triangle>& given, Index sheet, RestoredThrow& restored) {
    std::vector<std::uint8_t> is_own(nearest_fault_.size(), 0);
    CarriedHeights nodes(horizon_, edge_);
    for (Index t = 0; t < given.size(); ++t)
      for (std::size_t i = 0; !in_strip_[t] && sheet_[t] == sheet && i < 3; ++i)
        if (!is_own[given[t][i]]) is_own[given[t][i]] = 1, nodes.add(given[t][i]);
    std::vector<std::uint8_t> is_fixed = is_own;
    for (Index t = 0; t < given.size(); ++t)
      for (std::size_t i = 0; goes_round(t) && i < 3; ++i) is_fixed[given[t][i]] = 1;
    std::map<VertexIndex, std::optional<VertexIndex>> carried;  // by given node
    const auto row_of = [&](VertexIndex v) -> std::optional<VertexIndex> {
      if (is_fixed[v]) return v;
      const auto [at, is_new] = carried.try_emplace(v);
      if (!is_new) return at->second;
      Vec3 p = horizon_.points[v];
      const auto height = nodes.at(p, across_[v], widest_ + 2 * edge_);
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
      bool is_whole = true, is_beside = false;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto row = row_of(given[t][i]);
        is_whole = is_whole && row;
        is_beside = is_beside || is_own[given[t][i]] || !is_fixed[given[t][i]];
        made[i] = row.value_or(0);
      }
      if (!is_whole || !is_beside) continue;
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
  std::vector<const TriangulatedSurface*> faults_;
  std::vector<TriangulatedSurface> reaches_;  ///< of each fault
  std::vector<std::uint8_t> ends_inside_;     ///< per fault
  std::vector<Crossing> crossing_;            ///< per given triangle
  const BuildLog& log_;
  double edge_, widest_ = 0;
  std::vector<FaultFaces> faces_;  ///< faults at which the horizon may have ramps, followed by all other faults
  std::vector<Ramp> ramps_;
  std::vector<std::size_t> n_across_;   ///< number of triangles that cross each fault
  std::vector<std::uint8_t> in_strip_;  ///< per given triangle
  /// For each original node of the horizon: the nearest fault, and the distance from it perpendicular to its strike.
  std::vector<std::pair<Index, double>> nearest_fault_;
  std::vector<Vec2> across_;  ///< for each original node of the horizon: direction across the nearest fault's strike
  /// For each original triangle of the horizon, the number of its connected part after ramps were removed; and the
  /// numbers of those parts that are large enough to be kept.
  std::vector<Index> sheet_, numbers_;
  /// For each original node of the horizon in a ramp: heights extrapolated from the two sides of the fault.
  std::map<VertexIndex, std::vector<double>> heights_;
};

}  // namespace

RestoredThrow restore_smeared_throw(TriangulatedSurface& horizon, const std::vector<RampFault>& faults,
                                    const std::vector<const TriangulatedSurface*>& others, const BuildLog& log) {
  if (!is_single_valued(horizon)) return {};
  Restorer restorer(horizon, faults, others, log);
  if (!restorer.any()) return {};
  return restorer.restore();
}

}  // namespace geomesh::geomodel
