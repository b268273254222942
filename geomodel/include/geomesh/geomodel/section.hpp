// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Surfaces made from lines of a vertical section, and horizons made from thicknesses.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Key `extrude` of a surface: its file holds lines in a section, which are drawn out along an axis of the map.
struct ExtrudeSpec {
  int axis = -1;  ///< 0: along x, 1: along y; negative: not asked
  double from = 0, to = 0;
};

/// The lines of a section: polylines of any format that has them, or text. Each line of the text has a place along the
/// section (x, y, s or distance), a height (z, elevation, depth) and perhaps an id. Lines are parted by blank lines, by
/// `>` or by the id. Places along the section come back in y for lines drawn out along x, else in x. Throws as
/// read_surface_file.
FileContents read_section(const std::filesystem::path& file, const ExtrudeSpec& spec);

/// The lines drawn out from spec.from to spec.to. Closed lines (`closes`: all of them) become closed surfaces with
/// normals outward; others become sheets. Throws Error{invalid_input} where a closed line crosses itself.
TriangulatedSurface extrude_lines(const std::vector<Polyline>& lines, const ExtrudeSpec& spec, bool closes,
                                  const std::string& name);

struct BelowSurface {
  TriangulatedSurface surface;
  std::size_t n_without = 0;   ///< vertices of the surface above where no thickness is given
  std::size_t n_negative = 0;  ///< vertices where the thickness is below zero: taken as zero
  double least = 0, most = 0;  ///< thickness taken
};
/// The surface `above`, lowered at each of its vertices by the height of `thickness` there. Triangles with a corner at
/// which there is no thickness are left out. O(n) for evenly spaced triangles.
BelowSurface surface_below(const TriangulatedSurface& above, const TriangulatedSurface& thickness);
/// Lowered by the same thickness everywhere.
BelowSurface surface_below(const TriangulatedSurface& above, double thickness);

}  // namespace geomesh::geomodel
