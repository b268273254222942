// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Runs the stages refine and improve of a job, and converts the user's names to rows of the core.
#pragma once

#include "pipeline/journal.hpp"
#include "pipeline/stages/stages.hpp"

namespace geomesh::geomodel {

/// Returns for each facet of the PLC that is part of input triangles a number shared only by the facets of the same
/// triangles; no_index for polygons.
std::vector<Index> facet_parents(const Arranged& arranged);
/// Returns for each segment of the PLC a number shared by segments with the same names; no_index for pieces of wells,
/// whose vertices are kept.
std::vector<Index> segment_curves(const ModelPlc& plc);

/// Converts the settings to options of the core for this model. Throws Error{usage} if a name is none of the model's
/// units, surfaces or curves. `naming` is that of `mesh`.
RefineOptions refine_options(const ModelRecords& model, const ConstrainedTetrahedralization& mesh,
                             const NamingRules& naming);

/// Passes warnings to the log, and also returns them: for example, that places are kept exactly, or that time ran out.
RefineResult refine_model(const ModelRecords& model, ConstrainedTetrahedralization mesh, const RefineOptions& options,
                          const RunContext& context);

/// Returns the arrays named in settings.cell_arrays, one value for each tetrahedron in order. `size` may be null if it
/// is not among them.
std::vector<CellArray> make_cell_arrays(const std::vector<std::string>& names,
                                        const ConstrainedTetrahedralization& mesh, const SizeField* size);

}  // namespace geomesh::geomodel
