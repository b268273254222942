// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Pictures as PNG bytes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace geomesh::geomodel::page {

/// Rows from the top, three bytes a pixel.
struct Picture {
  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// PNG (ISO/IEC 15948), eight bits a channel. Throws std::runtime_error where zlib fails.
std::string to_png(const Picture& picture);

/// RFC 4648, section 4.
std::string base64(std::string_view bytes);

}  // namespace geomesh::geomodel::page
