// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the keys gridding, resample and smooth of an entry of `surfaces`, declared in project/read_reading.hpp, and the
// keys of fields, declared in project/read_gridding.hpp.
#include "project/read_gridding.hpp"

#include <algorithm>
#include <cmath>

#include "geomesh/geomodel/words.hpp"
#include "project/read_reading.hpp"

namespace geomesh::geomodel {
namespace {

void read_length(const YamlValue& value, double& length) {
  const auto number = value.number();
  if (!number) return;
  if (*number <= 0) return value.problem("a length greater than zero was expected");
  length = *number;
}

void read_method(const YamlValue& value, SurfaceSpec& spec) {
  const YamlMap map(value, {"method", "spacing", "smoothing", "max_distance", "extent"});
  if (!map.is_map()) return;
  if (const auto v = map.find("method")) {
    if (v->choice({"thin_plate", "triangulate"}) == "triangulate")
      spec.gridding.method = GriddingSpec::Method::triangulate;
  }
  if (const auto v = map.find("spacing")) read_length(*v, spec.gridding.spacing);
  if (const auto v = map.find("smoothing")) read_length(*v, spec.gridding.smoothing);
  if (const auto v = map.find("max_distance")) read_length(*v, spec.gridding.max_distance);
  if (const auto v = map.find("extent")) {
    spec.gridding.to_box = v->choice({"data", "box"}) == "box";
    if (spec.gridding.to_box && !spec.may_be(SurfaceKind::horizon))
      v->problem("only a horizon is gridded over the box; a fault is continued by 'extent: to_box' of the surface");
  }
  if (spec.gridding.method == GriddingSpec::Method::triangulate) {
    for (const char* key : {"spacing", "smoothing", "extent"})
      if (const auto v = map.find(key)) v->problem("has no meaning where points are triangulated as they are");
  }
}

/// Reads the grid spacing of a field: one length for all axes, or one for each.
std::optional<Vec3> read_spacing(const YamlValue& value) {
  std::optional<Vec3> spacing;
  if (value.is_list()) {
    spacing = value.point();
  } else if (const auto length = value.number()) {
    spacing = Vec3{*length, *length, *length};
  }
  if (spacing && !(spacing->x > 0 && spacing->y > 0 && spacing->z > 0))
    value.problem("lengths above zero were expected");
  return spacing;
}

std::vector<std::string> one_name_or_several(const YamlValue& value) {
  std::vector<std::string> names;
  if (!value.is_list()) {
    if (const auto name = value.text()) names.push_back(*name);
    return names;
  }
  for (const YamlValue& item : value.items())
    if (const auto name = item.text()) names.push_back(*name);
  if (names.empty()) value.problem("the list of surfaces is empty");
  return names;
}

FieldDomain read_domain(const YamlValue& value) {
  FieldDomain domain;
  const YamlMap map(value, {"above", "below", "block"});
  if (!map.is_map()) return domain;
  if (const auto v = map.find("above")) domain.above = one_name_or_several(*v);
  if (const auto v = map.find("below")) domain.below = one_name_or_several(*v);
  if (const auto v = map.find("block")) domain.block = v->point();
  if (!map.find("above") && !map.find("below") && !map.find("block"))
    value.problem("above or below (surfaces), or block (a place in a fault block), was expected");
  return domain;
}

void refuse_keys_of_files(const YamlMap& map) {
  for (const char* key : {"file", "object", "gridding", "resample", "smooth", "fault_polygons"})
    if (const auto v = map.find(key))
      v->problem("does not go with a field, whose surface follows from 'value' and the tolerance; leave it out");
  for (const char* key : {"crs", "unit", "z_unit", "z", "z_datum"})
    if (const auto v = map.find(key))
      v->problem("does not go with a field, which is in the coordinates of the project; leave it out");
}

}  // namespace

void read_gridding(const YamlMap& map, SurfaceSpec& spec) {
  if (const auto v = map.find("gridding")) read_method(*v, spec);
  if (const auto v = map.find("resample")) read_length(*v, spec.resample);
  if (const auto v = map.find("smooth")) {
    const auto n = v->number();
    if (!n) return;
    if (*n < 0 || *n > 1000 || *n != std::floor(*n))
      return v->problem("a whole number of passes from 0 to 1000 was expected");
    spec.smooth = static_cast<int>(*n);
  }
}

const std::vector<std::string_view>& level_set_keys() {
  static const std::vector<std::string_view> keys{"field", "value", "array", "origin", "spacing", "domain"};
  return keys;
}

void read_level_set(const YamlMap& map, const std::shared_ptr<FieldFunction>& function, SurfaceSpec& spec) {
  refuse_keys_of_files(map);
  LevelSetSpec& level_set = spec.level_sets.emplace_back();
  level_set.function = function;
  if (const auto v = map.require("value", "the value that the field has on the surface"))
    level_set.value = v->number().value_or(0);
  if (const auto v = map.find("array")) level_set.array = v->text().value_or("");
  if (const auto v = map.find("origin")) level_set.origin = v->point();
  if (const auto v = map.find("spacing")) level_set.spacing = read_spacing(*v);
  if (const auto v = map.find("domain")) level_set.domain = read_domain(*v);
  const auto field = map.find("field");
  if (function && field) field->problem("a function was given for '" + spec.name + "' already; leave out one of them");
  const bool is_npy = field && field->scalar().ends_with(".npy");
  if (is_npy && !(level_set.origin && level_set.spacing))
    field->problem("an array of NumPy says nothing of its place; give 'origin' [x, y, z] and 'spacing'");
  for (const char* key : {"origin", "spacing"})
    if (const auto v = map.find(key); v && !is_npy) v->problem("is allowed with a field in a .npy file alone");
}

void refuse_keys_of_first_entry(const YamlMap& map, const SurfaceSpec& first) {
  std::vector<std::string_view> own = level_set_keys();
  own.insert(own.end(), {"name", "kind"});
  for (const auto& [key, value] : named_entries(map.value(), "KEY: VALUE"))
    if (std::find(own.begin(), own.end(), key) == own.end())
      value.problem("belongs to the first entry of '" + first.name + "'; further entries give a field and its domain");
}

namespace {

/// Reads the domains in which the fields of one surface are valid.
class DomainReader {
 public:
  DomainReader(const YamlValue& root, Project& project, SurfaceSpec& spec)
      : root_(root), project_(project), spec_(spec) {}

  void read() {
    if (spec_.kind == SurfaceKind::body) return problem("a body is closed, and a domain would open it; leave it out");
    if (spec_.kind == SurfaceKind::fault && spec_.level_sets.size() > 1)
      return problem("several fields, one for each side of a fault, go with a horizon alone");
    for (const LevelSetSpec& level_set : spec_.level_sets) read_part(level_set.domain);
    for (std::size_t a = 0; a < spec_.level_sets.size(); ++a)
      for (std::size_t b = a + 1; b < spec_.level_sets.size(); ++b)
        if (overlap(spec_.rules.field_parts[a], spec_.rules.field_parts[b]))
          problem(
              "the domains of its entries overlap; let one be above and the other below the same fault, or give "
              "each a block");
    if (!spec_.rules.has_fault_domain()) return;
    if (spec_.rules.has_throw())
      problem("throw_at and fault_polygons do not go with a domain at faults, which says where its parts end");
    for (const FieldPart& part : spec_.rules.field_parts) {
      for (const auto& [fault, is_above] : part.sides) add_fault(fault);
      if (part.block) add_all_faults();
    }
  }

 private:
  void problem(const std::string& text) const { root_.problem("surface '" + spec_.name + "': " + text); }

  static bool overlap(const FieldPart& a, const FieldPart& b) {
    if (a.block && b.block) return false;  // only later it is known which points lie in one fault block
    for (const auto& [fault, is_above] : a.sides)
      for (const auto& [other, is_other_above] : b.sides)
        if (fault == other && is_above != is_other_above) return false;
    return true;
  }

  const SurfaceSpec* find(const std::string& name) const {
    std::vector<std::string_view> known;
    for (const SurfaceSpec& other : project_.surfaces) {
      if (&other == &spec_ || other.kind == SurfaceKind::body) continue;
      if (other.name == name) return &other;
      known.push_back(other.name);
    }
    const std::string meant = was_meant(name, known);
    problem("its domain names '" + name + "', which is no other horizon or fault" +
            (meant.empty() ? "; these are " + (known.empty() ? "none" : listed(known)) : meant));
    return nullptr;
  }

  void read_part(const FieldDomain& domain) {
    FieldPart part;
    part.block = domain.block;
    std::vector<std::string> above, below;
    for (const bool is_above : {true, false})
      for (const std::string& name : is_above ? domain.above : domain.below) {
        const SurfaceSpec* const other = find(name);
        if (!other) continue;
        if (spec_.kind == SurfaceKind::horizon && other->kind == SurfaceKind::fault)
          part.sides.emplace_back(name, is_above);
        else
          (is_above ? above : below).push_back(name);
        if (is_above && std::find(domain.below.begin(), domain.below.end(), name) != domain.below.end())
          problem("its domain is both above and below '" + name + "'");
        check_column(name, is_above);
      }
    if (part.block && spec_.kind != SurfaceKind::horizon) problem("only the field of a horizon holds in a block");
    if (part.block && project_.crs.z_scale != 1) problem("a domain in a block does not go with crs.z_scale");
    if (spec_.rules.field_parts.empty()) {
      spec_.rules.holds_above = above;
      spec_.rules.holds_below = below;
    } else if (above != spec_.rules.holds_above || below != spec_.rules.holds_below) {
      problem("all of its entries must be above and below the same horizons");
    }
    spec_.rules.field_parts.push_back(std::move(part));
  }

  /// Reports a horizon that is declared to lie above a younger one or below an older one.
  void check_column(const std::string& name, bool is_above) const {
    const auto& column = project_.column;
    const auto own = std::find(column.begin(), column.end(), spec_.name);
    const auto other = std::find(column.begin(), column.end(), name);
    if (own == column.end() || other == column.end() || (own < other) == is_above) return;
    problem("its domain is " + std::string(is_above ? "above" : "below") + " '" + name + "', which the column puts " +
            (is_above ? "above it" : "below it"));
  }

  void add_fault(const std::string& name) {
    std::vector<std::string>& faults = spec_.rules.throw_at;
    if (std::find(faults.begin(), faults.end(), name) == faults.end()) faults.push_back(name);
  }
  void add_all_faults() {
    for (const SurfaceSpec& other : project_.surfaces)
      if (other.kind == SurfaceKind::fault && !(other.given && other.file_as_written == "fractures"))
        add_fault(other.name);
  }

  const YamlValue& root_;
  Project& project_;
  SurfaceSpec& spec_;
};

}  // namespace

void finish_domains(const YamlValue& root, Project& project) {
  for (SurfaceSpec& spec : project.surfaces) {
    const bool has_domain =
        std::any_of(spec.level_sets.begin(), spec.level_sets.end(),
                    [](const LevelSetSpec& level_set) { return !level_set.domain.is_everywhere(); });
    if (has_domain) DomainReader(root, project, spec).read();
    spec.rules.field_parts.resize(spec.level_sets.size());
  }
}

}  // namespace geomesh::geomodel
