// SPDX-License-Identifier: GPL-3.0-or-later
// Detects inputs that do not lie near the model, declared in plausibility/doubts.hpp.
#include <algorithm>
#include <cmath>
#include <functional>

#include "geomesh/geomodel/words.hpp"
#include "plausibility/doubts.hpp"

namespace geomesh::geomodel {
namespace {

bool overlap(double a0, double a1, double b0, double b1) {
  return std::min(a0, a1) <= std::max(b0, b1) && std::min(b0, b1) <= std::max(a0, a1);
}
bool over_each_other(const Box3& a, const Box3& b) {
  return overlap(a.min.x, a.max.x, b.min.x, b.max.x) && overlap(a.min.y, a.max.y, b.min.y, b.max.y);
}
bool meet(const Box3& a, const Box3& b) { return over_each_other(a, b) && overlap(a.min.z, a.max.z, b.min.z, b.max.z); }

Box3 shifted(const Box3& box, const Vec3& by) { return {box.min + by, box.max + by}; }
Box3 mapped(const Box3& box, const std::function<Vec3(const Vec3&)>& map) {
  Box3 out;
  out.add(map(box.min));
  out.add(map(box.max));
  return out;
}

struct Factor {
  double factor;
  const char* words;  ///< names of the unit that coordinates may have, and of the one in which they were understood
};
constexpr Factor factors[] = {{foot, "feet where metres were understood"},
                              {1 / foot, "metres where feet were understood"},
                              {1000, "kilometres where metres were understood"},
                              {0.001, "metres where kilometres were understood"}};

/// A possible cause for the wrong position of an input, with the remedy. The causes are tested in coordinates that
/// include the project's origin.
struct Guess {
  std::string cause, text, remedy;
};

bool looks_like_degrees(const Box3& b) { return b.min.x >= -180 && b.max.x <= 360 && b.min.y >= -90 && b.max.y <= 90; }

std::optional<Guess> guess_in_map(const Box3& b, const Box3& model) {
  if (over_each_other(mapped(b, [](const Vec3& p) { return Vec3{p.y, p.x, p.z}; }), model))
    return Guess{
        "exchanged axes",
        "with x and y exchanged it would lie over the model: are easting and northing in each "
        "other's place?",
        "if so, name the columns of a table in its entry (columns: {x: 2, y: 1, z: 3}), or export the file again"};
  if (looks_like_degrees(b) && !looks_like_degrees(model))
    return Guess{
        "degrees", "its coordinates look like longitude and latitude, those of the model do not",
        "if so, name the project's system (crs: {horizontal: utm 32N} or another) and give 'crs: geographic' in "
        "its entry"};
  for (const Factor& f : factors)
    if (over_each_other(mapped(b, [&](const Vec3& p) { return Vec3{f.factor * p.x, f.factor * p.y, p.z}; }), model))
      return Guess{"unit", std::string("it would lie over the box if its coordinates were in ") + f.words,
                   "if so, give 'unit' in its entry"};
  // Data from the UTM system often have the zone's number in front of the easting, as in 32432500.
  const double zone = std::round((0.5 * (b.min.x + b.max.x) - 0.5 * (model.min.x + model.max.x)) / 1e6);
  if (zone != 0 && std::abs(zone) <= 60 &&
      over_each_other(mapped(b,
                             [&](const Vec3& p) {
                               return Vec3{p.x - 1e6 * zone, p.y, p.z};
                             }),
                      model))
    return Guess{"zone in front",
                 "it would lie over the model without " + short_words(zone) +
                     " million in front of its eastings: is that the number of the zone?",
                 "if so, take it out of the file"};
  return std::nullopt;
}

std::optional<Guess> guess_in_height(const Box3& b, const Box3& model) {
  const auto inside = [&](double factor) {
    return overlap(factor * b.min.z, factor * b.max.z, model.min.z, model.max.z);
  };
  if (inside(-1))
    return Guess{
        "direction of z",
        "it would lie inside the box if its z were counted the other way: are these depths, counted downwards?",
        "if so, give 'z: depth' or 'z: elevation' in its entry, or crs: {z: depth} for all of the project"};
  for (const Factor& f : factors)
    for (const double sign : {1.0, -1.0})
      if (inside(sign * f.factor))
        return Guess{"unit of z",
                     std::string("it would lie inside the box if its z were in ") + f.words +
                         (sign < 0 ? " and counted the other way" : ""),
                     "if so, give 'z_unit' (or 'unit', where x and y are in it too) and 'z' in its entry"};
  return std::nullopt;
}

struct Placed {
  std::string name;
  Box3 bounds;
  bool is_surface = true;
  Extend extend = Extend::none;
};

struct Outside {
  Guess guess;
  std::vector<std::string> names;
  Box3 bounds;
  bool of_map = false;  ///< whether the input lies outside the box in the map, rather than above or below it
};

std::string range(double from, double to) { return short_words(from) + " to " + short_words(to); }
std::string map_range(const Box3& b) {
  char text[160];
  std::snprintf(text, sizeof text, "x %.9g to %.9g, y %.9g to %.9g", b.min.x, b.max.x, b.min.y, b.max.y);
  return text;
}

std::vector<Placed> placed_inputs(const Inspected& model) {
  std::vector<Placed> placed;
  const auto add = [&](const std::string& name, const std::vector<Vec3>& points, bool is_surface, Extend extend) {
    Placed one{name, {}, is_surface, extend};
    for (const Vec3& p : points) one.bounds.add(p);
    if (!one.bounds.empty()) one.bounds = shifted(one.bounds, model.project.output.origin);
    placed.push_back(std::move(one));
  };
  for (std::size_t s = 0; s < model.inputs.surfaces.size(); ++s)
    add(model.inputs.surfaces[s].name, model.inputs.surfaces[s].points, true, model.project.rules.of(s).extend);
  for (const Polyline& well : model.inputs.wells) add(well.name, well.points, false, Extend::none);
  return placed;
}

/// Returns whether a surface that is continued to the box is near enough to reach it.
bool may_come_in(const Placed& input, const Box3& box) {
  if (input.extend == Extend::none) return false;
  const Box3& b = input.bounds;
  for (std::size_t k = 0; k < 2; ++k) {
    const double reach = (box.max[k] - box.min[k]) + (b.max[k] - b.min[k]);
    if (b.min[k] > box.max[k] + reach || b.max[k] < box.min[k] - reach) return false;
  }
  return input.extend == Extend::tangent || overlap(b.min.z, b.max.z, box.min.z, box.max.z);
}

/// Returns which share of the interval of heights between a and b is between the bottom and the top of the box.
double share_within(double a, double b, const Box3& box) {
  const double low = std::max(std::min(a, b), box.min.z), high = std::min(std::max(a, b), box.max.z);
  return a == b ? (low <= high ? 1 : 0) : std::max(0.0, high - low) / std::abs(b - a);
}

/// Returns whether a well seems to have depths instead of elevations. Wells begin near the top of the box, so such a
/// well touches the box: most of its path lies above it, and would lie inside with the opposite direction of z.
bool is_well_upside_down(const Placed& input, const Box3& box) {
  constexpr double few = 0.1, most = 0.5;
  const Box3& b = input.bounds;
  return !input.is_surface && over_each_other(b, box) && share_within(b.min.z, b.max.z, box) < few &&
         share_within(-b.max.z, -b.min.z, box) > most;
}

void add_outside(const Placed& input, const Box3& model, std::vector<Outside>& groups) {
  const bool in_map = over_each_other(input.bounds, model);
  const auto guess = in_map ? guess_in_height(input.bounds, model) : guess_in_map(input.bounds, model);
  const Guess made = guess.value_or(
      in_map ? Guess{"height", "in the map it lies over the box, but not in height",
                     "are both in the same unit and counted from the same zero (unit, z, z_datum in its entry)?"}
             : Guess{"place", "its coordinates are elsewhere",
                     "are they in the same system and unit as those of the "
                     "box (crs, unit in its entry)?"});
  auto group = std::find_if(groups.begin(), groups.end(), [&](const Outside& o) { return o.guess.text == made.text; });
  if (group == groups.end()) group = groups.insert(group, {made, {}, {}, !in_map});
  group->names.push_back(input.name);
  group->bounds.add(input.bounds.min);
  group->bounds.add(input.bounds.max);
}

/// Returns whether the box is a thousandth of the surfaces in size, and would contain them with limits in kilometres.
bool is_box_in_kilometres(const std::vector<Placed>& inputs, const Box3& box) {
  Box3 all;
  bool any = false, every = true;
  for (const Placed& input : inputs) {
    if (!input.is_surface || input.bounds.empty()) continue;
    any = true;
    every = every && meet(mapped(input.bounds, [](const Vec3& p) { return 0.001 * p; }), box);
    all.add(input.bounds.min);
    all.add(input.bounds.max);
  }
  constexpr double least = 50;  // the extent of all surfaces must exceed that of the box by this factor, in x and in y
  return any && every && all.max.x - all.min.x > least * (box.max.x - box.min.x) &&
         all.max.y - all.min.y > least * (box.max.y - box.min.y);
}

Finding finding_of(const Outside& group, const Box3& box, const std::string& unit) {
  Finding finding;
  finding.cause = group.guess.cause;
  finding.inputs = group.names;
  finding.text = few_of(group.names) + (group.names.size() > 1 ? " lie" : " lies") + " outside the box (" +
                 (group.of_map ? map_range(group.bounds) + "; the box " + map_range(box)
                               : "z " + range(group.bounds.min.z, group.bounds.max.z) + ", that of the box " +
                                     range(box.min.z, box.max.z)) +
                 ", " + unit + "); " + group.guess.text;
  finding.remedy = group.guess.remedy;
  return finding;
}

/// Returns a text if all horizons of the stratigraphic column, or all surfaces, lie outside the model; else empty.
std::string nothing_left(const Inspected& model, const std::vector<std::string>& outside) {
  const auto is_outside = [&](const std::string& name) {
    return std::find(outside.begin(), outside.end(), name) != outside.end();
  };
  const auto& surfaces = model.inputs.surfaces;
  if (std::all_of(surfaces.begin(), surfaces.end(), [&](const auto& s) { return is_outside(s.name); }))
    return "no surface of the project lies in the box: ";
  bool all = model.project.column.size() > 1;
  for (std::size_t i = 1; i < model.project.column.size(); i += 2) all = all && is_outside(model.project.column[i]);
  return all ? "no horizon of the column lies in the box: " : "";
}

void doubt_places_in(const Inspected& model, const std::vector<Placed>& inputs, const Box3& box,
                     std::vector<Finding>& findings) {
  const std::string& unit = model.project.crs.unit;
  if (is_box_in_kilometres(inputs, box)) {
    std::vector<std::string> names;
    for (const Placed& input : inputs) names.push_back(input.name);
    findings.push_back({Finding::Sureness::certain, "unit of the box", names,
                        "the box is a thousandth of what the surfaces cover (" + map_range(box) + ", " + unit +
                            "), and would hold all of them if it were in kilometres",
                        "lengths of the project file are in " + unit + ": multiply those of the box by 1000"});
    return;
  }
  std::vector<Outside> groups;
  std::vector<std::string> outside;
  for (const Placed& input : inputs) {
    const bool is_inside = meet(input.bounds, box) && !is_well_upside_down(input, box);
    if (input.bounds.empty() || is_inside || may_come_in(input, box)) continue;
    if (input.is_surface) outside.push_back(input.name);
    add_outside(input, box, groups);
  }
  if (groups.empty()) return;
  const std::string nonsense = outside.empty() ? "" : nothing_left(model, outside);
  for (const Outside& group : groups) {
    findings.push_back(finding_of(group, box, unit));
    const bool has_surface = std::any_of(group.names.begin(), group.names.end(), [&](const std::string& name) {
      return std::find(outside.begin(), outside.end(), name) != outside.end();
    });
    if (nonsense.empty() || !has_surface) continue;
    findings.back().sureness = Finding::Sureness::certain;
    findings.back().text = nonsense + findings.back().text;
  }
}

/// Finds a surface or well beside all other surfaces in the map, if the box is placed around the data and a change of
/// coordinates or unit would move it to the others.
void doubt_places_about(const std::vector<Placed>& inputs, std::vector<Finding>& findings, const std::string& unit) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    Box3 others;
    for (std::size_t k = 0; k < inputs.size(); ++k)
      if (k != i && inputs[k].is_surface && !inputs[k].bounds.empty()) {
        others.add(inputs[k].bounds.min);
        others.add(inputs[k].bounds.max);
      }
    const Box3& b = inputs[i].bounds;
    if (others.empty() || b.empty() || over_each_other(b, others)) continue;
    const auto guess = guess_in_map(b, others);
    if (!guess) continue;
    Finding finding{Finding::Sureness::probable,
                    guess->cause,
                    {inputs[i].name},
                    inputs[i].name + " lies beside all other surfaces (" + map_range(b) + "; the others " +
                        map_range(others) + ", " + unit + "); " + guess->text,
                    guess->remedy};
    findings.push_back(std::move(finding));
    if (inputs.size() == 2) return;  // with only two inputs, either may be misplaced, so the second is not reported too
  }
}

}  // namespace

void doubt_places(const Inspected& model, std::vector<Finding>& findings) {
  if (!model.project.box) return;
  const std::vector<Placed> inputs = placed_inputs(model);
  if (model.project.box->shape == VolumeSpec::Shape::margin) {
    doubt_places_about(inputs, findings, model.project.crs.unit);
  } else if (model.volume) {
    doubt_places_in(model, inputs, shifted(*model.volume, model.project.output.origin), findings);
  }
}

}  // namespace geomesh::geomodel
