// SPDX-License-Identifier: GPL-3.0-or-later
// The forecast of what a stretched start triangulation would miss, beside that triangulation itself.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "corpus_models.hpp"
#include "corpus_transform.hpp"
#include "geomesh/core/delaunay.hpp"
#include "recover/model/declare.hpp"
#include "recover/model/presence.hpp"
#include "recover/start/scale_forecast.hpp"
#include "recover/start/start_triangulation.hpp"
#include "tetrahedralize/canonical_form.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

struct Model {
  CanonicalForm form;
  recover::DeclaredModel declared;
  std::vector<Vec3> points;  ///< with the box

  /// The corpus model with z scaled by 2^z_exponent.
  Model(const char* name, int z_exponent)
      : form(canonical_form(mapped(corpus_model(name).make(),
                                   [=](const Vec3& p) {
                                     return Vec3{p.x, p.y, std::ldexp(p.z, z_exponent)};
                                   }))),
        declared(recover::declare_constraints(form.plc, form.names, {})),
        points(
            recover::triangulate_start(form.plc, form.names, declared, {}, {}, recover::StartFrame::as_given).points) {}

  TetMesh triangulated(const std::array<int, 3>& exponents) const {
    std::vector<Vec3> scaled = points;
    for (Vec3& p : scaled)
      for (std::size_t i = 0; i < 3; ++i) p[i] = std::ldexp(p[i], exponents[i]);
    return std::move(delaunay_tetrahedralization(scaled, {}, {}).mesh);
  }
  std::size_t n_missing(const std::array<int, 3>& exponents) const {
    const std::vector<CellIndex> seen = recover::cells_of_subsegments(triangulated(exponents), declared.constraints);
    return static_cast<std::size_t>(std::count(seen.begin(), seen.end(), no_cell));
  }
};

}  // namespace

TEST_CASE("the forecast tells where a stretched frame misses far less or far more", "[recover]") {
  unsigned n_less = 0, n_more = 0;
  for (const char* name : {"pinching_layers", "nested_spheres_fine"})
    for (const int flattened : {-3, -2, 1, 2}) {
      const Model model(name, flattened);
      TetMesh cells = model.triangulated({0, 0, 0});
      const std::vector<CellIndex> seen = recover::cells_of_subsegments(cells, model.declared.constraints);
      const std::size_t missing = model.n_missing({0, 0, 0});
      recover::ConstrainedMesh mesh(std::move(cells), model.points, model.points.size() - 8);
      const recover::ScaleForecast forecast(mesh, model.declared.constraints, seen);
      const double here = forecast.n_missing({0, 0, 0});
      // Of what is there nearly all is known to be.
      CHECK(here <= static_cast<double>(missing) + 0.05 * static_cast<double>(seen.size()));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<int, 3> trial{0, 0, 0};
        ++trial[axis];
        const double actual = static_cast<double>(model.n_missing(trial)) / static_cast<double>(missing);
        const double told = forecast.n_missing(trial) / here;
        INFO(name << " z 2^" << flattened << " axis " << axis << ": " << actual << ", forecast " << told);
        if (actual < 0.8) CHECK(told < 0.8);
        if (actual > 1.5) CHECK(told > 1.2);
        n_less += actual < 0.8;
        n_more += actual > 1.5;
      }
    }
  CHECK(n_less > 3);
  CHECK(n_more > 3);
}
