// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Suggestions for misspelt words, and numbers formatted as text.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace geomesh::geomodel {

/// The word of `known` that was most likely meant by `word`, or an empty view where none is near: edit distance with
/// swaps of neighbours, at most a third of the length, at least one. Source: Damerau 1964 (optimal string alignment).
std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& known);

/// Returns a list as text: "a, b or c".
std::string listed(const std::vector<std::string_view>& words);

/// Returns "; was 'B' meant?" for the most similar known word B; empty if none is similar.
std::string was_meant(std::string_view word, const std::vector<std::string_view>& known);
/// Returns the suggestion for a missing file, from the names in its folder.
std::string file_was_meant(const std::filesystem::path& file);

/// Formats a number with four significant digits, so that no figure is rounded to zero.
std::string short_words(double x);

}  // namespace geomesh::geomodel
