// SPDX-License-Identifier: GPL-3.0-or-later
// The entry of libFuzzer for single readers: GEOMESH_FUZZ_READER is a call that reads `file`. A reader returns or
// throws geomesh::Error; anything else is a finding. These programs hold the reader's own rooms and nothing else, so
// that they are built in a minute.
#include <unistd.h>

#include <fstream>

#include "geomesh/core/error.hpp"
#include "mesh_readers/mesh_readers.hpp"
#include "vtk_files/vtk_data.hpp"

namespace {

using namespace geomesh::geomodel;

[[maybe_unused]] void read_vtk(const InputFile& file) {
  if (is_vtk_legacy(file))
    read_vtk_legacy_data(file);
  else
    read_vtk_xml_data(file);
}

/// For a reader that opens the file by its name, through a library.
[[maybe_unused]] void read_exodus(const InputFile& file) {
  const std::string name = "/dev/shm/geomesh_fuzz_" + std::to_string(getpid()) + ".e";
  std::ofstream(name, std::ios::binary).write(file.bytes.data(), static_cast<std::streamsize>(file.bytes.size()));
  read_exodus_mesh(name);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const InputFile file{"fuzzed", std::string(reinterpret_cast<const char*>(data), size)};
  try {
    GEOMESH_FUZZ_READER(file);
  } catch (const geomesh::Error&) {
  }
  return 0;
}
