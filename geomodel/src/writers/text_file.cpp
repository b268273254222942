// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/text_file.hpp"

#include "geomesh/geomodel/writers.hpp"

namespace geomesh::geomodel {

void write_output_text(const std::filesystem::path& file, const std::function<void(OutputText&)>& compose) {
  write_complete_or_absent(file, [&](const std::filesystem::path& temporary) {
    OutputText out(temporary);
    compose(out);
    if (!out.close()) refuse_to_write(file);
  });
}

}  // namespace geomesh::geomodel
