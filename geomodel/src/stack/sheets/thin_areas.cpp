// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/sheets/thin_areas.hpp"

#include <algorithm>
#include <cmath>

#include "common/parallel.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double cells_a_size = 4;
constexpr std::uint32_t few_samples = 4;  // of a cell
constexpr int places_a_side = 3;          // number of sampled places along a side of raster cells with few samples
constexpr int smoothing_passes = 4;
constexpr std::size_t cells_a_task = 1024;
constexpr double least_squares = 2;   // least area of a thin area or an opening in one, in squares of the target size
constexpr double surely_thin = 0.75;  // thin areas must somewhere be below this fraction of the least thickness
constexpr double surely_thick = 1.5;  // openings in thin areas must exceed this multiple of the least thickness
// Multiple of the least thickness from which an opening in a thin area is kept whatever its area.
constexpr double kept_however_small = 3;
constexpr double line_piece = 0.7;  // of the size
constexpr double led_from = 0.12;   // of the size
constexpr double same_line = 0.35;  // of the size

/// Averages each horizon's height over evenly spaced places of one raster cell. If some horizon is absent at each
/// place, the heights at the cell's centre are used.
void average_places(const MapSamples& samples, const MapRaster& like, std::size_t cell, std::vector<MapRaster>& means) {
  const Vec2 centre = like.centre(cell % like.n_columns, cell / like.n_columns);
  std::vector<double> heights(means.size()), sums(means.size(), 0);
  int n = 0;
  for (int j = 0; j < places_a_side; ++j)
    for (int i = 0; i < places_a_side; ++i) {
      const double u = (i + 0.5) / places_a_side - 0.5, v = (j + 0.5) / places_a_side - 0.5;
      samples.heights_at({centre.x + u * like.step, centre.y + v * like.step}, heights);
      if (std::any_of(heights.begin(), heights.end(), [](double h) { return std::isnan(h); })) continue;
      for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += heights[k];
      ++n;
    }
  if (n == 0) samples.heights_at(centre, heights);
  for (std::size_t k = 0; k < sums.size(); ++k) means[k].values[cell] = n == 0 ? heights[k] : sums[k] / n;
}

/// Returns each horizon's mean height over the samples in a raster cell, or over evenly spaced places if there are few.
std::vector<MapRaster> cell_means(const MapSamples& samples, const MapRaster& like) {
  const std::size_t n = samples.n_surfaces();
  std::vector<MapRaster> means(n, like);
  for (MapRaster& m : means) std::fill(m.values.begin(), m.values.end(), 0.0);
  std::vector<std::uint32_t> counts(like.size(), 0);
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const std::size_t cell = like.cell_of(samples.place(s));
    const std::span<const double> heights = samples.heights(s);
    // Samples at which a horizon is absent are left out, so that the means of all horizons represent the same places.
    const bool complete = std::none_of(heights.begin(), heights.end(), [](double h) { return std::isnan(h); });
    if (!complete) continue;
    for (std::size_t k = 0; k < n; ++k) means[k].values[cell] += heights[k];
    ++counts[cell];
  }
  const auto fill = [&](std::size_t cell) {
    if (counts[cell] < few_samples) {
      average_places(samples, like, cell, means);
    } else {
      for (MapRaster& m : means) m.values[cell] /= counts[cell];
    }
  };
  parallel_for((like.size() + cells_a_task - 1) / cells_a_task, [&](std::size_t task) {
    const std::size_t end = std::min(like.size(), (task + 1) * cells_a_task);
    for (std::size_t cell = task * cells_a_task; cell < end; ++cell) fill(cell);
  });
  return means;
}

/// Returns the smoothed thickness between neighbouring horizons, negative where they cross.
std::vector<MapRaster> thicknesses(const std::vector<MapRaster>& heights) {
  std::vector<MapRaster> result;
  for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
    MapRaster thickness = heights[k];
    for (std::size_t c = 0; c < thickness.size(); ++c) thickness.values[c] -= heights[k + 1].values[c];
    fill_from_neighbours(thickness);
    const bool any =
        std::none_of(thickness.values.begin(), thickness.values.end(), [](double v) { return std::isnan(v); });
    if (any) smooth(thickness, smoothing_passes);
    result.push_back(std::move(thickness));
  }
  return result;
}

/// Corrects thicknesses for the order of horizons: moving one changes the thickness of its neighbouring unit, too.
void put_in_order(std::vector<MapRaster>& thickness, const Keepers& keepers) {
  if (thickness.empty()) return;
  std::vector<double> heights(thickness.size() + 1);
  for (std::size_t c = 0; c < thickness.front().size(); ++c) {
    heights[0] = 0;
    for (std::size_t k = 0; k < thickness.size(); ++k) heights[k + 1] = heights[k] - thickness[k].values[c];
    settle_column(heights, 0, keepers, 0);
    for (std::size_t k = 0; k < thickness.size(); ++k) thickness[k].values[c] = heights[k] - heights[k + 1];
  }
}

/// Reverses the sign of groups of raster cells (thin areas, or openings) too small to be kept; returns their number.
std::size_t drop_islands(MapRaster& excess, const ThinAreaOptions& options) {
  const double cell = excess.step * excess.step, least = least_squares * options.size * options.size;
  const auto turn = [&](bool below, auto&& stays) {
    const CellGroups groups = groups_of(excess, below);
    std::size_t n = 0;
    std::vector<bool> goes(groups.n_cells.size());
    for (std::size_t g = 0; g < goes.size(); ++g) {
      goes[g] = groups.n_cells[g] != excess.size() && !stays(groups, g);
      n += goes[g];
    }
    for (std::size_t c = 0; c < excess.size(); ++c)
      if (groups.group[c] != no_index && goes[groups.group[c]])
        excess.values[c] = (below ? 1 : -1) * 0.25 * options.thickness;
    return n;
  };
  const std::size_t n_holes = turn(false, [&](const CellGroups& groups, std::size_t g) {
    const double thickness = options.thickness + groups.greatest[g],
                 area = cell * static_cast<double>(groups.n_cells[g]);
    return thickness > kept_however_small * options.thickness ||
           (area >= least && thickness > surely_thick * options.thickness);
  });
  return n_holes + turn(true, [&](const CellGroups& groups, std::size_t g) {
           return cell * static_cast<double>(groups.n_cells[g]) >= least &&
                  options.thickness + groups.least[g] < surely_thin * options.thickness;
         });
}

double distance(const Vec2& p, const Vec2& q) { return std::hypot(p.x - q.x, p.y - q.y); }

/// Returns the point of `earlier` (points of other lines) that is nearest to p and within reach, otherwise p itself.
Vec2 snapped(const Vec2& p, const std::vector<Vec2>& earlier, double reach) {
  Vec2 best = p;
  for (const Vec2& q : earlier)
    if (const double d = distance(p, q); d < reach) reach = d, best = q;
  return best;
}

/// Routes a line through all points closer to it than `reach`, so that lines meet in points or are disjoint.
std::vector<Vec2> led_through(const std::vector<Vec2>& line, const std::vector<Vec2>& points, double reach) {
  std::vector<Vec2> led{line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 a = line[i - 1], b = line[i];
    const double length = distance(a, b);
    std::vector<std::pair<double, Vec2>> between;
    for (const Vec2& q : points) {
      const double along = ((q.x - a.x) * (b.x - a.x) + (q.y - a.y) * (b.y - a.y)) / length;
      const double off = std::abs((q.y - a.y) * (b.x - a.x) - (q.x - a.x) * (b.y - a.y)) / length;
      if (along > 0 && along < length && off < reach && !(q == a) && !(q == b)) between.emplace_back(along, q);
    }
    std::sort(between.begin(), between.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    for (const auto& [along, q] : between)
      if (!(led.back() == q)) led.push_back(q);
    if (!(led.back() == b)) led.push_back(b);
  }
  return led;
}

/// Draws the pinch-out lines of all pairs of horizons. The lines are smooth, consist of pieces of about the target
/// size, and either meet in points or are disjoint.
void draw_lines(std::vector<ThinArea>& areas, double size, double shift) {
  std::vector<Vec2> points;
  for (ThinArea& area : areas) {
    const std::size_t n_earlier = points.size();
    const std::vector<Vec2> earlier(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(n_earlier));
    for (const std::vector<Vec2>& curve : zero_curves(area.excess)) {
      std::vector<Vec2> line;
      for (const Vec2& p : beside(smooth_curve(curve, line_piece * size), shift)) {
        const Vec2 q = snapped(p, earlier, same_line * size);
        if (line.empty() || !(line.back() == q)) line.push_back(q);
      }
      if (line.size() < 2) continue;
      points.insert(points.end(), line.begin(), line.end());
      area.curves.push_back(std::move(line));
    }
  }
  for (ThinArea& area : areas)
    for (std::vector<Vec2>& line : area.curves) line = led_through(line, points, led_from * size);
}

}  // namespace

bool ThinArea::any() const {
  return std::any_of(excess.values.begin(), excess.values.end(), [](double v) { return v < 0; });
}

std::vector<ThinArea> find_thin_areas(const MapSamples& samples, const MapBounds& bounds, const Keepers& keepers,
                                      const ThinAreaOptions& options) {
  const double width = bounds.max.x - bounds.min.x, height = bounds.max.y - bounds.min.y;
  const double step = std::max(options.size / cells_a_size, std::sqrt(width * height / most_cells));
  const MapRaster like(bounds.grown(2 * step), step);
  std::vector<MapRaster> thickness = thicknesses(cell_means(samples, like));
  put_in_order(thickness, keepers);
  std::vector<ThinArea> areas;
  for (MapRaster& t : thickness) {
    ThinArea area;
    area.excess = std::move(t);
    for (double& v : area.excess.values) v = std::isnan(v) ? options.thickness : v - options.thickness;
    area.n_islands = drop_islands(area.excess, options);
    areas.push_back(std::move(area));
  }
  draw_lines(areas, options.size, options.shift);
  return areas;
}

}  // namespace geomesh::geomodel
