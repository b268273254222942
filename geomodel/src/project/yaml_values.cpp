// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/yaml_values.hpp"

#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "project/read_rules.hpp"
#include "readers/text/text.hpp"

namespace geomesh::geomodel {
namespace {

Place place_of(const YAML::Node& node, Place fallback) {
  const YAML::Mark mark = node.Mark();
  return mark.is_null() || mark.line < 0 ? fallback : Place{mark.line + 1, mark.column + 1};
}

/// The map of a project file in which each key belongs, for messages. Users write keys of rules in entries of surfaces,
/// and vice versa.
const std::vector<std::pair<std::string_view, std::vector<std::string_view>>> homes{
    {"rules",
     {"on_crossing", "trim_overshoot", "topography", "fault_blocks", "min_volume", "small_regions", "min_thickness",
      "thin_layers", "continue_within"}},
    {"an entry of surfaces", {"kind", "file"}},
    {"an entry of surfaces", surface_rule_keys()},
    {"box", {"min", "max", "margin", "polygon", "azimuth", "center"}},
    {"mesh",
     {"mode", "refine", "size", "quality", "quality_measure", "preserve_boundary", "cluster_distance", "honour",
      "surfaces_within", "tolerance", "max_elements", "time_budget", "cell_arrays"}},
    {"mesh.size", {"input_edges", "on_surfaces", "curvature", "gap_layers", "gradation"}},
    {"output",
     {"formats", "directory", "origin", "groups", "inner_faces", "curves", "order", "region_array", "single_grid",
      "node_arrays", "compression", "split", "fault_zone", "cohesive"}},
    {"the top of the file",
     {"column", "wells", "points", "regions", "groups", "attributes", "colours", "surfaces", "rules", "merge_within"}}};

std::string home_of(std::string_view key) {
  for (const auto& [home, keys] : homes)
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) return std::string(home);
  return {};
}

/// Returns whether a number has a leading zero. Some YAML readers take 010 as 8 and others as 10, so it is refused.
bool has_leading_zero(std::string_view s) {
  if (!s.empty() && (s.front() == '-' || s.front() == '+')) s.remove_prefix(1);
  return s.size() > 1 && s[0] == '0' && std::isdigit(static_cast<unsigned char>(s[1]));
}

/// Returns whether the bytes are valid UTF-8 (RFC 3629: shortest forms only, no surrogates).
bool is_utf8(std::string_view s) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(s[i]); };
  for (std::size_t i = 0; i < s.size();) {
    const unsigned lead = byte(i);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xc2 && lead < 0xe0 ? 2
                               : lead >= 0xe0 && lead < 0xf0 ? 3
                               : lead >= 0xf0 && lead < 0xf5 ? 4
                                                             : 0;
    if (length == 0 || i + length > s.size()) return false;
    for (std::size_t k = 1; k < length; ++k)
      if ((byte(i + k) & 0xc0) != 0x80) return false;
    if (lead == 0xe0 && byte(i + 1) < 0xa0) return false;
    if (lead == 0xed && byte(i + 1) >= 0xa0) return false;
    if (lead == 0xf0 && byte(i + 1) < 0x90) return false;
    if (lead == 0xf4 && byte(i + 1) >= 0x90) return false;
    i += length;
  }
  return true;
}

bool is_quoted(const YAML::Node& node) { return node.Tag() == "!"; }

/// Receives the events of a YAML document and ignores them, to skip the document.
class NoEvents : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

}  // namespace

YamlValue::YamlValue(Problems& problems, YAML::Node node, std::string name, Place fallback)
    : problems_(&problems), node_(std::move(node)), name_(std::move(name)), place_(place_of(node_, fallback)) {}

std::string YamlValue::described() const {
  if (node_.IsSequence()) return "a list";
  if (node_.IsMap()) return "a map";
  if (node_.IsScalar()) return in_quotes(node_.Scalar());
  return "nothing";
}

std::optional<std::string> YamlValue::text() const {
  if (node_.IsScalar() && !is_utf8(node_.Scalar())) {
    problem("a letter is not in UTF-8; save the project file with the encoding UTF-8");
    return std::nullopt;
  }
  if (node_.IsScalar() && !node_.Scalar().empty()) return node_.Scalar();
  problem("a text was expected, found " + described());
  return std::nullopt;
}

std::optional<double> YamlValue::number() const {
  const std::optional<double> value = node_.IsScalar() && !is_quoted(node_) ? to_double(node_.Scalar()) : std::nullopt;
  const std::string lower = node_.IsScalar() ? to_lower(node_.Scalar()) : "";
  if ((value && !std::isfinite(*value)) || lower.find(".inf") != std::string::npos || lower == ".nan") {
    problem("a finite number was expected, found " + described());
  } else if (!value) {
    problem("a number was expected, found " + described());
  } else if (has_leading_zero(node_.Scalar())) {
    problem("the number " + described() + " has a leading zero, which some read as octal; write it without");
  } else {
    return value;
  }
  return std::nullopt;
}

std::optional<bool> YamlValue::boolean() const {
  if (node_.IsScalar() && !is_quoted(node_)) {
    if (node_.Scalar() == "true") return true;
    if (node_.Scalar() == "false") return false;
  }
  problem("true or false was expected, found " + described());
  return std::nullopt;
}

std::optional<std::string> YamlValue::choice(const std::vector<std::string_view>& words) const {
  if (node_.IsScalar() && std::find(words.begin(), words.end(), node_.Scalar()) != words.end()) return node_.Scalar();
  problem(listed(words) + " was expected, found " + described() +
          (node_.IsScalar() ? was_meant(node_.Scalar(), words) : std::string()));
  return std::nullopt;
}

std::optional<Vec3> YamlValue::point() const {
  if (!node_.IsSequence() || node_.size() != 3) {
    problem("three numbers [x, y, z] were expected, found " +
            (node_.IsSequence() ? std::to_string(node_.size()) + " values" : described()));
    return std::nullopt;
  }
  Vec3 p;
  bool complete = true;
  const std::vector<YamlValue> values = items();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto v = values[i].number();
    complete = complete && v;
    p[i] = v.value_or(0);
  }
  return complete ? std::optional(p) : std::nullopt;
}

std::vector<YamlValue> YamlValue::items() const {
  std::vector<YamlValue> list;
  if (!node_.IsSequence()) {
    problem("a list was expected, found " + described() +
            (node_.IsMap() ? "; each entry begins with a dash: - {name: ...}" : ""));
    return list;
  }
  for (std::size_t i = 0; i < node_.size(); ++i) {
    list.emplace_back(*problems_, node_[i], name_ + "[" + std::to_string(i + 1) + "]", place_);
  }
  return list;
}

YamlMap::YamlMap(const YamlValue& value, const std::vector<std::string_view>& known,
                 const std::vector<std::string_view>& not_offered)
    : value_(value), is_map_(value.is_map()) {
  if (!is_map_) {
    value.problem("a map with the keys " + listed(known) + " was expected");
    return;
  }
  const std::string prefix = value.name() == "project" ? "" : value.name() + ".";
  for (const auto& entry : value.node()) {
    const Place place = place_of(entry.first, value.place());
    Problems& problems = value.problems();
    if (!entry.first.IsScalar()) {
      problems.add(place, value.name() + ": a key must be a word; known are " + listed(known));
      continue;
    }
    const std::string key = entry.first.Scalar();
    if (std::find(not_offered.begin(), not_offered.end(), key) != not_offered.end()) {
      problems.add(place, prefix + key + ": not offered yet");
      continue;
    }
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      const std::string meant = was_meant(key, known);
      const std::string home = home_of(key);
      problems.add(place, "unknown key " + in_quotes(key) + (value.name() == "project" ? "" : " in " + value.name()) +
                              (!home.empty()   ? "; it belongs to " + home
                               : meant.empty() ? "; known are " + listed(known)
                                               : meant));
      continue;
    }
    if (find(key)) {
      problems.add(place, prefix + key + ": duplicate");
      continue;
    }
    entries_.emplace_back(key, YamlValue(problems, entry.second, prefix + key, place));
  }
}

std::optional<YamlValue> YamlMap::find(std::string_view key) const {
  for (const auto& [k, v] : entries_)
    if (k == key) return v;
  return std::nullopt;
}

std::optional<YamlValue> YamlMap::require(std::string_view key, const char* what) const {
  auto value = find(key);
  if (!value && is_map_) value_.problem("the key '" + std::string(key) + "' is missing: " + what);
  return value;
}

std::optional<YamlValue> find_renamed(const YamlMap& map, std::string_view name, std::string_view former,
                                      std::vector<std::string>& notes) {
  auto value = map.find(name), old = map.find(former);
  if (!old) return value;
  if (value)
    old->problem("is the former name of '" + std::string(name) + "', which is given too; leave out one of them");
  notes.push_back("the key '" + old->name() + "' is now called '" + std::string(name) + "'; it is read as before");
  return old;
}

std::vector<std::pair<std::string, YamlValue>> named_entries(const YamlValue& value, const char* expected) {
  std::vector<std::pair<std::string, YamlValue>> entries;
  if (!value.is_map()) {
    value.problem(std::string(expected) + " was expected");
    return entries;
  }
  for (const auto& item : value.node()) {
    const std::string key = item.first.IsScalar() ? item.first.Scalar() : std::string();
    if (key.empty()) {
      value.problem("a name was expected as key");
      continue;
    }
    if (std::any_of(entries.begin(), entries.end(), [&](const auto& e) { return e.first == key; })) {
      value.problem("'" + key + "' stands here twice");
      continue;
    }
    entries.emplace_back(key, YamlValue(value.problems(), item.second, value.name() + "." + key, value.place()));
  }
  return entries;
}

YamlDocuments read_yaml_documents(const std::string& text) {
  std::istringstream in(text);
  YAML::Parser parser(in);
  NoEvents none;
  const bool has_more = parser.HandleNextDocument(none) && parser.HandleNextDocument(none);
  return {YAML::Load(text), has_more};
}

}  // namespace geomesh::geomodel
