// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Words that a user may have meant, and numbers as words.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace geomesh::geomodel {

/// The word of `known` that was most likely meant by `word`, or an empty view where none is near: edit distance with
/// swaps of neighbours, at most a third of the length, at least one. Source: Damerau 1964 (optimal string alignment).
std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& known);

/// "a, b or c".
std::string listed(const std::vector<std::string_view>& words);

/// "; was 'B' meant?" for the nearest word B; empty where none is near.
std::string was_meant(std::string_view word, const std::vector<std::string_view>& known);
/// The same for a file that is not there, of the names in its folder.
std::string file_was_meant(const std::filesystem::path& file);

/// Four significant digits: no figure is rounded to zero.
std::string short_words(double x);

}  // namespace geomesh::geomodel
