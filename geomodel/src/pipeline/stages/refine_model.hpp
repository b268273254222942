// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Stages refine and improve of a job: the user's names become the core's rows.
#pragma once

#include "pipeline/journal.hpp"
#include "pipeline/stages/stages.hpp"

namespace geomesh::geomodel {

/// Per facet of the PLC that is a piece of input triangles a number that only pieces of the same triangles have;
/// no_index for polygons.
std::vector<Index> facet_parents(const Arranged& arranged);
/// Per segment of the PLC a number that those of the same names have in common; no_index for pieces of wells, whose
/// vertices are kept.
std::vector<Index> segment_curves(const ModelPlc& plc);

/// What the settings ask of the core for this model. Throws Error{usage} where a name is none of the model's units,
/// surfaces or curves.
/// `naming` is that of `mesh`.
RefineOptions refine_options(const ModelRecords& model, const ConstrainedTetrahedralization& mesh,
                             const NamingRules& naming);

/// Passes warnings on to the log, and returns them in the result: places that are kept exactly, out of time.
RefineResult refine_model(const ModelRecords& model, ConstrainedTetrahedralization mesh, const RefineOptions& options,
                          const RunContext& context);

/// The arrays that settings.cell_arrays names, one value for each tetrahedron in order. `size` may be null where it is
/// not among them.
std::vector<CellArray> make_cell_arrays(const std::vector<std::string>& names,
                                        const ConstrainedTetrahedralization& mesh, const SizeField* size);

}  // namespace geomesh::geomodel
