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
  MeshCurves curves;

  HorizonOnFault() {
    add_surface("f", SurfaceKind::fault);
    add_surface("h", SurfaceKind::horizon);
    model.surfaces = {{7, "f", SurfaceKind::fault}, {8, "h", SurfaceKind::horizon}};
    model.surface_sets = {{7}, {8}};
    const auto face = [&](Triangle t, std::int32_t set, std::int32_t patch) {
      model.faces.push_back({t, 7 + set, set, patch, 1, 1, 0});
    };
    face({0, 1, 2}, 0, 1), face({1, 0, 3}, 0, 1);
    face({0, 1, 4}, 1, 2), face({1, 5, 4}, 1, 2);
    curves.curves = {{"h.border", "border"}, {"f.tip", "fault_tip"}, {"w", "well"}};
    const auto edge = [&](VertexIndex a, VertexIndex b, Index curve) { curves.edges.push_back({a, b, curve}); };
    edge(1, 2, 1), edge(2, 0, 1), edge(0, 3, 1), edge(3, 1, 1);
    edge(1, 5, 0), edge(5, 4, 0), edge(4, 0, 0);
    edge(2, 0, 2);
  }

  void add_surface(std::string name, SurfaceKind kind) {
    surfaces.emplace_back();
    surfaces.back().name = std::move(name);
    surfaces.back().kind = kind;
  }
  void border_at_0_1() { curves.edges.push_back({1, 0, 0}); }
  static std::string told(const SoupCurve& curve) {
    std::string text = curve.kind;
    text += ' ';
    return text += curve.name;
  }
  std::vector<std::string> names_at(VertexIndex a, VertexIndex b) const {
    std::vector<std::string> names;
    for (const MeshCurves::Edge& e : curves.edges)
      if (std::minmax({e.a, e.b}) == std::minmax({a, b})) names.push_back(told(curves.curves[e.curve]));
    return names;
  }
  std::vector<std::int32_t> patches() const {
    std::vector<std::int32_t> all;
    for (const ModelMesh::Face& face : model.faces) all.push_back(face.patch);
    return all;
  }
  std::vector<std::string> faults() {
    ModelMesh checked = model;
    for (Index c = 0; c < curves.curves.size(); ++c)
      checked.curves.push_back({static_cast<std::int32_t>(20 + c), curves.curves[c].name, curves.curves[c].kind});
    for (const auto& [a, b, curve] : curves.edges)
      checked.curve_edges.push_back({a, b, static_cast<std::int32_t>(20 + curve)});
    std::vector<std::string> found;
    check_curves_at_faces(checked, found);
    return found;
  }
};

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a border on which refinement put a fault is told as their intersection", "[sets]") {
  // Found by seed 902199 of the random models (--light).
  HorizonOnFault at;
  at.border_at_0_1();
  correct_by_faces(at.surfaces, at.model, at.curves);
  CHECK(at.names_at(0, 1) == Names{"intersection f*h"});
  CHECK(at.patches() == std::vector<std::int32_t>{1, 2, 3, 3});
  CHECK(at.faults().empty());
  CHECK(at.names_at(1, 2) == Names{"fault_tip f.tip"});
  CHECK(at.names_at(4, 5) == Names{"border h.border"});
  CHECK(at.names_at(2, 0) == Names{"fault_tip f.tip", "well w"});
  // Curves keep their order: by kind, then name, wells last.
  Names order;
  for (const SoupCurve& curve : at.curves.curves) order.push_back(curve.name);
  CHECK(order == Names{"h.border", "f.tip", "f*h", "w"});
}

TEST_CASE("an edge where surfaces meet without a curve gets one", "[sets]") {
  HorizonOnFault at;
  CHECK(at.faults() == Names{"1 faces at an edge where surfaces meet or end that is on no curve (rows 0)"});
  correct_by_faces(at.surfaces, at.model, at.curves);
  CHECK(at.names_at(0, 1) == Names{"intersection f*h"});
  CHECK(at.faults().empty());
}

TEST_CASE("a curve inside of a patch goes, and so does a second curve at an edge", "[sets]") {
  HorizonOnFault at;
  correct_by_faces(at.surfaces, at.model, at.curves);
  at.curves.edges.push_back({1, 4, 0});
  at.curves.edges.push_back({1, 5, 1});
  CHECK(at.faults().size() == 2);
  correct_by_faces(at.surfaces, at.model, at.curves);
  CHECK(at.names_at(1, 4).empty());
  CHECK(at.names_at(1, 5) == Names{"border h.border"});
  CHECK(at.faults().empty());
}

TEST_CASE("what the faces say already stays as it is", "[sets]") {
  HorizonOnFault at;
  correct_by_faces(at.surfaces, at.model, at.curves);
  for (ModelMesh::Face& face : at.model.faces) face.patch += 10;
  const auto patches = at.patches();
  correct_by_faces(at.surfaces, at.model, at.curves);
  CHECK(at.patches() == patches);
  at.model.faces[2].patch = 1;
  CHECK(at.faults() == Names{"1 faces whose patch differs from that of the face beside them (rows 3)"});
}
