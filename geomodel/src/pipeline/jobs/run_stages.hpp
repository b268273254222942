// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Runs the stages of a run in order.
#pragma once

#include <functional>

#include "pipeline/outputs/write_outputs.hpp"
#include "pipeline/stages/stages.hpp"

namespace geomesh::geomodel {

/// Runs `read`, then the stages from build to write. If the user requests to stop after a stage, the run ends there
/// with the report; after `intersect` it also writes the polygon soup and its problematic spots for viewing. No mesh is
/// written if verification finds a defect (InternalError) or an error is thrown.
JobResult run_stages(const OutputPlan& plan, StageRecorder& recorder, const std::function<Inputs(Journal&)>& read);

/// A mesh that was named and verified, but is not yet written to files. `refined.mesh` has the tetrahedra of `mesh`, in
/// the same order. `description` describes the inputs, with the target size that was used.
struct VerifiedModel {
  RefineResult refined;
  ModelMesh mesh;
  std::string description;
};
/// Runs the stages from delaunay to verify for a model without scaling of z. Throws the same errors as run_stages.
VerifiedModel mesh_and_verify(const ModelRecords& model, const SparseMeshing& sparse, Journal& journal);

}  // namespace geomesh::geomodel
