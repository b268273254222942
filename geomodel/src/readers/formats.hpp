// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The readers of surface files, one for each format. `is_...` examines the content (and the extension only if the
/// content does not decide); `read_...` throws Error{invalid_input} with file and line.
#pragma once

#include "geomesh/geomodel/readers.hpp"
#include "geomesh/geomodel/surface.hpp"
#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {

bool is_gocad(const InputFile& file);
FileContents read_gocad(const InputFile& file);

bool is_off(const InputFile& file);
FileContents read_off(const InputFile& file);

bool is_ply(const InputFile& file);
FileContents read_ply(const InputFile& file);

bool is_vtk_xml(const InputFile& file);
FileContents read_vtk_xml(const InputFile& file);

bool is_stl(const InputFile& file);
FileContents read_stl(const InputFile& file);

bool is_obj(const InputFile& file);
FileContents read_obj(const InputFile& file);

bool is_esri_ascii(const InputFile& file);
FileContents read_esri_ascii(const InputFile& file);

bool is_surfer_text(const InputFile& file);
FileContents read_surfer_text(const InputFile& file);

bool is_surfer_6(const InputFile& file);
FileContents read_surfer_6(const InputFile& file);

bool is_surfer_7(const InputFile& file);
FileContents read_surfer_7(const InputFile& file);

bool is_zmap(const InputFile& file);
FileContents read_zmap(const InputFile& file);

bool is_cps3(const InputFile& file);
FileContents read_cps3(const InputFile& file);

bool is_irap_text(const InputFile& file);
FileContents read_irap_text(const InputFile& file);

bool is_irap_binary(const InputFile& file);
FileContents read_irap_binary(const InputFile& file);

bool is_geotiff(const InputFile& file);
FileContents read_geotiff(const InputFile& file);

bool is_netcdf(const InputFile& file);
FileContents read_netcdf(const InputFile& file);

bool is_dxf(const InputFile& file);
FileContents read_dxf(const InputFile& file);

bool is_omf(const InputFile& file);
FileContents read_omf(const InputFile& file);

bool is_earth_vision(const InputFile& file);
FileContents read_earth_vision(const InputFile& file);

bool is_petrel_points(const InputFile& file);
FileContents read_petrel_points(const InputFile& file);

/// Shapefile, GeoPackage, GeoJSON.
bool is_vector(const InputFile& file);
FileContents read_vector(const InputFile& file);

bool is_charisma(const InputFile& file);
FileContents read_charisma(const InputFile& file);

bool is_xyz(const InputFile& file);
FileContents read_xyz(const InputFile& file);

/// Reads wells from a table: one polyline for each name in the column of well names, or a single polyline if there is
/// no such column. Throws Error{invalid_input} if the columns are not known, or if the position of the head of a
/// deviation survey is not known.
FileContents read_well_table(const InputFile& file, const WellReading& reading);

}  // namespace geomesh::geomodel
