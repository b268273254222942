// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Help texts in plain words. CLI11's own would contain, for example, "ENUM:value in {cut->1,elements->2} OR {1,2}".
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace geomesh::app {

/// Returns a type of CLI11 in plain words: "a|b|c" for "TEXT:{a,b,c}" or "ENUM:value in {a->0,b->1} OR {0,1}", "N" and
/// "X" for numbers, nothing for words.
inline std::string plain_type(const std::string& type) {
  constexpr std::size_t longest = 60;
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) {
    const std::string base = type.substr(0, type.find(':'));
    return base == "UINT" || base == "INT" ? "N" : base == "FLOAT" ? "X" : base == "TEXT" ? "" : base;
  }
  std::string words;
  for (std::size_t from = open + 1; from < close;) {
    const std::size_t comma = std::min(type.find(',', from), close);
    const std::string entry = type.substr(from, comma - from);
    words += (words.empty() ? "" : "|") + entry.substr(0, entry.find("->"));
    from = comma + 1;
  }
  return words.size() > longest ? "NAME" : words;
}

class HelpFormat : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    std::string text;
    if (option->get_type_size() != 0) {
      const std::string type = plain_type(option->get_type_name());
      if (!type.empty()) text += " " + type;
      if (!option->get_default_str().empty()) text += " (" + option->get_default_str() + ")";
    }
    if (option->get_expected_max() == CLI::detail::expected_max_vector_size) text += " ...";
    if (option->get_required()) text += " (needed)";
    return text;
  }
};

inline void use_plain_help(CLI::App& app) { app.formatter(std::make_shared<HelpFormat>()); }

}  // namespace geomesh::app
