// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Parts of a VTK XML file that is only written for viewing: cells that are lists of points, and texts.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "writers/vtk_xml.hpp"

namespace geomesh::geomodel {

/// Makes a VTK array of the n texts that `text(i)` returns, each followed by a zero byte. It is only for viewing,
/// because a widely used Python reader refuses files with texts.
template <class F>
VtkArray vtk_texts(std::string name, std::size_t n, F text) {
  std::string bytes;
  for (std::size_t i = 0; i < n; ++i) bytes.append(text(i)).push_back('\0');
  const std::size_t n_bytes = bytes.size();
  return {std::move(name),
          "String",
          1,
          1,
          n_bytes,
          [bytes = std::move(bytes)](std::size_t first, std::size_t last, std::byte* out) {
            std::memcpy(out, bytes.data() + first, last - first);
          }};
}

/// Makes a section of cells of a VTK XML file from lists of points, as the arrays `connectivity` and `offsets`.
VtkSection vtk_cells(const char* tag, std::vector<std::vector<VertexIndex>> lists);
VtkSection vtk_points(const std::vector<Vec3>& points);

}  // namespace geomesh::geomodel
