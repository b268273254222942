// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/block_sheets.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "naming/sums.hpp"
#include "rules/continuation/block_places.hpp"
#include "rules/continuation/horizon_division.hpp"

namespace geomesh::geomodel {
namespace {

class Continuation {
 public:
  Continuation(const HorizonInBlocks& setting, Index block, const std::vector<Triangle>& sheet)
      : s_(setting), places_(setting, block, sheet) {
    made_.block = block;
  }

  /// Continues a horizon in a block; nothing if its border crosses itself in the map, or the grid would have no points.
  std::optional<BlockExtension> make() {
    if (!places_.has_grid()) return std::nullopt;
    std::vector<Vec2> in_map;
    for (const Vec3& p : places_.points()) in_map.push_back({p.x, p.y});
    const auto all = triangulate_plane(in_map, places_.border().edges());
    if (!all) return std::nullopt;
    std::vector<std::set<Index>> walls_of;
    std::vector<bool> is_kept;
    for (const PlanarTriangle& t : *all) is_kept.push_back(places_.is_filled(t.vertices, walls_of.emplace_back()));
    const std::vector<bool> begins_at_border = places_.border().beside_border(*all, is_kept);
    std::set<Index> walls;
    for (std::size_t k = 0; k < all->size(); ++k) {
      if (!begins_at_border[k]) continue;
      walls.insert(walls_of[k].begin(), walls_of[k].end());
      book((*all)[k].vertices);
      add((*all)[k].vertices);
    }
    if (s_.has_margin) add_margin(*all, begins_at_border);
    made_.walls.assign(walls.begin(), walls.end());
    return std::move(made_);
  }

 private:
  /// Adds the length of border that triangle t continues, and finds the place of t farthest from the horizon's border.
  void book(const std::array<Index, 3>& t) {
    const std::vector<Vec3>& points = places_.points();
    const auto look_at = [&](const Vec3& p, double distance) {
      if (distance <= made_.farthest) return;
      made_.farthest = distance;
      made_.place = p;
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      if (places_.border().is_end(std::minmax(a, b))) made_.length += norm(points[b] - points[a]);
      if (!places_.is_in_block(a)) continue;
      look_at(points[a], places_.distance(a));
      const auto hit = s_.walls.first_hit(points[a], points[b], s_.row);
      if (!hit) continue;
      const Vec3 p = points[a] + hit->share * (points[b] - points[a]);
      look_at(p, places_.border().continued_at({p.x, p.y}).distance);
    }
  }

  void add(const std::array<Index, 3>& t) {
    Triangle own;
    for (std::size_t i = 0; i < 3; ++i) own[i] = row_of(t[i]);
    if (!places_.border().faces_up()) std::swap(own[1], own[2]);
    made_.triangles.push_back(own);
  }

  /// Adds a margin to the continuation: the triangles beyond bounding surfaces that share a corner with kept ones.
  void add_margin(const std::vector<PlanarTriangle>& all, const std::vector<bool>& is_kept) {
    std::vector<bool> is_reached(places_.points().size(), false);
    for (std::size_t k = 0; k < all.size(); ++k)
      if (is_kept[k])
        for (const Index v : all[k].vertices) is_reached[v] = true;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::array<Index, 3>& t = all[k].vertices;
      if (!is_kept[k] && all[k].depth % 2 == 0 && std::ranges::any_of(t, [&](Index v) { return is_reached[v]; }) &&
          !places_.overlaps(t))
        add(t);
    }
  }

  VertexIndex row_of(Index v) {
    if (v < places_.n_border()) return places_.border().row(v);
    const auto [at, is_new] = added_.emplace(v, no_vertex);
    if (is_new) {
      at->second = static_cast<VertexIndex>(s_.horizon.points.size() + made_.added.size());
      made_.added.push_back(places_.points()[v]);
    }
    return at->second;
  }

  HorizonInBlocks s_;
  BlockPlaces places_;
  BlockExtension made_;
  std::map<Index, VertexIndex> added_;
};

}  // namespace

DividedHorizon continue_in_blocks(const TriangulatedSurface& horizon, Index row, const BorderStates& states,
                                  const BlockSetting& setting) {
  const auto& [framework, cutters, walls, within, fills_blocks, is_left_out, has_margin] = setting;
  const HorizonDivision division(horizon, row, framework, cutters, states);
  DividedHorizon divided{
      std::vector<bool>(horizon.triangles.size(), true), std::vector<bool>(framework.n_blocks(), true), {}};
  for (Index b = 0; b < framework.n_blocks(); ++b) {
    if (!is_left_out.empty() && is_left_out[b]) continue;
    const std::vector<Index> rows = division.sheet_of(b);
    if (rows.empty()) continue;
    std::vector<Triangle> sheet;
    for (const Index t : rows) sheet.push_back(division.triangles()[t]);
    std::optional<BlockExtension> extension;
    if (!framework.has_tip(b))
      extension =
          Continuation({horizon, row, framework, cutters, walls, within, division, fills_blocks, has_margin}, b, sheet)
              .make();
    if (extension) {
      if (!extension->triangles.empty()) divided.extensions.push_back(std::move(*extension));
      continue;
    }
    for (const Index t : rows) divided.is_continued[t] = false;
    divided.block_is_continued[b] = false;
  }
  return divided;
}

}  // namespace geomesh::geomodel
