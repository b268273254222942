// SPDX-License-Identifier: GPL-3.0-or-later
// Images of a model that are exact (renumbered, axes permuted, mirrored, scaled by powers of two, moved) are meshed
// alike: the same counts in the report, and where the model has no symmetry of its own, the image of the same mesh.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "corpus_random.hpp"
#include "corpus_run.hpp"
#include "corpus_transform.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

struct Image {
  const char* name;
  PointMap map;
  int orientation = 1;
  std::uint64_t shuffle = 0;  ///< 0: numbered as the model

  PiecewiseLinearComplex of(const PiecewiseLinearComplex& plc) const {
    const PiecewiseLinearComplex image = mapped(plc, map, orientation);
    return shuffle == 0 ? image : shuffled(image, shuffle);
  }
};

std::vector<Image> exact_images() {
  return {{"shuffled", scaled(0), 1, 11},
          {"axes permuted", axes_permuted()},
          {"mirrored", mirrored(), -1},
          {"scaled down", scaled(-17)},
          {"scaled up", scaled(23)},
          {"mirrored, axes permuted and shuffled",
           [](const Vec3& p) {
             return Vec3{p.z, -p.x, p.y};
           },
           -1, 5}};
}

/// In [1, 1.25): moves by quarters that stay below 2 are exact, and added points are rounded to the same grid there.
PiecewiseLinearComplex within_one_binade(const PiecewiseLinearComplex& plc) {
  Box3 box;
  for (const Vec3& p : plc.points) box.add(p);
  const double extent = std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
  const double scale = std::ldexp(1.0, -std::ilogb(extent) - 3);
  return mapped(plc, [&](const Vec3& p) { return Vec3{1, 1, 1} + scale * (p - box.min); });
}

std::vector<Image> moves() {
  return {{"moved", moved({0.25, 0.5, 0.125})},
          {"moved and mirrored",
           [](const Vec3& p) {
             return Vec3{p.x + 0.5, -p.y, p.z + 0.25};
           },
           -1}};
}

std::vector<TetrahedralizeOptions> all_modes() { return {constrained_mode(), preserving_mode(), conforming_mode()}; }
/// Conforming mode adds points by the hundred: every fifth model will do.
std::vector<TetrahedralizeOptions> modes_for(std::uint64_t seed) {
  return seed % 5 == 0 ? all_modes() : std::vector{constrained_mode(), preserving_mode()};
}

struct Counted {
  const char* name;
  std::size_t n;
  friend bool operator==(const Counted& a, const Counted& b) { return a.n == b.n; }
  friend std::ostream& operator<<(std::ostream& out, const Counted& c) { return out << c.name << ' ' << c.n; }
};

std::vector<Counted> counts(const ConstrainedTetrahedralization& mesh) {
  const RecoveryStatistics& s = mesh.recovery;
  return {{"segments", s.segments_total},
          {"facets", s.facets_total},
          {"edges missing", s.missing_edges_initial},
          {"facets missing before segments", s.missing_facets_before_segments},
          {"facets missing", s.missing_facets_initial},
          {"edges reinserted", s.edges_reinserted},
          {"facets reinserted", s.facets_reinserted},
          {"facets given up", s.facets_not_recovered.size()},
          {"points on segments", s.steiner_on_segments},
          {"points on facets", s.steiner_on_facets},
          {"points inside", s.steiner_inside},
          {"cells unconstrained", s.tetrahedra_unconstrained},
          {"cells", s.tetrahedra_final},
          {"faces", mesh.faces.size()},
          {"edges", mesh.edges.size()},
          {"components", mesh.n_components}};
}

using Cell = std::array<std::array<double, 3>, 4>;

/// By coordinates, so that numbers and orientations do not matter. Sorted.
std::vector<Cell> cells(const ConstrainedTetrahedralization& mesh, const PointMap& map) {
  std::vector<Cell> out;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    Cell cell;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 p = map(mesh.points[t[i]]);
      cell[i] = {p.x, p.y, p.z};
    }
    std::sort(cell.begin(), cell.end());
    out.push_back(cell);
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string mode_name(const TetrahedralizeOptions& options) {
  return options.recover.mode == MeshMode::conforming ? "conforming"
         : options.recover.preserve_boundary          ? "boundary kept"
                                                      : "constrained";
}

/// `has_symmetries`: the mesh of an image may be the image of another mesh, one that a symmetry of the model takes to
/// the first.
void check_images(const PiecewiseLinearComplex& plc, const std::vector<Image>& images, bool has_symmetries,
                  const std::vector<TetrahedralizeOptions>& modes = all_modes()) {
  for (TetrahedralizeOptions options : modes) {
    options.recover.max_steiner_per_facet = 100;
    INFO(mode_name(options));
    const CorpusRun reference = run_and_judge(plc, options);
    CHECK(reference.trouble == "");
    if (!reference.ok()) continue;
    for (const Image& image : images) {
      INFO(image.name);
      const ConstrainedTetrahedralization mesh = tetrahedralize(image.of(plc), options);
      CHECK(counts(mesh) == counts(*reference.mesh));
      if (!has_symmetries) CHECK((cells(mesh, scaled(0)) == cells(*reference.mesh, image.map)));
    }
  }
}

}  // namespace

TEST_CASE("exact images of random models are meshed alike in every mode", "[recover][metamorphic]") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    check_images(random_generic_plc(seed), exact_images(), false, modes_for(seed));
  }
}

TEST_CASE("random models are meshed alike wherever they are moved without rounding", "[recover][metamorphic]") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    check_images(within_one_binade(random_generic_plc(seed)), moves(), false, modes_for(seed));
  }
}

TEST_CASE("exact images of the hard models are meshed alike in every mode", "[recover][metamorphic][corpus]") {
  for (const CorpusModel& model : corpus_models()) {
    if (model.is_large) continue;
    INFO(model.name);
    check_images(model.make(), exact_images(), true);
  }
}

TEST_CASE("exact images of the hard models, pushed off their symmetries, are meshed alike",
          "[recover][metamorphic][corpus]") {
  const PointMap skewed = [](const Vec3& p) { return Vec3{p.x + 0.25 * p.y, p.y + 0.125 * p.z, p.z + 0.0625 * p.x}; };
  for (const char* name : {"schonhardt_30", "schonhardt_in_box_30", "chazelle_4", "hanging_plates_4",
                           "high_degree_vertex", "wedge_in_box_1e-3"}) {
    INFO(name);
    check_images(mapped(as_triangles(corpus_model(name).make()), skewed), exact_images(), false);
  }
}

TEST_CASE("random models whose points lie on a grid are meshed alike in every exact image", "[recover][metamorphic]") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    check_images(random_plc(seed), exact_images(), true, modes_for(seed));
  }
}

TEST_CASE("a model is meshed in the same way whichever way its points were inserted", "[recover][metamorphic]") {
  for (const char* name :
       {"schonhardt_in_box_30", "chazelle_4", "hanging_plates_4", "pinching_horizons", "flat_layers"}) {
    INFO(name);
    const PiecewiseLinearComplex plc = corpus_model(name).make();
    TetrahedralizeOptions options;
    options.delaunay.cluster_distance = 0;
    const ConstrainedTetrahedralization reference = tetrahedralize(plc, options);
    TetrahedralizeOptions waiting = options, flips = options;
    waiting.delaunay.cluster_distance = 10;
    flips.delaunay.algorithm = DelaunayAlgorithm::flip;
    for (const TetrahedralizeOptions& other : {waiting, flips}) {
      const ConstrainedTetrahedralization mesh = tetrahedralize(plc, other);
      CHECK(mesh.tetrahedra == reference.tetrahedra);
      CHECK((mesh.points == reference.points));
    }
  }
}
