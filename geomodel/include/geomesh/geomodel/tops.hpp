// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Well tops: points at which a well was observed to meet a horizon. Horizons are moved vertically to pass through
/// these points.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// The key `tops` of a project: the file of well tops and how they are used.
struct TopsSpec {
  enum class Depth {
    along,  ///< depth of a top measured along the well's path from its first point
    z,      ///< depth of a top given as the project's z: elevation, or depth if `crs.z` says so
  };
  std::filesystem::path file;  ///< empty: no tops
  std::string file_as_written;
  Depth depth = Depth::along;
  /// Radius on the map within which a well top moves its horizon; 0: a fifth of the horizon's longer extent.
  double reach = 0;
};

/// One line of a table of well tops.
struct WellTop {
  std::string well, horizon;
  double depth = 0;
  std::size_t line = 0;  ///< line number in the file of tops, from 1
};

/// A well top with its position on the path of the well. Misfit: height of the top minus that of the horizon there; NaN
/// if no horizon is above or below the top.
struct FittedTop {
  std::string well, horizon;
  Vec3 place;
  double misfit_given = 0;   ///< misfit of the horizon before it was moved to fit the tops
  double misfit_fitted = 0;  ///< misfit of the horizon after it was moved to fit the tops
  double misfit_meshed = 0;  ///< of the mesh
};

/// Reads a table of well tops, with columns named well, horizon (or top, surface, marker, pick) and depth (or md, z),
/// separated by blanks, commas, semicolons or tabs. Throws Error{invalid_input} with the line if a column is missing or
/// a depth is not a number.
std::vector<WellTop> read_tops(const std::filesystem::path& file);

/// Returns the point of a well path at a depth along the path; nothing beyond the ends of the path. With `height`, the
/// first point at this z is returned instead.
std::optional<Vec3> place_on_path(const std::vector<Vec3>& path, double depth, bool height);

/// Moves the points of a horizon vertically, so that the horizon passes through the well tops. A top moves the nearest
/// part of the horizon above or below it. Between tops, the move is a sum of Wendland's functions, one for each top (H.
/// Wendland, 1995); farther than `reach` from all tops, it is 0. Triangles are not subdivided, so if a triangle has
/// more than three tops above or below it, they are fitted on average. Fills misfit_given and misfit_fitted. Cost: tops
/// times triangles, and the cube of the number of tops.
void fit_to_tops(TriangulatedSurface& horizon, std::span<FittedTop> tops, double reach);

/// Returns a well top's height minus that of the horizon's nearest triangle above or below it; NaN if there is none.
double misfit_of(const Vec3& place, std::span<const Vec3> points, std::span<const Triangle> triangles);

}  // namespace geomesh::geomodel
