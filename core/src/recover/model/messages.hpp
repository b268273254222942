// SPDX-License-Identifier: MIT
/// @file
/// Formats messages of recovery about items of the model.
#pragma once

#include <string>
#include <vector>

#include "recover/model/recover.hpp"

namespace geomesh::recover {

std::string describe_vertex(const Recovery& recovery, VertexIndex v);
std::string describe_edge(const Recovery& recovery, VertexIndex a, VertexIndex b);
std::string describe_subfacet(const Recovery& recovery, Index subfacet);

/// Returns the facets (rows of the PLC) that have this subsegment on their border.
std::vector<Index> facets_of_subsegment(const Recovery& recovery, Index subsegment);

/// Returns whether all of these vertices are from the input, so that contradictions are errors of the input.
bool all_input(const Recovery& recovery, std::initializer_list<VertexIndex> vertices);

Error error_of_vertex_on_segment(const Recovery& recovery, VertexIndex v, Index subsegment);
Error error_of_segments_cross(const Recovery& recovery, Index s, Index t);
Error error_of_vertex_on_facet(const Recovery& recovery, VertexIndex v, Index subfacet);
Error error_of_segment_pierces_facet(const Recovery& recovery, Index subsegment, Index subfacet);
Error error_of_segment_not_recovered(const Recovery& recovery, Index subsegment);
Error error_of_facet_not_recovered(const Recovery& recovery, Index subfacet);

/// Returns the error for Steiner points that cannot be replaced by any double near them.
Error error_of_rounding(const Recovery& recovery, const std::vector<VertexIndex>& points);

}  // namespace geomesh::recover
