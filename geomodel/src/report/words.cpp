// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/words.hpp"

#include <cstdio>

namespace geomesh::geomodel {

std::string volume_words(double volume, const std::string& unit) {
  char text[64];
  if (volume >= 1e8 && unit == "m") {
    std::snprintf(text, sizeof text, "%.4g km3", volume / 1e9);
  } else {
    std::snprintf(text, sizeof text, "%.4g %s3", volume, unit.c_str());
  }
  return text;
}

}  // namespace geomesh::geomodel
