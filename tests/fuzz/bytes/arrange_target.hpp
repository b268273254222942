// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Bytes as small triangles on a grid of integers, where nearly everything is degenerate.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fuzz_bytes {

/// Arranges the triangles in a box, judges the soup, recovers it, and judges the mesh. Throws std::logic_error where
/// either is wrong, or where a soup that is right is refused; geomesh::Error where the arrangement refuses.
void arrange_and_recover(const std::uint8_t* data, std::size_t size);

}  // namespace fuzz_bytes
