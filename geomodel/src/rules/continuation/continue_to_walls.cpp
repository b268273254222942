// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/continue_to_walls.hpp"

#include <algorithm>
#include <set>

#include "naming/region_facts.hpp"
#include "rules/continuation/apron.hpp"
#include "rules/continuation/bridges.hpp"
#include "rules/planar/borders.hpp"

namespace geomesh::geomodel {
namespace {

constexpr Index given_part = 0;  ///< part of the triangles that no continuation made

/// One surface on its way to its walls.
class Continuing {
 public:
  Continuing(BuiltSurfaces& built, Index row, const Walls& walls, const ContinuationRules& rules, double within)
      : built_(built), row_(row), walls_(walls), rules_(rules), within_(within) {
    ledger_.name = surface().name;
  }

  void fill_gaps(const Walls& without_horizons, const std::vector<TriangulatedSurface>& tips) {
    const Bridged bridged = bridge_gaps(surface(), without_horizons, tips, rules_.bounds, within_);
    ledger_.n_filled = bridged.n_triangles;
    ledger_.area_filled = bridged.area;
    ledger_.place_filled = bridged.place;
  }

  void go_on() {
    const std::size_t first = surface().triangles.size();
    const ApronSetting setting{frame_of(surface()), within_, rules_.bounds};
    const std::vector<BorderChain> chains = chains_before_walls(surface(), row_, walls_, rules_.bounds, within_);
    std::vector<Apron> aprons;
    for (const BorderChain& chain : chains) aprons.push_back(make_apron(surface(), row_, chain, walls_, setting));
    std::vector<Index> part(first, given_part);
    Index n_parts = 1;
    std::set<Index> ends_on;
    for (std::size_t k = 0; k < aprons.size(); ++k) {
      if (aprons[k].triangles.empty()) continue;
      append(aprons[k], first_points_);
      for (const Index side : aprons[k].side) part.push_back(n_parts + side);
      n_parts = 1 + *std::max_element(part.begin(), part.end());
      book(chains[k], aprons[k], ends_on);
    }
    ledger_.area = area_from(surface(), first);
    if (ends_on.empty() && ledger_.area == 0) return;
    built_.rows.part_of_triangle[row_] = std::move(part);
    built_.rows.continued_to[row_].assign(ends_on.begin(), ends_on.end());
  }

  void tell(const BuildLog& log) {
    if (ledger_.n_filled > 0)
      log.notes.push_back("surface " + ledger_.name + ": gaps narrower than " + to_text(2 * within_) +
                          " filled (area " + to_text(ledger_.area_filled) + ", the largest near " +
                          to_text(ledger_.place_filled) + ")");
    if (ledger_.area > 0)
      log.notes.push_back("surface " + ledger_.name + ": continued along " + to_text(ledger_.length) +
                          " m of its border to " + ledger_.walls + ", by up to " + to_text(ledger_.farthest) +
                          " m, near " + to_text(ledger_.place) + " (extend: none keeps the border open)");
    if (ledger_.n_filled > 0 || ledger_.area > 0) built_.continued.push_back(ledger_);
  }

 private:
  TriangulatedSurface& surface() { return built_.surfaces[row_]; }

  void append(const Apron& apron, std::size_t& first_points) {
    TriangulatedSurface& s = surface();
    if (first_points == 0) first_points = s.points.size();
    const auto shift = static_cast<VertexIndex>(s.points.size() - first_points);
    s.points.insert(s.points.end(), apron.added.begin(), apron.added.end());
    for (Triangle t : apron.triangles) {
      for (VertexIndex& v : t)
        if (v >= first_points) v += shift;
      s.triangles.push_back(t);
    }
  }

  void book(const BorderChain& chain, const Apron& apron, std::set<Index>& ends_on) {
    ledger_.length += chain.length;
    if (chain.farthest >= ledger_.farthest) ledger_.farthest = chain.farthest, ledger_.place = chain.place;
    std::set<std::string> names;
    for (const Index wall : chain.walls) names.insert(name_of(wall));
    for (const Index wall : apron.walls) {
      names.insert(name_of(wall));
      ends_on.insert(wall);
    }
    for (const std::string& name : names)
      if ((", " + ledger_.walls + ",").find(", " + name + ",") == std::string::npos)
        ledger_.walls += (ledger_.walls.empty() ? "" : ", ") + name;
  }

  std::string name_of(Index wall) const {
    return wall == Walls::side_of_volume ? "the sides of the model" : built_.surfaces[wall].name;
  }

  BuiltSurfaces& built_;
  Index row_;
  const Walls& walls_;
  const ContinuationRules& rules_;
  double within_;
  std::size_t first_points_ = 0;
  ContinuedSurface ledger_;
};

std::vector<Index> rows_of(const std::vector<TriangulatedSurface>& surfaces, std::initializer_list<SurfaceKind> kinds) {
  std::vector<Index> rows;
  for (Index s = 0; s < surfaces.size(); ++s)
    if (std::find(kinds.begin(), kinds.end(), surfaces[s].kind) != kinds.end()) rows.push_back(s);
  return rows;
}

/// A fault across which a horizon has throw is continued by that rule, to part the horizon's blocks.
bool parts_a_horizon(const ModelRules& rules, const std::string& fault) {
  return std::any_of(rules.surfaces.begin(), rules.surfaces.end(), [&](const SurfaceRules& rule) {
    return std::find(rule.throw_at.begin(), rule.throw_at.end(), fault) != rule.throw_at.end();
  });
}

bool keeps_border(const BuiltSurfaces& built, const ModelRules& rules, Index row) {
  const SurfaceRules& rule = rules.of(row);
  return built.surfaces[row].triangles.empty() || !rule.continues || rule.extend != Extend::none ||
         !rule.throw_at.empty();
}

}  // namespace

void continue_faults(BuiltSurfaces& built, const ModelRules& rules, const BuildLog& log) {
  const ContinuationRules& how = rules.continuation;
  if (!(how.within_of_faults > 0)) return;
  const std::vector<Index> faults = rows_of(built.surfaces, {SurfaceKind::fault});
  const Walls walls(built.surfaces, faults, how.sides);
  for (const Index row : faults) {
    if (keeps_border(built, rules, row) || parts_a_horizon(rules, built.surfaces[row].name)) continue;
    Continuing fault(built, row, walls, how, how.within_of_faults);
    fault.go_on();
    fault.tell(log);
  }
}

void continue_horizons(BuiltSurfaces& built, const ModelRules& rules, const BuildLog& log) {
  const ContinuationRules& how = rules.continuation;
  if (!(how.within_of_horizons > 0)) return;
  const std::vector<Index> cutters = rows_of(built.surfaces, {SurfaceKind::fault, SurfaceKind::body});
  const std::vector<Index> all = rows_of(built.surfaces, {SurfaceKind::fault, SurfaceKind::body, SurfaceKind::horizon});
  std::vector<TriangulatedSurface> tips;
  for (const Index row : cutters)
    if (built.surfaces[row].kind == SurfaceKind::fault) tips.push_back(built.surfaces[row]);
  const Walls explained(built.surfaces, cutters, {}), walls(built.surfaces, all, how.sides);
  for (const Index row : all) {
    if (built.surfaces[row].kind != SurfaceKind::horizon || keeps_border(built, rules, row)) continue;
    Continuing horizon(built, row, walls, how, how.within_of_horizons);
    horizon.fill_gaps(explained, tips);
    horizon.go_on();
    horizon.tell(log);
  }
}

}  // namespace geomesh::geomodel
