// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Stages refine and improve of a job: the user's names become the core's rows.
#pragma once

#include "pipeline/finish.hpp"

namespace geomesh::geomodel {

/// Per facet of the PLC that is a piece of input triangles a number that only pieces of the same triangles have;
/// no_index for polygons.
std::vector<Index> facet_parents(const PreparedModel& model);
/// Per segment of the PLC a number that those of the same names have in common; no_index for pieces of wells, whose
/// vertices are kept.
std::vector<Index> segment_curves(const PreparedModel& model);

/// What the settings ask of the core for this model. Throws Error{usage} where a name is none of the model's units,
/// surfaces or curves.
RefineOptions refine_options(const PreparedModel& model, const ConstrainedTetrahedralization& mesh);

/// Warns where the result is not what was asked (out of time).
RefineResult refine_model(PreparedModel& model, ConstrainedTetrahedralization mesh, const RefineOptions& options,
                          const RunContext& context);

/// The arrays that settings.cell_arrays names, one value for each tetrahedron in order. `size` may be null where it is
/// not among them.
std::vector<CellArray> make_cell_arrays(const std::vector<std::string>& names,
                                        const ConstrainedTetrahedralization& mesh, const SizeField* size);

}  // namespace geomesh::geomodel
