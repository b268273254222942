// SPDX-License-Identifier: GPL-3.0-or-later
// Curves and patches as the faces at each edge tell them.
#include <algorithm>
#include <catch2/catch.hpp>

#include "naming/patches/surface_curves.hpp"
#include "verify/curves_at_faces.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

/// A fault of two faces at the edge 0-1. One of the two faces of a horizon, which ends on the fault, has that edge,
/// too.
struct HorizonOnFault {
  std::vector<TriangulatedSurface> surfaces;
  ModelMesh model;

  HorizonOnFault() {
    add_surface("f", SurfaceKind::fault);
    add_surface("h", SurfaceKind::horizon);
    model.surfaces = {{7, "f", SurfaceKind::fault}, {8, "h", SurfaceKind::horizon}};
    model.surface_sets = {{7}, {8}};
    const auto face = [&](Triangle t, std::int32_t set) { model.faces.push_back({t, 7 + set, set, 0, 1, 1, 0}); };
    face({0, 1, 2}, 0), face({1, 0, 3}, 0);
    face({0, 1, 4}, 1), face({1, 5, 4}, 1);
  }
  void add_surface(std::string name, SurfaceKind kind) {
    surfaces.emplace_back();
    surfaces.back().name = std::move(name);
    surfaces.back().kind = kind;
  }

  /// Tells curves and patches; the curves become those of the model, with ids from 20.
  MeshCurves tell() {
    const MeshCurves told = tell_curves_and_patches(surfaces, model);
    model.curves.clear();
    model.curve_edges.clear();
    for (Index c = 0; c < told.curves.size(); ++c)
      model.curves.push_back({id_of(c), told.curves[c].name, told.curves[c].kind});
    for (const auto& [a, b, curve] : told.edges) model.curve_edges.push_back({a, b, id_of(curve)});
    return told;
  }
  static std::int32_t id_of(Index curve) { return static_cast<std::int32_t>(20 + curve); }

  std::vector<std::string> names_at(VertexIndex a, VertexIndex b) const {
    std::vector<std::string> names;
    for (const auto& e : model.curve_edges)
      if (std::minmax({e.a, e.b}) == std::minmax({a, b}))
        names.push_back(model.curves[static_cast<std::size_t>(e.curve - 20)].name);
    return names;
  }
  std::vector<std::int32_t> patches() const {
    std::vector<std::int32_t> all;
    for (const ModelMesh::Face& face : model.faces) all.push_back(face.patch);
    return all;
  }
  std::vector<std::string> faults() const {
    std::vector<std::string> found;
    check_curves_at_faces(model, found);
    return found;
  }
};

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a border on which refinement put a fault is told as their intersection", "[sets]") {
  // Found by seed 902199 of the random models (--light).
  HorizonOnFault at;
  const MeshCurves told = at.tell();
  CHECK(at.names_at(0, 1) == Names{"f*h"});
  CHECK(at.patches() == std::vector<std::int32_t>{1, 2, 3, 3});
  CHECK(at.names_at(1, 2) == Names{"f.tip"});
  CHECK(at.names_at(4, 5) == Names{"h.border"});
  CHECK(at.names_at(1, 4).empty());
  CHECK(at.faults().empty());
  Names order;  // by kind, then name
  for (const SoupCurve& curve : told.curves) order.push_back(curve.kind);
  CHECK(order == Names{"border", "fault_tip", "intersection"});
}

TEST_CASE("without the horizon the fault is one patch, and the edge on no curve", "[sets]") {
  HorizonOnFault at;
  at.model.faces.resize(2);
  at.tell();
  CHECK(at.names_at(0, 1).empty());
  CHECK(at.patches() == std::vector<std::int32_t>{1, 1});
  CHECK(at.faults().empty());
}

TEST_CASE("faces where surfaces coincide are a patch of their own, with an intersection about it", "[sets]") {
  HorizonOnFault at;
  at.model.surface_sets.push_back({7, 8});
  at.model.faces = {at.model.faces[0], at.model.faces[1]};
  at.model.faces[1].surface_set = 2;
  at.tell();
  CHECK(at.names_at(0, 1) == Names{"f*h"});
  CHECK(at.names_at(1, 3) == Names{"f*h"});
  CHECK(at.names_at(1, 2) == Names{"f.tip"});
  CHECK(at.patches() == std::vector<std::int32_t>{1, 2});
}

TEST_CASE("the verification sees edges without their curve, with two, or with one inside a patch", "[sets]") {
  HorizonOnFault good;
  good.tell();
  const auto faults_of = [&](auto&& spoil) {
    HorizonOnFault bad = good;
    spoil(bad.model);
    return bad.faults();
  };
  CHECK(faults_of([](ModelMesh& m) {
          std::erase_if(m.curve_edges, [](const auto& e) { return e.a == 0 && e.b == 1; });
        }) == Names{"1 faces at an edge where surfaces meet or end that is on no curve (rows 0)"});
  CHECK(faults_of([](ModelMesh& m) {
          m.curve_edges.push_back({5, 1, 21});
        }) == Names{"1 faces at an edge on several curves of surfaces (rows 3)"});
  CHECK(faults_of([](ModelMesh& m) {
          m.curve_edges.push_back({1, 4, 20});
        }) == Names{"1 faces at an edge on a curve inside a patch (rows 2)"});
  CHECK(faults_of([](ModelMesh& m) { m.faces[2].patch = 1; }) ==
        Names{"1 faces whose patch differs from that of the face beside them (rows 3)"});
  CHECK(faults_of([](ModelMesh& m) {
          m.curves.push_back({30, "w", "well"});
          m.curve_edges.push_back({1, 4, 30});
        }).empty());
}
