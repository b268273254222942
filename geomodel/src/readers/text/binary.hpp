// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads binary numbers, whatever the byte order of the machine.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>

namespace geomesh::geomodel {

/// Reads the number at byte `at` of binary data. Precondition: at + sizeof(T) <= bytes.size().
template <class T>
T read_number(std::string_view bytes, std::size_t at, std::endian order) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes.data() + at, sizeof(T));
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}
template <class T>
T read_little(std::string_view bytes, std::size_t at) {
  return read_number<T>(bytes, at, std::endian::little);
}
template <class T>
T read_big(std::string_view bytes, std::size_t at) {
  return read_number<T>(bytes, at, std::endian::big);
}

}  // namespace geomesh::geomodel
