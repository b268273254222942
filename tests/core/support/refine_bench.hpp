// SPDX-License-Identifier: MIT
// A model as a mesh to be refined, for tests of operations on it.
#pragma once

#include "refine_models.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/sizes/sizes.hpp"

namespace refine_models {

using namespace geomesh::remesh;

/// A model with all that operations on its mesh need.
struct Bench {
  Model model;
  RefineOptions options;
  DomainMesh mesh;
  SurfaceGuard guard;
  SizeField size;
  RefineStatistics statistics;
  Toolbox tools;

  explicit Bench(Model m, double tolerance = 0)
      : model(std::move(m)),
        options(make_options(tolerance)),
        mesh(import_domain(model.plc, model.mesh, options)),
        guard(mesh, mesh, model.plc, options.honour, LocalTolerance(options.tolerance)),
        size(build_size_field(model.plc, mesh, options, LocalTolerance(tolerance)).all),
        tools(mesh, guard, size, statistics) {}

  static RefineOptions make_options(double tolerance) {
    RefineOptions o;
    o.size.from_input_edges = false;  // no size is asked: lengths refuse nothing
    o.size.gap_layers = 0;
    if (tolerance > 0) o.honour = Honour::tolerance, o.tolerance = tolerance;
    return o;
  }
  double volume() const {
    double v = 0;
    for (const double part : component_volumes(export_domain(mesh, model.mesh))) v += part;
    return v;
  }
};

/// Applies operate(bench, cell) to cells of a growing mesh, the k-th of every `stride`, validating after each success.
template <class Operate>
std::size_t over_cells(Bench& bench, CellIndex stride, Operate operate) {
  std::size_t done = 0;
  for (CellIndex c = 0; c < bench.mesh.n_slots() && done < 40; c += stride) {
    if (!bench.mesh.is_live(c) || !operate(bench, c)) continue;
    ++done;
    REQUIRE(bench.mesh.validate() == "");
  }
  return done;
}

}  // namespace refine_models
