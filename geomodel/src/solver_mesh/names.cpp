// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_mesh/names.hpp"

#include <array>
#include <cctype>
#include <cstdint>
#include <string_view>

namespace geomesh::geomodel {

namespace {

/// ASCII spellings of the letters U+00C0 to U+017F, which European languages use.
constexpr std::array<std::string_view, 192> letters{
    "A",  "A", "A",  "A", "Ae", "A", "Ae", "C",  "E",  "E", "E",  "E",  "I", "I", "I",  "I",  "D",  "N", "O",  "O",
    "O",  "O", "Oe", "_", "Oe", "U", "U",  "U",  "Ue", "Y", "Th", "ss", "a", "a", "a",  "a",  "ae", "a", "ae", "c",
    "e",  "e", "e",  "e", "i",  "i", "i",  "i",  "d",  "n", "o",  "o",  "o", "o", "oe", "_",  "oe", "u", "u",  "u",
    "ue", "y", "th", "y", "A",  "a", "A",  "a",  "A",  "a", "C",  "c",  "C", "c", "C",  "c",  "C",  "c", "D",  "d",
    "D",  "d", "E",  "e", "E",  "e", "E",  "e",  "E",  "e", "E",  "e",  "G", "g", "G",  "g",  "G",  "g", "G",  "g",
    "H",  "h", "H",  "h", "I",  "i", "I",  "i",  "I",  "i", "I",  "i",  "I", "i", "IJ", "ij", "J",  "j", "K",  "k",
    "k",  "L", "l",  "L", "l",  "L", "l",  "L",  "l",  "L", "l",  "N",  "n", "N", "n",  "N",  "n",  "n", "N",  "n",
    "O",  "o", "O",  "o", "O",  "o", "Oe", "oe", "R",  "r", "R",  "r",  "R", "r", "S",  "s",  "S",  "s", "S",  "s",
    "S",  "s", "T",  "t", "T",  "t", "T",  "t",  "U",  "u", "U",  "u",  "U", "u", "U",  "u",  "U",  "u", "U",  "u",
    "W",  "w", "Y",  "y", "Y",  "Z", "z",  "Z",  "z",  "Z", "z",  "s"};

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

std::string transliterated(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    if (lead < 0x80) {
      result += text[i++];
      continue;
    }
    std::size_t n = 1;  // number of bytes of the current UTF-8 character
    while (i + n < text.size() && (static_cast<unsigned char>(text[i + n]) & 0xC0u) == 0x80u) ++n;
    const std::uint32_t code =
        n == 2 ? (lead & 0x1Fu) << 6 | (static_cast<unsigned char>(text[i + 1]) & 0x3Fu) : 0xFFFFFFFFu;
    result += code >= 0xC0 && code < 0x180 ? letters[code - 0xC0] : std::string_view("_");
    i += n;
  }
  return result;
}

std::string SolverNames::give(const std::string& full_name) {
  std::string clean;
  for (const char c : transliterated(full_name))
    clean += std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '-' ? c : '_';
  if (clean.empty() || !std::isalpha(static_cast<unsigned char>(clean.front()))) clean.insert(0, 1, 'n');
  std::string name = clean.substr(0, limit_);
  for (std::size_t k = 1; (k == 1 && clean.size() > limit_) || taken_.contains(lower_case(name)); ++k) {
    const std::string number = std::string("_").append(std::to_string(k));
    name = clean.substr(0, limit_ - number.size()) + number;
  }
  taken_.insert(lower_case(name));
  return name;
}

}  // namespace geomesh::geomodel
