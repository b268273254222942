// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Encodes pictures as PNG.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace geomesh::geomodel::page {

/// A picture: rows from the top, three bytes (red, green, blue) per pixel.
struct Picture {
  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Returns PNG data (ISO/IEC 15948), eight bits per channel. Throws std::runtime_error if zlib fails.
std::string to_png(const Picture& picture);

/// Encodes bytes as base64 (RFC 4648, section 4).
std::string base64(std::string_view bytes);

}  // namespace geomesh::geomodel::page
