// SPDX-License-Identifier: GPL-3.0-or-later
// The names of the temporary files of this process, in fixed storage, so that a signal handler can remove the files.
#include <array>
#include <atomic>
#include <cstring>

#include "common/operating_system.hpp"
#include "geomesh/geomodel/writers.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::size_t most_files = 64, longest_name = 4096;

/// A slot for the name of one file that is being written. The signal handler reads the name only if `ready` says that
/// it is complete.
struct Place {
  std::atomic<bool> claimed{false}, ready{false};
  std::array<char, longest_name> name{};
};
std::array<Place, most_files> places;

}  // namespace

FileBeingWritten::FileBeingWritten(const std::filesystem::path& temporary) {
  const std::string name = temporary.string();
  if (name.size() >= longest_name) return;
  for (Place& place : places) {
    if (place.claimed.exchange(true)) continue;
    std::memcpy(place.name.data(), name.c_str(), name.size() + 1);
    place.ready = true;
    place_ = &place;
    return;
  }
}

FileBeingWritten::~FileBeingWritten() {
  if (!place_) return;
  auto& place = *static_cast<Place*>(place_);
  place.ready = false;
  place.claimed = false;
}

void remove_files_being_written() noexcept {
  for (const Place& place : places)
    if (place.ready) remove_in_handler(place.name.data());
}

}  // namespace geomesh::geomodel
