// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads files of fractures, as tables, polygons or ellipses.
#pragma once

#include <filesystem>
#include <vector>

#include "fractures/fracture.hpp"

namespace geomesh::geomodel {

struct FractureFileOptions {
  enum class Layout { found, polygons, ellipses } layout = Layout::found;
  bool degrees = false;  ///< whether angles of ellipses in a file without a header are in degrees
  int n_corners = 16;    ///< number of polygon corners for ellipses that do not define it
  std::string name = "fracture";
};

/// Reads the fractures of a file. Most formats have one fracture in each line:
/// - a table with a header of names: x, y, z, radius (or major and minor), dip_direction and dip, perhaps angle (of the
///   major axis in the plane, from the strike) and name; angles are in degrees;
/// - polygons as PorePy's network_3d_from_csv: x, y, z of each corner, which may begin with a line of the six bounds of
///   the domain;
/// - ellipses as PorePy's elliptic_network_3d_from_csv: center (3), major and minor half axis, angle of the major axis,
///   of the strike and of the dip, perhaps the number of corners;
/// - polygons as dfnWorks' polygons.dat: "nPolygons: N", then the number of corners and {x, y, z} of each;
/// - polygons as well-known text: POLYGON Z ((x y z, ...)). Or a file of surfaces or closed lines
///   (is_file_of_surfaces). Lines that begin with # are ignored. Throws Error{invalid_input} with file and line for a
///   word that is not a number, too few numbers, a polygon that is not plane or crosses itself, an axis that is not
///   above zero.
std::vector<Fracture> read_fracture_file(const std::filesystem::path& path, const FractureFileOptions& options);

}  // namespace geomesh::geomodel
