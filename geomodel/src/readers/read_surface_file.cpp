// SPDX-License-Identifier: GPL-3.0-or-later
// Which reader reads a file: its content decides, its extension only where the content cannot tell.
#include <array>

#include "geomesh/geomodel/readers.hpp"
#include "readers/formats.hpp"
#include "readers/text.hpp"

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
    Format{"OFF", ".off", is_off, read_off},
    Format{"STL", ".stl", is_stl, read_stl},
    Format{"OBJ", ".obj", is_obj, read_obj},
};

/// The format that the extension stands for, or nullptr.
const Format* by_extension(const InputFile& file) {
  const std::string wanted = file.extension();
  if (wanted.empty()) return nullptr;
  for (const Format& f : formats) {
    const std::string all = std::string(f.extensions) + " ";
    if (all.find(wanted + " ") != std::string::npos) return &f;
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
  for (const Format& f : formats) known += std::string(known.empty() ? "" : ", ") + f.name;
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
