// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/thin_layers.hpp"

#include <algorithm>
#include <cmath>

#include "geomesh/core/error.hpp"
#include "naming/region_facts.hpp"
#include "naming/sums.hpp"
#include "rules/planar/map_locator.hpp"
#include "rules/planar/planar_overlay.hpp"

namespace geomesh::geomodel {
namespace {

double map_area(Vec2 a, Vec2 b, Vec2 c) {
  return 0.5 * std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// Places where a layer is thinner than required, at the points of the common triangulation of its two horizons.
struct ThinPlaces {
  double area = 0;   ///< area in the map of triangles at all corners of which the layer is thin
  double least = 0;  ///< least thickness of the layer; negative where the horizons cross
  Vec3 place;
  bool any = false;
};

/// Returns whether a layer is thin but not pinched out; where its horizons coincide, its absence is intended.
bool is_thin(double thickness, double wanted) { return thickness != 0 && std::abs(thickness) < wanted; }

void note_thin(ThinPlaces& thin, double thickness, const Vec3& place) {
  if (thin.any && thickness >= thin.least) return;
  thin.any = true;
  thin.least = thickness;
  thin.place = place;
}

std::string told(const std::string& unit, const ModelRules& rules, const ThinPlaces& thin) {
  return "unit " + unit + " is thinner than " + to_text(rules.min_thickness) + " m over an area of about " +
         to_text(thin.area) + " (" +
         (thin.least < 0 ? "its horizons cross by " + to_text(-thin.least) : "least " + to_text(thin.least)) +
         " m near " + to_text(thin.place) + ")";
}

/// A horizon interpolated on the common triangulation of several horizons in the map.
struct Draped {
  std::vector<bool> has;       ///< for each triangle of the horizons' common triangulation: whether it has the horizon
  std::vector<double> height;  ///< height of the horizon at each point of the common triangulation; NaN where absent
  bool overhangs = false;
};

Draped drape(const PlanarOverlay& overlay, const TriangulatedSurface& horizon) {
  const MapLocator locator(horizon);
  Draped draped;
  draped.height.assign(overlay.points.size(), std::nan(""));
  for (const Triangle& t : overlay.triangles) {
    const Vec2 &a = overlay.points[t[0]], &b = overlay.points[t[1]], &c = overlay.points[t[2]];
    const MapLocator::Hit hit = locator.find({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
    draped.has.push_back(hit.count > 0);
    draped.overhangs = draped.overhangs || (hit.count > 1 && hit.strictly);
    if (hit.count == 0) continue;
    for (VertexIndex v : t) {
      if (!std::isnan(draped.height[v])) continue;
      const MapLocator::Hit own = locator.find(overlay.points[v]);
      draped.height[v] = locator.height(own.count > 0 ? own.triangle : hit.triangle, overlay.points[v]);
    }
  }
  return draped;
}

/// Measures where the layer between two horizons is thin, only inside the box if there is one.
ThinPlaces measure(const TriangulatedSurface& top, const TriangulatedSurface& base, const ModelRules& rules) {
  const PlanarOverlay overlay = overlay_in_map({&top, &base});
  const Draped above = drape(overlay, top), below = drape(overlay, base);
  const auto in_box = [&](const Triangle& t) {
    Box3 box;
    for (VertexIndex v : t) box.add({overlay.points[v].x, overlay.points[v].y, 0});
    return !rules.box || (box.max.x > rules.box->min.x && box.min.x < rules.box->max.x &&
                          box.max.y > rules.box->min.y && box.min.y < rules.box->max.y);
  };
  ThinPlaces thin;
  for (std::size_t f = 0; f < overlay.triangles.size(); ++f) {
    const Triangle& t = overlay.triangles[f];
    if (!above.has[f] || !below.has[f] || !in_box(t)) continue;
    std::size_t n_thin = 0;
    for (VertexIndex v : t) {
      const double thickness = above.height[v] - below.height[v];
      if (!is_thin(thickness, rules.min_thickness)) continue;
      note_thin(thin, thickness, {overlay.points[v].x, overlay.points[v].y, below.height[v]});
      ++n_thin;
    }
    if (n_thin == 3) thin.area += map_area(overlay.points[t[0]], overlay.points[t[1]], overlay.points[t[2]]);
  }
  return thin;
}

/// Moves points of the younger horizon closer than `wanted` to the older one onto it; returns the largest move.
double collapse_onto(const Draped& older, double wanted, Draped& younger) {
  double largest = 0;
  for (std::size_t v = 0; v < younger.height.size(); ++v) {
    const double gap = younger.height[v] - older.height[v];
    if (!(std::abs(gap) < wanted)) continue;  // heights of absent horizons are NaN, so their points are skipped, too
    largest = std::max(largest, std::abs(gap));
    younger.height[v] = older.height[v];
  }
  return largest;
}

TriangulatedSurface redraped(const TriangulatedSurface& given, const PlanarOverlay& overlay, const Draped& draped) {
  TriangulatedSurface s = given;
  s.points.clear();
  s.triangles.clear();
  CompensatedSum up;
  for (const Triangle& t : given.triangles)
    up.add(cross(given.points[t[1]] - given.points[t[0]], given.points[t[2]] - given.points[t[0]]).z);
  std::vector<VertexIndex> row(overlay.points.size(), no_vertex);
  for (std::size_t f = 0; f < overlay.triangles.size(); ++f) {
    if (!draped.has[f]) continue;
    Triangle t = overlay.triangles[f];
    for (VertexIndex& v : t) {
      if (row[v] == no_vertex) {
        row[v] = static_cast<VertexIndex>(s.points.size());
        s.points.push_back({overlay.points[v].x, overlay.points[v].y, draped.height[v]});
      }
      v = row[v];
    }
    if (up.value() < 0) std::swap(t[1], t[2]);
    s.triangles.push_back(t);
  }
  return s;
}

double collapsed_area(const PlanarOverlay& overlay, const Draped& a, const Draped& b) {
  double area = 0;
  for (std::size_t f = 0; f < overlay.triangles.size(); ++f) {
    const Triangle& t = overlay.triangles[f];
    if (a.has[f] && b.has[f] &&
        std::all_of(t.begin(), t.end(), [&](VertexIndex v) { return a.height[v] == b.height[v]; }))
      area += map_area(overlay.points[t[0]], overlay.points[t[1]], overlay.points[t[2]]);
  }
  return area;
}

/// Collapses the layers between the horizons rows[first] .. rows[last], youngest first, each too thin somewhere.
void collapse_run(BuiltSurfaces& built, const ModelRules& rules, const std::vector<Index>& rows, std::size_t first,
                  std::size_t last) {
  std::vector<const TriangulatedSurface*> run;
  for (std::size_t k = first; k <= last; ++k) run.push_back(&built.surfaces[rows[k]]);
  const PlanarOverlay overlay = overlay_in_map(run);
  std::vector<Draped> draped;
  for (const TriangulatedSurface* s : run) draped.push_back(drape(overlay, *s));
  for (std::size_t k = 0; k < run.size(); ++k)
    if (draped[k].overhangs || !built.rows.block_of_triangle[rows[first + k]].empty()) {
      built.warnings.push_back("min_thickness not applied to horizons " + run.front()->name + " to " +
                               run.back()->name + ": " + run[k]->name +
                               (draped[k].overhangs ? " overhangs in the map" : " is given block by block"));
      return;
    }
  for (std::size_t k = run.size() - 1; k-- > 0;) {
    const double before = collapsed_area(overlay, draped[k], draped[k + 1]);
    const double largest = collapse_onto(draped[k + 1], rules.min_thickness, draped[k]);
    built.notes.push_back("unit " + rules.column[2 * (first + k + 1)] + " collapsed where thinner than " +
                          to_text(rules.min_thickness) + " m: horizon " + run[k]->name + " laid onto " +
                          run[k + 1]->name + " over an area of " +
                          to_text(collapsed_area(overlay, draped[k], draped[k + 1]) - before) + ", moved by at most " +
                          to_text(largest) + " m");
  }
  std::vector<TriangulatedSurface> result;
  for (std::size_t k = 0; k < run.size(); ++k) result.push_back(redraped(*run[k], overlay, draped[k]));
  for (std::size_t k = 0; k < run.size(); ++k) {
    const Index row = rows[first + k];
    built.surfaces[row] = std::move(result[k]);
    built.rows.n_given_triangles[row] = static_cast<Index>(built.surfaces[row].triangles.size());
  }
}

}  // namespace

void apply_min_thickness(BuiltSurfaces& built, const ModelRules& rules) {
  std::vector<Index> rows;
  for (std::size_t i = 1; i < rules.column.size(); i += 2) {
    const auto at = std::find_if(built.surfaces.begin(), built.surfaces.end(),
                                 [&](const auto& s) { return s.name == rules.column[i]; });
    if (at == built.surfaces.end())
      throw Error(ErrorKind::usage, "no surface is named " + rules.column[i] + " (in the column)");
    rows.push_back(static_cast<Index>(at - built.surfaces.begin()));
  }
  std::vector<bool> thin_below(rows.size(), false);  // whether the layer below each horizon is thin
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    const ThinPlaces thin = measure(built.surfaces[rows[k]], built.surfaces[rows[k + 1]], rules);
    if (!thin.any) continue;
    const std::string text = told(rules.column[2 * (k + 1)], rules, thin);
    if (rules.thin_layers == ThinLayers::error)
      throw Error(ErrorKind::invalid_input,
                  text + "; correct horizon " + built.surfaces[rows[k]].name + " or " +
                      built.surfaces[rows[k + 1]].name + ", or choose thin_layers: collapse",
                  {{}, {}, {}, {thin.place}});
    if (rules.thin_layers == ThinLayers::keep) built.warnings.push_back(text + "; kept");
    thin_below[k] = true;
  }
  if (rules.thin_layers != ThinLayers::collapse) return;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!thin_below[k]) continue;
    std::size_t last = k + 1;
    while (last < rows.size() && thin_below[last]) ++last;
    collapse_run(built, rules, rows, k, last);
    k = last;
  }
}

}  // namespace geomesh::geomodel
