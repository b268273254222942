// SPDX-License-Identifier: GPL-3.0-or-later
// Declared in geomesh/geomodel/warnings.hpp.
#include <algorithm>
#include <cctype>

#include "geomesh/geomodel/warnings.hpp"

namespace geomesh::geomodel {

namespace {

constexpr std::string_view left_out = "...";  ///< stands for names and numbers in which warnings of a group differ
constexpr const char* ends_of_statement = ":;(";

bool is_name_or_number(std::string_view word) {
  return std::any_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isdigit(c) != 0 || c == '_' || c == '*' || c == '/' || c == '\'' || c == '"' || c == '.';
  });
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" ,", begin), text.size());
    if (end > begin) words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// Returns a message without a prefix that ends with a colon, such as "top.ts: the file says" or "polyline W2:".
std::string_view without_prefix(std::string_view text) {
  const std::size_t colon = text.find(": ");
  const bool is_name = colon != std::string_view::npos && words_of(text.substr(0, colon)).size() <= 2;
  if (is_name) return text.substr(colon + 2);
  const std::size_t blank = text.find(' ');
  return blank == std::string_view::npos ? text : text.substr(blank + 1);
}

}  // namespace

std::string warning_cause(std::string_view warning) {
  const std::string_view said = without_prefix(warning);
  std::string cause;
  for (const std::string_view word : words_of(said.substr(0, said.find_first_of(ends_of_statement)))) {
    const std::string_view kept = is_name_or_number(word) ? left_out : word;
    if (kept == left_out && cause.ends_with(left_out)) continue;
    cause += (cause.empty() ? "" : " ") + std::string(kept);
  }
  return cause.empty() ? std::string(warning) : cause;
}

std::string warning_statement(std::string_view warning) {
  const std::size_t said_at = warning.size() - without_prefix(warning).size();
  std::string_view statement = warning.substr(0, warning.find_first_of(ends_of_statement, said_at));
  for (const std::string_view end : {" ", ", near"})  // a position may follow in the message: "..., near (x, y, z)"
    while (statement.ends_with(end)) statement.remove_suffix(end.size());
  return std::string(statement.empty() ? warning : statement);
}

std::vector<WarningGroup> group_warnings(const std::vector<std::string>& warnings) {
  std::vector<WarningGroup> groups;
  for (const std::string& text : warnings) {
    const std::string cause = warning_cause(text);
    const auto known =
        std::find_if(groups.begin(), groups.end(), [&](const WarningGroup& g) { return g.cause == cause; });
    if (known != groups.end()) {
      ++known->count;
    } else {
      groups.push_back({cause, 1, text});
    }
  }
  return groups;
}

}  // namespace geomesh::geomodel
