// SPDX-License-Identifier: GPL-3.0-or-later
// Writes small text files that are either complete or absent, declared in geomesh/geomodel/writers.hpp.
#include <fstream>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/writers.hpp"

namespace geomesh::geomodel {

void refuse_to_write(const std::filesystem::path& file) {
  throw Error(ErrorKind::usage, "cannot write " + file.string() + ": is the folder there, writable and not full?");
}

void write_text_file(const std::filesystem::path& file, std::string_view content) {
  write_complete_or_absent(file, [&](const std::filesystem::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    if (!out) refuse_to_write(file);
  });
}

}  // namespace geomesh::geomodel
