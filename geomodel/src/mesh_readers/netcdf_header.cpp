// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_readers/netcdf_header.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <vector>

namespace geomesh::geomodel {
namespace {

struct Damaged {};

/// Bytes of a value by the number of its type, from 1.
constexpr std::array<std::uint64_t, 12> bytes_of_type{0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
constexpr std::uint64_t dimensions = 10, variables = 11, attributes = 12;  // tags of lists

class Header {
 public:
  Header(std::ifstream& file, std::uint64_t bytes, unsigned version)
      : file_(file),
        bytes_(bytes),
        left_(bytes - 4),
        width_(version == 5 ? 8 : 4),
        width_of_offset_(version == 1 ? 4 : 8) {}

  void check() {
    number(width_);  // of records
    const std::uint64_t n_dimensions = begin_list(dimensions, 2 * width_);
    std::vector<std::uint64_t> lengths;
    for (std::uint64_t i = 0; i < n_dimensions; ++i) {
      skip_name();
      lengths.push_back(number(width_));
    }
    check_attributes();
    for (std::uint64_t n = begin_list(variables, 4 * width_); n > 0; --n) {
      skip_name();
      std::uint64_t n_values = 1;
      for (std::uint64_t rank = count(width_); rank > 0; --rank) {
        const std::uint64_t dimension = number(width_);
        if (dimension >= n_dimensions) throw Damaged{};
        const std::uint64_t length = lengths[dimension];
        if (length != 0 && n_values > bytes_ / length) throw Damaged{};
        n_values *= length;  // 0 along the records, which are not checked
      }
      check_attributes();
      const std::uint64_t type = number(4);
      if (type == 0 || type >= bytes_of_type.size()) throw Damaged{};
      number(width_);
      check_extent(number(width_of_offset_), n_values * bytes_of_type[type]);
    }
  }

 private:
  /// Values end within the file. The library reads zeros behind its end.
  void check_extent(std::uint64_t begin, std::uint64_t bytes) const {
    if (bytes > 0 && (begin > bytes_ || bytes > bytes_ - begin)) throw Damaged{};
  }
  std::uint64_t number(unsigned width) {
    std::array<unsigned char, 8> bytes{};
    take(width);
    if (!file_.read(reinterpret_cast<char*>(bytes.data()), width)) throw Damaged{};
    std::uint64_t value = 0;
    for (unsigned i = 0; i < width; ++i) value = value << 8 | bytes[i];
    return value;
  }
  void take(std::uint64_t bytes) {
    if (bytes > left_) throw Damaged{};
    left_ -= bytes;
  }
  void skip(std::uint64_t bytes) {
    take(bytes);
    file_.seekg(static_cast<std::streamoff>(bytes), std::ios::cur);
  }
  /// A number of things of which each takes at least so many bytes in the rest of the file.
  std::uint64_t count(std::uint64_t least_bytes) {
    const std::uint64_t n = number(width_);
    if (n > left_ / least_bytes) throw Damaged{};
    return n;
  }
  /// The length of a list, which is absent or has the tag.
  std::uint64_t begin_list(std::uint64_t tag, std::uint64_t least_bytes) {
    const std::uint64_t found = number(4), n = count(least_bytes);
    if (found != tag && (found != 0 || n != 0)) throw Damaged{};
    return n;
  }
  static std::uint64_t padded(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }
  void skip_name() { skip(padded(count(1))); }
  void check_attributes() {
    for (std::uint64_t n = begin_list(attributes, 2 * width_ + 4); n > 0; --n) {
      skip_name();
      const std::uint64_t type = number(4);
      if (type == 0 || type >= bytes_of_type.size()) throw Damaged{};
      skip(padded(count(bytes_of_type[type]) * bytes_of_type[type]));
    }
  }

  std::ifstream& file_;
  std::uint64_t bytes_, left_;  // of the file, and of what follows
  unsigned width_, width_of_offset_;
};

}  // namespace

bool netcdf_header_is_sound(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 4> magic{};
  if (!file.read(magic.data(), magic.size()) || magic[0] != 'C' || magic[1] != 'D' || magic[2] != 'F') return true;
  const auto version = static_cast<unsigned>(magic[3]);
  if (version != 1 && version != 2 && version != 5) return true;  // the library refuses it
  try {
    Header(file, std::filesystem::file_size(path), version).check();
  } catch (const Damaged&) {
    return false;
  }
  return true;
}

}  // namespace geomesh::geomodel
