// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/room_on_disk.hpp"

#include "common/operating_system.hpp"
#include "geomesh/geomodel/writers.hpp"

namespace geomesh::geomodel {

void require_room(const std::filesystem::path& temporary, const std::filesystem::path& file, std::size_t bytes) {
  if (!make_file_of(temporary, bytes)) refuse_to_write(file);
}

}  // namespace geomesh::geomodel
