// SPDX-License-Identifier: GPL-3.0-or-later
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/writers.hpp"

namespace geomesh::geomodel {

const std::vector<std::string>& mesh_formats() {
  static const std::vector<std::string> formats{"vtu", "msh", "inp"};
  return formats;
}

const std::vector<std::string>& known_formats() {
  static const std::vector<std::string> formats = [] {
    std::vector<std::string> all = mesh_formats();
    all.emplace_back("html");
    return all;
  }();
  return formats;
}

namespace {

/// NAME.vtu and the files beside it; where one cannot be written, those before it are removed: they would be taken for
/// a whole.
void write_vtu_set(const ModelMesh& mesh, const std::vector<std::filesystem::path>& files) {
  std::size_t n_written = 0;
  try {
    write_vtu(mesh, files[n_written++]);
    write_faces_vtp(mesh, files[n_written++]);
    write_curves_vtp(mesh, files[n_written++]);
  } catch (...) {
    std::error_code ignored;
    for (std::size_t i = 0; i + 1 < n_written; ++i) std::filesystem::remove(files[i], ignored);
    throw;
  }
}

}  // namespace

std::vector<std::filesystem::path> write_format(const ModelMesh& mesh, const std::string& format,
                                                const std::filesystem::path& stem) {
  const auto with = [&](const char* ending) { return std::filesystem::path(stem.string() + ending); };
  if (format == "vtu") {
    const std::vector<std::filesystem::path> files{with(".vtu"), with(".faces.vtp"), with(".curves.vtp")};
    write_vtu_set(mesh, files);
    return files;
  }
  if (format == "msh") {
    write_gmsh41(mesh, with(".msh"));
    return {with(".msh"), with(".msh.json")};
  }
  if (format == "inp") {
    write_abaqus_inp(mesh, with(".inp"));
    return {with(".inp"), with(".inp.json")};
  }
  std::string known;
  for (const std::string& f : mesh_formats()) known += (known.empty() ? "" : ", ") + f;
  throw Error(ErrorKind::usage, "output format '" + format + "' is not known; known are " + known);
}

}  // namespace geomesh::geomodel
