// SPDX-License-Identifier: MIT
// The schedule of refinement; declared in passes.hpp.
#include "remesh/operations/surface_repair.hpp"
#include "remesh/passes/pass_runner.hpp"
#include "remesh/passes/passes.hpp"
#include "remesh/passes/surface_regularizer.hpp"
#include "remesh/sizes/sizes.hpp"

namespace geomesh::remesh {

namespace {

/// The passes by name, each run once.
class RefinePasses {
 public:
  RefinePasses(Toolbox& tools, const RefineOptions& options, const RunContext& context)
      : tools_(tools),
        most_(options.max_elements),
        context_(context),
        runner_(tools.mesh, context, [] { return false; }),
        regularizer_(tools) {}

  void make_surfaces_regular() {
    run("surfaces made regular", [&] { regularizer_.run(context_); });
  }
  void collapse_on_surfaces() const {
    run("short edges of surfaces taken out", [&] { collapse_short_edges(tools_, ShortEdges::on_surfaces, context_); });
  }
  void collapse_inside() const {
    run("short edges inside taken out", [&] { collapse_short_edges(tools_, ShortEdges::inside, context_); });
  }
  void split_curves() const {
    run("long edges of curves split", [&] { split_long_edges(tools_, LongEdges::of_curves, most_, context_); });
  }
  /// Returns their number.
  std::size_t split_surfaces() const {
    std::size_t n = 0;
    run("long edges of surfaces split", [&] { n = split_long_edges(tools_, LongEdges::of_surfaces, most_, context_); });
    return n;
  }
  void flip() const {
    run("cells flipped towards Delaunay", [&] { flip_towards_delaunay(tools_, context_); });
  }
  void fill_surfaces() const {
    run("points put on surfaces", [&] { refine_surfaces(tools_, most_, context_); });
  }
  void fill_components() const {
    run("points put inside", [&] { refine_components_inside(tools_, most_, context_); });
  }
  void fill_inside() const {
    run("points put inside where there is room", [&] { refine_inside(tools_, most_, context_); });
  }

 private:
  template <class Work>
  void run(std::string_view name, const Work& work) const {
    const auto once = [&](unsigned) {
      work();
      return Next::done;
    };
    runner_.run({.name = name, .round = once});
  }

  Toolbox& tools_;
  std::size_t most_;  // cells
  const RunContext& context_;
  PassRunner runner_;
  SurfaceRegularizer regularizer_;
};

}  // namespace

void refine_to_size(Toolbox& tools, const RefineOptions& options, const RunContext& context) {
  RefinePasses passes(tools, options, context);
  if (!sizes_surfaces(options)) {
    passes.flip();
    passes.fill_components();
    passes.collapse_inside();
    return;
  }
  if (options.honour == Honour::tolerance) passes.make_surfaces_regular();
  passes.collapse_on_surfaces();
  passes.split_curves();
  passes.flip();
  passes.fill_surfaces();
  const std::size_t n_split = passes.split_surfaces();
  passes.flip();
  passes.fill_components();
  passes.flip();
  // Bisected faces are of poor shape. Their neighbourhood is loose enough to mend them only once it is filled.
  if (n_split > 0) {
    passes.make_surfaces_regular();
    passes.collapse_on_surfaces();
    passes.make_surfaces_regular();
    passes.flip();
    passes.fill_inside();
  }
  passes.collapse_inside();
}

}  // namespace geomesh::remesh
