// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What all ranks begin with: surfaces within the tolerance, named, few tetrahedra between them, and the sizes.
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
  /// Verified. Its faces and edges of curves, halved some times, are those of the fine mesh.
  geomodel::ModelMesh mesh;
  std::vector<Index> component;  ///< by tetrahedron: what sizes are asked of
  SizeField size;                ///< as asked
  unsigned halvings = 0;         ///< of all edges, until surfaces have these sizes
};

/// What rank 0 alone knows, for the report.
struct SparseRun {
  std::string input_json;
  std::vector<geomodel::StageRecord> stages;
  std::vector<std::string> notes, warnings;
  double estimated_elements = 0, divide_seconds = 0;  ///< processor seconds
  std::size_t broadcast_bytes = 0;
};

/// Takes the format html from a project that asks for others too, and returns a warning that says so.
std::vector<std::string> leave_out_page(geomodel::Project& project);

/// Throws Error{usage} where the project asks for what is not there on ranks.
void refuse_what_ranks_lack(const geomodel::Project& project);

/// The stages read to verify of the serial program, with few points inside. Errors as geomodel::run_project.
SparseModel make_sparse_model(const geomodel::Project& project, const RunContext& context, SparseRun& run);

/// From rank 0 to all. Returns how many bytes it is. Sizes that are a function of the place come from the project.
std::size_t broadcast(SparseModel& model, const geomodel::Project& project, const Ranks& ranks);

}  // namespace geomesh::app
