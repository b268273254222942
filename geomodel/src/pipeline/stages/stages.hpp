// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The stages of a run, in order. Each tells what it found in the journal.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geomesh/geomodel/pipeline.hpp"
#include "geomesh/geomodel/report.hpp"
#include "pipeline/journal.hpp"
#include "pipeline/records.hpp"

namespace geomesh::geomodel {

/// Stage read of a project: its files, in the project's frame. Nonsense ends the run here, before anything is built.
Inputs read_project_model(const Project& project, Journal& journal);

/// Stage read of `geomesh mesh`; a single PLC file (.poly, .smesh) goes to the engine as it is.
Inputs read_mesh_model(const MeshRequest& request, Journal& journal);

/// Stage build of a project: applies the rules to the surfaces (holes, continuations, open bodies).
Built build_model(const Inputs& inputs, Journal& journal);
/// Of `geomesh mesh`: no rules, and no stage.
Built built_as_given(const Inputs& inputs);

/// Stage intersect. Rules on crossings (erosion, onlap, ends of continuations) are applied to the soup.
Arranged intersect(const Inputs& inputs, const Built& built, Journal& journal);

/// How coarse a start for ranks is: RefineOptions::sparse_growth, sparse_ratio, sparse_surfaces. As it stands: not at
/// all.
struct SparseMeshing {
  double growth = 0, ratio = 10, surfaces = 1;
};
/// Stages delaunay to improve. Throws Error{cannot_mesh} where the surfaces enclose nothing.
Meshed mesh_model(const ModelRecords& model, const SparseMeshing& sparse, Journal& journal);

/// The record as it is without scaling of z: what naming, verification and writing read.
Arranged in_true_heights(const Arranged& arranged, const ZScale& scale);

/// The mesh with no tetrahedron that has all of its corners on one of the surfaces named `split`. It comes before
/// anything is measured: counts and shapes are those of the mesh that is written.
Meshed free_split_corners(const ModelRecords& model, Meshed meshed, const std::vector<std::string>& split,
                          unsigned threads);

/// Names the mesh, and verifies that it holds what a run promises. Throws InternalError with each fault;
/// Error{cannot_mesh} where regions do not fill the volume or have changed by more than the tolerance allows.
ModelMesh name_and_verify(const ModelRecords& model, const Meshed& meshed, std::vector<CellArray> arrays,
                          Journal& journal);
/// Throws InternalError with each fault of the finished mesh.
void require_valid(const ModelMesh& mesh, const ZScale& scale, unsigned threads);

/// Shapes, sizes and causes of poor elements. The tetrahedra of `mesh` are those of `meshed`, in the same order.
QualityReport judge_quality(const ModelRecords& model, const Meshed& meshed, const ModelMesh& mesh, unsigned threads);
/// Whether solvers bear the elements, and which not. Tetrahedra of fault zones come last in `mesh`.
SolverVerdict judge_solvers(const Meshed& meshed, const ModelMesh& mesh, unsigned threads);
/// How far the mesh's horizons are off the tops of wells.
std::vector<FittedTop> measure_tops(std::vector<FittedTop> tops, const ModelMesh& mesh);
/// Units without a region are warned of; the verdict counts all warnings. Empty where no project says what is wanted.
std::string judge_model(const ModelRecords& model, const ModelMesh& mesh, Journal& journal);

/// Makes names unique by a suffix `_2`, `_3` ... in order; names of box sides are reserved.
void make_names_unique(std::vector<TriangulatedSurface>& surfaces);

}  // namespace geomesh::geomodel
