// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The stages of a run strung together.
#pragma once

#include <functional>

#include "pipeline/outputs/write_outputs.hpp"
#include "pipeline/stages/stages.hpp"

namespace geomesh::geomodel {

/// Runs `read`, then the stages build to write. With a stage to stop after, ends there with the report, and after
/// `intersect` with the soup and its offending spots for viewing. Nothing is written where verification finds a fault
/// (InternalError) or an error is thrown.
JobResult run_stages(const OutputPlan& plan, StageRecorder& recorder, const std::function<Inputs(Journal&)>& read);

/// A mesh that was named and verified, and is not written. `refined.mesh` has the tetrahedra of `mesh`, in the
/// same order. `description` is that of the inputs, with the size that was used.
struct VerifiedModel {
  RefineResult refined;
  ModelMesh mesh;
  std::string description;
};
/// The stages delaunay to verify of a model without scaling of z. Errors as run_stages.
VerifiedModel mesh_and_verify(const ModelRecords& model, const SparseMeshing& sparse, Journal& journal);

}  // namespace geomesh::geomodel
