// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_html/model/png.hpp"

#include <zlib.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace geomesh::geomodel::page {
namespace {

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255u);
  return bytes;
}

std::string chunk(const std::string& kind, const std::string& body) {
  const std::string checked = kind + body;
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(checked.data()),
                         static_cast<uInt>(checked.size()));  // safe cast: a PNG is smaller than 4 GB
  return big_endian(static_cast<std::uint32_t>(body.size())) + checked + big_endian(static_cast<std::uint32_t>(sum));
}

std::string deflated(const std::string& text) {
  uLongf size = compressBound(static_cast<uLong>(text.size()));
  std::string packed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                static_cast<uLong>(text.size()), Z_BEST_COMPRESSION) != Z_OK)
    throw std::runtime_error("zlib could not compress a picture");
  packed.resize(size);
  return packed;
}

/// Replaces each row of the picture by its differences from the row above (PNG filter Up): flat areas become zeros.
std::string filtered_rows(const Picture& picture) {
  constexpr char up = 2;
  const std::size_t stride = 3 * picture.width;
  std::string rows;
  rows.reserve((stride + 1) * picture.height);
  for (std::size_t y = 0; y < picture.height; ++y) {
    rows += up;
    for (std::size_t i = y * stride; i < (y + 1) * stride; ++i)
      rows += static_cast<char>(picture.rgb[i] - (y == 0 ? 0 : picture.rgb[i - stride]));
  }
  return rows;
}

}  // namespace

std::string to_png(const Picture& picture) {
  std::string header =
      big_endian(static_cast<std::uint32_t>(picture.width)) + big_endian(static_cast<std::uint32_t>(picture.height));
  header += {8, 2, 0, 0, 0};  // PNG: 8 bits per channel, RGB, deflate, the five standard filters, no interlace
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", deflated(filtered_rows(picture))) +
         chunk("IEND", "");
}

std::string base64(std::string_view bytes) {
  static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += k <= n ? digits[group >> (18 - 6 * k) & 63u] : '=';
  }
  return out;
}

}  // namespace geomesh::geomodel::page
