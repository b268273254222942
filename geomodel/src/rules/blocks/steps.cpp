// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of horizons beyond the ends of faults: remove_continuations of rules/blocks/part_blocks.hpp, and add_steps of
// geomesh/geomodel/model_rules.hpp.
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "common/union_find.hpp"
#include "geomesh/core/predicates.hpp"
#include "naming/region_facts.hpp"
#include "naming/sums.hpp"
#include "rules/blocks/part_blocks.hpp"

namespace geomesh::geomodel {
namespace {

using Origin = PolygonSoup::Origin;

bool is_continued(const BuiltRows& built, const std::vector<TriangulatedSurface>& surfaces, Index s) {
  return s < built.first_only_parting.size() && built.first_only_parting[s] < surfaces[s].triangles.size();
}

/// Whether blocks part the horizon, or parts of it were made block by block: only then may its blocks not meet.
bool has_blocks(const BuiltRows& built, std::size_t horizon) {
  return !built.parted_at[horizon].empty() || !built.part_of_triangle[horizon].empty();
}

/// An edge of what continues a fault.
struct Edge {
  std::span<const EdgeUse> uses;
  std::vector<Index> own;  ///< facets of the continuation
};

/// How high a step of a horizon is where it ends: at the fault, at the sides of the model, or at another fault.
struct StepHeights {
  double largest = 0, at_sides = 0;

  /// `step`: facets, ascending.
  StepHeights(const Parting& p, const std::vector<Edge>& edges, Index horizon, const std::vector<Index>& step) {
    const auto& points = p.soup.soup.points;
    std::map<VertexIndex, Index> row;
    std::vector<const Edge*> ends;
    for (const Edge& e : edges) {
      const auto in_step = [&](Index f) { return std::ranges::binary_search(step, f); };
      const auto is_of_horizon = [&](const EdgeUse& u) { return p.soup.has(u.facet, horizon); };
      if (std::ranges::count_if(e.uses, is_of_horizon) != 1 || std::ranges::count_if(e.own, in_step) != 1) continue;
      ends.push_back(&e);
      for (const VertexIndex v : {e.uses[0].a, e.uses[0].b}) row.emplace(v, static_cast<Index>(row.size()));
    }
    UnionFind joined(row.size());
    for (const Edge* e : ends) joined.unite(row.at(e->uses[0].a), row.at(e->uses[0].b));
    std::map<Index, double> height;  // by run of edges
    std::set<Index> at_side;
    for (const Edge* e : ends) {
      const Index run = joined.find(row.at(e->uses[0].a));
      height[run] += std::abs(points[e->uses[0].a].z - points[e->uses[0].b].z);
      for (const EdgeUse& u : e->uses)
        for (const Origin& o : p.soup.origins[u.facet])
          if (p.surfaces[o.surface].kind == SurfaceKind::box) at_side.insert(run);
    }
    for (const auto& [run, high] : height) {
      largest = std::max(largest, high);
      if (at_side.contains(run)) at_sides = std::max(at_sides, high);
    }
  }
};

/// The facets by which one fault was continued.
class FaultContinuation {
 public:
  FaultContinuation(const Parting& p, Index fault) : p_(p), fault_(fault) {
    for (Index f = 0; f < p.soup.origins.size(); ++f)
      if (triangle_at(f)) facets_.push_back(f);
    for_each_edge(p.soup.uses, [&](std::span<const EdgeUse> edge) {
      std::vector<Index> own;
      for (const EdgeUse& u : edge)
        if (std::ranges::binary_search(facets_, u.facet)) own.push_back(u.facet);
      if (!own.empty()) edges_.push_back({edge, std::move(own)});
    });
  }

  /// Gives the horizon the facets between its blocks.
  void close(Index horizon) {
    std::map<Index, std::vector<Neighbour>> beside;
    std::array<bool, 2> ends_on{false, false};  // by side of the fault
    for (const Edge& e : edges_) {
      std::vector<Index> of_horizon;
      for (const EdgeUse& u : e.uses)
        if (p_.soup.has(u.facet, horizon)) of_horizon.push_back(u.facet);
      const bool ends_here = of_horizon.size() % 2 == 1;
      if (of_horizon.size() == 1 && !std::ranges::count(e.own, of_horizon[0]))
        ends_on[is_above(of_horizon[0], e) ? 1 : 0] = true;
      for (std::size_t i = 1; i < e.own.size(); ++i) {
        beside[e.own[0]].push_back({e.own[i], ends_here});
        beside[e.own[i]].push_back({e.own[0], ends_here});
      }
    }
    if (!ends_on[0] && !ends_on[1]) return;
    std::map<Index, int> side;  // by facet: of the horizon's ends, 0 or 1
    std::vector<Index> step;
    bool is_closed = ends_on[0] && ends_on[1];
    for (const Index first : facets_)
      if (is_closed && !side.contains(first)) is_closed = add_smaller_side(first, side, beside, step);
    if (is_closed && !step.empty()) give(horizon, std::move(step));
    const std::vector<Index>& faults = p_.built.parted_at[horizon];
    if (!is_closed && std::ranges::binary_search(faults, fault_)) tell_open(horizon);
  }

  void remove() {
    p_.removed[fault_] += p_.soup.remove(facets_, [&](const Origin& o) { return is_made(o); });
  }

 private:
  struct Neighbour {
    Index facet;
    bool changes;  ///< the horizon ends between the two
  };

  /// Whether a facet at the edge lies on the side of the fault to which its triangles' normals point.
  bool is_above(Index facet, const Edge& e) const {
    const auto& points = p_.soup.soup.points;
    const Triangle& t = p_.soup.soup.facets[e.own[0]];
    const auto at = std::ranges::find_if(p_.soup.origins[e.own[0]], [&](const Origin& o) { return is_made(o); });
    for (const VertexIndex v : p_.soup.soup.facets[facet])
      if (v != e.uses[0].a && v != e.uses[0].b)
        return (orient3d(points[t[0]], points[t[1]], points[t[2]], points[v]) == Sign::positive) != at->reversed;
    return false;
  }

  bool is_made(const Origin& o) const {
    return o.surface == fault_ && o.triangle >= p_.built.first_only_parting[fault_];
  }
  std::optional<Index> triangle_at(Index f) const {
    const auto at = std::ranges::find_if(p_.soup.origins[f], [&](const Origin& o) { return is_made(o); });
    return at == p_.soup.origins[f].end() ? std::nullopt : std::optional(at->triangle);
  }

  /// Goes from facet to facet, and changes sides where the horizon ends. The smaller side lies between its blocks.
  /// False where a facet would be on both sides.
  bool add_smaller_side(Index first, std::map<Index, int>& side, std::map<Index, std::vector<Neighbour>>& beside,
                        std::vector<Index>& step) const {
    std::vector<Index> reached{first};
    side[first] = 0;
    double area[2] = {0, 0};
    for (std::size_t k = 0; k < reached.size(); ++k) {
      const int here = side.at(reached[k]);
      area[here] += p_.soup.area(reached[k]);
      for (const auto& [other, changes] : beside[reached[k]]) {
        const auto [at, is_new] = side.emplace(other, changes ? 1 - here : here);
        if (is_new) reached.push_back(other);
        if (at->second != (changes ? 1 - here : here)) return false;
      }
    }
    const int smaller = area[1] < area[0] ? 1 : 0;
    for (const Index f : reached)
      if (side.at(f) == smaller && area[smaller] < area[1 - smaller] && area[smaller] > 0) step.push_back(f);
    return true;
  }

  void give(Index horizon, std::vector<Index> step) {
    double area = 0;
    for (const Index f : step) {
      // Copies of the continuations of faults follow each other in the order of the faults.
      Index row = p_.built.first_step[horizon];
      for (Index s = 0; s < fault_; ++s)
        if (is_continued(p_.built, p_.surfaces, s))
          row += static_cast<Index>(p_.surfaces[s].triangles.size()) - p_.built.first_only_parting[s];
      const auto at = std::ranges::find_if(p_.soup.origins[f], [&](const Origin& o) { return is_made(o); });
      row += at->triangle - p_.built.first_only_parting[fault_];
      p_.soup.origins[f].push_back({horizon, row, at->reversed});
      std::ranges::sort(p_.soup.origins[f], {}, [](const Origin& o) { return std::pair(o.surface, o.triangle); });
      area += p_.soup.area(f);
    }
    tell(horizon, std::move(step), area);
  }

  void tell(Index horizon, std::vector<Index> step, double area) {
    std::ranges::sort(step);
    const StepHeights heights(p_, edges_, horizon, step);
    const std::string what = "horizon " + p_.surfaces[horizon].name +
                             ": its blocks are joined beyond the end of its faults by a step at " +
                             p_.surfaces[fault_].name + " (throw left there: at most " + to_text(heights.largest) +
                             " m, area " + to_text(area) + ", near " + to_text(p_.soup.centre(step.front())) + ")";
    if (heights.at_sides > p_.rules.stack.tolerance)
      p_.warnings.push_back(what +
                            "; the throw does not die out towards the end of the model: should the fault reach " +
                            "further (extent: to_box)?");
    else
      p_.notes.push_back(what);
  }

  void tell_open(Index horizon) {
    p_.warnings.push_back("horizon " + p_.surfaces[horizon].name + " is not divided by fault " +
                          p_.surfaces[fault_].name +
                          " alone: beyond the end of the fault its blocks do not meet; let the fault reach through the "
                          "model (extent: to_box), or give the horizon round its end");
  }

  const Parting& p_;
  Index fault_;
  std::vector<Index> facets_;  ///< ascending
  std::vector<Edge> edges_;
};

}  // namespace

void add_steps(std::vector<TriangulatedSurface>& surfaces, BuiltRows& built) {
  built.first_step.assign(surfaces.size(), no_index);
  std::vector<Index> faults;
  for (Index s = 0; s < surfaces.size(); ++s)
    if (is_continued(built, surfaces, s)) faults.push_back(s);
  if (faults.empty()) return;
  for (std::size_t h = 0; h < surfaces.size(); ++h) {
    TriangulatedSurface& horizon = surfaces[h];
    if (horizon.kind != SurfaceKind::horizon || !has_blocks(built, h)) continue;
    built.first_step[h] = static_cast<Index>(horizon.triangles.size());
    for (const Index s : faults) {
      const auto shift = static_cast<VertexIndex>(horizon.points.size());
      horizon.points.insert(horizon.points.end(), surfaces[s].points.begin(), surfaces[s].points.end());
      for (std::size_t t = built.first_only_parting[s]; t < surfaces[s].triangles.size(); ++t) {
        Triangle own = surfaces[s].triangles[t];
        for (VertexIndex& v : own) v += shift;
        horizon.triangles.push_back(own);
      }
    }
  }
}

void remove_continuations(const Parting& parting) {
  for (Index s = 0; s < parting.built.first_only_parting.size(); ++s) {
    if (!is_continued(parting.built, parting.surfaces, s)) continue;
    FaultContinuation continuation(parting, s);
    for (Index h = 0; h < parting.built.first_step.size(); ++h)
      if (parting.built.first_step[h] != no_index) continuation.close(h);
    continuation.remove();
  }
}

}  // namespace geomesh::geomodel
