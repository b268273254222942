// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/sheets/centred_sheets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "stack/sheets/sheet_locator.hpp"
#include "stack/sheets/sheet_room.hpp"

namespace geomesh::geomodel {
namespace {

constexpr int rounds = 20;
constexpr int hops = 6;  // number of edges over which a round passes on height corrections that vertices could not take
constexpr double most_places = 1e5;
// Largest distance between sampled places, as a fraction of the thickness raster's cell size.
constexpr double place_of_cell = 0.25;
constexpr double fit_of_spacing = 2;  // radius in which data are averaged, as a multiple of the sample spacing
constexpr double fit_of_cell = 0.5;   // largest averaging radius, as a fraction of the thickness raster's cell size
// Additional vertical move that a horizon may make where a unit closes, as a fraction of the least thickness.
constexpr double more_where_closing = 0.5;

/// A place of the map, and the heights that data and rules give to the horizons there; NaN for absent horizons.
struct RuledPlace {
  SheetLocator::Place at;
  std::vector<double> heights;
};

/// Returns the pairs of neighbouring horizons that coincide at the place p, according to the averaged thickness.
MergedPairs merged_at(const std::vector<ThinArea>& areas, const Vec2& p) {
  MergedPairs merged = 0;
  for (std::size_t k = 0; k < areas.size(); ++k)
    if (areas[k].excess.between(p) < 0) merged |= MergedPairs{1} << k;
  return merged;
}

class Centring {
 public:
  Centring(MapSheets& sheets, const MapSamples& samples, const SheetOptions& options)
      : sheets_(sheets),
        options_(options),
        n_(sheets.n_horizons),
        merged_about_(sheets.points.size(), 0),
        first_(sheets.heights),
        room_(room_of_sheets(sheets, samples, options)) {
    std::set<std::pair<VertexIndex, VertexIndex>> edges;
    for (std::size_t f = 0; f < sheets.triangles.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexIndex v = sheets.triangles[f][i], w = sheets.triangles[f][(i + 1) % 3];
        merged_about_[v] |= sheets.merged[f];
        edges.emplace(v, w);
        edges.emplace(w, v);
      }
    neighbours_.resize(sheets.points.size());
    for (const auto& [v, w] : edges) neighbours_[v].push_back(w);
    leave_room_where_units_close();
    share_room();
  }

  void look_at(const MapSamples& samples, const std::vector<ThinArea>& areas) {
    MapBounds bounds;
    for (const Vec2& p : sheets_.points) bounds.add(p);
    const double width = bounds.max.x - bounds.min.x, height = bounds.max.y - bounds.min.y;
    double step = samples.spacing(), radius = fit_of_spacing * samples.spacing();
    for (const ThinArea& area : areas) {
      step = std::min(step, place_of_cell * area.excess.step);
      radius = std::min(radius, fit_of_cell * area.excess.step);
    }
    step = std::max(step, std::sqrt(width * height / most_places));
    const auto n_columns = static_cast<std::size_t>(std::max(1.0, std::round(width / step))),
               n_rows = static_cast<std::size_t>(std::max(1.0, std::round(height / step)));
    const double dx = width / static_cast<double>(n_columns), dy = height / static_cast<double>(n_rows);
    const SheetLocator locator(sheets_);
    for (std::size_t j = 0; j < n_rows; ++j)
      for (std::size_t i = 0; i < n_columns; ++i) {
        const Vec2 p{bounds.min.x + dx * (static_cast<double>(i) + 0.5),
                     bounds.min.y + dy * (static_cast<double>(j) + 0.5)};
        RuledPlace place{locator.find(p), std::vector<double>(n_)};
        if (place.at.triangle == no_index) continue;
        samples.fitted_heights(p, radius, place.heights);
        settle_column(place.heights, merged_at(areas, p), options_.keepers, options_.gap);
        places_.push_back(std::move(place));
      }
  }

  void round() {
    sum_distances();
    std::vector<double> left = sums_;
    for (int hop = 0; hop < hops; ++hop) left = passed_on(moved_by(left));
  }

 private:
  /// Returns which horizon of a merged pair is moved onto the other.
  std::size_t giver(std::size_t pair) const { return options_.keepers[pair] == Keeper::younger ? pair + 1 : pair; }
  bool follows(VertexIndex v, std::size_t horizon) const {
    for (std::size_t k = 0; k + 1 < n_; ++k)
      if ((merged_about_[v] >> k & 1) && giver(k) == horizon) return true;
    return false;
  }

  /// Lets the vertices beside a pinch-out line move farther, for the horizon that is moved where the unit closes.
  void leave_room_where_units_close() {
    for (VertexIndex v = 0; v < neighbours_.size(); ++v)
      for (const VertexIndex w : neighbours_[v])
        for (std::size_t k = 0; k + 1 < n_; ++k)
          if ((merged_about_[w] & ~merged_about_[v]) >> k & 1)
            widen(v * n_ + giver(k), share_for_centring * options_.allowed + more_where_closing * options_.gap);
  }

  void widen(std::size_t row, double least) {
    room_.up[row] = std::max(room_.up[row], least);
    room_.down[row] = std::max(room_.down[row], least);
  }

  /// Gives horizons that are merged at a vertex the smaller of their allowed vertical moves.
  void share_room() {
    for (VertexIndex v = 0; v < neighbours_.size(); ++v)
      for (int way = 0; way < 2; ++way)
        for (std::size_t j = 0; j + 1 < n_; ++j) {
          const std::size_t k = way == 0 ? j : n_ - 2 - j, row = v * n_ + k;
          if (!(merged_about_[v] >> k & 1)) continue;
          room_.up[row] = room_.up[row + 1] = std::min(room_.up[row], room_.up[row + 1]);
          room_.down[row] = room_.down[row + 1] = std::min(room_.down[row], room_.down[row + 1]);
        }
  }

  /// Returns the weight with which a vertex takes on height corrections that its neighbours could not take.
  double taking(VertexIndex v, std::size_t horizon) const {
    return follows(v, horizon) ? 0 : weights_[v * n_ + horizon];
  }

  void sum_distances() {
    sums_.assign(sheets_.heights.size(), 0);
    weights_.assign(sheets_.heights.size(), 0);
    for (const RuledPlace& place : places_) {
      const Triangle& t = sheets_.triangles[place.at.triangle];
      for (std::size_t k = 0; k < n_; ++k) {
        double off = place.heights[k];
        for (std::size_t i = 0; i < 3; ++i) off -= place.at.weights[i] * sheets_.height(t[i], k);
        if (std::isnan(off)) continue;
        for (std::size_t i = 0; i < 3; ++i) {
          sums_[t[i] * n_ + k] += place.at.weights[i] * off;
          weights_[t[i] * n_ + k] += place.at.weights[i];
        }
      }
    }
  }

  /// Moves vertices by their weighted mean distance from data, as far as allowed. Returns sums of the distances left.
  std::vector<double> moved_by(std::vector<double> sums) {
    std::vector<double> before(n_);
    const double least = share_for_centring * options_.allowed;
    for (VertexIndex v = 0; v < sheets_.points.size(); ++v) {
      const std::span<double> heights(sheets_.heights.data() + v * n_, n_);
      std::copy(heights.begin(), heights.end(), before.begin());
      if (!move(v, sums, std::numeric_limits<double>::max())) {
        std::copy(before.begin(), before.end(), heights.begin());
        if (!move(v, sums, least)) std::copy(before.begin(), before.end(), heights.begin());
      }
      for (std::size_t k = 0; k < n_; ++k)
        if (const double moved = heights[k] - before[k]; !std::isnan(moved))
          sums[v * n_ + k] -= moved * weights_[v * n_ + k];
    }
    return sums;
  }

  /// Moves the horizons at vertex v by at most `most` towards their data, then restores their order. Returns false if
  /// this moves a horizon farther than allowed.
  bool move(VertexIndex v, const std::vector<double>& sums, double most) {
    const std::span<double> heights(sheets_.heights.data() + v * n_, n_);
    const auto lowest = [&](std::size_t row) { return first_[row] - std::min(most, room_.down[row]); };
    const auto highest = [&](std::size_t row) { return first_[row] + std::min(most, room_.up[row]); };
    for (std::size_t k = 0; k < n_; ++k)
      if (const std::size_t row = v * n_ + k; weights_[row] > 0)
        heights[k] = std::clamp(heights[k] + sums[row] / weights_[row], lowest(row), highest(row));
    settle_column(heights, merged_about_[v], options_.keepers, options_.gap);
    for (std::size_t k = 0; k < n_; ++k) {
      const std::size_t row = v * n_ + k;
      const double rounding = 1e-12 * std::abs(first_[row]);
      if (heights[k] < first_[row] - room_.down[row] - rounding || heights[k] > first_[row] + room_.up[row] + rounding)
        return false;
    }
    return true;
  }

  /// Distributes the height corrections that vertices could not take among their neighbours.
  std::vector<double> passed_on(const std::vector<double>& left) const {
    std::vector<double> passed(left.size(), 0);
    for (VertexIndex v = 0; v < neighbours_.size(); ++v)
      for (std::size_t k = 0; k < n_; ++k) {
        double all = 0;
        for (const VertexIndex w : neighbours_[v]) all += taking(w, k);
        if (!(all > 0)) continue;
        for (const VertexIndex w : neighbours_[v]) passed[w * n_ + k] += left[v * n_ + k] * taking(w, k) / all;
      }
    return passed;
  }

  MapSheets& sheets_;
  const SheetOptions& options_;
  std::size_t n_;
  /// For each vertex, the pairs of horizons that are merged in any triangle around it.
  std::vector<MergedPairs> merged_about_;
  std::vector<std::vector<VertexIndex>> neighbours_;
  std::vector<double> first_;           ///< heights of all vertices before the first round of moves
  SheetRoom room_;                      ///< largest moves of vertices from their heights before the first round
  std::vector<double> sums_, weights_;  ///< per vertex and horizon: sum of weighted distances from data, and of weights
  std::vector<RuledPlace> places_;
};

}  // namespace

void centre_sheets(MapSheets& sheets, const MapSamples& samples, const std::vector<ThinArea>& areas,
                   const SheetOptions& options) {
  Centring centring(sheets, samples, options);
  centring.look_at(samples, areas);
  for (int k = 0; k < rounds; ++k) centring.round();
}

}  // namespace geomesh::geomodel
