// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_readers/netcdf/netcdf_header.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <vector>

namespace geomesh::geomodel {
namespace {

struct Damaged {};
struct MissingRecords {
  std::uint64_t counted, there;
};

/// Number of bytes of a netCDF value by the number of its type, from 1.
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
    n_records_ = number(width_);
    const std::uint64_t n_dimensions = begin_list(dimensions, 2 * width_);
    for (std::uint64_t i = 0; i < n_dimensions; ++i) {
      skip_name();
      lengths_.push_back(number(width_));
    }
    check_attributes();
    for (std::uint64_t n = begin_list(variables, 4 * width_); n > 0; --n) check_variable();
    check_records();
  }

 private:
  struct PartOfRecord {
    std::uint64_t begin, bytes;
  };

  void check_variable() {
    skip_name();
    std::uint64_t n_values = 1;
    bool has_records = false;
    for (std::uint64_t rank = count(width_); rank > 0; --rank) {
      const std::uint64_t dimension = number(width_);
      if (dimension >= lengths_.size()) throw Damaged{};
      const std::uint64_t length = lengths_[dimension];
      if (length != 0 && n_values > bytes_ / length) throw Damaged{};
      if (length == 0) has_records = true;
      n_values *= length == 0 ? 1 : length;
    }
    check_attributes();
    const std::uint64_t type = number(4);
    if (type == 0 || type >= bytes_of_type.size()) throw Damaged{};
    number(width_);
    const std::uint64_t begin = number(width_of_offset_), bytes = n_values * bytes_of_type[type];
    if (has_records) {
      parts_.push_back({begin, bytes});
    } else {
      check_extent(begin, bytes);
    }
  }

  /// Checks that all records lie in the netCDF file. A file written as a stream does not say how many records it has.
  void check_records() const {
    const std::uint64_t unknown = width_ == 8 ? ~std::uint64_t{0} : 0xFFFFFFFF;
    if (n_records_ == 0 || n_records_ == unknown || parts_.empty()) return;
    std::uint64_t record = 0;
    for (const PartOfRecord& part : parts_) record += parts_.size() == 1 ? part.bytes : padded(part.bytes);
    for (const PartOfRecord& part : parts_) {
      if (part.begin > bytes_ || part.bytes > bytes_ - part.begin) throw Damaged{};
      const std::uint64_t there = record == 0 ? n_records_ : (bytes_ - part.begin - part.bytes) / record + 1;
      if (there < n_records_) throw MissingRecords{n_records_, there};
    }
  }

  /// Checks that the values of a variable end within the file, because the netCDF library reads zeros beyond its end.
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
  /// Reads a count in a netCDF header. Throws if less of the file is left than `least_bytes` for each item counted.
  std::uint64_t count(std::uint64_t least_bytes) {
    const std::uint64_t n = number(width_);
    if (n > left_ / least_bytes) throw Damaged{};
    return n;
  }
  /// Reads the tag and the length of a list in a netCDF header. Returns the length, which is 0 if the list is absent.
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
  std::uint64_t bytes_, left_;  // number of bytes of the file, and of the part that was not read yet
  unsigned width_, width_of_offset_;
  std::uint64_t n_records_ = 0;
  std::vector<std::uint64_t> lengths_;  // lengths of the netCDF file's dimensions; 0 for the unlimited one
  std::vector<PartOfRecord> parts_;
};

}  // namespace

std::string netcdf_header_fault(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 4> magic{};
  if (!file.read(magic.data(), magic.size()) || magic[0] != 'C' || magic[1] != 'D' || magic[2] != 'F') return "";
  const auto version = static_cast<unsigned>(magic[3]);
  if (version != 1 && version != 2 && version != 5) return "";  // the netCDF library refuses all but CDF-1, -2, -5
  try {
    Header(file, std::filesystem::file_size(path), version).check();
  } catch (const Damaged&) {
    return "its header does not fit into the file: it is damaged";
  } catch (const MissingRecords& missing) {
    return "it is cut short or damaged: of " + std::to_string(missing.counted) + " records that its header counts, " +
           std::to_string(missing.there) + " are whole in the file; copy or write it again";
  }
  return "";
}

}  // namespace geomesh::geomodel
