// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/sheets/sheet_approximation.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "common/by_rounding.hpp"
#include "stack/map/growing_triangulation.hpp"
#include "stack/sheets/edge_crossings.hpp"

namespace geomesh::geomodel {
namespace {

// The radius of plane fits is reduced if these cause at least this fraction of a sample's vertical distance from the
// approximation.
constexpr double vertex_is_off = 0.5;
// Fraction of the sample spacing within which crossings beside a vertex are not tested: there, the height of the vertex
// itself causes the distance from the data.
constexpr double near_vertex = 0.25;
constexpr int most_rounds = 4;  // most rounds of adding points at edges that are too far from the data
// Distance of a new vertex from the sample beside which it is placed, as a fraction of the sample spacing.
constexpr double beside_of_spacing = 0.02;
constexpr double golden_angle = 2.399963229728653;
// Least length of a constraint segment that may be halved, as a multiple of the sample spacing.
constexpr double shortest_of_spacing = 0.7;

double twice_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Returns for each zone of the map the pairs of horizons that are merged in it, because their averaged thickness is
/// too small over most of the zone's area.
std::vector<MergedPairs> merged_zones(const GrowingTriangulation& map, const std::vector<ThinArea>& areas) {
  std::vector<MergedPairs> merged(map.n_zones(), 0);
  for (std::size_t k = 0; k < areas.size(); ++k) {
    if (!areas[k].any()) continue;
    std::vector<double> balance(map.n_zones(), 0.0);
    for (const GrowingTriangulation::Cell& cell : map.cells()) {
      const Vec2 &a = map.points()[cell.vertices[0]], &b = map.points()[cell.vertices[1]],
                 &c = map.points()[cell.vertices[2]];
      const Vec2 centre{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
      const bool thin = areas[k].excess.values[areas[k].excess.cell_of(centre)] < 0;
      balance[cell.zone] += (thin ? 1 : -1) * twice_area(a, b, c);
    }
    for (std::size_t zone = 0; zone < merged.size(); ++zone)
      if (balance[zone] > 0) merged[zone] |= MergedPairs{1} << k;
  }
  return merged;
}

/// All horizons over one triangulation of the map: their heights, and the allowed distances from the data.
class Sheets {
 public:
  Sheets(const MapSamples& samples, const SheetOptions& options, const GrowingTriangulation& map,
         const std::vector<ThinArea>& areas)
      : samples_(samples),
        options_(options),
        n_(samples.n_surfaces()),
        map_(map),
        zone_merged_(merged_zones(map, areas)),
        exact_(n_) {}

  MergedPairs merged(Index cell) const { return zone_merged_[map_.cells()[cell].zone]; }

  /// Computes the heights of all horizons at a new vertex, from planes fitted to the samples within the radius.
  void add_vertex(VertexIndex v, double radius) {
    if (vertex_merged_.size() <= v) {
      vertex_merged_.resize(v + 1);
      radius_.resize(v + 1);
      heights_.resize((v + 1) * n_);
    }
    vertex_merged_[v] = merged_about(v);
    radius_[v] = radius;
    set_heights(v);
  }

  /// Fits the horizons' planes at a vertex again, to the data within half of the previous radius.
  void sharpen(VertexIndex v) {
    radius_[v] *= 0.5;
    set_heights(v);
  }
  /// Returns the distance of a horizon from its data at a vertex that is due to the fitted plane alone.
  double off_by_fit(VertexIndex v, std::size_t horizon) {
    if (radius_[v] == 0) return 0;
    return std::abs(heights_on_triangles(map_.points()[v], vertex_merged_[v])[horizon] - heights_[v * n_ + horizon]);
  }
  /// Returns the heights of all horizons at the place p on their input triangles, after putting them in order.
  std::span<const double> heights_on_triangles(const Vec2& p, MergedPairs merged) {
    samples_.heights_at(p, exact_);
    settle_column(exact_, merged, options_.keepers, options_.gap);
    return exact_;
  }

  /// Returns the barycentric coordinates of the place p in a cell of the triangulation.
  std::array<double, 3> weights(Index cell, const Vec2& p) const {
    const Triangle& v = map_.cells()[cell].vertices;
    const Vec2 &a = map_.points()[v[0]], &b = map_.points()[v[1]], &c = map_.points()[v[2]];
    const double whole = twice_area(a, b, c), wb = twice_area(a, p, c) / whole, wc = twice_area(a, b, p) / whole;
    return {1 - wb - wc, wb, wc};
  }

  double height(VertexIndex v, std::size_t k) const { return heights_[v * n_ + k]; }
  double height(Index cell, const std::array<double, 3>& w, std::size_t k) const {
    const Triangle& v = map_.cells()[cell].vertices;
    return w[0] * height(v[0], k) + w[1] * height(v[1], k) + w[2] * height(v[2], k);
  }
  const std::vector<double>& heights() const { return heights_; }

  /// Returns, as bit k for horizon k, the horizons that are moved at a pinch-out line that touches the cell.
  std::uint64_t giving_way(Index cell) const {
    const Triangle& v = map_.cells()[cell].vertices;
    const MergedPairs about = vertex_merged_[v[0]] | vertex_merged_[v[1]] | vertex_merged_[v[2]];
    std::uint64_t givers = 0;
    for (std::size_t k = 0; k + 1 < n_; ++k)
      if ((about & ~merged(cell)) >> k & 1)
        givers |= std::uint64_t{1} << (options_.keepers[k] == Keeper::younger ? k + 1 : k);
    return givers;
  }

  double allowed(std::uint64_t givers, std::size_t k) const {
    return (1 - share_for_centring) * options_.allowed + (givers >> k & 1 ? options_.room_at_pinch_outs : 0);
  }

  /// Returns the places where edges of the data and of the triangulation cross in the map and are farther apart than
  /// allowed. The difference of two triangulated surfaces is largest at vertices or such crossings. The vertices need
  /// no test: the input's are samples already, and those of the triangulation lie on the data or near a sample.
  std::vector<Vec2> crossings_off() {
    std::vector<Vec2> off;
    for_each_crossing(map_, samples_, [&](const EdgeCrossing& at) {
      if (is_off(at)) off.push_back(at.place);
    });
    return off;
  }

 private:
  bool is_off(const EdgeCrossing& at) {
    if (at.from_vertex < near_vertex * samples_.spacing()) return false;
    const std::size_t k = at.horizon;
    const double z = (1 - at.along) * height(at.a, k) + at.along * height(at.b, k);
    const double most = allowed(giving_way(at.cell), k) * (1 + by_rounding);
    return std::abs(z - at.height) > most && std::abs(z - heights_on_triangles(at.place, merged(at.cell))[k]) > most;
  }

  MergedPairs merged_about(VertexIndex v) {
    map_.star(v, star_);
    MergedPairs result = 0;
    for (const Index cell : star_) result |= merged(cell);
    return result;
  }

  void set_heights(VertexIndex v) {
    const std::span<double> heights(heights_.data() + v * n_, n_);
    if (radius_[v] < samples_.spacing()) radius_[v] = 0;
    if (radius_[v] > 0) {
      samples_.fitted_heights(map_.points()[v], radius_[v], heights);
    } else {
      samples_.heights_at(map_.points()[v], heights);
    }
    settle_column(heights, vertex_merged_[v], options_.keepers, options_.gap);
  }

  const MapSamples& samples_;
  const SheetOptions& options_;
  std::size_t n_;
  const GrowingTriangulation& map_;
  std::vector<MergedPairs> zone_merged_;
  std::vector<MergedPairs> vertex_merged_;  ///< for each vertex, the pairs of horizons merged in any cell around it
  std::vector<double> radius_;              ///< radius of the plane fit at each vertex; 0: heights on input triangles
  std::vector<double> heights_;             ///< settled; per vertex
  std::vector<Index> star_;
  std::vector<double> exact_;
};

/// The samples in each cell of the triangulation, with their heights after they were put in order.
class HeldSamples {
 public:
  HeldSamples(const MapSamples& samples, const SheetOptions& options, const GrowingTriangulation& map,
              const Sheets& sheets)
      : samples_(samples), n_(samples.n_surfaces()) {
    by_cell_.resize(map.cells().size());
    targets_.resize(samples_.size() * n_);
    Index near = 0;
    for (Index s = 0; s < samples_.size(); ++s) {
      const Index cell = map.locate(samples_.place(s), near);
      if (cell == no_index) continue;
      near = cell;
      by_cell_[cell].push_back(s);
      const std::span<const double> given = samples_.heights(s);
      const std::span<double> target(targets_.data() + s * n_, n_);
      std::copy(given.begin(), given.end(), target.begin());
      settle_column(target, sheets.merged(cell), options.keepers, options.gap);
    }
  }

  const std::vector<Index>& of(Index cell) const { return by_cell_[cell]; }
  double target(Index sample, std::size_t k) const { return targets_[sample * n_ + k]; }
  /// Moves the samples of removed cells of the triangulation to the new cells.
  void redistribute(const Sheets& sheets, std::size_t n_cells, const GrowingTriangulation::Change& change) {
    std::vector<Index> moving;
    for (const Index cell : change.emptied) {
      moving.insert(moving.end(), by_cell_[cell].begin(), by_cell_[cell].end());
      by_cell_[cell].clear();
    }
    by_cell_.resize(n_cells);
    for (const Index s : moving) {
      const Vec2 p = samples_.place(s);
      Index best = no_index;
      double inside = -1e300;
      for (const Index cell : change.made) {
        const std::array<double, 3> w = sheets.weights(cell, p);
        const double least = std::min({w[0], w[1], w[2]});
        if (least > inside) inside = least, best = cell;
        if (least >= 0) break;
      }
      by_cell_[best].push_back(s);
    }
  }

 private:
  const MapSamples& samples_;
  std::size_t n_;
  std::vector<std::vector<Index>> by_cell_;
  std::vector<double> targets_;  ///< per sample
};

/// Approximates the horizons by inserting vertices, first at the sample with the largest relative distance.
class Approximation {
 public:
  Approximation(const MapSamples& samples, const MapLayout& layout, const std::vector<ThinArea>& areas,
                const SheetOptions& options)
      : samples_(samples),
        n_(samples.n_surfaces()),
        lattice_(layout.lattice),
        beside_(options.beside_samples ? beside_of_spacing * samples.spacing() : 0),
        map_(triangulate_layout(layout)),
        sheets_(samples, options, map_, areas),
        held_(samples, options, map_, sheets_),
        version_(map_.cells().size(), 0) {}

  MapSheets run() {
    for (VertexIndex v = 0; v < map_.points().size(); ++v) sheets_.add_vertex(v, fit_of_edge * lattice_);
    for (Index cell = 0; cell < map_.cells().size(); ++cell) measure(cell);
    serve_queue();
    for (int round = 0; round < most_rounds && add_where_edges_are_off(); ++round) serve_queue();
    return result();
  }

 private:
  void serve_queue() {
    while (!queue_.empty()) {
      const Worst worst = queue_.top();
      queue_.pop();
      if (worst.version == version_[worst.cell]) improve(worst);
    }
  }

  struct Worst {
    double excess;  ///< a sample's vertical distance from the approximation, divided by the allowed distance
    Index cell, version, sample;
    bool operator<(const Worst& other) const {
      return excess != other.excess ? excess < other.excess : cell > other.cell;
    }
  };

  double distance(Index cell, const std::array<double, 3>& w, Index sample, std::size_t k) const {
    return std::abs(sheets_.height(cell, w, k) - held_.target(sample, k));
  }

  /// Queues a triangulation cell if one of its samples is farther from the approximation than allowed.
  void measure(Index cell) {
    Worst worst{1, cell, ++version_[cell], no_index};
    const std::uint64_t givers = sheets_.giving_way(cell);
    for (const Index s : held_.of(cell)) {
      const std::array<double, 3> w = sheets_.weights(cell, samples_.place(s));
      for (std::size_t k = 0; k < n_; ++k)
        if (const double excess = distance(cell, w, s, k) / sheets_.allowed(givers, k); excess > worst.excess) {
          worst.excess = excess;
          worst.sample = s;
        }
    }
    if (worst.sample != no_index) queue_.push(worst);
  }

  void improve(const Worst& worst) {
    if (sharpen(worst)) return;
    const auto [p, at] = place_for(worst);
    const Triangle& v = map_.cells()[worst.cell].vertices;
    const double side = std::sqrt(twice_area(map_.points()[v[0]], map_.points()[v[1]], map_.points()[v[2]]));
    map_.add(p, at, shortest_of_spacing * samples_.spacing(), change_);
    if (change_.vertex == no_vertex) return;  // nothing inserted, because p is at a vertex, or the cell is too narrow
    take_change();
    sheets_.add_vertex(change_.vertex, fit_of_edge * std::min(lattice_, side));
    for (const Index cell : change_.made) measure(cell);
    // If inserting the vertex split a segment in other cells instead, the cell of the sample is measured again.
    if (std::find(change_.made.begin(), change_.made.end(), worst.cell) == change_.made.end()) measure(worst.cell);
  }

  /// Returns the place at which a vertex is inserted for a sample, and the cell that contains the place.
  std::pair<Vec2, Index> place_for(const Worst& worst) const {
    const Vec2 p = samples_.place(worst.sample);
    if (beside_ == 0) return {p, worst.cell};
    const double angle = golden_angle * static_cast<double>(worst.sample);
    const Vec2 beside{p.x + beside_ * std::cos(angle), p.y + beside_ * std::sin(angle)};
    const Index at = map_.locate(beside, worst.cell);
    return at == no_index ? std::pair(p, worst.cell) : std::pair(beside, at);
  }

  /// Fits a plane to the data again, with half of the radius, at that vertex of a triangle whose fit contributes most
  /// to a sample's distance from the triangle. Returns false if poor fits are not the main cause.
  bool sharpen(const Worst& worst) {
    const Triangle v = map_.cells()[worst.cell].vertices;
    const std::array<double, 3> w = sheets_.weights(worst.cell, samples_.place(worst.sample));
    std::size_t horizon = 0;
    double off = 0;
    for (std::size_t k = 0; k < n_; ++k)
      if (const double d = distance(worst.cell, w, worst.sample, k); d > off) off = d, horizon = k;
    double sum = 0, greatest = 0;
    VertexIndex blunt = no_vertex;
    for (std::size_t i = 0; i < 3; ++i) {
      const double part = w[i] * sheets_.off_by_fit(v[i], horizon);
      if (std::isnan(part)) continue;
      sum += part;
      if (part > greatest) greatest = part, blunt = v[i];
    }
    if (blunt == no_vertex || sum < vertex_is_off * off) return false;
    sheets_.sharpen(blunt);
    std::vector<Index> about;
    map_.star(blunt, about);
    for (const Index cell : about) measure(cell);
    return true;
  }

  void take_change() {
    held_.redistribute(sheets_, map_.cells().size(), change_);
    version_.resize(map_.cells().size(), 0);
  }

  /// Inserts vertices at the crossings of edges that are too far from the data. Returns false if there are none.
  bool add_where_edges_are_off() {
    const std::vector<Vec2> off = sheets_.crossings_off();
    for (const Vec2& p : off) {
      const Index at = map_.locate(p, 0);
      if (at == no_index) continue;
      map_.add(p, at, shortest_of_spacing * samples_.spacing(), change_);
      if (change_.vertex == no_vertex) continue;
      take_change();
      sheets_.add_vertex(change_.vertex, 0);
      for (const Index cell : change_.made) measure(cell);
    }
    return !off.empty();
  }

  MapSheets result() {
    MapSheets out;
    out.n_horizons = n_;
    out.points = map_.points();
    out.heights = sheets_.heights();
    for (Index cell = 0; cell < map_.cells().size(); ++cell) {
      out.triangles.push_back(map_.cells()[cell].vertices);
      out.merged.push_back(sheets_.merged(cell));
    }
    return out;
  }

  const MapSamples& samples_;
  std::size_t n_;
  double lattice_, beside_;
  GrowingTriangulation map_;
  Sheets sheets_;
  HeldSamples held_;
  std::vector<Index> version_;  ///< version of each triangulation cell; queue entries with an older version are ignored
  std::priority_queue<Worst> queue_;
  GrowingTriangulation::Change change_;
};

}  // namespace

MapSheets approximate_sheets(const MapSamples& samples, const MapLayout& layout, const std::vector<ThinArea>& areas,
                             const SheetOptions& options) {
  return Approximation(samples, layout, areas, options).run();
}

}  // namespace geomesh::geomodel
