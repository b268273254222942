// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writers, one format a file under src/writers. Each writes beside the target and renames, so that a file is complete or absent.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

void write_vtu(const ModelMesh& mesh, const std::filesystem::path& file);
void write_faces_vtp(const ModelMesh& mesh, const std::filesystem::path& file);
void write_curves_vtp(const ModelMesh& mesh, const std::filesystem::path& file);
void write_gmsh41(const ModelMesh& mesh, const std::filesystem::path& file);
void write_abaqus_inp(const ModelMesh& mesh, const std::filesystem::path& file);

/// Formats of a mesh: vtu (VTU + faces + curves), msh, inp.
const std::vector<std::string>& mesh_formats();
/// Names accepted in `output.formats` and, as extensions, after `-o`: those of a mesh, and html, the report as a page.
const std::vector<std::string>& known_formats();
/// Writes all files of one mesh format with `stem` (a path without extension); returns what was written.
std::vector<std::filesystem::path> write_format(const ModelMesh& mesh, const std::string& format, const std::filesystem::path& stem);

/// Calls `write(temporary path)` and renames the temporary to `file`; removes it where `write` throws.
template <class F>
void write_complete_or_absent(const std::filesystem::path& file, F&& write) {
  const std::filesystem::path temporary = file.string() + ".part";
  try {
    write(temporary);
    std::filesystem::rename(temporary, file);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw;
  }
}

/// A text file, complete or absent. Throws Error{usage} where it cannot be written.
void write_text_file(const std::filesystem::path& file, std::string_view content);

}  // namespace geomesh::geomodel
