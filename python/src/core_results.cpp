// SPDX-License-Identifier: MIT
#include "core_results.hpp"

#include <pybind11/stl.h>

namespace geomesh::python {
namespace {

using Face = ConstrainedTetrahedralization::Face;
using Edge = ConstrainedTetrahedralization::Edge;

const std::vector<Vec3>& points_of(const MeshResult& r) { return r.mesh.points; }

void define_delaunay(py::module_& module) {
  py::class_<DelaunayResult>(module, "Delaunay", "The Delaunay tetrahedralization of a point set. Arrays are views.")
      .def_readonly("points", &DelaunayResult::points,
                    "float64 (n, 3): the array given, not a copy, where it was float64 and C-contiguous.")
      .def_property_readonly(
          "tetrahedra", [](const py::object& self) { return view_rows(self.cast<DelaunayResult&>().tetrahedra, self); },
          "uint32 (m, 4): rows of points; every tetrahedron has positive volume.")
      .def_property_readonly(
          "neighbors",
          [](const py::object& self) {
            const auto& rows = self.cast<DelaunayResult&>().neighbors;
            return view(reinterpret_cast<const std::int32_t*>(rows.data()), rows.size(), 4, 16, self);
          },
          "int32 (m, 4): row of the tetrahedron opposite each vertex; -1 on the hull.")
      .def_property_readonly(
          "hull", [](const py::object& self) { return view_rows(self.cast<DelaunayResult&>().hull, self); },
          "uint32 (k, 3): triangles of the convex hull, normals outward.")
      .def_property_readonly(
          "representative",
          [](const py::object& self) { return view_numbers(self.cast<DelaunayResult&>().representative, self); },
          "uint32 (n,): each point itself, or the first point with equal coordinates, which alone is in the mesh.")
      .def_property_readonly(
          "statistics",
          [](const DelaunayResult& r) {
            py::dict d;
            d["points_deferred"] = r.statistics.points_deferred;
            d["exact_calls"] = r.statistics.exact_calls;
            d["walk_steps"] = r.statistics.walk_steps;
            return d;
          },
          "Counts: points_deferred, exact_calls (predicates decided exactly), walk_steps.");
}

/// Returns a view of members of faces and edges, with the stride of their struct.
template <class Member>
auto face_view(std::size_t width, Member member) {
  return [width, member](const py::object& self) {
    return view_member(self.cast<MeshResult&>().mesh.faces, width, self, member);
  };
}

void define_faces(py::class_<MeshResult>& type) {
  type.def_property_readonly("faces", face_view(3, [](const Face& f) { return f.vertices.data(); }),
                             "uint32 (k, 3): every mesh face that is part of a facet, once, oriented as the facet.")
      .def_property_readonly("face_facet", face_view(0, [](const Face& f) { return &f.facet; }),
                             "uint32 (k,): the facet that each face is part of.")
      .def_property_readonly("face_below", face_view(0, [](const Face& f) { return &f.tetrahedron_below; }),
                             "uint32 (k,): tetrahedron that the normal points away from; 4294967295 outside.")
      .def_property_readonly("face_above", face_view(0, [](const Face& f) { return &f.tetrahedron_above; }),
                             "uint32 (k,): tetrahedron that the normal points to; 4294967295 outside.")
      .def_property_readonly(
          "edges",
          [](const py::object& self) {
            return view_member(self.cast<MeshResult&>().mesh.edges, 2, self, [](const Edge& e) { return &e.a; });
          },
          "uint32 (l, 2): every mesh edge that is part of a segment given.")
      .def_property_readonly(
          "edge_segment",
          [](const py::object& self) {
            return view_member(self.cast<MeshResult&>().mesh.edges, 0, self, [](const Edge& e) { return &e.segment; });
          },
          "uint32 (l,): the segment that each edge is part of.");
}

void define_mesh(py::module_& module) {
  static_assert(offsetof(Edge, b) == offsetof(Edge, a) + sizeof(VertexIndex));
  py::class_<MeshResult> type(module, "Tetrahedralization",
                              "A tetrahedral mesh in which every facet given is a union of faces. Arrays are views.");
  type.def_property_readonly(
          "points", [](const py::object& self) { return view_points(points_of(self.cast<MeshResult&>()), self); },
          "float64 (n, 3): points of the input that are in the mesh first, in input order.")
      .def_property_readonly(
          "tetrahedra",
          [](const py::object& self) { return view_rows(self.cast<MeshResult&>().mesh.tetrahedra, self); },
          "uint32 (m, 4): rows of points; every tetrahedron has positive volume.")
      .def_property_readonly(
          "component",
          [](const py::object& self) { return view_numbers(self.cast<MeshResult&>().mesh.component, self); },
          "uint32 (m,): the component (what facets enclose) that each tetrahedron is in, from 0.")
      .def_property_readonly(
          "component_seed",
          [](const py::object& self) { return view_numbers(self.cast<MeshResult&>().mesh.component_seed, self); },
          "uint32 (components,): row of the region seed inside each component; 4294967295 where there is none.")
      .def_property_readonly(
          "input_vertex",
          [](const py::object& self) { return view_numbers(self.cast<MeshResult&>().mesh.input_vertex, self); },
          "uint32 (n,): row of the point in the input; 4294967295 where it was added.")
      .def_property_readonly(
          "origin",
          [](const py::object& self) {
            const auto& origin = self.cast<MeshResult&>().mesh.origin;
            return view(reinterpret_cast<const std::uint8_t*>(origin.data()), origin.size(), 0, 1, self);
          },
          "uint8 (n,): 0 input, 2 added on a segment, 3 on a facet, 4 inside.")
      .def_readonly("statistics", &MeshResult::statistics, "Counts of recovery, and of refinement where it ran.")
      .def_readonly("warnings", &MeshResult::warnings, "What the run noted, as sentences.");
  define_faces(type);
}

}  // namespace

DelaunayResult without_ghosts(PointArray points, DelaunayTetrahedralization&& whole) {
  DelaunayResult result{std::move(points), {}, {}, {}, std::move(whole.representative), whole.statistics};
  const TetMesh& cells = whole.mesh;
  std::vector<std::int32_t> row(cells.n_slots(), -1);
  std::int32_t n = 0;
  for (CellIndex c = 0; c < cells.n_slots(); ++c)
    if (cells.is_live(c) && !cells.is_ghost(c)) row[c] = n++;
  result.tetrahedra.reserve(static_cast<std::size_t>(n));
  result.neighbors.reserve(static_cast<std::size_t>(n));
  for (CellIndex c = 0; c < cells.n_slots(); ++c) {
    if (!cells.is_live(c)) continue;
    const auto& v = cells.vertices(c);
    if (const int ghost = cells.ghost_index(c); ghost >= 0) {
      const auto& f = face_vertices[static_cast<std::size_t>(ghost)];
      result.hull.push_back({v[f[0]], v[f[1]], v[f[2]]});
      continue;
    }
    result.tetrahedra.push_back(v);
    std::array<std::int32_t, 4> beside{};
    for (unsigned i = 0; i < 4; ++i) beside[i] = row[cells.neighbor_cell(c, i)];
    result.neighbors.push_back(beside);
  }
  return result;
}

py::dict statistics_of(const ConstrainedTetrahedralization& mesh) {
  const RecoveryStatistics& r = mesh.recovery;
  py::dict d;
  d["delaunay"] = mesh.delaunay;
  d["components"] = mesh.n_components;
  d["segments_total"] = r.segments_total;
  d["facets_total"] = r.facets_total;
  d["missing_edges_initial"] = r.missing_edges_initial;
  d["missing_facets_initial"] = r.missing_facets_initial;
  d["edges_reinserted"] = r.edges_reinserted;
  d["facets_reinserted"] = r.facets_reinserted;
  d["facets_not_recovered"] = r.facets_not_recovered;
  d["steiner_on_segments"] = r.steiner_on_segments;
  d["steiner_on_facets"] = r.steiner_on_facets;
  d["steiner_inside"] = r.steiner_inside;
  d["tetrahedra_unconstrained"] = r.tetrahedra_unconstrained;
  d["tetrahedra_final"] = r.tetrahedra_final;
  return d;
}

py::dict statistics_of(const RefineResult& result) {
  py::dict d = statistics_of(result.mesh);
  const RefineStatistics& s = result.statistics;
  d["estimated_elements"] = s.estimated_elements;
  d["points_on_curves"] = s.points_on_curves;
  d["points_on_surfaces"] = s.points_on_surfaces;
  d["points_inside"] = s.points_inside;
  d["deviation_result_to_input"] = s.deviation_result_to_input;
  d["deviation_input_to_result"] = s.deviation_input_to_result;
  d["out_of_time"] = s.out_of_time;
  return d;
}

void define_results(py::module_& module) {
  define_delaunay(module);
  define_mesh(module);
}

}  // namespace geomesh::python
