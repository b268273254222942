// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/words.hpp"

#include <cstdio>

namespace geomesh::geomodel {

std::string volume_words(double cubic_metres) {
  char text[64];
  if (cubic_metres >= 1e8) {
    std::snprintf(text, sizeof text, "%.4g km3", cubic_metres / 1e9);
  } else {
    std::snprintf(text, sizeof text, "%.4g m3", cubic_metres);
  }
  return text;
}

}  // namespace geomesh::geomodel
