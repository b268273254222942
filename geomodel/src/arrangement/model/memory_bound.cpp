// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/model/memory_bound.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "arrangement/model/ingest.hpp"
#include "geomesh/core/error.hpp"

namespace geomesh::geomodel::arrangement {

std::size_t default_memory_bound() {
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
  std::size_t bytes =
      pages > 0 && page > 0 ? static_cast<std::size_t>(pages) * static_cast<std::size_t>(page) : std::size_t{3} << 30;
  std::size_t of_container = 0;
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> of_container)
    bytes = std::min(bytes, of_container);  // "max" is no number
  return bytes / 4 * 3;
}

void MemoryUse::refuse(const Vec3& place) const {
  char bound[40];
  std::snprintf(bound, sizeof bound, "%.3g GB", static_cast<double>(bound_) * 1e-9);
  throw Error(ErrorKind::cannot_mesh,
              "triangles meet in so many places, near " + to_text(place) +
                  " among others, that intersecting the surfaces would take more than " + bound +
                  " of memory: do surfaces lie on each other over a wide area, or are there triangles that cross most "
                  "others? Leave such "
                  "surfaces out, or make them coarser",
              {{}, {}, {}, {place}});
}

}  // namespace geomesh::geomodel::arrangement
