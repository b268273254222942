// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the project file: every key of docs/project-file.md, reporting all mistakes in one run.
#include <algorithm>
#include <cctype>
#include <map>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/given.hpp"
#include "geomesh/geomodel/project.hpp"
#include "project/read_coordinates.hpp"
#include "project/read_gridding.hpp"
#include "project/read_mesh_settings.hpp"
#include "project/read_output.hpp"
#include "project/read_reading.hpp"
#include "project/read_rules.hpp"
#include "project/read_volume.hpp"
#include "project/yaml_values.hpp"
#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns advice on the most frequent cause of a YAML syntax error near the given line (counted from 0).
std::string yaml_advice(const std::string& text, int line) {
  std::size_t begin = 0;
  std::string near;
  for (int i = 0; i <= line && begin <= text.size(); ++i) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (i >= line - 1) near += text.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  if (near.find('\t') != std::string::npos) return "; there is a tab near it: YAML is indented with blanks alone";
  if (near.find('\\') != std::string::npos && near.find('"') != std::string::npos)
    return "; a backslash between double quotes begins an escape: write paths with / or without the quotes";
  static const std::string colon_letter = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ[{";
  for (std::size_t at = near.find(':'); at != std::string::npos; at = near.find(':', at + 1))
    if (at + 1 < near.size() && colon_letter.find(near[at + 1]) != std::string::npos)
      return "; is there a blank after the colon?";
  return "; keys of one entry begin in the same column, and brackets and quotes are closed";
}

/// Replaces `NAME:LINE:COLUMN: ` at the beginning of each line of messages by `NAME: `. This is for texts that a
/// program composed, whose line numbers mean nothing to the user.
std::string without_places(const std::string& messages, const std::string& name) {
  std::string result;
  const auto is_of_place = [](char c) { return c == ':' || std::isdigit(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t begin = 0; begin < messages.size();) {
    const std::size_t end = std::min(messages.find('\n', begin), messages.size() - 1) + 1;
    const std::string_view line = std::string_view(messages).substr(begin, end - begin);
    std::size_t at = line.starts_with(name + ":") ? name.size() : 0;
    result += line.substr(0, at);
    if (at > 0) {
      while (at < line.size() && is_of_place(line[at])) ++at;
      result += ":";
    }
    result += line.substr(at);
    begin = end;
  }
  return result;
}

const std::vector<std::string_view> box_sides{"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};

class ProjectReader {
 public:
  explicit ProjectReader(const std::filesystem::path& file) : problems_(file.string()) {
    project_.file = std::filesystem::absolute(file);
    folder_ = project_.file.parent_path();
    project_.output.directory = folder_ / "out";
    const std::string stem = file.stem().string();
    project_.name = stem == "project" ? folder_.filename().string() : stem;
  }
  explicit ProjectReader(const GivenProject& given)
      : problems_(given.name), given_(&given.inputs), given_fields_(&given.fields) {
    folder_ = std::filesystem::absolute(given.folder.empty() ? "." : given.folder).lexically_normal();
    project_.file = folder_ / given.name;
    project_.output.directory = folder_ / "out";
    project_.name = given.name;
  }

  Project read(const std::string& text) {
    if (const auto root = parse(text)) read_root(*root);
    problems_.throw_if_any();
    return std::move(project_);
  }

 private:
  std::optional<YamlValue> parse(const std::string& text) {
    try {
      const auto [document, has_more] = read_yaml_documents(text);
      if (has_more) problems_.add({}, "the file holds several YAML documents (---); one was expected");
      if (document.IsNull()) {
        problems_.add({1, 1}, "the project is empty; surfaces or a box were expected");
        return std::nullopt;
      }
      if (document.IsScalar() && text.find(": ") == std::string::npos)
        problems_.add({1, 1}, "keys and values were expected (KEY: VALUE); is there a blank after the colon?");
      return YamlValue(problems_, document, "project", {1, 1});
    } catch (const YAML::Exception& e) {
      problems_.add({e.mark.line + 1, e.mark.column + 1}, "not valid YAML: " + e.msg + yaml_advice(text, e.mark.line));
      return std::nullopt;
    }
  }

  void read_root(const YamlValue& root) {
    const YamlMap map(
        root, {"name", "crs", "box", "surfaces", "wells", "tops", "points", "fractures", "column", "rules", "regions",
               "groups", "attributes", "colours", "merge_within", "tolerance", "mesh", "output"});
    if (!map.is_map()) return;
    if (const auto v = map.find("name")) read_name(*v, project_.name);
    if (const auto v = map.find("crs")) read_crs(*v, project_.crs);
    // If the entry `box` has errors, they are reported when it is read, and an empty box takes its place.
    if (const auto v = map.find("box")) project_.box = read_volume(*v).value_or(VolumeSpec{});
    if (const auto v = map.find("surfaces")) {
      for (const YamlValue& item : v->items()) read_surface(item);
    }
    if (const auto v = map.find("wells")) {
      for (const YamlValue& item : v->items()) read_well(item);
    }
    if (const auto v = map.find("tops")) read_tops_spec(*v);
    if (const auto v = map.find("points")) {
      for (const YamlValue& item : v->items()) read_named_point(item);
    }
    if (const auto v = map.find("fractures")) add_fractures(*v);
    if (!map.find("surfaces") && !map.find("box"))
      root.problem("neither 'surfaces' nor 'box' is given: there is nothing to mesh");
    if (const auto v = map.find("column")) read_column(*v);
    if (const auto v = map.find("rules")) read_model_rules(*v, project_);
    if (const auto v = map.find("regions")) read_region_seeds(*v, project_);
    if (const auto v = map.find("groups")) read_groups(*v, project_);
    if (const auto v = map.find("attributes")) read_attributes(*v, project_);
    if (const auto v = map.find("colours")) read_colours(*v, project_);
    finish_volume(root, project_);
    finish_domains(root, project_);
    finish_rules(root, project_);
    finish_below(root, project_);
    if (const auto v = find_renamed(map, "merge_within", "tolerance", project_.notes)) read_merge_within(*v);
    if (const auto v = map.find("mesh")) {
      read_mesh(*v);
    } else {
      default_refinement(project_);
    }
    if (const auto v = map.find("output")) read_output(*v, folder_, project_);
  }

  /// Returns a text such as " (line 7)". If a program composed the project text, returns nothing, because its line
  /// numbers mean nothing to the user.
  std::string on_line(int line) const {
    std::string text;
    if (!given_) text.append(" (line ").append(std::to_string(line)).append(")");
    return text;
  }

  /// Reads a name. Names appear in files of many formats and in file names, so they must not be too long, or contain
  /// control characters, quotes, commas or blanks at the ends.
  static bool read_name(const YamlValue& value, std::string& name) {
    const auto text = value.text();
    if (!text) return false;
    const bool odd = std::any_of(text->begin(), text->end(), [](char c) {
      return static_cast<unsigned char>(c) < 0x20 || c == '"' || c == '\'' || c == ',' || c == '/' || c == '\\';
    });
    if (odd || text->front() == ' ' || text->back() == ' ') {
      value.problem("the name " + in_quotes(*text) +
                    " holds a quote, a comma, a slash, a control character or a blank at its end");
      return false;
    }
    constexpr std::size_t longest_name = 200;  // in bytes: file systems allow 255, and suffixes are added
    if (text->size() > longest_name) {
      value.problem("the name " + in_quotes(*text) + " has " + std::to_string(text->size()) + " bytes; at most " +
                    std::to_string(longest_name) + " are taken, as files are named by it");
      return false;
    }
    name = *text;
    return true;
  }

  /// Reports a name that is already in use, because surfaces, box sides, wells and points must have distinct names.
  void claim_name(const YamlValue& value, const std::string& name) {
    if (std::find(box_sides.begin(), box_sides.end(), name) != box_sides.end()) {
      value.problem("'" + name + "' is the name of a side of the box; choose another");
    } else if (const auto [it, fresh] = name_line_.emplace(name, value.place().line); !fresh) {
      value.problem("the name '" + name + "' is used already" + on_line(it->second));
    }
  }

  void read_file(const YamlValue& value, std::filesystem::path& file, std::string& as_written) {
    const auto text = value.text();
    if (!text) return;
    as_written = *text;
    file = (folder_ / *text).lexically_normal();
    std::error_code ec;
    const auto status = std::filesystem::status(file, ec);
    if (!std::filesystem::exists(status)) {
      value.problem("there is no file '" + *text + "' (looked for as " + file.string() + ")" + file_was_meant(file));
    } else if (std::filesystem::is_directory(status)) {
      value.problem(in_quotes(*text) + " is a folder; a file was expected");
    }
  }

  /// Reads where the data of an entry (a surface, a well) come from: its file, or an input given in memory.
  template <class Spec>
  void read_content(const YamlMap& map, const char* what, Spec& spec) {
    const auto given = given_ ? given_->find(spec.name) : GivenInputs::const_iterator{};
    if (!given_ || given == given_->end()) {
      if (const auto v = map.require("file", what)) read_file(*v, spec.file, spec.file_as_written);
    } else if (const auto v = map.find("file")) {
      v->problem("'" + spec.name + "' was given as arrays, and has a file too; leave out one of them");
    } else {
      spec.given = given->second;
      spec.file_as_written = spec.given->format;
    }
  }

  /// Returns the function that a calling program gave for the surface; null if none.
  std::shared_ptr<FieldFunction> given_field(const std::string& name) const {
    if (!given_fields_) return nullptr;
    const auto at = given_fields_->find(name);
    return at == given_fields_->end() ? nullptr : at->second;
  }

  /// Returns an earlier entry of the project for the same surface, if that entry and this one both make it from fields
  /// that are valid in a part of the model; null if there is none.
  SurfaceSpec* first_entry(const YamlMap& map, const std::string& name) {
    const auto first = std::find_if(project_.surfaces.begin(), project_.surfaces.end(),
                                    [&](const SurfaceSpec& s) { return s.name == name; });
    const bool is_further = map.find("domain") && first != project_.surfaces.end() && !first->level_sets.empty() &&
                            !first->level_sets.front().domain.is_everywhere();
    return is_further ? &*first : nullptr;
  }

  /// Reads a further field of a surface, which is valid on another side of a fault than its previous fields.
  void read_further_field(const YamlMap& map, SurfaceSpec& first) {
    refuse_keys_of_first_entry(map, first);
    if (const auto v = map.require("kind", "horizon, fault or body"))
      if (v->scalar() != to_string(first.kind))
        v->problem("the first entry of '" + first.name + "' is a " + std::string(to_string(first.kind)));
    SurfaceSpec spec;
    spec.name = first.name;
    spec.kind = first.kind;
    read_shape(map, spec, first.level_sets.size() + 1);
    first.level_sets.insert(first.level_sets.end(), spec.level_sets.begin(), spec.level_sets.end());
    if (!spec.level_sets.empty()) first.file_as_written += ", " + spec.file_as_written;
  }

  /// Reads how the surface is defined: by triangles or points, or as a level set of a field. `entry` counts the entries
  /// with the surface's name, from 1.
  void read_shape(const YamlMap& map, SurfaceSpec& spec, std::size_t entry = 1) {
    const auto field = map.find("field");
    const std::shared_ptr<FieldFunction> function = given_field(further_field(spec.name, entry));
    if (!field && !function) {
      read_content(map, "the file of the surface, or the field whose level set it is", spec);
      for (const std::string_view key : level_set_keys())
        if (const auto v = map.find(key)) v->problem("is allowed with 'field' alone");
      return;
    }
    read_level_set(map, function, spec);
    LevelSetSpec& level_set = spec.level_sets.back();
    if (field) read_file(*field, level_set.file, level_set.file_as_written);
    spec.file_as_written = field ? level_set.file_as_written : "a function";
  }

  void read_surface(const YamlValue& value) {
    std::vector<std::string_view> keys{"name",           "kind",    "file",    "object",   "crs",      "unit",
                                       "z_unit",         "z",       "z_datum", "gridding", "resample", "smooth",
                                       "fault_polygons", "columns", "no_data", "below",    "extrude"};
    keys.insert(keys.end(), surface_rule_keys().begin(), surface_rule_keys().end());
    keys.insert(keys.end(), level_set_keys().begin(), level_set_keys().end());
    const YamlMap map(value, keys);
    if (!map.is_map()) return;
    SurfaceSpec spec;
    spec.line = map.place().line;
    if (const auto v = map.require("name", "each surface needs a name")) {
      if (read_name(*v, spec.name)) {
        if (SurfaceSpec* const first = first_entry(map, spec.name)) return read_further_field(map, *first);
        claim_name(*v, spec.name);
      }
    }
    spec.kind = SurfaceKind::surface;  // while the surface's kind is unknown, keys for certain kinds are not rejected
    if (const auto v = map.require("kind", "horizon, fault or body")) {
      const auto kind = v->choice({"horizon", "fault", "body"});
      if (kind)
        spec.kind = *kind == "fault" ? SurfaceKind::fault : *kind == "body" ? SurfaceKind::body : SurfaceKind::horizon;
    }
    read_made_surface(map, spec,
                      [&](const YamlValue& v, auto& file, auto& as_written) { read_file(v, file, as_written); });
    if (spec.below.empty()) read_shape(map, spec);
    spec.cuts_all = spec.kind == SurfaceKind::body;
    read_source(map, spec.source);
    if (const auto v = map.find("cuts")) read_cuts(*v, spec);
    read_gridding(map, spec);
    read_surface_rules(map, spec);
    if (const auto v = map.find("fault_polygons")) read_fault_polygons_spec(*v, spec);
    if (spec.source.object != "*" || !problems_.empty()) {
      project_.surfaces.push_back(std::move(spec));
    } else {
      add_all_objects(map.value(), spec);
    }
  }

  /// Handles `object: "*"`: adds an entry for each object of the file; bodies also form a group with the entry's name.
  void add_all_objects(const YamlValue& value, const SurfaceSpec& spec) {
    for (SurfaceSpec& entry : entries_of_all_objects(spec)) {
      claim_name(value, entry.name);
      if (entry.kind == SurfaceKind::body) project_.naming.groups[spec.name].push_back(entry.name);
      project_.surfaces.push_back(std::move(entry));
    }
  }

  void add_fractures(const YamlValue& value) {
    const bool has_corners = project_.box && project_.box->shape == VolumeSpec::Shape::box;
    const std::vector<Fracture> fractures =
        read_fractures(value, folder_, has_corners ? std::optional(project_.box->box) : std::nullopt);
    for (const Fracture& fracture : fractures) {
      claim_name(value, fracture.name);
      project_.surfaces.push_back(surface_of(fracture));
      project_.surfaces.back().line = value.place().line;
    }
  }

  void read_fault_polygons_spec(const YamlValue& value, SurfaceSpec& spec) {
    const YamlMap map(value, {"file", "object", "crs", "unit"});
    if (!map.is_map()) return;
    FaultPolygonsSpec& polygons = spec.fault_polygons;
    if (const auto v = map.require("file", "the file of the polygons"))
      read_file(*v, polygons.file, polygons.file_as_written);
    read_source(map, polygons.source);
    if (!spec.may_be(SurfaceKind::horizon)) value.problem("only a horizon has fault polygons");
    spec.rules.throw_at_polygons = true;
  }

  void read_well(const YamlValue& value) {
    const YamlMap map(value, {"name", "file", "object", "crs", "unit", "z_unit", "z", "z_datum", "columns", "head"});
    if (!map.is_map()) return;
    WellSpec spec;
    spec.line = map.place().line;
    if (const auto v = map.require("name", "each well needs a name")) {
      if (read_name(*v, spec.name)) claim_name(*v, spec.name);
    }
    read_content(map, "the file of the well's path", spec);
    read_source(map, spec.source);
    if (const auto v = map.find("head")) spec.head = v->point();
    project_.wells.push_back(std::move(spec));
  }

  void read_tops_spec(const YamlValue& value) {
    const YamlMap map(value, {"file", "depth", "reach"});
    if (!map.is_map()) return;
    TopsSpec& tops = project_.tops;
    if (const auto v = map.require("file", "the table of tops")) read_file(*v, tops.file, tops.file_as_written);
    if (const auto v = map.find("depth"))
      tops.depth = v->choice({"along", "z"}) == "z" ? TopsSpec::Depth::z : TopsSpec::Depth::along;
    if (const auto v = map.find("reach")) {
      tops.reach = v->number().value_or(1);
      if (!(tops.reach > 0)) v->problem("a length above zero was expected");
    }
    if (project_.wells.empty()) value.problem("tops are places on wells, and there is no well");
  }

  void read_named_point(const YamlValue& value) {
    const YamlMap map(value, {"name", "at"});
    if (!map.is_map()) return;
    NamedPoint point;
    if (const auto v = map.require("name", "each point needs a name")) {
      if (read_name(*v, point.name)) claim_name(*v, point.name);
    }
    if (const auto v = map.require("at", "[x, y, z] of the point")) point.point = v->point().value_or(Vec3{});
    project_.points.push_back(std::move(point));
  }

  void read_column(const YamlValue& value) {
    const std::vector<YamlValue> items = value.items();
    if (!value.is_list()) return;
    if (items.size() % 2 == 0) {
      value.problem(
          "unit, horizon, unit, ..., unit was expected, from the youngest to the oldest: an odd number of names; "
          "found " +
          std::to_string(items.size()));
    }
    std::map<std::string, int> seen;
    for (std::size_t i = 0; i < items.size(); ++i) {
      std::string name;
      if (!read_name(items[i], name)) continue;
      if (const auto [it, fresh] = seen.emplace(name, items[i].place().line); !fresh) {
        items[i].problem("'" + name + "' stands in the column already");
      } else {
        check_column_entry(items[i], name, i % 2 == 1);
      }
      project_.column.push_back(name);
    }
  }

  void check_column_entry(const YamlValue& value, const std::string& name, bool horizon_expected) const {
    const auto it = std::find_if(project_.surfaces.begin(), project_.surfaces.end(),
                                 [&](const SurfaceSpec& s) { return s.name == name; });
    if (!horizon_expected) {
      if (it != project_.surfaces.end()) {
        value.problem("the name of a unit was expected here, but '" + name + "' is a surface" + on_line(it->line) +
                      ": units and horizons must alternate");
      }
    } else if (it == project_.surfaces.end()) {
      std::vector<std::string_view> horizons;
      for (const SurfaceSpec& s : project_.surfaces)
        if (s.may_be(SurfaceKind::horizon)) horizons.push_back(s.name);
      const std::string meant = was_meant(name, horizons);
      value.problem("a horizon was expected here, but no surface is named '" + name + "'" +
                    (meant.empty() ? "; horizons are " + (horizons.empty() ? "none" : listed(horizons)) : meant));
    } else if (!it->may_be(SurfaceKind::horizon)) {
      value.problem("a horizon was expected here, but '" + name + "' is a " + to_string(it->kind) + on_line(it->line));
    }
  }

  void read_mesh(const YamlValue& value) {
    std::vector<std::string_view> keys{"mode", "cluster_distance", "preserve_boundary"};
    keys.insert(keys.end(), refinement_keys().begin(), refinement_keys().end());
    const YamlMap map(value, keys);
    if (!map.is_map()) return;
    TetrahedralizeOptions& options = project_.mesh.options;
    if (const auto v = map.find("mode")) {
      if (v->choice({"constrained", "conforming"}) == "conforming") options.recover.mode = MeshMode::conforming;
    }
    if (const auto v = map.find("cluster_distance")) {
      if (v->scalar() == "auto") {
        options.delaunay.cluster_distance = -1;
      } else if (const auto d = v->number()) {
        options.delaunay.cluster_distance = *d;
        if (*d < 0) v->problem("auto or a length of zero or more was expected");
      }
    }
    if (const auto v = map.find("preserve_boundary")) options.recover.preserve_boundary = v->boolean().value_or(false);
    read_refinement(map, project_);
  }

  void read_merge_within(const YamlValue& value) {
    const auto length = value.number();
    if (!length) return;
    project_.merge_within = *length;
    if (*length < 0) value.problem("a length of zero or more was expected");
  }

  Problems problems_;
  Project project_;
  std::filesystem::path folder_;
  const GivenInputs* given_ = nullptr;
  const GivenFields* given_fields_ = nullptr;
  std::map<std::string, int> name_line_;
};

}  // namespace

Project read_project(const std::filesystem::path& file) {
  const InputFile input = load_input_file(file);
  return ProjectReader(file).read(input.bytes);
}

Project read_given_project(const GivenProject& given) {
  try {
    return ProjectReader(given).read(given.text);
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::usage) throw;
    throw Error(e.kind(), without_places(e.what(), given.name), e.context());
  }
}

}  // namespace geomesh::geomodel
