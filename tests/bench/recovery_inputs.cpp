// SPDX-License-Identifier: GPL-3.0-or-later
#include "recovery_inputs.hpp"

#include <algorithm>
#include <filesystem>

#include "corpus_models.hpp"
#include "corpus_shared.hpp"
#include "needle_cad.hpp"
#include "recovery_families.hpp"
#ifdef GEOMESH_BENCH_GEOMODEL
#include "geomesh/geomodel/arrangement.hpp"
#include "noisy_faults.hpp"
#include "structural_models.hpp"
#endif

namespace geomesh::bench {

namespace {

#ifdef GEOMESH_BENCH_GEOMODEL
/// All surfaces of a folder, intersected with each other and with the sides of a box a tenth larger than they are.
PiecewiseLinearComplex intersected_faults(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  std::vector<geomodel::TriangulatedSurface> surfaces;
  geomodel::ArrangementOptions options;
  Box3 box;
  for (const std::string& path : paths) {
    const test::GocadTriangles soup = test::read_gocad_triangles(path);
    geomodel::TriangulatedSurface surface;
    surface.name = std::filesystem::path(path).stem().string();
    surface.points = soup.points;
    surface.triangles = soup.triangles;
    surfaces.push_back(surface);
    for (const Vec3& p : soup.points) box.add(p);
  }
  const Vec3 margin = 0.1 * (box.max - box.min);
  options.box = Box3{box.min - margin, box.max + margin};
  const geomodel::PolygonSoup soup = geomodel::arrange(surfaces, {}, {}, options).soup;
  PiecewiseLinearComplex plc;
  plc.points = soup.points;
  for (const Triangle& t : soup.facets) plc.add_triangle(t);
  return plc;
}
#endif

/// Plates, fans, sheets and lines that grow, so that a time which is not near to linear in them is seen.
void add_families(std::vector<RecoveryInput>& inputs) {
  const auto add = [&](const std::string& name, std::function<test::FamilyModel()> make) {
    inputs.push_back({"families/" + name, [make = std::move(make)] { return make().plc; }});
  };
  for (const unsigned n : {100u, 300u, 1000u, 3686u, 10000u})
    for (const test::CapTriangles triangles : {test::CapTriangles::turned_zigzag, test::CapTriangles::random_ears}) {
      test::PlateOptions options;
      options.n = n;
      options.triangles = triangles;
      const std::string kind = triangles == test::CapTriangles::turned_zigzag ? "turned_zigzag_" : "random_ears_";
      add("plate_" + kind + std::to_string(n), [options] { return test::plate_of_needles(options); });
    }
  for (const unsigned n : {10u, 100u, 1000u})
    add("fans_" + std::to_string(n), [n] { return test::crossing_fans(0, n, 0.01); });
  for (const unsigned n : {2u, 20u, 200u})
    add("sheets_" + std::to_string(n), [n] { return test::flat_sheets(n, 10, 5e-5); });
  for (const unsigned n : {2000u, 20000u, 200000u})
    add("line_" + std::to_string(n), [n] { return test::points_on_line(n); });
}

}  // namespace

std::vector<RecoveryInput> recovery_inputs(const std::string& data_folder) {
  std::vector<RecoveryInput> inputs;
  if (std::filesystem::exists(data_folder + "/solids"))  // else models of our own making alone
    for (const test::SharedModel& m : test::shared_models(data_folder)) inputs.push_back({m.name, m.make});
#ifdef GEOMESH_BENCH_GEOMODEL
  for (const char* group : {"SALT", "MJVA", "SNFA"}) {
    const std::string folder = data_folder + "/faults/" + group;
    if (std::filesystem::exists(folder))
      inputs.push_back({std::string("faults/") + group, [folder] { return intersected_faults(folder); }});
  }
#endif
  for (const unsigned seed : {0u, 3u, 10u, 11u})
    inputs.push_back({"made/needle_plate_" + std::to_string(seed),
                      [seed] { return test::needle_cad(seed, test::needle_cad_options(seed)).plc; }});
#ifdef GEOMESH_BENCH_GEOMODEL
  for (const unsigned seed : {0u, 1u, 2u, 3u}) {
    inputs.push_back({"made/structural_" + std::to_string(seed), [seed] {
                        using namespace geomodel::testing;
                        return structural_model(seed, structural_options(seed, 0)).plc;
                      }});
    inputs.push_back({"made/noisy_faults_" + std::to_string(seed), [seed] {
                        using namespace geomodel::testing;
                        return noisy_faults_model(seed, noisy_faults_options(seed)).plc;
                      }});
  }
#endif
  for (const char* name : {"chazelle_8", "chazelle_16", "nested_spheres_fine", "cube_lattice_12", "pinching_layers",
                           "pinching_layers_fine", "flat_layers", "flat_layers_wide", "pyramids_and_block_0.5",
                           "high_degree_vertex", "dodecahedron_icosahedron"})
    inputs.push_back({std::string("corpus/") + name, test::corpus_model(name).make});
  add_families(inputs);
  return inputs;
}

}  // namespace geomesh::bench
