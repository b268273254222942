// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Runs the stages refine and improve of a job, and converts the user's names to indices of the core.
#pragma once

#include "pipeline/journal.hpp"
#include "pipeline/stages/stages.hpp"

namespace geomesh::geomodel {

/// Returns a number for each facet of the PLC that is part of input triangles; facets of the same triangles share a
/// number. Polygons get no_index.
std::vector<Index> facet_parents(const Arranged& arranged);
/// Returns a number for each segment of the PLC; segments of the same curves share a number. Pieces of wells, whose
/// vertices are kept, get no_index.
std::vector<Index> segment_curves(const ModelPlc& plc);

/// Converts the mesh settings to options of the core. Throws Error{usage} if the settings name something that is no
/// unit, surface or curve of the model. `naming` has the naming rules of `mesh`.
RefineOptions refine_options(const ModelRecords& model, const ConstrainedTetrahedralization& mesh,
                             const NamingRules& naming);

/// Refines the mesh. Warnings are passed to the log and also returned: for example, that some surfaces are kept
/// exactly, or that time ran out.
RefineResult refine_model(const ModelRecords& model, ConstrainedTetrahedralization mesh, const RefineOptions& options,
                          const RunContext& context);

/// Returns the arrays named in settings.cell_arrays, with one value for each tetrahedron in order. `size` may be null
/// if the array of target sizes is not requested.
std::vector<CellArray> make_cell_arrays(const std::vector<std::string>& names,
                                        const ConstrainedTetrahedralization& mesh, const SizeField* size);

}  // namespace geomesh::geomodel
