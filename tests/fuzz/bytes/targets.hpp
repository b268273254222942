// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What takes bytes from outside: the project file, the readers of surfaces, the judge's readers, those of `convert`,
/// and of the names beside a mesh. Each target is given any bytes and must return, or refuse them with geomesh::Error.
/// Anything else is a finding. The last target, `arrange`, reads no format (arrange_target.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fuzz_bytes {

enum class Verdict { taken, refused };

struct Target {
  const char* name;
  std::vector<std::string> extensions;  ///< of files that it takes
};

/// project, surfaces, meshes, convert, names, arrange.
const std::vector<Target>& targets();

/// Hands the bytes to the target as a file with that extension. Throws whatever is no geomesh::Error.
Verdict run(std::string_view target, const std::string& extension, const std::uint8_t* data, std::size_t size);

}  // namespace fuzz_bytes
