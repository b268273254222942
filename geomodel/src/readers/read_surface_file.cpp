// SPDX-License-Identifier: GPL-3.0-or-later
// Which reader reads a file: its content decides, its extension only where the content cannot tell.
#include <array>

#include "geomesh/geomodel/readers.hpp"
#include "readers/formats.hpp"
#include "readers/text/text.hpp"
#include "readers/vtk_legacy.hpp"

namespace geomesh::geomodel {
namespace {

struct Format {
  const char* name;
  const char* extensions;  ///< blank-separated
  bool (*recognises)(const InputFile&);
  FileContents (*read)(const InputFile&);
};

/// In the order of asking: formats that say who they are before those that are recognised by the look of their lines.
constexpr std::array formats{
    Format{"GOCAD", ".ts .ml .pl .vs .wl .mx .gp", is_gocad, read_gocad},
    Format{"PLY", ".ply", is_ply, read_ply},
    Format{"VTK XML", ".vtp .vtu", is_vtk_xml, read_vtk_xml},
    Format{"VTK legacy", ".vtk", is_vtk_legacy, read_vtk_legacy},
    Format{"OFF", ".off", is_off, read_off},
    Format{"GeoTIFF", ".tif .tiff", is_geotiff, read_geotiff},
    Format{"OMF", ".omf", is_omf, read_omf},
    Format{"DXF", ".dxf", is_dxf, read_dxf},
    Format{"Surfer grid (text)", "", is_surfer_text, read_surfer_text},
    Format{"Surfer 6 grid", "", is_surfer_6, read_surfer_6},
    Format{"Surfer 7 grid", ".grd", is_surfer_7, read_surfer_7},
    Format{"ESRI ASCII grid", ".asc", is_esri_ascii, read_esri_ascii},
    Format{"ZMAP+ grid", ".zmap .zmp", is_zmap, read_zmap},
    Format{"CPS-3 grid", ".cps3 .cps", is_cps3, read_cps3},
    Format{"Irap classic grid", "", is_irap_binary, read_irap_binary},
    Format{"Irap classic grid", ".irap .gri .fgr", is_irap_text, read_irap_text},
    Format{"EarthVision", "", is_earth_vision, read_earth_vision},
    Format{"Petrel points", "", is_petrel_points, read_petrel_points},
    Format{"STL", ".stl", is_stl, read_stl},
    Format{"OBJ", ".obj", is_obj, read_obj},
    Format{"points (XYZ, CSV)", ".xyz .csv .txt .dat .pts", is_xyz, read_xyz},
};

/// The format that the extension stands for, or nullptr.
const Format* by_extension(const InputFile& file) {
  const std::string wanted = file.extension();
  if (wanted.empty()) return nullptr;
  for (const Format& f : formats) {
    const std::string all = std::string(f.extensions) + " ";
    if (*f.extensions && all.find(wanted + " ") != std::string::npos) return &f;
  }
  return nullptr;
}

[[noreturn]] void refuse_unknown(const InputFile& file) {
  if (trim(file.text()).empty()) file.fail("the file is empty");
  if (const Format* f = by_extension(file)) {
    file.fail(std::string(looks_binary(file) ? "a binary file, not " : "does not begin as ") + f->name +
              ", though its extension says so");
  }
  std::string known;
  for (const Format& f : formats)
    if (known.find(f.name) == std::string::npos) known += std::string(known.empty() ? "" : ", ") + f.name;
  file.fail("its format is not known; these are read: " + known);
}

}  // namespace

FileContents read_surface_file(const std::filesystem::path& path) {
  const InputFile file = load_input_file(path);
  for (const Format& format : formats) {
    if (!format.recognises(file)) continue;
    return format.read(file);
  }
  refuse_unknown(file);
}

}  // namespace geomesh::geomodel
