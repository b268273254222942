// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The judge of every result of tetrahedralize(): decides in exact arithmetic (CGAL's, not ours), from the plain arrays
/// alone, whether the mesh is what the model and the options asked for. It shares no code with recovery.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/plc.hpp"
#include "geomesh/core/tetrahedralize.hpp"

namespace geomesh::test {

/// All faults found (at most 20 a check), empty where all is well. `plc` must be valid.
///
/// 1. Points: distinct, used, input ones first, in order and unmoved; counts of added points as reported; under
/// `preserve_boundary` none
///    on a segment or facet.
/// 2. Cells: exactly positive; a face has at most two, on opposite sides; every face of the boundary belongs to a
/// facet.
/// 3. Facets: the faces listed for a facet are mesh faces that name the right cells, none twice; their border is
/// exactly the facet's loops
///    (subdivided by added points in order along each segment), their areas add up; inner segments and points are
///    there; added points lie within `added_point_ulps` ulps of the largest coordinate of their segment or plane. A
///    facet without inner segments is covered wholly or, where nothing on either side is kept, not at all.
///    Coplanar triangles that are not covered one by one are covered together: see coplanar_groups.
/// 4. Segments named by the caller are chains of mesh edges.
/// 5. Components: exactly the classes of cells joined through faces of no facet, numbered by their first facet.
/// 6. Volumes: of each component, cells and boundary faces agree exactly; and agree with the input facets exactly where
/// no point was added
///    on the boundary, else within 2 ulps of the largest coordinate times the area plus 1e-12 of itself.
/// 7. Conforming, where the result claims `delaunay`: no face between two cells, but those of `facets_not_recovered`,
/// has the
///    opposite vertex strictly inside the circumsphere (ties allowed).
///
/// O(n log n) in the size of the result.
std::vector<std::string> check_tetrahedralization(const PiecewiseLinearComplex& plc,
                                                  const TetrahedralizeOptions& options,
                                                  const ConstrainedTetrahedralization& result);

inline constexpr double added_point_ulps = 4;

}  // namespace geomesh::test
