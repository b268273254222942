// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <fstream>
#include <string>

#include "mesh_readers/netcdf/netcdf_header.hpp"
#include "scratch.hpp"

using namespace geomesh::geomodel;

namespace {

std::string number(std::uint64_t value, int width) {
  std::string bytes;
  for (int i = width - 1; i >= 0; --i) bytes += static_cast<char>(value >> 8 * i & 0xFF);
  return bytes;
}

/// A file with a dimension `n` of 2, a global attribute and a variable `x` of n doubles with an attribute of its own.
std::string sound_file(int version) {
  const int width = version == 5 ? 8 : 4, offset = version == 1 ? 4 : 8;
  const auto name = [&](char letter) { return number(1, width) + std::string{letter, 0, 0, 0}; };
  const std::string units =
      number(12, 4) + number(1, width) + name('u') + number(2, 4) + number(2, width) + std::string{'k', 'm', 0, 0};
  std::string file = "CDF" + number(static_cast<std::uint64_t>(version), 1) + number(0, width);
  file += number(10, 4) + number(1, width) + name('n') + number(2, width) + units;
  file += number(11, 4) + number(1, width) + name('x') + number(1, width) + number(0, width) + units + number(6, 4) +
          number(16, width);
  file += number(file.size() + static_cast<std::size_t>(offset), offset);
  return file + std::string(16, '\0');
}

std::string fault(const std::string& bytes) {
  const std::filesystem::path file = testing::scratch_folder() / "header.e";
  std::ofstream(file, std::ios::binary) << bytes;
  return netcdf_header_fault(file);
}
bool is_sound(const std::string& bytes) { return fault(bytes).empty(); }

/// The same with 5 records of `n_parts` variables, of two shorts each: 20 bytes of one variable, 4 a record of each.
std::string file_with_records(int version, int n_parts) {
  const int width = version == 5 ? 8 : 4, offset = version == 1 ? 4 : 8;
  const auto name = [&](char letter) { return number(1, width) + std::string{letter, 0, 0, 0}; };
  const std::string no_attributes = number(0, 4) + number(0, width);
  std::string file = "CDF" + number(static_cast<std::uint64_t>(version), 1) + number(5, width);
  file += number(10, 4) + number(2, width) + name('t') + number(0, width) + name('n') + number(1, width);
  file += no_attributes + number(11, 4) + number(static_cast<std::uint64_t>(n_parts), width);
  const std::size_t one = no_attributes.size() + name('x').size() + static_cast<std::size_t>(4 * width + 4 + offset);
  const std::size_t begin = file.size() + static_cast<std::size_t>(n_parts) * one;
  for (int k = 0; k < n_parts; ++k)
    file += name('x') + number(2, width) + number(0, width) + number(1, width) + no_attributes + number(3, 4) +
            number(4, width) + number(begin + 4 * static_cast<std::size_t>(k), offset);
  // Records of one variable are not padded; of several each part is, but for the last one of the file.
  return file + std::string(n_parts == 1 ? 10 : static_cast<std::size_t>(5 * 4 * n_parts - 2), '\1');
}

}  // namespace

TEST_CASE("a file of netCDF whose last records are missing is refused with their numbers", "[netcdf]") {
  for (const int version : {1, 2, 5})
    for (const int n_parts : {1, 2, 3}) {
      INFO("version " << version << ", variables " << n_parts);
      const std::string whole = file_with_records(version, n_parts);
      CHECK(fault(whole).empty());
      CHECK(fault(whole + std::string(100, '\0')).empty());
      CHECK_THAT(fault(whole.substr(0, whole.size() - 1)), Catch::Contains("of 5 records that its header counts, 4"));
      std::string streamed = whole.substr(0, whole.size() - 1);
      streamed.replace(4, version == 5 ? 8 : 4, version == 5 ? 8 : 4, '\xFF');
      CHECK(fault(streamed).empty());
    }
}

TEST_CASE("headers of classic netCDF files are sound, those of other kinds are left to their libraries", "[netcdf]") {
  for (const int version : {1, 2, 5}) CHECK(is_sound(sound_file(version)));
  CHECK(is_sound("\x89HDF\r\n\x1a\n and so on"));
  CHECK(is_sound("solid of an STL file"));
  CHECK(is_sound("CDF\x07"));
}

TEST_CASE("a header of netCDF that does not fit into its file is found, wherever it is damaged", "[netcdf]") {
  for (const int version : {1, 2, 5}) {
    const std::string whole = sound_file(version);
    for (std::size_t end = 4; end < whole.size(); ++end) {
      INFO("version " << version << ", cut at " << end);
      CHECK_FALSE(is_sound(whole.substr(0, end)));
    }
    // Every count, length of a name and id of a dimension in turn becomes far too large.
    const std::size_t width = version == 5 ? 8 : 4, list = 4 + width;
    const std::size_t n_dimensions = 4 + list, attributes = 4 + width + list + width + 4 + width;
    const std::size_t attribute = list + width + 4 + 4 + width + 4, variables = attributes + attribute;
    for (const std::size_t at :
         {n_dimensions, n_dimensions + width, attributes + 4, attributes + list, attributes + list + width + 4 + 4,
          variables + 4, variables + list, variables + list + width + 4, variables + list + width + 4 + width}) {
      INFO("version " << version << ", the number at " << at);
      std::string damaged = whole;
      damaged[at] = 0x7F;
      CHECK_FALSE(is_sound(damaged));
    }
  }
}
