// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Well tops: points at which a well was observed to meet a horizon. Horizons are moved vertically so that they pass
/// through them.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// The key `tops` of a project.
struct TopsSpec {
  enum class Depth {
    along,  ///< depth measured along the well's path from its first point
    z,      ///< the project's z: elevation, or depth if `crs.z` says so
  };
  std::filesystem::path file;  ///< empty: no tops
  std::string file_as_written;
  Depth depth = Depth::along;
  /// Radius on the map within which a top has an effect; 0: a fifth of the longer side of the horizon's bounding box.
  double reach = 0;
};

/// One line of the table of tops.
struct WellTop {
  std::string well, horizon;
  double depth = 0;
  std::size_t line = 0;  ///< line number in the file, from 1
};

/// A top located on its well. Misfit: height of the top minus that of the horizon there; NaN if no horizon is above or
/// below it.
struct FittedTop {
  std::string well, horizon;
  Vec3 place;
  double misfit_given = 0;   ///< misfit of the horizon as given
  double misfit_fitted = 0;  ///< misfit of the horizon after it was moved
  double misfit_meshed = 0;  ///< of the mesh
};

/// Reads a table with columns named well, horizon (or top, surface, marker, pick) and depth (or md, z), separated by
/// blanks, commas, semicolons or tabs. Throws Error{invalid_input} with the line if a column is missing or a depth is
/// not a number.
std::vector<WellTop> read_tops(const std::filesystem::path& file);

/// Returns the point of the path at that depth; nothing beyond its ends. With `height`, the first point at this z is
/// returned instead of one by length along the path.
std::optional<Vec3> place_on_path(const std::vector<Vec3>& path, double depth, bool height);

/// Moves the horizon's points along the vertical, so that it passes through the tops. Farther than `reach` from all of
/// them it is not changed. A top moves the sheet that is over or under it, the nearest one. Between tops the move is a
/// sum of Wendland's functions, one a top (H. Wendland, 1995). The triangles are not subdivided; if a triangle has more
/// than three tops above or below it, they are fitted on average. Fills both misfits. Cost: tops times triangles, and
/// the cube of the tops.
void fit_to_tops(TriangulatedSurface& horizon, std::span<FittedTop> tops, double reach);

/// Returns the height of the place minus that of the nearest triangle above or below it; NaN if there is none.
double misfit_of(const Vec3& place, std::span<const Vec3> points, std::span<const Triangle> triangles);

}  // namespace geomesh::geomodel
