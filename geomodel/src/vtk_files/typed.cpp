// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_files/typed.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "readers/text/text.hpp"

namespace geomesh::geomodel {
namespace {

/// Converts a word to a number of type T. Returns false if it is none.
template <class T>
bool parse(std::string_view word, T& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  if constexpr (std::is_floating_point_v<T>) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc() && end == word.data() + word.size()) return true;
    const auto other = to_double(word);  // also reads Fortran's exponents (1D5) and numbers outside the range of T
    value = static_cast<T>(other.value_or(0));
    return other.has_value();
  } else {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
  }
}

}  // namespace

std::vector<std::byte> unpacked_bits(std::span<const std::byte> packed, std::size_t n) {
  std::vector<std::byte> bits(n);
  for (std::size_t i = 0; i < n; ++i) bits[i] = (packed[i / 8] >> (7 - i % 8)) & std::byte{1};
  return bits;
}

std::vector<std::byte> numbers_of_text(std::string_view& text, VtkType type, std::size_t n) {
  std::vector<std::byte> bytes;
  with_type(type, [&](auto value) {
    bytes.reserve(std::min(n, text.size() / 2 + 1) * sizeof value);
    for (std::size_t i = 0; i < n; ++i) {
      const std::string_view before = text, word = next_word(text);
      if (word.empty() || !parse(word, value)) {
        text = before;
        return;
      }
      const std::size_t at = bytes.size();
      bytes.resize(at + sizeof value);
      std::memcpy(bytes.data() + at, &value, sizeof value);
    }
  });
  return bytes;
}

}  // namespace geomesh::geomodel
