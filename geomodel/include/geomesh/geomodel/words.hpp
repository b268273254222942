// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Suggestions for misspelt words, and numbers formatted as text.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace geomesh::geomodel {

/// Returns the word of `known` that was most likely meant by `word`, or an empty view if none is similar. Words are
/// compared by edit distance, in which a swap of neighbouring letters counts as one edit: at most a third of the length
/// of `word`, but at least one, is allowed. Source: Damerau 1964 (optimal string alignment).
std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& known);

/// Returns a list as text: "a, b or c".
std::string listed(const std::vector<std::string_view>& words);

/// Returns "; was 'B' meant?" for the known word B that is most similar to `word`; empty if none is similar.
std::string was_meant(std::string_view word, const std::vector<std::string_view>& known);
/// Returns "; was 'B' meant?" for a missing file, where B is the most similar name in its folder.
std::string file_was_meant(const std::filesystem::path& file);

/// Formats a number with four significant digits, so that no figure is rounded to zero.
std::string short_words(double x);

}  // namespace geomesh::geomodel
