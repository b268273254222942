// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Calls a generic function with the C++ type that stores the numbers of a VTK type.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "vtk_files/vtk_data.hpp"

namespace geomesh::geomodel {

/// Calls `f` with a zero of the C++ type that stores this VTK type; bits and the bytes of texts are 8-bit numbers.
template <class F>
decltype(auto) with_type(VtkType type, F&& f) {
  switch (type) {
    case VtkType::int8:
      return f(std::int8_t{0});
    case VtkType::int16:
      return f(std::int16_t{0});
    case VtkType::uint16:
      return f(std::uint16_t{0});
    case VtkType::int32:
      return f(std::int32_t{0});
    case VtkType::uint32:
      return f(std::uint32_t{0});
    case VtkType::int64:
      return f(std::int64_t{0});
    case VtkType::uint64:
      return f(std::uint64_t{0});
    case VtkType::float32:
      return f(float{0});
    case VtkType::float64:
      return f(double{0});
    default:
      return f(std::uint8_t{0});
  }
}

/// Reverses the bytes of each value of `size` bytes if the file's byte order is not this machine's.
inline void to_native_order(std::span<std::byte> bytes, std::size_t size, std::endian order) {
  if (order == std::endian::native || size < 2) return;
  for (std::size_t i = 0; i + size <= bytes.size(); i += size)
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i), bytes.begin() + static_cast<std::ptrdiff_t>(i + size));
}

/// Unpacks `n` bits, the highest of each byte first, into one byte each.
std::vector<std::byte> unpacked_bits(std::span<const std::byte> packed, std::size_t n);

/// Returns the next word of a text, and shortens the text to what follows; empty at the end.
inline std::string_view next_word(std::string_view& text) {
  constexpr std::string_view blanks = " \t\n\r\v\f";
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

/// Reads `n` numbers of the type from a text, and shortens the text to what follows. Memory is bounded by the text's
/// length. Returns fewer numbers if a word is not a number of the type, or if the text ends; `text` then begins at that
/// word.
std::vector<std::byte> numbers_of_text(std::string_view& text, VtkType type, std::size_t n);

/// Returns a * b, or the largest number if that does not fit in 64 bits.
inline std::size_t product(std::size_t a, std::size_t b) { return b != 0 && a > SIZE_MAX / b ? SIZE_MAX : a * b; }

}  // namespace geomesh::geomodel
