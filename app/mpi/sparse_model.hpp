// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The data with which all ranks start: surfaces within the tolerance, few tetrahedra between them, and the sizes.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/size_field.hpp"
#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/project.hpp"
#include "geomesh/geomodel/report.hpp"
#include "ranks.hpp"

namespace geomesh::app {

struct SparseModel {
  /// The verified mesh. Its faces and edges of curves, halved `halvings` times, are those of the fine mesh.
  geomodel::ModelMesh mesh;
  std::vector<Index> component;  ///< for each tetrahedron the connected part of its region, on which sizes depend
  SizeField size;                ///< as requested
  unsigned halvings = 0;         ///< number of times that all edges are halved before surfaces have the target sizes
};

/// Data that only rank 0 has, for the report.
struct SparseRun {
  std::string input_json;
  std::vector<geomodel::StageRecord> stages;
  std::vector<std::string> notes, warnings;
  double estimated_elements = 0, divide_seconds = 0;  ///< processor seconds
  std::size_t broadcast_bytes = 0;
};

/// Removes the format html from a project that requests other formats too, and returns a warning.
std::vector<std::string> leave_out_page(geomodel::Project& project);

/// Throws Error{usage} if the project requests something that is not supported on ranks.
void refuse_what_ranks_lack(const geomodel::Project& project);

/// Runs the serial program's stages from `read` to `verify`, with few points in regions. Errors: those of run_project.
SparseModel make_sparse_model(const geomodel::Project& project, const RunContext& context, SparseRun& run);

/// Sends the model from rank 0 to all ranks. Returns its size in bytes. Target sizes that are a function of position
/// are not sent; each rank reads them from the project.
std::size_t broadcast(SparseModel& model, const geomodel::Project& project, const Ranks& ranks);

}  // namespace geomesh::app
