// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolates horizons separately in each fault block, declared in geomesh/geomodel/gridding_in_blocks.hpp.
#include "geomesh/geomodel/gridding_in_blocks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geomesh/core/error.hpp"
#include "gridding/graph.hpp"
#include "naming/sums.hpp"
#include "rules/continuation/continue_to_walls.hpp"
#include "rules/framework/block_framework.hpp"
#include "rules/planar/nearest_place.hpp"

namespace geomesh::geomodel {
namespace {

/// Fewest points from which the surface of a fault block is made. A plane passes through any three points, so their
/// distances from it do not reveal how wrong the plane is farther away.
constexpr std::size_t fewest_points = 4;

/// Divides each triangle into n * n equal ones; neighbouring triangles share the new points on their common edge.
TriangulatedSurface divided(const TriangulatedSurface& s, std::size_t n) {
  if (n <= 1) return s;
  TriangulatedSurface fine;
  fine.points = s.points;
  std::map<std::array<std::size_t, 3>, VertexIndex> on_edge;  // new points by edge (ascending ends) and step along it
  const auto add = [&](const Vec3& p) {
    fine.points.push_back(p);
    return static_cast<VertexIndex>(fine.points.size() - 1);
  };
  // Returns point k of the n equal steps from vertex a to b.
  const auto between = [&](VertexIndex a, VertexIndex b, std::size_t k) {
    if (k == 0) return a;
    if (k == n) return b;
    if (a > b) std::swap(a, b), k = n - k;
    const auto [at, is_new] = on_edge.emplace(std::array<std::size_t, 3>{a, b, k}, no_vertex);
    if (is_new)
      at->second = add(s.points[a] + static_cast<double>(k) / static_cast<double>(n) * (s.points[b] - s.points[a]));
    return at->second;
  };
  for (const auto& [a, b, c] : s.triangles) {
    std::vector<std::vector<VertexIndex>> rows;  // new points of a triangle abc in rows parallel to bc, beginning at a
    for (std::size_t i = 0; i <= n; ++i) {
      std::vector<VertexIndex>& row = rows.emplace_back();
      for (std::size_t j = 0; j <= i; ++j) {
        if (j == 0)
          row.push_back(between(a, b, i));
        else if (j == i)
          row.push_back(between(a, c, i));
        else if (i == n)
          row.push_back(between(b, c, j));
        else
          row.push_back(add(s.points[a] +
                            static_cast<double>(i - j) / static_cast<double>(n) * (s.points[b] - s.points[a]) +
                            static_cast<double>(j) / static_cast<double>(n) * (s.points[c] - s.points[a])));
      }
    }
    for (std::size_t i = 1; i <= n; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        fine.triangles.push_back({rows[i - 1][j], rows[i][j], rows[i][j + 1]});
        if (j > 0) fine.triangles.push_back({rows[i - 1][j - 1], rows[i][j], rows[i - 1][j]});
      }
  }
  return fine;
}

/// Number of equal parts into which the sides of all triangles must be divided so that no part is longer than the step.
std::size_t parts_of_sides(const TriangulatedSurface& s, double step) {
  double longest = 0;
  for (const Triangle& t : s.triangles)
    for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, norm(s.points[t[(i + 1) % 3]] - s.points[t[i]]));
  return static_cast<std::size_t>(std::ceil(longest / step));
}

class FaultBlocks {
 public:
  FaultBlocks(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules)
      : built_(faults_of(surfaces, rules)), framework_(built_, rules) {}
  Index n_blocks() const { return framework_.n_blocks(); }
  /// Returns whether faults end at the horizon. If so, blocks end there too, and the horizon's points lie in no block.
  bool end_at(Index horizon) const {
    return std::ranges::any_of(built_.rows.truncations, [&](const auto& t) { return t.second == horizon; });
  }
  std::vector<Index> blocks_at(const std::vector<Vec3>& points) const {
    std::vector<Index> blocks;
    Index last = no_index;
    for (const Vec3& p : points) blocks.push_back(framework_.block_at(p, last));
    return blocks;
  }

 private:
  /// Returns the model's faults, continued to the surfaces at which they end. Bodies are left out, because they
  /// displace no horizon.
  static BuiltSurfaces faults_of(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules) {
    BuiltSurfaces built;
    built.surfaces = surfaces;
    for (TriangulatedSurface& s : built.surfaces)
      if (s.kind == SurfaceKind::body) s.triangles.clear();
    built.rows.part_of_triangle.resize(surfaces.size());
    built.rows.block_of_part.resize(surfaces.size());
    built.rows.continued_to.resize(surfaces.size());
    std::vector<std::string> notes, warnings;  // messages on continuing faults; the run gives them later
    continue_faults(built, rules, {notes, warnings});
    return built;
  }

  BuiltSurfaces built_;
  BlockFramework framework_;
};

/// A horizon that is composed of separate surfaces for its fault blocks.
class BlockSurfaces {
 public:
  BlockSurfaces(const TriangulatedSurface& common, const GriddedPoints& made, const FaultBlocks& blocks, double step)
      : common_(common), made_(made), blocks_(blocks), step_(step), surface_(common) {
    surface_.points.clear();
    surface_.triangles.clear();
    for (const Vec3& p : common.points) over_.add(p);
  }

  /// Composes the horizon from a surface for each fault block; returns nothing if its points lie in a single block.
  std::optional<GriddedInBlocks> make() {
    const std::map<Index, std::vector<Vec3>> points = points_by_block();
    if (points.size() < 2) return std::nullopt;
    GriddedInBlocks told{no_index, points.size()};
    for (Index b = 0; b < blocks_.n_blocks(); ++b) {
      const auto own = points.find(b);
      const std::optional<TriangulatedSurface> sheet = own == points.end() ? std::nullopt : sheet_of(own->second);
      if (own != points.end() && !sheet) ++told.n_in_common;
      add(sheet ? *sheet : common_, b);
      if (own != points.end()) measure(own->second, sheet ? *sheet : common_, told);
    }
    if (n_measured_ > 0) told.rms_residual = std::sqrt(squares_.value() / static_cast<double>(n_measured_));
    return told;
  }
  TriangulatedSurface& surface() { return surface_; }

 private:
  /// Returns the horizon's points by block. Points outside of the model determine the surface near the model's sides;
  /// they are assigned to the block of the nearest point inside.
  std::map<Index, std::vector<Vec3>> points_by_block() const {
    const std::vector<Index> block = blocks_.blocks_at(made_.points);
    std::vector<Vec3> inside;
    std::vector<Index> block_of_inside;
    for (std::size_t i = 0; i < block.size(); ++i)
      if (block[i] != no_index) inside.push_back(made_.points[i]), block_of_inside.push_back(block[i]);
    std::map<Index, std::vector<Vec3>> points;
    if (inside.empty()) return points;
    const NearestPlace nearest(inside);
    for (std::size_t i = 0; i < block.size(); ++i) {
      const Vec3& p = made_.points[i];
      points[block[i] != no_index ? block[i] : block_of_inside[nearest.find(p.x, p.y)]].push_back(p);
    }
    return points;
  }

  /// Interpolates the points of one fault block. Returns nothing if they do not determine a surface.
  std::optional<TriangulatedSurface> sheet_of(const std::vector<Vec3>& points) const {
    if (points.size() < fewest_points) return std::nullopt;
    GriddingSpec spec = made_.spec;
    spec.spacing = made_.spacing;
    spec.to_box = true;
    try {
      return grid_points(points, spec, GraphOver::map, &over_).surface;
    } catch (const Error&) {  // All points lie on one line, which determines no surface.
      return std::nullopt;
    }
  }

  /// Adds those triangles of the surface that lie in the given fault block, also outside of the model, because all
  /// surfaces are clipped later.
  void add(const TriangulatedSurface& sheet, Index block) {
    const TriangulatedSurface fine = divided(sheet, parts_of_sides(sheet, step_));
    const std::vector<Index> at = blocks_.blocks_at(fine.points);
    std::vector<VertexIndex> row(fine.points.size(), no_vertex);
    for (const Triangle& t : fine.triangles) {
      const auto is_elsewhere = [&](VertexIndex v) { return at[v] != block && at[v] != no_index; };
      const auto is_here = [&](VertexIndex v) { return at[v] == block; };
      if (std::ranges::any_of(t, is_elsewhere) || std::ranges::none_of(t, is_here)) continue;
      Triangle own = t;
      for (VertexIndex& v : own) {
        if (row[v] == no_vertex) {
          row[v] = static_cast<VertexIndex>(surface_.points.size());
          surface_.points.push_back(fine.points[v]);
        }
        v = row[v];
      }
      surface_.triangles.push_back(own);
    }
  }

  void measure(const std::vector<Vec3>& points, const TriangulatedSurface& sheet, GriddedInBlocks& told) {
    const TriangleFinder finder(sheet.points, sheet.triangles);
    for (const Vec3& p : points) {
      const auto height = finder.height(p.x, p.y);
      if (!height) continue;
      const double residual = *height - p.z;
      squares_.add(residual * residual);
      ++n_measured_;
      if (std::abs(residual) > std::abs(told.largest_residual))
        told.largest_residual = residual, told.largest_place = p;
    }
  }

  const TriangulatedSurface& common_;
  const GriddedPoints& made_;
  const FaultBlocks& blocks_;
  double step_;
  TriangulatedSurface surface_;
  Box3 over_;  ///< bounds of the surface that was made from the points of all fault blocks
  CompensatedSum squares_;
  std::size_t n_measured_ = 0;
};

}  // namespace

std::vector<GriddedInBlocks> grid_in_blocks(std::vector<TriangulatedSurface>& surfaces, const PointsOfHorizons& made,
                                            const ModelRules& rules) {
  const ContinuationRules& how = rules.continuation;
  const auto is_fault = [](const TriangulatedSurface& s) {
    return s.kind == SurfaceKind::fault && !s.triangles.empty();
  };
  if (made.empty() || how.sides.empty() || !(how.within_of_horizons > 0) || std::ranges::none_of(surfaces, is_fault))
    return {};
  const FaultBlocks blocks(surfaces, rules);
  if (blocks.n_blocks() < 2) return {};
  // The horizon's surface in a fault block may end up to one triangle side before the fault. Continuing it over twice
  // that length closes the gap.
  const double step = how.within_of_horizons / 2;
  std::vector<GriddedInBlocks> told;
  for (const auto& [row, points] : made) {
    if (blocks.end_at(row)) continue;
    BlockSurfaces horizon(surfaces[row], points, blocks, step);
    std::optional<GriddedInBlocks> in_blocks = horizon.make();
    if (!in_blocks) continue;
    in_blocks->row = row;
    told.push_back(*in_blocks);
    surfaces[row].points = std::move(horizon.surface().points);
    surfaces[row].triangles = std::move(horizon.surface().triangles);
  }
  return told;
}

}  // namespace geomesh::geomodel
