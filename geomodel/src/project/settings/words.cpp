// SPDX-License-Identifier: GPL-3.0-or-later
#include "geomesh/geomodel/words.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>

namespace geomesh::geomodel {
namespace {

/// Returns the optimal string alignment distance (Damerau 1964), which counts insertions, deletions, substitutions and
/// swaps of neighbouring letters.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& known) {
  if (word.size() > 100) return {};
  std::string_view best;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string_view k : known) {
    const std::size_t distance = edit_distance(word, k);
    if (distance < least) {
      least = distance;
      best = k;
    }
  }
  return best;
}

std::string listed(const std::vector<std::string_view>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  return text;
}

std::string was_meant(std::string_view word, const std::vector<std::string_view>& known) {
  const std::string_view near = nearest_word(word, known);
  return near.empty() ? std::string() : "; was '" + std::string(near) + "' meant?";
}

std::string file_was_meant(const std::filesystem::path& file) {
  std::error_code error;
  std::vector<std::string> names;
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  // Among similar names, one that differs only in extension or case is preferred to one that differs in letters.
  const auto lower = [](std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
      return c < 0x80 ? static_cast<char>(std::tolower(c)) : static_cast<char>(c);
    });
    return text;
  };
  const std::string whole = lower(file.filename().string()), stem = lower(file.stem().string());
  for (const std::string& name : names)
    if (lower(name) == whole) return "; was '" + name + "' meant?";
  for (const std::string& name : names)
    if (lower(std::filesystem::path(name).stem().string()) == stem) return "; was '" + name + "' meant?";
  return was_meant(file.filename().string(), {names.begin(), names.end()});
}

std::string short_words(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

}  // namespace geomesh::geomodel
