// SPDX-License-Identifier: MIT
#include <string>

#include "remesh/operations/surface_repair.hpp"
#include "remesh/passes/passes.hpp"
#include "remesh/sizes/sizes.hpp"

namespace geomesh::remesh {

namespace {

void note_cells(const Toolbox& tools, const char* when, const RunContext& context) {
  context.note(LogLevel::debug, std::to_string(tools.mesh.n_cells()) + " cells " + when);
}

}  // namespace

void refine_to_size(Toolbox& tools, const RefineOptions& options, const RunContext& context) {
  if (!sizes_surfaces(options)) {
    flip_towards_delaunay(tools, context);
    refine_inside(tools, options.max_elements, context);
    collapse_short_edges(tools, true, context);
    return;
  }
  note_cells(tools, "before points are added for sizes", context);
  if (options.honour == Honour::tolerance) regularize_surfaces(tools, context);
  collapse_short_edges(tools, false, context);
  split_long_edges(tools, true, options.max_elements, context);
  flip_towards_delaunay(tools, context);
  refine_surfaces(tools, options.max_elements, context);
  note_cells(tools, "after points on surfaces", context);
  const std::size_t n_split = split_long_edges(tools, false, options.max_elements, context);
  flip_towards_delaunay(tools, context);
  refine_inside(tools, options.max_elements, context);
  flip_towards_delaunay(tools, context);
  note_cells(tools, "after points inside", context);
  if (n_split > 0) {
    // Bisected faces are of poor shape, and their neighbourhood is loose enough to mend them only once it is filled.
    regularize_surfaces(tools, context);
    collapse_short_edges(tools, false, context);
    regularize_surfaces(tools, context);
    flip_towards_delaunay(tools, context);
    refine_inside(tools, options.max_elements, context);
  }
  collapse_short_edges(tools, true, context);
  note_cells(tools, "at the asked sizes", context);
}

}  // namespace geomesh::remesh
