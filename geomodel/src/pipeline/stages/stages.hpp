// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The stages of a run in their order. Each stage writes its findings to the journal.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geomesh/geomodel/pipeline.hpp"
#include "geomesh/geomodel/report.hpp"
#include "pipeline/journal.hpp"
#include "pipeline/records.hpp"

namespace geomesh::geomodel {

/// Runs the stage read for a project: reads files into the project's frame. Throws if inputs are certainly wrong.
Inputs read_project_model(const Project& project, Journal& journal);

/// Runs the stage read for `geomesh mesh`; a single PLC file (.poly, .smesh) is passed to the engine unchanged.
Inputs read_mesh_model(const MeshRequest& request, Journal& journal);

/// Runs the stage build for a project: applies the rules to the surfaces (holes, extensions, open bodies).
Built build_model(const Inputs& inputs, Journal& journal);
/// Replaces the stage build for `geomesh mesh`, which has no rules.
Built built_as_given(const Inputs& inputs);

/// Runs the stage intersect. Rules on crossings (erosion, onlap, ends of continuations) apply to the polygon soup.
Arranged intersect(const Inputs& inputs, const Built& built, Journal& journal);

/// Options that make the initial mesh for MPI ranks coarser: RefineOptions::sparse_growth, sparse_ratio,
/// sparse_surfaces. By default it is not coarser.
struct SparseMeshing {
  double growth = 0, ratio = 10, surfaces = 1;
};
/// Runs the stages from delaunay to improve. Throws Error{cannot_mesh} if the surfaces enclose nothing.
Meshed mesh_model(const ModelRecords& model, const SparseMeshing& sparse, Journal& journal);

/// Returns the arranged model with the scaling of z undone, as naming, verification and writing need it.
Arranged in_true_heights(const Arranged& arranged, const ZScale& scale);

/// Returns the mesh changed so that no tetrahedron has all of its corners on one of the surfaces named `split`. Call it
/// before anything is measured, so that counts and shapes are those of the written mesh.
Meshed free_split_corners(const ModelRecords& model, Meshed meshed, const std::vector<std::string>& split,
                          unsigned threads);

/// Names the mesh, and verifies what a run guarantees. Throws InternalError listing each defect of the mesh, and
/// Error{cannot_mesh} if regions do not fill the volume or changed by more than the tolerance allows.
ModelMesh name_and_verify(const ModelRecords& model, const Meshed& meshed, std::vector<CellArray> arrays,
                          Journal& journal);
/// Throws InternalError listing each defect of the finished mesh.
void require_valid(const ModelMesh& mesh, const ZScale& scale, unsigned threads);

/// Measures shapes, sizes and causes of poor elements. `mesh` has the tetrahedra of `meshed`, in the same order.
QualityReport judge_quality(const ModelRecords& model, const Meshed& meshed, const ModelMesh& mesh, unsigned threads);
/// Checks which solvers can use the elements. Precondition: tetrahedra of fault zones come last in `mesh`.
SolverVerdict judge_solvers(const Meshed& meshed, const ModelMesh& mesh, unsigned threads);
/// Measures how far the mesh's horizons are from the well tops.
std::vector<FittedTop> measure_tops(std::vector<FittedTop> tops, const ModelMesh& mesh);
/// Warns of units of the project that have no region. Returns the verdict, which counts all warnings; empty if there is
/// no project that lists the expected units.
std::string judge_model(const ModelRecords& model, const ModelMesh& mesh, Journal& journal);

/// Makes names of surfaces unique by the suffixes `_2`, `_3` ... in order; names of box sides are reserved.
void make_names_unique(std::vector<TriangulatedSurface>& surfaces);

}  // namespace geomesh::geomodel
