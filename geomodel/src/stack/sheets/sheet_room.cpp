// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/sheets/sheet_room.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stack/map/growing_triangulation.hpp"
#include "stack/sheets/edge_crossings.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double unbounded = std::numeric_limits<double>::max();

GrowingTriangulation map_of(const MapSheets& sheets) {
  return GrowingTriangulation({sheets.points, sheets.triangles, std::vector<std::uint8_t>(sheets.triangles.size(), 0)});
}

class RoomFinder {
 public:
  RoomFinder(const MapSheets& sheets, const MapSamples& samples, const SheetOptions& options)
      : sheets_(sheets),
        samples_(samples),
        options_(options),
        n_(sheets.n_horizons),
        map_(map_of(sheets)),
        merged_about_(sheets.points.size(), 0),
        column_(n_) {
    room_.up.assign(sheets.heights.size(), unbounded);
    room_.down = room_.up;
    for (std::size_t f = 0; f < sheets.triangles.size(); ++f)
      for (const VertexIndex v : sheets.triangles[f]) merged_about_[v] |= sheets.merged[f];
  }

  SheetRoom find() {
    look_at_vertices();
    look_at_samples();
    for_each_crossing(map_, samples_, [this](const EdgeCrossing& at) { look_at(at); });
    const double least = share_for_centring * options_.allowed;
    for (std::vector<double>* room : {&room_.up, &room_.down})
      for (double& r : *room) r = r < unbounded ? std::max(r, least) : least;
    return std::move(room_);
  }

 private:
  void look_at_vertices() {
    for (VertexIndex v = 0; v < sheets_.points.size(); ++v) {
      samples_.heights_at(sheets_.points[v], column_);
      settle_column(column_, merged_about_[v], options_.keepers, options_.gap);
      for (std::size_t k = 0; k < n_; ++k) bound(v, k, sheets_.height(v, k) - column_[k], options_.allowed);
    }
  }

  void look_at_samples() {
    Index near = 0;
    for (Index s = 0; s < samples_.size(); ++s) {
      const Vec2 p = samples_.place(s);
      const Index cell = map_.locate(p, near);
      if (cell == no_index) continue;
      near = cell;
      const Triangle& t = sheets_.triangles[cell];
      const std::array<double, 3> w = weights(t, p);
      const std::span<const double> given = samples_.heights(s);
      std::copy(given.begin(), given.end(), column_.begin());
      settle_column(column_, sheets_.merged[cell], options_.keepers, options_.gap);
      for (std::size_t k = 0; k < n_; ++k) {
        double off = -column_[k];
        for (std::size_t i = 0; i < 3; ++i) off += w[i] * sheets_.height(t[i], k);
        for (const VertexIndex v : t) bound(v, k, off, allowed(cell, k));
      }
    }
  }

  /// Limits the vertical moves of both ends of a triangle's side where an edge of the data crosses it. Distances are
  /// measured from the data; if the horizon is too far from the data there, from the height that the rules give it.
  void look_at(const EdgeCrossing& at) {
    const std::size_t k = at.horizon;
    const double z = (1 - at.along) * sheets_.height(at.a, k) + at.along * sheets_.height(at.b, k);
    const double most = allowed(at.cell, k);
    double off = z - at.height;
    if (std::abs(off) > most) {
      samples_.heights_at(at.place, column_);
      settle_column(column_, sheets_.merged[at.cell], options_.keepers, options_.gap);
      off = z - column_[k];
    }
    bound(at.a, k, off, most);
    bound(at.b, k, off, most);
  }

  /// Returns the distance from the data that the approximation allows a horizon in the triangle.
  double allowed(Index cell, std::size_t horizon) const {
    const Triangle& v = sheets_.triangles[cell];
    const MergedPairs about = (merged_about_[v[0]] | merged_about_[v[1]] | merged_about_[v[2]]) & ~sheets_.merged[cell];
    const bool gives_way =
        (horizon > 0 && (about >> (horizon - 1) & 1) && options_.keepers[horizon - 1] == Keeper::younger) ||
        (horizon + 1 < n_ && (about >> horizon & 1) && options_.keepers[horizon] == Keeper::older);
    return options_.allowed + (gives_way ? options_.room_at_pinch_outs : 0);
  }

  void bound(VertexIndex v, std::size_t horizon, double off, double most) {
    if (std::isnan(off)) return;
    double &up = room_.up[v * n_ + horizon], &down = room_.down[v * n_ + horizon];
    up = std::min(up, most - off);
    down = std::min(down, most + off);
  }

  std::array<double, 3> weights(const Triangle& t, const Vec2& p) const {
    const Vec2 &a = sheets_.points[t[0]], &b = sheets_.points[t[1]], &c = sheets_.points[t[2]];
    const auto twice_area = [](const Vec2& x, const Vec2& y, const Vec2& z) {
      return (y.x - x.x) * (z.y - x.y) - (y.y - x.y) * (z.x - x.x);
    };
    const double whole = twice_area(a, b, c), wb = twice_area(a, p, c) / whole, wc = twice_area(a, b, p) / whole;
    return {1 - wb - wc, wb, wc};
  }

  const MapSheets& sheets_;
  const MapSamples& samples_;
  const SheetOptions& options_;
  std::size_t n_;
  GrowingTriangulation map_;
  std::vector<MergedPairs> merged_about_;  ///< for each vertex, the pairs of horizons merged in any triangle around it
  std::vector<double> column_;
  SheetRoom room_;
};

}  // namespace

SheetRoom room_of_sheets(const MapSheets& sheets, const MapSamples& samples, const SheetOptions& options) {
  return RoomFinder(sheets, samples, options).find();
}

}  // namespace geomesh::geomodel
