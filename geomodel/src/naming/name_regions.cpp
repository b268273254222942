// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/name_regions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>

#include "geomesh/core/predicates.hpp"
#include "naming/sums.hpp"
#include "naming/units_by_heights.hpp"

namespace geomesh::geomodel {

namespace {

// A warning explains the remedy if more than this number of regions share a name.
constexpr std::size_t most_of_one_name = 10;
constexpr const char* what_would_help =
    "; fewer come of horizons that do not cross by noise (honour: tolerance with rules.stack: auto, or min_thickness "
    "with thin_layers: collapse), of small_regions: merge with a min_volume, and of names by fault block "
    "(fault_blocks)";

enum Class : Index { column_class, body_class, hint_class, seed_class, unnamed_class, hull_class };

/// A component's name, without a suffix for regions of equal names, and its rank in the order of region ids.
struct Label {
  Class order = unnamed_class;
  Index rank = 0;  ///< within the class
  std::string name;
};

/// Returns for each component the closed surfaces in which it lies, as ascending indices: bodies (kind body) or, for
/// files without rules, any surface.
std::vector<std::vector<Index>> bodies_around(const std::vector<ComponentFacts>& facts,
                                              const std::vector<TriangulatedSurface>& surfaces,
                                              std::vector<std::string>& warnings) {
  std::vector<std::vector<Index>> around(facts.size());
  for (Index s = 0; s < surfaces.size(); ++s) {
    const TriangulatedSurface& surface = surfaces[s];
    if (surface.kind != SurfaceKind::body && surface.kind != SurfaceKind::surface) continue;
    if (!is_closed(surface)) {
      if (surface.kind == SurfaceKind::body)
        warnings.push_back("body " + surface.name +
                           " is not closed (or its triangles are not oriented alike): no region is named after it");
      continue;
    }
    Box3 box;
    for (const Triangle& t : surface.triangles)
      for (VertexIndex v : t) box.add(surface.points[v]);
    for (std::size_t c = 0; c < facts.size(); ++c) {
      const Vec3& p = facts[c].inside_point;
      if (p.x < box.min.x || p.y < box.min.y || p.z < box.min.z || p.x > box.max.x || p.y > box.max.y ||
          p.z > box.max.z)
        continue;
      if (winding_number(surface, p) != 0) around[c].push_back(s);
    }
  }
  return around;
}

/// Returns the innermost body around component c: one that lies within all other bodies around c; the first if there
/// are several. A body lies within another if the other one contains all of its components.
Index innermost_body(std::size_t c, const std::vector<std::vector<Index>>& around,
                     const std::vector<TriangulatedSurface>& surfaces) {
  const auto holds = [&](std::size_t component, Index body) {
    return std::binary_search(around[component].begin(), around[component].end(), body);
  };
  // A body lies within another if all components in the inner one are also in the outer one, but not vice versa.
  const auto within = [&](Index inner, Index outer) {
    bool all = true, strict = false;
    for (std::size_t k = 0; k < around.size(); ++k) {
      all = all && (!holds(k, inner) || holds(k, outer));
      strict = strict || (holds(k, outer) && !holds(k, inner));
    }
    return all && strict;
  };
  std::vector<Index> bodies;
  for (Index s : around[c])
    if (surfaces[s].kind == SurfaceKind::body) bodies.push_back(s);
  for (Index body : bodies)
    if (std::none_of(bodies.begin(), bodies.end(), [&](Index other) { return other != body && within(other, body); }))
      return body;
  return no_index;
}

/// Returns for each component the region named by the file (hint) whose boundary triangles bound it with the largest
/// area; no_index if there is none.
std::vector<Index> hinted(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup, const ModelPlc& plc,
                          const std::vector<RegionHint>& hints) {
  std::map<std::pair<Index, Index>, std::vector<std::pair<Index, bool>>> at_triangle;
  for (Index h = 0; h < hints.size(); ++h)
    for (const RegionHint::OrientedTriangle& side : hints[h].boundary)
      at_triangle[{side.surface, side.triangle}].push_back({h, side.as_stored});
  std::vector<std::map<Index, double>> votes(mesh.n_components);
  for (const auto& face : mesh.faces) {
    const double area =
        triangle_area(mesh.points[face.vertices[0]], mesh.points[face.vertices[1]], mesh.points[face.vertices[2]]);
    for (const PolygonSoup::Origin& o : origins_of(soup, plc, face.facet)) {
      const auto at = at_triangle.find({o.surface, o.triangle});
      if (at == at_triangle.end()) continue;
      for (const auto& [hint, as_stored] : at->second) {
        const bool outward_is_facet_normal = as_stored != o.reversed;
        const Index c = component_of(mesh, outward_is_facet_normal ? face.tetrahedron_below : face.tetrahedron_above);
        if (c != no_index) votes[c][hint] += area;
      }
    }
  }
  std::vector<Index> result(mesh.n_components, no_index);
  for (std::size_t c = 0; c < votes.size(); ++c) {
    double best = 0;
    for (const auto& [hint, area] : votes[c])
      if (area > best) {
        best = area;
        result[c] = hint;
      }
  }
  return result;
}

void warn_of_verdict(const UnitVerdict& verdict, const ComponentFacts& fact, const Column& column,
                     const std::vector<TriangulatedSurface>& surfaces, std::vector<std::string>& warnings) {
  const auto horizon = [&](Index h) { return surfaces[column.horizons[h]].name; };
  const std::string where = "the region of volume " + to_text(fact.volume) + " near " + to_text(fact.inside_point);
  switch (verdict.kind) {
    case UnitVerdict::Kind::unknown:
      warnings.push_back(where + " touches no horizon of the column: it is not named after a unit");
      break;
    case UnitVerdict::Kind::vertical:
      warnings.push_back(where + " touches no horizon of the column: it is named " + column.units[verdict.first] +
                         (verdict.by_heights ? ", by the horizons as they were deposited"
                                             : ", by the horizons next above and below it on the vertical"));
      break;
    case UnitVerdict::Kind::pocket:
      warnings.push_back(where + " is a thin void below " + horizon(verdict.first_possible - 1) + " and above " +
                         horizon(verdict.last_possible) + ", which cross; it is named " + column.units[verdict.first] +
                         ", as if the younger horizon cut the older one (rules.on_crossing, or base: erode or onlap of "
                         "a horizon, would cut one by the other)");
      break;
    case UnitVerdict::Kind::incomplete: {
      std::string missing;
      for (Index h = verdict.first_possible; h < verdict.last_possible; ++h)
        missing += (missing.empty() ? "" : ", ") + horizon(h);
      warnings.push_back(where + " could be " + column.units[verdict.first_possible] + " to " +
                         column.units[verdict.last_possible] + ": no face of " + missing + " divides it; it is named " +
                         column.units[verdict.first] +
                         (verdict.by_heights ? ", by the horizons as they were deposited" : ""));
      break;
    }
    case UnitVerdict::Kind::unit:
    case UnitVerdict::Kind::joined:
      break;
  }
}

void find_units_by_vertical(const std::vector<ComponentFacts>& facts, const PolygonSoup& soup,
                            const std::vector<TriangulatedSurface>& surfaces, const Column& column,
                            std::vector<UnitVerdict>& verdicts) {
  for (std::size_t c = 0; c < facts.size(); ++c) {
    if (verdicts[c].kind != UnitVerdict::Kind::unknown) continue;
    UnitVerdict verdict = find_unit(contacts_on_vertical(soup, surfaces, column, facts[c].inside_point), column);
    if (verdict.kind == UnitVerdict::Kind::unknown) continue;
    verdict.kind = UnitVerdict::Kind::vertical;
    verdicts[c] = verdict;
  }
}

/// Determines the unit of regions whose faces leave several units possible between an unconformity and a horizon below
/// it. Such a region is the unit deposited directly on that horizon, because the others were eroded.
void find_units_below_unconformities(const NamingRules& rules, const std::vector<TriangulatedSurface>& surfaces,
                                     const Column& column, std::vector<UnitVerdict>& verdicts) {
  for (UnitVerdict& verdict : verdicts) {
    if (verdict.kind != UnitVerdict::Kind::incomplete || verdict.first_possible == 0) continue;
    const std::string& above = surfaces[column.horizons[verdict.first_possible - 1]].name;
    const bool has_horizon_below = verdict.last_possible < column.horizons.size();
    if (has_horizon_below && std::ranges::find(rules.unconformities, above) != rules.unconformities.end())
      verdict.first = verdict.last = verdict.last_possible;
  }
}

std::vector<std::size_t> id_order(const std::vector<Label>& labels, const std::vector<ComponentFacts>& facts) {
  std::vector<std::size_t> order(labels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    const auto key = [](const Label& l) { return std::tie(l.order, l.rank, l.name); };
    if (key(labels[i]) != key(labels[j])) return key(labels[i]) < key(labels[j]);
    for (const auto member : {&ComponentFacts::min_point, &ComponentFacts::max_point, &ComponentFacts::centroid})
      if (const int c = compare_lexicographic(facts[i].*member, facts[j].*member); c != 0) return c < 0;
    return i < j;
  });
  return order;
}

/// Returns whether no two regions of a unit lie in the same fault block, so that only faults separate them. `block` is
/// the fault block of each component.
bool are_apart_by_faults(const std::vector<std::size_t>& members, const std::vector<std::size_t>& order,
                         const std::vector<Index>& block) {
  std::set<Index> blocks;
  return std::ranges::all_of(members, [&](std::size_t r) { return blocks.insert(block[order[r]]).second; });
}

/// Regions in their final order, with the data that determine their numbers and warnings.
struct NumberedRegions {
  const std::vector<std::size_t>& order;  ///< for each region, in their order: its component
  const std::vector<Label>& labels;
  const std::vector<ComponentFacts>& facts;
  const std::vector<Index>& block;  ///< by component
};

/// Gives every region its final name, with the suffix `__k` if several regions share a name. Warns if something other
/// than faults divides a unit.
void add_suffixes(const NumberedRegions& numbered, std::vector<Region>& regions, std::vector<std::string>& warnings) {
  const auto& [order, labels, facts, block] = numbered;
  std::map<std::string, std::vector<std::size_t>> rows;  // by name: indices of the regions that have it
  std::set<std::string> taken;
  for (std::size_t r = 0; r < order.size(); ++r) rows[labels[order[r]].name].push_back(r);
  for (const auto& [name, members] : rows)
    if (members.size() == 1) taken.insert(name);
  for (const auto& [name, members] : rows) {
    std::string list;
    std::size_t number = 0;
    for (std::size_t r : members) {
      regions[r].name = name;
      if (members.size() == 1) continue;
      do regions[r].name = name + "__" + std::to_string(++number);
      while (!taken.insert(regions[r].name).second);
      if (number <= 8)
        list += (list.empty() ? "" : ", ") + regions[r].name + " (volume " + to_text(regions[r].volume) + " near " +
                to_text(facts[order[r]].inside_point) + ")";
    }
    const bool is_unit = labels[order[members.front()]].order == column_class;
    if (members.size() > 1 && !(is_unit && are_apart_by_faults(members, order, block)))
      warnings.push_back(name + " falls into " + std::to_string(members.size()) + " regions: " + list +
                         (members.size() > 8 ? ", ..." : "") +
                         (members.size() > most_of_one_name ? what_would_help : ""));
  }
}

/// Data about all components of the mesh before they have names: measurements, bodies around each component, and its
/// unit.
struct KnownComponents {
  const std::vector<ComponentFacts>& facts;
  const std::vector<std::vector<Index>>& around;
  const std::vector<UnitVerdict>& verdicts;
};

/// Returns the labels of all components by the naming rules; warns where the column does not determine the unit.
std::vector<Label> make_labels(const MeshedModel& model, const KnownComponents& known, const NamingRules& rules,
                               const Column& column, std::vector<std::string>& warnings) {
  const ConstrainedTetrahedralization& mesh = model.mesh;
  const std::vector<TriangulatedSurface>& surfaces = model.surfaces;
  const std::vector<ComponentFacts>& facts = known.facts;
  const std::vector<Index> points = seeded(mesh, rules.seeds, warnings);
  const std::vector<Index> hints = hinted(mesh, model.soup, model.plc, rules.hints);
  std::vector<Label> labels(facts.size());
  for (std::size_t c = 0; c < facts.size(); ++c) {
    Label& label = labels[c];
    const Index seed = c < mesh.component_seed.size() ? mesh.component_seed[c] : no_index;
    if (points[c] != no_index) {
      label = {seed_class, points[c], rules.seeds[points[c]].name};
    } else if (seed < rules.seed_names.size()) {
      label = {seed_class, seed, rules.seed_names[seed]};
    } else if (const Index body = innermost_body(c, known.around, surfaces); rules.name_by_bodies && body != no_index) {
      label = {body_class, body, surfaces[body].name};
    } else if (hints[c] != no_index) {
      label = {hint_class, hints[c], rules.hints[hints[c]].name};
    } else if (!facts[c].enclosed) {
      label = {hull_class, 0, "hull"};
    } else if (column.given()) {
      const UnitVerdict& verdict = known.verdicts[c];
      warn_of_verdict(verdict, facts[c], column, surfaces, warnings);
      if (verdict.first != no_index)
        label = {column_class, 2 * verdict.first + (verdict.last > verdict.first), unit_name(verdict, column)};
    }
  }
  std::vector<std::size_t> unnamed;
  for (std::size_t c = 0; c < labels.size(); ++c)
    if (labels[c].name.empty()) unnamed.push_back(c);
  std::sort(unnamed.begin(), unnamed.end(), [&](std::size_t i, std::size_t j) {
    return std::tie(facts[i].first_triangle, i) < std::tie(facts[j].first_triangle, j);
  });
  for (std::size_t k = 0; k < unnamed.size(); ++k)
    labels[unnamed[k]] = {unnamed_class, static_cast<Index>(k), "region_" + std::to_string(k + 1)};
  return labels;
}

/// Adds block numbers such as `Unit__B2` to units of the column, if faults form more than one block.
void add_blocks(const std::vector<Index>& block, std::vector<Label>& labels) {
  std::map<Index, Index> number;  // numbers of the fault blocks that contain a unit, in the order of their position
  for (std::size_t c = 0; c < labels.size(); ++c)
    if (labels[c].order == column_class) number[block[c]] = 0;
  if (number.size() < 2) return;
  Index n = 0;
  for (auto& [key, value] : number) value = ++n;
  for (std::size_t c = 0; c < labels.size(); ++c)
    if (labels[c].order == column_class) labels[c].name += "__B" + std::to_string(number[block[c]]);
}

/// Returns for each component the component into whose region it is merged, which is itself for most. Regions smaller
/// than min_volume are merged or reported.
std::vector<Index> small_regions(const ConstrainedTetrahedralization& mesh, const std::vector<ComponentFacts>& facts,
                                 const NamingRules& rules, const std::vector<Label>& labels,
                                 std::vector<std::string>& warnings) {
  std::vector<Index> target(facts.size());
  std::iota(target.begin(), target.end(), Index{0});
  if (!(rules.min_volume > 0)) return target;
  if (rules.merge_small) target = merge_targets(mesh, facts, rules.min_volume);
  if (rules.join_pieces) {  // units of the column are merged into others, but bodies are kept
    for (std::size_t c = 0; c < facts.size(); ++c)
      if (labels[c].order != column_class) target[c] = static_cast<Index>(c);
  }
  for (std::size_t c = 0; c < facts.size(); ++c) {
    if (facts[c].volume >= rules.min_volume || (rules.join_pieces && rules.merge_small && target[c] == c)) continue;
    const std::string what = "region of " + labels[c].name + " near " + to_text(facts[c].inside_point) +
                             " has a volume of " + to_text(facts[c].volume) + ", less than min_volume";
    warnings.push_back(target[c] == c ? what : what + ": it joins " + labels[target[c]].name);
  }
  return target;
}

/// Returns for each component the name of its unit and fault block; an empty name if it is no unit of the column.
std::vector<std::string> unit_labels(const std::vector<Label>& labels) {
  std::vector<std::string> names;
  for (const Label& label : labels) names.push_back(label.order == column_class ? label.name : "");
  return names;
}

}  // namespace

NamedRegions name_regions(const MeshedModel& model, const NamingRules& rules, const Column& column,
                          std::vector<std::string>& warnings) {
  const ConstrainedTetrahedralization& mesh = model.mesh;
  const PolygonSoup& soup = model.soup;
  const ModelPlc& plc = model.plc;
  const std::vector<TriangulatedSurface>& surfaces = model.surfaces;
  const std::vector<ComponentFacts> facts = component_facts(mesh, soup, plc, rules.hull_surface);
  const std::vector<std::vector<Index>> around = bodies_around(facts, surfaces, warnings);
  NamedRegions named;
  for (const HorizonContacts& contacts : horizon_contacts(mesh, soup, plc, column))
    named.verdicts.push_back(find_unit(contacts, column));
  if (column.given()) find_units_by_vertical(facts, soup, surfaces, column, named.verdicts);
  if (column.given()) find_units_below_unconformities(rules, surfaces, column, named.verdicts);
  if (column.given()) find_units_by_heights(mesh, rules, column, named.verdicts);
  std::vector<Label> labels = make_labels(model, {facts, around, named.verdicts}, rules, column, warnings);
  std::vector<std::string> units;
  for (const Label& label : labels) units.push_back(label.name);
  const std::vector<Index> block = fault_blocks(mesh, soup, plc, facts, column);
  if (rules.fault_blocks) add_blocks(block, labels);
  std::vector<Index> joined(facts.size());
  std::iota(joined.begin(), joined.end(), Index{0});
  if (rules.join_pieces) joined = join_targets(facts, unit_labels(labels));
  std::vector<Index> target = small_regions(mesh, joined_facts(facts, joined), rules, labels, warnings);
  for (Index& t : target) t = joined[t];

  std::vector<std::size_t> order = id_order(labels, facts);
  std::erase_if(order, [&](std::size_t c) { return target[c] != c; });
  named.id_of_component.resize(facts.size());
  for (std::size_t r = 0; r < order.size(); ++r) {
    const std::size_t c = order[r];
    named.id_of_component[c] = static_cast<std::int32_t>(r + 1);
    Region region{static_cast<std::int32_t>(r + 1), "", {}, 0, 0, units[c]};
    for (Index s : around[c]) region.inside.push_back(surfaces[s].name);
    named.regions.push_back(std::move(region));
  }
  std::vector<CompensatedSum> volumes(order.size());
  for (std::size_t c = 0; c < facts.size(); ++c) {
    named.id_of_component[c] = named.id_of_component[target[c]];
    const auto row = static_cast<std::size_t>(named.id_of_component[c] - 1);
    named.regions[row].n_tetrahedra += facts[c].n_tetrahedra;
    volumes[row].add(facts[c].volume);
  }
  for (std::size_t r = 0; r < order.size(); ++r) named.regions[r].volume = volumes[r].value();
  add_suffixes({order, labels, facts, block}, named.regions, warnings);
  return named;
}

}  // namespace geomesh::geomodel
