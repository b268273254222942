// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Surfaces extruded from lines on a vertical section, and horizons computed from thicknesses.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// The key `extrude` of a surface: its file holds lines on a section, which are extruded along a horizontal axis.
struct ExtrudeSpec {
  int axis = -1;  ///< axis of extrusion: 0 for x, 1 for y, negative if none is requested
  double from = 0, to = 0;
};

/// Reads the lines of a section: polylines of any format that has them, or text. Each line of the text has a place
/// along the section (x, y, s or distance), a height (z, elevation, depth) and perhaps an id. Lines are parted by blank
/// lines, by `>` or by the id. Positions along the section are returned in y for lines extruded along x, else in x.
/// Throws as read_surface_file.
FileContents read_section(const std::filesystem::path& file, const ExtrudeSpec& spec);

/// Extrudes the lines from spec.from to spec.to. Closed lines (`closes`: all of them) become closed surfaces with
/// outward normals; others become sheets. Throws Error{invalid_input} if a closed line crosses itself.
TriangulatedSurface extrude_lines(const std::vector<Polyline>& lines, const ExtrudeSpec& spec, bool closes,
                                  const std::string& name);

struct BelowSurface {
  TriangulatedSurface surface;
  std::size_t n_without = 0;   ///< number of vertices of the upper surface at which no thickness is given
  std::size_t n_negative = 0;  ///< number of vertices with a negative thickness, which is taken as zero
  double least = 0, most = 0;  ///< thickness taken
};
/// Returns the surface `above`, lowered at each of its vertices by the value of `thickness` there. Triangles that have
/// a corner without thickness are left out. O(n) for evenly spaced triangles.
BelowSurface surface_below(const TriangulatedSurface& above, const TriangulatedSurface& thickness);
/// Returns the surface lowered by the same thickness everywhere.
BelowSurface surface_below(const TriangulatedSurface& above, double thickness);

}  // namespace geomesh::geomodel
