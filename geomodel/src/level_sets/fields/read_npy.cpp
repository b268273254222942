// SPDX-License-Identifier: GPL-3.0-or-later
// Reads arrays of NumPy (format .npy 1 to 3: numpy.lib.format), declared in level_sets/fields/read_field.hpp.
#include <bit>
#include <charconv>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "level_sets/fields/read_field.hpp"
#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {
namespace {

struct NpyHeader {
  std::string type;  ///< as "<f8"
  bool is_fortran = false;
  std::vector<std::size_t> shape;
  std::size_t begin = 0;  ///< of the data
};

/// Returns the text after a key in the header of a NumPy file, which is a Python literal.
std::string_view behind(const InputFile& file, std::string_view header, std::string_view key) {
  const std::size_t at = header.find(key);
  if (at == std::string_view::npos) file.fail("its header has no " + std::string(key) + ": it is damaged");
  const std::size_t colon = header.find(':', at);
  return colon == std::string_view::npos ? std::string_view{} : header.substr(colon + 1);
}

std::vector<std::size_t> shape_of(const InputFile& file, std::string_view text) {
  const std::size_t open = text.find('('), close = text.find(')');
  if (open == std::string_view::npos || close == std::string_view::npos || close < open)
    file.fail("its header has no shape: it is damaged");
  std::vector<std::size_t> shape;
  const char *at = text.data() + open + 1, *const end = text.data() + close;
  while (at < end) {
    std::size_t n = 0;
    const auto [next, error] = std::from_chars(at, end, n);
    if (error == std::errc() && next != at) {
      shape.push_back(n);
      at = next;
    } else {
      ++at;
    }
  }
  return shape;
}

NpyHeader header_of(const InputFile& file) {
  const std::string_view bytes = file.text();
  if (bytes.size() < 12 || !bytes.starts_with("\x93NUMPY")) file.fail("is no array of NumPy (.npy)");
  const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])); };
  const bool is_short = byte(6) == 1;
  const std::size_t length =
      is_short ? byte(8) + 256 * byte(9) : byte(8) + 256 * byte(9) + 65536 * byte(10) + 16777216 * byte(11);
  NpyHeader header;
  header.begin = (is_short ? 10 : 12) + length;
  if (header.begin > bytes.size()) file.fail("the file ends within its header (truncated)");
  const std::string_view text = bytes.substr(10, header.begin - 10);
  const std::string_view type = behind(file, text, "'descr'");
  const std::size_t quote = type.find('\'');
  const std::size_t end_quote = quote == std::string_view::npos ? quote : type.find('\'', quote + 1);
  if (end_quote == std::string_view::npos) file.fail("its header names no type of numbers");
  header.type = type.substr(quote + 1, end_quote - quote - 1);
  const std::string_view order = behind(file, text, "'fortran_order'");
  header.is_fortran = order.substr(0, order.find(',')).find("True") != std::string_view::npos;
  header.shape = shape_of(file, behind(file, text, "'shape'"));
  return header;
}

template <class Number>
double number_at(const char* at, bool is_swapped) {
  char bytes[sizeof(Number)];
  std::memcpy(bytes, at, sizeof bytes);
  if (is_swapped)
    for (std::size_t i = 0; i < sizeof bytes / 2; ++i) std::swap(bytes[i], bytes[sizeof bytes - 1 - i]);
  Number value;
  std::memcpy(&value, bytes, sizeof bytes);
  return static_cast<double>(value);
}

using Decode = double (*)(const char*, bool);

Decode decoder(std::string_view kind) {
  if (kind == "f8") return number_at<double>;
  if (kind == "f4") return number_at<float>;
  if (kind == "i8") return number_at<std::int64_t>;
  if (kind == "i4") return number_at<std::int32_t>;
  if (kind == "i2") return number_at<std::int16_t>;
  if (kind == "u1") return number_at<std::uint8_t>;
  return nullptr;
}

}  // namespace

GridField::Lattice read_npy(const LevelSetSpec& spec) {
  const InputFile file = load_input_file(spec.file);
  const NpyHeader header = header_of(file);
  if (header.shape.size() != 3)
    file.fail("holds an array of " + std::to_string(header.shape.size()) + " axes; three were expected: x, y and z");
  const Decode decode = header.type.size() == 3 ? decoder(std::string_view(header.type).substr(1)) : nullptr;
  if (!decode) file.fail("its numbers are of the type " + header.type + "; float64 or float32 were expected");
  const bool is_swapped = (header.type[0] == '>') == (std::endian::native == std::endian::little);
  const std::size_t size = static_cast<std::size_t>(header.type[2] - '0');
  GridField::Lattice lattice;
  lattice.n = {header.shape[0], header.shape[1], header.shape[2]};
  lattice.origin = *spec.origin;
  lattice.spacing = *spec.spacing;
  const auto [nx, ny, nz] = lattice.n;
  const std::size_t held = (file.size() - header.begin) / size;
  if (nx == 0 || ny == 0 || nz == 0 || nx > held || ny > held / nx || nz > held / nx / ny)
    file.fail("its header names more numbers than the file holds (truncated)");
  lattice.nodes.resize(nx * ny * nz);
  for (std::size_t k = 0; k < nz; ++k)
    for (std::size_t j = 0; j < ny; ++j)
      for (std::size_t i = 0; i < nx; ++i) {
        const std::size_t row = header.is_fortran ? i + nx * (j + ny * k) : (i * ny + j) * nz + k;
        lattice.nodes[i + nx * (j + ny * k)] = decode(file.bytes.data() + header.begin + row * size, is_swapped);
      }
  return lattice;
}

}  // namespace geomesh::geomodel
