// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Formats coordinates of places for messages.
#pragma once

#include <cstdio>
#include <string>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

inline std::string place_words(const Vec3& p) {
  char text[100];
  std::snprintf(text, sizeof text, "(%.9g, %.9g, %.9g)", p.x, p.y, p.z);
  return text;
}

}  // namespace geomesh::geomodel
