// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Extracts the triangles of faults and fractures without the tetrahedra around them, for solvers of fracture networks
/// (`output.fractures_only`).
#pragma once

#include <string>

#include "geomesh/geomodel/formats.hpp"

namespace geomesh::geomodel {

/// Returns a mesh without tetrahedra and regions: the faces on surfaces of kind fault, the nodes of these faces, and
/// the curves and named points on them. Surfaces and curves keep their ids, names and order, and nodes keep their
/// order. Fractures that cross share nodes as they do in the whole mesh. Cell arrays are dropped and point arrays are
/// kept. Precondition: no midpoints. Throws Error{usage} if no face is on a fault. O(points + faces + curves).
ModelMesh fractures_alone(const ModelMesh& mesh);

/// Returns why a file of this format cannot hold fractures without tetrahedra under these options; empty if it can.
std::string against_fractures_alone(const Format& format, const WriteOptions& options);

}  // namespace geomesh::geomodel
