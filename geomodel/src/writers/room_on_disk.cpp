// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/room_on_disk.hpp"

#include <fcntl.h>
#include <unistd.h>

#include "geomesh/geomodel/writers.hpp"

namespace geomesh::geomodel {

void require_room(const std::filesystem::path& temporary, const std::filesystem::path& file, std::size_t bytes) {
  constexpr mode_t readable_by_all = 0666;  // less what the user's mask takes away
  const int descriptor = open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, readable_by_all);
  if (descriptor < 0) refuse_to_write(file);
  const int status = posix_fallocate(descriptor, 0, static_cast<off_t>(bytes));
  if (close(descriptor) != 0 || status != 0) refuse_to_write(file);
}

}  // namespace geomesh::geomodel
