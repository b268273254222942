// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Typed reading of YAML values, which keep their line and column for error messages.
#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "project/problems.hpp"

namespace geomesh::geomodel {

/// A YAML node with its path in the project ("surfaces[2].file"). Its functions report mistakes and return nothing
/// then.
class YamlValue {
 public:
  YamlValue(Problems& problems, YAML::Node node, std::string name, Place fallback);

  Place place() const { return place_; }
  const std::string& name() const { return name_; }
  bool is_list() const { return node_.IsSequence(); }
  bool is_map() const { return node_.IsMap(); }
  /// Returns the scalar as written; empty for lists, maps and null.
  std::string scalar() const { return node_.IsScalar() ? node_.Scalar() : std::string(); }
  void problem(const std::string& message) const { problems_->add(place_, name_ + ": " + message); }

  /// Returns the text of a YAML scalar; nothing if the value is no scalar or empty.
  std::optional<std::string> text() const;
  /// Returns a finite decimal number; reports numbers with a leading zero (octal in older YAML) or in quotes.
  std::optional<double> number() const;
  std::optional<bool> boolean() const;
  std::optional<std::string> choice(const std::vector<std::string_view>& words) const;
  /// [x, y, z].
  std::optional<Vec3> point() const;
  std::vector<YamlValue> items() const;

  const YAML::Node& node() const { return node_; }
  Problems& problems() const { return *problems_; }

 private:
  std::string described() const;

  Problems* problems_;
  YAML::Node node_;
  std::string name_;
  Place place_;
};

/// A YAML map with a list of known keys. The constructor reports duplicate keys, unknown keys (with the most similar
/// known one) and keys of a later version.
class YamlMap {
 public:
  YamlMap(const YamlValue& value, const std::vector<std::string_view>& known,
          const std::vector<std::string_view>& not_offered = {});

  bool is_map() const { return is_map_; }
  std::optional<YamlValue> find(std::string_view key) const;
  /// Returns the value of a key; reports an error if the key is missing.
  std::optional<YamlValue> require(std::string_view key, const char* what) const;
  Place place() const { return value_.place(); }
  const YamlValue& value() const { return value_; }

 private:
  YamlValue value_;
  bool is_map_ = false;
  std::vector<std::pair<std::string, YamlValue>> entries_;
};

/// Finds the value of a renamed key under its present or its former name; for the former name, a note is recorded.
/// Reports an error if both are given.
std::optional<YamlValue> find_renamed(const YamlMap& map, std::string_view name, std::string_view former,
                                      std::vector<std::string>& notes);

/// Returns the entries of a YAML map whose keys are user-chosen names. Reports that `expected` was expected if the
/// value is no map.
std::vector<std::pair<std::string, YamlValue>> named_entries(const YamlValue& value, const char* expected);

struct YamlDocuments {
  YAML::Node first;  ///< the first YAML document in a text; null if there is none
  bool has_more = false;
};

/// Reads at most two YAML documents: yaml-cpp (0.7) finds endless empty ones after a comma. Throws YAML::Exception.
YamlDocuments read_yaml_documents(const std::string& text);

}  // namespace geomesh::geomodel
