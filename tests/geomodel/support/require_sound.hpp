// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <catch2/catch.hpp>

#include "geomesh/geomodel/arrangement.hpp"

namespace geomesh::geomodel::testing {

/// The soup passes the exact check written apart from the arrangement.
inline void require_sound(const PolygonSoup& soup) {
  const auto faults = validate_soup(soup);
  for (const SoupFault& f : faults)
    UNSCOPED_INFO(f.what << " at " << f.place.x << " " << f.place.y << " " << f.place.z);
  REQUIRE(faults.empty());
}

}  // namespace geomesh::geomodel::testing
