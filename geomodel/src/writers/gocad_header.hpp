// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Makes the header of an object in a GOCAD file.
#pragma once

#include <string>

namespace geomesh::geomodel {

/// Returns the header of a GOCAD object. `type` is "TSurf" or "TSolid"; coordinates are in `unit` with z upwards.
inline std::string gocad_header(const std::string& type, const std::string& name, const std::string& unit) {
  const std::string u = "\"" + unit + "\"";
  return "GOCAD " + type + " 1\nHEADER {\nname:" + name +
         "\n}\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME Default\nAXIS_NAME \"X\" \"Y\" \"Z\"\nAXIS_UNIT " + u + " " + u +
         " " + u + "\nZPOSITIVE Elevation\nEND_ORIGINAL_COORDINATE_SYSTEM\n";
}

}  // namespace geomesh::geomodel
