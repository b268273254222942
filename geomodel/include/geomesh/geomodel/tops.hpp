// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Tops of wells: where a well was seen to meet a horizon. Horizons are moved along the vertical to pass through them.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Key `tops` of a project.
struct TopsSpec {
  enum class Depth {
    along,  ///< along the well's path from its first point
    z,      ///< the project's z: elevation, or depth as `crs.z` says
  };
  std::filesystem::path file;  ///< empty: no tops
  std::string file_as_written;
  Depth depth = Depth::along;
  double reach = 0;  ///< of a top in the map; 0: a fifth of the longer side of the horizon's bounds
};

/// One line of the table.
struct WellTop {
  std::string well, horizon;
  double depth = 0;
  std::size_t line = 0;  ///< of the file, from 1
};

/// A top that was found on its well. Misfits: height of the top less that of the horizon there; NaN: no horizon over or
/// under it.
struct FittedTop {
  std::string well, horizon;
  Vec3 place;
  double misfit_given = 0;   ///< of the horizon as it was given
  double misfit_fitted = 0;  ///< of the horizon as it was moved
  double misfit_meshed = 0;  ///< of the mesh
};

/// Columns named well, horizon (or top, surface, marker, pick) and depth (or md, z); parted by blanks, commas,
/// semicolons or tabs. Throws Error{invalid_input} with the line where a column is missing or a depth is no number.
std::vector<WellTop> read_tops(const std::filesystem::path& file);

/// Where the path is at that depth; nothing beyond its ends. `height`: the place is sought at this z in place of a
/// length along the path; the first one counts.
std::optional<Vec3> place_on_path(const std::vector<Vec3>& path, double depth, bool height);

/// Moves the horizon's points along the vertical, so that it passes through the tops. Further than `reach` from all of
/// them it is as it was. A top moves the sheet that is over or under it, the nearest one. Between tops the move is
/// a sum of Wendland's functions, one a top (H. Wendland, 1995). The triangles as they are pass through the tops;
/// where more than three tops stand over one triangle they are met in the mean. Fills both misfits. Cost: tops times
/// triangles, and the cube of the tops.
void fit_to_tops(TriangulatedSurface& horizon, std::span<FittedTop> tops, double reach);

/// Height of the place less that of the nearest of the triangles over or under it; NaN where there is none.
double misfit_of(const Vec3& place, std::span<const Vec3> points, std::span<const Triangle> triangles);

}  // namespace geomesh::geomodel
