// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/model/memory_bound.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <limits>

#include "arrangement/model/ingest.hpp"
#include "common/operating_system.hpp"
#include "geomesh/core/error.hpp"

namespace geomesh::geomodel::arrangement {

std::size_t default_memory_bound() {
  constexpr std::size_t where_unknown =
      std::min<std::uint64_t>(std::uint64_t{1} << 33, std::numeric_limits<std::size_t>::max());
  const std::size_t bytes = memory_of_machine();
  return (bytes == 0 ? where_unknown : bytes) / 4 * 3;
}

void MemoryUse::refuse(const Vec3& place) const {
  char bound[40];
  std::snprintf(bound, sizeof bound, "%.3g GB", static_cast<double>(bound_) * 1e-9);
  throw Error(ErrorKind::cannot_mesh,
              "triangles meet in so many places, near " + to_text(place) +
                  " among others, that intersecting the surfaces would take more than " + bound +
                  " of memory: do surfaces coincide over a wide area, or are there triangles that cross most "
                  "others? Leave such "
                  "surfaces out, or make them coarser",
              {{}, {}, {}, {place}});
}

}  // namespace geomesh::geomodel::arrangement
