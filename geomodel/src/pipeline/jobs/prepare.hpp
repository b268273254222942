// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Stages read, build and intersect of the jobs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geomesh/geomodel/pipeline.hpp"
#include "pipeline/finish.hpp"

namespace geomesh::geomodel {

/// Reads the project's files into model.surfaces / points and `wells`, in the project's frame (output.origin
/// subtracted).
void prepare_project(const Project& project, PreparedModel& model, const RunContext& context);

/// Reads the files given to `geomesh mesh`; a single PLC file (.poly, .smesh) goes to the engine as it is.
void prepare_mesh(const MeshRequest& request, PreparedModel& model, const RunContext& context);

/// Stage build: applies model.rules to the surfaces (holes, continuations, open bodies).
void build(PreparedModel& model, const RunContext& context);

/// Stage intersect: fills model.arrangement and model.plc, appends the box sides to model.surfaces.
/// Rules on crossings (erosion, onlap, ends of continuations) are applied to the soup.
void intersect(PreparedModel& model, const std::vector<Polyline>& wells, const ArrangementOptions& options,
               const RunContext& context);

/// Makes names unique by a suffix `_2`, `_3` ... in order; names of box sides are reserved.
void make_names_unique(std::vector<TriangulatedSurface>& surfaces);

}  // namespace geomesh::geomodel
