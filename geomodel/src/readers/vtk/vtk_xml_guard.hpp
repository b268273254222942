// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What VTK's XML readers do not survive (9.1 at least), looked for before they see a file. An array without a known
/// type makes them follow a null pointer, and so does broken cell data without point data. Counts that lie make them
/// ask for all memory.
#pragma once

#include <cstddef>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace geomesh::geomodel {

/// What is wrong with the elements of a VTK XML file, "" where they are fit to be read. Looks at attributes alone:
/// `head` may end where the appended data begin. `file_size`: in bytes; compressed as they may be, so many points or
/// cells must fit into it.
std::string fault_of_vtk_elements(std::string_view head, std::size_t file_size);

/// The text of a VTK XML file with an empty element for point data in each piece that has none. Nothing where all have
/// one. Where cell data cannot be read, VTK names the point data in its message, and follows a null pointer there.
std::optional<std::string> with_point_data(std::string_view text);

/// Runs VTK's reading; false where it ran out of memory or of the largest size of an array, which sizes in a damaged
/// file do.
template <class Read>
bool survives_sizes(Read&& read) {
  try {
    read();
    return true;
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  return false;
}

}  // namespace geomesh::geomodel
