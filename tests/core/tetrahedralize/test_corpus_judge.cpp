// SPDX-License-Identifier: GPL-3.0-or-later
/// The judge is judged: every way of spoiling a right mesh must be noticed, by the check that is meant to.
#include <algorithm>
#include <catch2/catch.hpp>

#include "corpus_builder.hpp"
#include "corpus_run.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

struct Spoilt {
  PiecewiseLinearComplex plc;
  TetrahedralizeOptions options;
  ConstrainedTetrahedralization mesh;
  std::string faults() const {
    std::string all;
    for (const std::string& f : check_tetrahedralization(plc, options, mesh)) all += f + "; ";
    return all;
  }
};

/// Two regions, a well, points added on facets or segments.
Spoilt right_mesh(const std::string& name) {
  Spoilt s;
  s.plc = corpus_model(name).make();
  s.mesh = tetrahedralize(s.plc);
  REQUIRE(s.faults() == "");
  return s;
}

VertexIndex first_added(const ConstrainedTetrahedralization& mesh) {
  return static_cast<VertexIndex>(std::find(mesh.input_vertex.begin(), mesh.input_vertex.end(), no_vertex) -
                                  mesh.input_vertex.begin());
}

void check_noticed(const Spoilt& s, const std::string& check) { CHECK_THAT(s.faults(), Catch::Contains(check + ": ")); }

}  // namespace

TEST_CASE("the judge notices spoilt cells", "[judged][judge]") {
  SECTION("one turned inside out") {
    Spoilt s = right_mesh("nested_spheres");
    std::swap(s.mesh.tetrahedra[5][0], s.mesh.tetrahedra[5][1]);
    check_noticed(s, "cells");
  }
  SECTION("one missing") {
    Spoilt s = right_mesh("nested_spheres");
    s.mesh.tetrahedra.pop_back();
    s.mesh.component.pop_back();
    check_noticed(s, "cells");
    check_noticed(s, "volume");
  }
  SECTION("one twice") {
    Spoilt s = right_mesh("nested_spheres");
    s.mesh.tetrahedra.push_back(s.mesh.tetrahedra[0]);
    s.mesh.component.push_back(s.mesh.component[0]);
    check_noticed(s, "cells");
  }
}

TEST_CASE("the judge notices spoilt points", "[judged][judge]") {
  SECTION("an input point moved") {
    Spoilt s = right_mesh("cube_lattice_2");
    s.mesh.points[3].x += 1e-9;
    check_noticed(s, "points");
  }
  SECTION("a point that nothing uses") {
    Spoilt s = right_mesh("cube_lattice_2");
    s.mesh.points.push_back({0.3, 0.3, 0.3});
    s.mesh.input_vertex.push_back(no_vertex);
    s.mesh.origin.push_back(VertexOrigin::inside);
    check_noticed(s, "points");
  }
  SECTION("an isolated point not listed") {
    Spoilt s = right_mesh("wells_and_points");
    s.mesh.isolated_points.pop_back();
    check_noticed(s, "isolated points");
  }
  SECTION("an added point that claims to be on a facet where the boundary is kept") {
    Spoilt s = right_mesh("schonhardt_in_box_30");
    const VertexIndex v = first_added(s.mesh);
    REQUIRE(v < s.mesh.points.size());
    s.options.recover.preserve_boundary = true;
    s.mesh.origin[v] = VertexOrigin::on_facet;
    check_noticed(s, "preserve_boundary");
  }
}

TEST_CASE("the judge notices spoilt facets", "[judged][judge]") {
  Spoilt s = right_mesh("polygons_with_holes");
  SECTION("a face missing from the list") {
    s.mesh.faces.erase(s.mesh.faces.begin() + 4);
    check_noticed(s, "facets");
  }
  SECTION("a face given to another facet") {
    s.mesh.faces[0].facet = static_cast<Index>(s.plc.n_facets() - 1);
    check_noticed(s, "facets");
  }
  SECTION("a face seen from the wrong side") {
    std::swap(s.mesh.faces[0].vertices[0], s.mesh.faces[0].vertices[1]);
    check_noticed(s, "facets");
  }
  SECTION("a face twice") {
    s.mesh.faces.push_back(s.mesh.faces[0]);
    check_noticed(s, "facets");
  }
  SECTION("a facet that the model has and the mesh has not") {
    PlcBuilder more;
    more.plc = s.plc;
    const VertexIndex a = more.plc.outer_loop(0)[0], b = more.plc.outer_loop(0)[1];
    more.plc.add_triangle({a, b, more.plc.outer_loop(2)[2]});
    s.plc = more.plc;
    auto face = s.mesh.faces[0];
    face.facet = static_cast<Index>(s.plc.n_facets() - 1);
    s.mesh.faces.push_back(face);
    check_noticed(s, "facets");
  }
}

TEST_CASE("the judge notices an inner segment of a facet that is not there", "[judged][judge]") {
  Spoilt s = right_mesh("polygons_with_holes");
  const auto a = s.plc.facet_segments[0].a;
  const auto far = s.plc.outer_loop(0)[2];
  s.plc.facet_segments.push_back({0, a, far});
  check_noticed(s, "facets");
}

TEST_CASE("the judge notices spoilt segments", "[judged][judge]") {
  Spoilt s = right_mesh("wells_and_points");
  SECTION("an edge missing") {
    s.mesh.edges.pop_back();
    check_noticed(s, "segments");
  }
  SECTION("an edge that no cell has") {
    s.mesh.edges.push_back({0, 7, 0});
    check_noticed(s, "segments");
  }
}

TEST_CASE("the judge notices spoilt components", "[judged][judge]") {
  Spoilt s = right_mesh("nested_spheres");
  SECTION("a cell in the wrong one") {
    s.mesh.component[0] = s.mesh.component[0] == 0 ? 1 : 0;
    check_noticed(s, "components");
    check_noticed(s, "volume");
  }
  SECTION("two taken as one") {
    for (Index& c : s.mesh.component) c = std::min<Index>(c, 1);
    s.mesh.n_components = 2;
    s.mesh.component_seed.resize(2);
    check_noticed(s, "components");
  }
  SECTION("numbered in another order") {
    for (Index& c : s.mesh.component) c = 2 - c;
    check_noticed(s, "components");
  }
}

TEST_CASE("the judge notices a mesh that is not Delaunay", "[judged][judge]") {
  PlcBuilder b;  // a flat octahedron cut along its longest diagonal instead of the shortest
  const Vec3 e{-4, 0, 0}, w{4, 0, 0}, n{0, 3, 0}, u{0, 0, 1}, d{0, -3, 0}, l{0, 0, -1};
  const Vec3 ring[4] = {n, u, d, l};
  Spoilt s;
  for (int i = 0; i < 4; ++i) {
    b.triangle(e, ring[(i + 1) % 4], ring[i]);
    b.triangle(w, ring[i], ring[(i + 1) % 4]);
  }
  s.plc = b.plc;
  s.mesh = tetrahedralize(s.plc);
  REQUIRE(s.faults() == "");
  auto& mesh = s.mesh;
  const VertexIndex ve = b.vertex(e), vw = b.vertex(w);
  mesh.tetrahedra.clear();
  for (int i = 0; i < 4; ++i) mesh.tetrahedra.push_back({ve, vw, b.vertex(ring[i]), b.vertex(ring[(i + 1) % 4])});
  mesh.component.assign(4, 0);
  mesh.delaunay = true;
  check_noticed(s, "delaunay");
}
