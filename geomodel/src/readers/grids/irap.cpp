// SPDX-License-Identifier: GPL-3.0-or-later
// Reads Irap classic grids (RMS), text and binary: values at nodes, with x varying fastest from the node (x0, y0),
// about which the grid is rotated. Values of 9999900 or more mean that a node has no height. The header of the text
// form: -996 ny dx dy / xmin xmax ymin ymax / nx rotation x0 y0 / seven zeros. The binary form consists of Fortran
// records, each between its length in bytes, big-endian. They hold: -996 ny xmin xmax ymin ymax dx dy / nx rotation x0
// y0 / seven zeros / values.
#include <cmath>

#include "readers/formats.hpp"
#include "readers/grids/grid.hpp"
#include "readers/text/binary.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double least_null = 9999900;
constexpr std::int32_t magic = -996;

std::size_t checked_count(const InputFile& file, std::int64_t n, const char* what) {
  if (n < 0) file.fail(std::string("the number of ") + what + " is negative: " + std::to_string(n));
  return static_cast<std::size_t>(n);
}

class Records {
 public:
  explicit Records(const InputFile& file) : file_(file) {}
  bool at_end() const { return at_ == file_.size(); }
  std::pair<std::size_t, std::size_t> next(const char* what) {
    const std::size_t left = file_.size() - at_;
    if (left < 8) fail(what, "the file ends");
    const std::size_t length = read_big<std::uint32_t>(file_.bytes, at_);
    if (length > left - 8)
      fail(what, "a record of " + std::to_string(length) + " bytes extends beyond the end of the file");
    if (read_big<std::uint32_t>(file_.bytes, at_ + 4 + length) != length)
      fail(what, "a record has two different lengths");
    const std::size_t begin = at_ + 4;
    at_ = begin + length + 4;
    return {begin, length};
  }

 private:
  [[noreturn]] void fail(const char* what, const std::string& how) const {
    file_.fail(how + " where " + what + " was expected, at byte " + std::to_string(at_) + " (truncated)");
  }
  const InputFile& file_;
  std::size_t at_ = 0;
};

}  // namespace

bool is_irap_text(const InputFile& file) {
  return Tokens(trim(file.text().substr(0, 64))).next() == "-996" && !looks_binary(file);
}

bool is_irap_binary(const InputFile& file) {
  return file.size() >= 8 && read_big<std::int32_t>(file.bytes, 0) == 32 &&
         read_big<std::int32_t>(file.bytes, 4) == magic;
}

FileContents read_irap_text(const InputFile& file) {
  TokenStream tokens(file);
  tokens.integer("-996");
  Grid grid;
  grid.n_rows = checked_count(file, tokens.integer("the number of rows"), "rows");
  grid.dx = tokens.number("the spacing in x");
  grid.dy = tokens.number("the spacing in y");
  for (int i = 0; i < 4; ++i) tokens.number("a limit of x or y");
  grid.n_columns = checked_count(file, tokens.integer("the number of columns"), "columns");
  grid.rotation = tokens.number("the rotation");
  grid.x0 = tokens.number("x of the origin");
  grid.y0 = tokens.number("y of the origin");
  for (int i = 0; i < 7; ++i) tokens.number("one of the seven zeros that end the header");
  allocate_heights(file, grid, tokens.bytes_left(), 2);
  read_heights_below(least_null, tokens, grid);
  return grid_contents(file, "Irap classic grid (text)", grid);
}

FileContents read_irap_binary(const InputFile& file) {
  Records records(file);
  Grid grid;
  const auto [first, first_length] = records.next("the first record of the header");
  const auto [second, second_length] = records.next("the second record of the header");
  const auto [third, third_length] = records.next("the third record of the header");
  if (first_length != 32 || second_length != 16 || third_length != 28)
    file.fail("the records of the header have lengths other than 32, 16 and 28");
  grid.n_rows = checked_count(file, read_big<std::int32_t>(file.bytes, first + 4), "rows");
  grid.dx = read_big<float>(file.bytes, first + 24);
  grid.dy = read_big<float>(file.bytes, first + 28);
  grid.n_columns = checked_count(file, read_big<std::int32_t>(file.bytes, second), "columns");
  grid.rotation = read_big<float>(file.bytes, second + 4);
  grid.x0 = read_big<float>(file.bytes, second + 8);
  grid.y0 = read_big<float>(file.bytes, second + 12);
  allocate_heights(file, grid, file.size(), sizeof(float));
  std::size_t n = 0;
  while (n < grid.heights.size()) {
    const auto [begin, length] = records.next("a record of values");
    if (length % sizeof(float) != 0 || length == 0 || length / sizeof(float) > grid.heights.size() - n)
      file.fail("a record of values has " + std::to_string(length) + " bytes, more or other than are left of the grid");
    for (std::size_t i = 0; i < length / sizeof(float); ++i, ++n) {
      const double value = read_big<float>(file.bytes, begin + sizeof(float) * i);
      if (value < least_null && std::isfinite(value)) grid.heights[n] = value;
    }
  }
  if (!records.at_end()) file.fail("bytes follow behind the last value of the grid: its counts are wrong");
  FileContents contents = grid_contents(file, "Irap classic grid (binary)", grid);
  contents.notes.push_back("coordinates have single precision in the file: at northings of 6e6 that is half a metre");
  return contents;
}

}  // namespace geomesh::geomodel
