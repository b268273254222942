// SPDX-License-Identifier: MIT
// The schedule of refinement. Declared in passes.hpp.
#include <optional>

#include "remesh/operations/surface_repair.hpp"
#include "remesh/passes/pass_runner.hpp"
#include "remesh/passes/passes.hpp"
#include "remesh/sizes/sizes.hpp"

namespace geomesh::remesh {

void refine_to_size(Toolbox& tools, const RefineOptions& options, const RunContext& context) {
  const PassRunner passes(tools.mesh, context, [] { return false; });
  const std::size_t most = options.max_elements;
  InVainOnSurfaces in_vain;
  const auto make_regular = [&] { make_surfaces_regular(tools, in_vain, context); };
  const auto collapse_on_surfaces = [&] { collapse_short_edges(tools, ShortEdges::on_surfaces, context); };
  const auto flip = [&] { flip_towards_delaunay(tools, context); };
  std::optional<SizeField> sparse;
  std::optional<Toolbox> apart;
  const auto inside = [&]() -> Toolbox& {  // tools with target sizes for the interior, which may be larger
    if (!(options.sparse_growth > 0)) return tools;
    sparse.emplace(sparse_sizes(tools.mesh, tools.lengths.field(), options));
    apart.emplace(tools.mesh, tools.guard, *sparse, tools.statistics);
    apart->bad_cells_may_spread = tools.bad_cells_may_spread;
    return *apart;
  };

  std::size_t n_split = 0;
  if (sizes_surfaces(options)) {
    if (options.honour == Honour::tolerance) passes.once("surfaces made regular", make_regular);
    passes.once("short edges of surfaces taken out", collapse_on_surfaces);
    passes.once("long edges of curves split", [&] { split_long_edges(tools, LongEdges::of_curves, most, context); });
    passes.once("cells flipped towards Delaunay", flip);
    passes.once("points put on surfaces", [&] { refine_surfaces(tools, most, context); });
    passes.once("long edges of surfaces split",
                [&] { n_split = split_long_edges(tools, LongEdges::of_surfaces, most, context); });
  }
  passes.once("cells flipped towards Delaunay", flip);
  passes.once("points put inside", [&] { refine_components_inside(inside(), most, context); });
  // Bisected faces have poor shapes. They can be improved only after their neighbourhood has been filled.
  if (n_split > 0) {
    const std::uint64_t flipped = tools.mesh.tick();
    passes.once("surfaces made regular", make_regular);
    passes.once("short edges of surfaces taken out", collapse_on_surfaces);
    passes.once("surfaces made regular", make_regular);
    passes.once("cells flipped towards Delaunay", [&] { flip_towards_delaunay(tools, context, flipped); });
    passes.once("points put inside where there is room", [&] { refine_inside(inside(), most, context); });
  }
  passes.once("short edges inside taken out", [&] { collapse_short_edges(tools, ShortEdges::inside, context); });
}

}  // namespace geomesh::remesh
