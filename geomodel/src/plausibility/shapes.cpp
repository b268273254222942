// SPDX-License-Identifier: GPL-3.0-or-later
// Detects inputs whose shape does not fit their kind, declared in plausibility/doubts.hpp.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "common/union_find.hpp"
#include "geomesh/geomodel/words.hpp"
#include "naming/sheets.hpp"
#include "naming/sums.hpp"
#include "plausibility/doubts.hpp"
#include "plausibility/spikes.hpp"

namespace geomesh::geomodel {
namespace {

/// Ratio of map area to true area below which a horizon counts as vertical (mean dip of more than 80 degrees).
/// Overturned folds and flanks of salt have a flatter mean.
constexpr double upright = 0.17;
/// Ratio of map area to true area below which a horizon counts as vertical if it passes through most of the box and
/// covers little of the map, as faults do.
constexpr double steep = 0.6, most_of_height = 0.5, little_of_map = 0.35;
/// A fault counts as horizontal if its mean dip is below 5 degrees over nearly all of the map.
constexpr double level = 0.996, all_of_map = 0.95;
/// Tolerances within which an open end of a body counts as leaving the box: its distance from the box side may be some
/// edge lengths of the end, limited by these shares of the box's diagonal. Coarse bodies have long edges.
constexpr double most_edges_inside = 3, least_share_inside = 0.01, most_share_inside = 0.03;
/// A closed surface with a smaller volume than this, relative to the cube of its diagonal, encloses nothing.
constexpr double least_volume = 1e-12;

struct Areas {
  double whole = 0, map = 0;
  Box3 bounds;
};

Areas areas_of(const TriangulatedSurface& s) {
  CompensatedSum whole, map;
  Areas areas;
  for (const Vec3& p : s.points) areas.bounds.add(p);
  for (const Triangle& t : s.triangles) {
    const Vec3 normal = cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]);
    whole.add(0.5 * norm(normal));
    map.add(0.5 * std::abs(normal.z));
  }
  areas.whole = whole.value();
  areas.map = map.value();
  return areas;
}

std::string place_words(const Vec3& p, const Vec3& origin) {
  char text[120];
  std::snprintf(text, sizeof text, "(%.8g, %.8g, %.6g)", p.x + origin.x, p.y + origin.y, p.z + origin.z);
  return text;
}

void doubt_kind(const Inspected& model, const TriangulatedSurface& s, std::vector<Finding>& findings) {
  const Areas areas = areas_of(s);
  if (!(areas.whole > 0)) return;
  const double flatness = areas.map / areas.whole;
  bool is_steep = flatness < upright, is_level = false;
  if (model.volume) {
    const Vec3 size = model.volume->max - model.volume->min;
    const double map_area = size.x * size.y;
    is_steep = is_steep || (flatness < steep && areas.map < little_of_map * map_area &&
                            areas.bounds.max.z - areas.bounds.min.z > most_of_height * size.z);
    is_level = flatness > level && areas.map > all_of_map * map_area;
  }
  const double dip = std::acos(std::min(1.0, flatness)) * 180 / 3.14159265358979323846;
  if (s.kind == SurfaceKind::horizon && is_steep)
    findings.push_back({Finding::Sureness::probable,
                        "upright horizon",
                        {s.name},
                        "horizon " + s.name + " dips by " + short_words(dip) + " degrees in the mean, as a fault does",
                        "if it is one, give kind: fault"});
  const bool is_fracture = s.file == "fractures";  // fractures are faults by default, so the user did not choose that
  if (s.kind == SurfaceKind::fault && is_level && !is_fracture)
    findings.push_back({Finding::Sureness::probable,
                        "level fault",
                        {s.name},
                        "fault " + s.name + " lies nearly level over the whole map, as a horizon does",
                        "if it is one, give kind: horizon, and its place in the column"});
}

/// Border edges of a surface, after merging points with equal coordinates.
struct Border {
  std::vector<std::pair<VertexIndex, VertexIndex>> edges;
};
Border border_of(const TriangulatedSurface& s) {
  struct Edge {
    VertexIndex low, high;
    bool operator<(const Edge& o) const { return std::tie(low, high) < std::tie(o.low, o.high); }
  };
  std::vector<Edge> edges;
  for (const Triangle& t : merged_triangles(s))
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexIndex a = t[i], b = t[(i + 1) % 3];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b)});
    }
  std::sort(edges.begin(), edges.end());
  Border border;
  for (std::size_t i = 0, j; i < edges.size(); i = j) {
    for (j = i; j < edges.size() && !(edges[i] < edges[j]);) ++j;
    if (j - i == 1) border.edges.emplace_back(edges[i].low, edges[i].high);
  }
  return border;
}

/// An open end of a body: its border, and the largest distance of its points from the side of the box nearest to it.
struct OpenEnd {
  Box3 bounds;
  double length = 0;
  std::size_t n_edges = 0;
  double inside(const Box3& box) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k)
      least = std::min({least, bounds.max[k] - box.min[k], box.max[k] - bounds.min[k]});
    return least;
  }
};

std::vector<OpenEnd> open_ends(const TriangulatedSurface& s) {
  const Border border = border_of(s);
  UnionFind joined(s.points.size());
  for (const auto& [a, b] : border.edges) joined.unite(a, b);
  std::vector<Index> row(s.points.size(), no_index);
  std::vector<OpenEnd> ends;
  for (const auto& [a, b] : border.edges) {
    Index& end = row[joined.find(a)];
    if (end == no_index) {
      end = static_cast<Index>(ends.size());
      ends.emplace_back();
    }
    ends[end].bounds.add(s.points[a]);
    ends[end].bounds.add(s.points[b]);
    ends[end].length += norm(s.points[b] - s.points[a]);
    ++ends[end].n_edges;
  }
  return ends;
}

void doubt_open_body(const Inspected& model, const TriangulatedSurface& s, const SurfaceRules& rule,
                     std::vector<Finding>& findings) {
  if (!model.volume || !rule.close_at_box) return;
  const double diagonal = norm(model.volume->max - model.volume->min);
  for (const OpenEnd& end : open_ends(s)) {
    if (end.length <= rule.fill_holes) continue;
    const double inside = end.inside(*model.volume);
    const double mean_edge = end.length / static_cast<double>(end.n_edges);
    const double allowed =
        std::clamp(most_edges_inside * mean_edge, least_share_inside * diagonal, most_share_inside * diagonal);
    if (inside <= allowed) continue;
    const Vec3 middle = 0.5 * (end.bounds.min + end.bounds.max);
    // Salt whose roots were not interpreted ends in the model, too, so this is a warning: the body is extruded to the
    // box.
    findings.push_back({Finding::Sureness::probable,
                        "open body",
                        {s.name},
                        "body " + s.name + " is open inside the model: a border of " + std::to_string(end.n_edges) +
                            " edges about " + place_words(middle, model.project.output.origin) + " ends " +
                            short_words(inside) + " " + model.project.crs.unit +
                            " before the nearest side of the box, to which it is drawn out straight",
                        "close it (fill_holes: all in its entry puts a lid on it), or let it go on beyond the box"});
    return;  // one end suffices
  }
}

void doubt_volume(const TriangulatedSurface& s, std::vector<Finding>& findings) {
  CompensatedSum volume;
  Box3 bounds;
  for (const Vec3& p : s.points) bounds.add(p);
  const Vec3 origin = s.points.front();
  for (const Triangle& t : s.triangles)
    volume.add(dot(s.points[t[0]] - origin, cross(s.points[t[1]] - origin, s.points[t[2]] - origin)) / 6);
  const double diagonal = norm(bounds.max - bounds.min);
  if (std::abs(volume.value()) >= least_volume * diagonal * diagonal * diagonal) return;
  findings.push_back({Finding::Sureness::certain,
                      "empty body",
                      {s.name},
                      "body " + s.name +
                          " is closed, but encloses nothing (its walls coincide, or its "
                          "triangles are not oriented alike)",
                      "a dyke or sill is given as one sheet with thickness: T in its entry"});
}

void doubt_duplicates(const Inspected& model, std::vector<Finding>& findings) {
  const auto& surfaces = model.inputs.surfaces;
  std::vector<std::size_t> order;
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    if (!surfaces[s].points.empty() && model.project.surfaces[s].below.empty()) order.push_back(s);
  const auto less = [&](std::size_t a, std::size_t b) {
    const auto key = [&](std::size_t s) {
      const Vec3 &first = surfaces[s].points.front(), &last = surfaces[s].points.back();
      return std::tuple(surfaces[s].points.size(), first.x, first.y, first.z, last.x, last.y, last.z);
    };
    return key(a) < key(b);
  };
  std::stable_sort(order.begin(), order.end(), less);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const TriangulatedSurface &a = surfaces[order[i - 1]], &b = surfaces[order[i]];
    if (a.points != b.points || a.triangles != b.triangles) continue;
    findings.push_back({Finding::Sureness::probable,
                        "duplicate",
                        {a.name, b.name},
                        a.name + " and " + b.name + " are one and the same surface" +
                            (a.file == b.file && !a.file.empty() ? " (both from " + a.file + ")" : ""),
                        "is one of the files (or 'object') meant to be another?"});
  }
}

void doubt_duplicate_wells(const Inspected& model, std::vector<Finding>& findings) {
  std::map<std::vector<std::tuple<double, double, double>>, std::string> known;
  for (const Polyline& well : model.inputs.wells) {
    std::vector<std::tuple<double, double, double>> path;
    for (const Vec3& p : well.points) path.emplace_back(p.x, p.y, p.z);
    const auto [first, is_new] = known.try_emplace(std::move(path), well.name);
    if (is_new || well.points.empty()) continue;
    findings.push_back({Finding::Sureness::probable,
                        "duplicate",
                        {first->second, well.name},
                        "wells " + first->second + " and " + well.name + " have one and the same path",
                        "is one of the files (or 'object') meant to be another?"});
  }
}

void doubt_spikes(const Inspected& model, const TriangulatedSurface& s, std::vector<Finding>& findings) {
  const Spikes spikes = find_spikes(s);
  if (spikes.n > 0)
    findings.push_back({Finding::Sureness::probable,
                        "spikes",
                        {s.name},
                        "horizon " + s.name + ": " + spikes_words(spikes, model.project.output.origin),
                        spikes_remedy});
}

}  // namespace

void doubt_shapes(const Inspected& model, std::vector<Finding>& findings) {
  // Inputs that another check has already reported are left out, because a wrong unit, for example, also changes the
  // shape of a surface.
  std::set<std::string> elsewhere;
  for (const Finding& finding : findings) elsewhere.insert(finding.inputs.begin(), finding.inputs.end());
  for (std::size_t s = 0; s < model.inputs.surfaces.size(); ++s) {
    const TriangulatedSurface& surface = model.inputs.surfaces[s];
    const SurfaceRules rule = model.project.rules.of(s);
    if (surface.triangles.empty() || elsewhere.contains(surface.name)) continue;
    if (surface.kind != SurfaceKind::body) {
      doubt_kind(model, surface, findings);
      if (surface.kind == SurfaceKind::horizon) doubt_spikes(model, surface, findings);
    } else if (rule.thickness > 0) {
      continue;
    } else if (is_closed(surface)) {
      doubt_volume(surface, findings);
    } else {
      doubt_open_body(model, surface, rule, findings);
    }
  }
  doubt_duplicates(model, findings);
  doubt_duplicate_wells(model, findings);
}

}  // namespace geomesh::geomodel
