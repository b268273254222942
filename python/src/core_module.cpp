// SPDX-License-Identifier: MIT
// The module geomesh.core._core: the engine for plain arrays. Arguments are checked here; geomesh/core/__init__.py
// contains the functions that users call, with their docstrings.
#include <pybind11/stl.h>

#include "core_results.hpp"
#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/plc.hpp"
#include "job.hpp"

namespace geomesh::python {
namespace {

/// Polygons as lists of loops (the outer one first), each a list of rows of points.
using Polygons = std::vector<std::vector<std::vector<VertexIndex>>>;

/// A piecewise linear complex as passed from Python: points, facets, segments, regions and holes in arrays.
struct PlcArguments {
  PointArray points;
  std::vector<Triangle> triangles;
  Polygons polygons;  ///< used instead of `triangles` if facets are polygons
  py::array segments;
  PointArray regions, holes;  ///< points inside the regions that get numbers, and inside those that are left out
};

PiecewiseLinearComplex make_plc(const PlcArguments& a) {
  PiecewiseLinearComplex plc;
  const std::span<const Vec3> points = as_points(a.points, "points");
  plc.points.assign(points.begin(), points.end());
  for (const Triangle& t : a.triangles) plc.add_triangle(t);
  for (const auto& loops : a.polygons) plc.add_polygon(loops);
  const std::vector<VertexIndex> ends = as_rows(a.segments, 2, "segments");
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) plc.segments.push_back({ends[i], ends[i + 1], no_index});
  Index id = 0;
  if (a.regions.size() > 0)
    for (const Vec3& p : as_points(a.regions, "regions")) plc.region_seeds.push_back({p, id++});
  if (a.holes.size() > 0)
    for (const Vec3& p : as_points(a.holes, "holes")) plc.hole_seeds.push_back({p, no_index});
  return plc;
}

TetrahedralizeOptions options_of(const py::dict& given) {
  TetrahedralizeOptions options;
  if (given["mode"].cast<std::string>() == "conforming") options.recover.mode = MeshMode::conforming;
  options.recover.preserve_boundary = given["preserve_boundary"].cast<bool>();
  return options;
}

JobRequest request_of(const py::dict& given) {
  return {given["progress"], given["log"], given["threads"].cast<unsigned>()};
}

DelaunayResult delaunay(const PointArray& points, const std::string& algorithm, double cluster_distance,
                        const py::dict& given) {
  const std::span<const Vec3> rows = as_points(points, "points");
  DelaunayOptions options;
  options.algorithm = algorithm == "flip" ? DelaunayAlgorithm::flip : DelaunayAlgorithm::cavity;
  options.cluster_distance = cluster_distance;
  Job job(request_of(given));
  DelaunayTetrahedralization whole =
      job.run([&](const RunContext& context) { return delaunay_tetrahedralization(rows, options, context); });
  return without_ghosts(points, std::move(whole));
}

MeshResult mesh_plc(const PlcArguments& arguments, const py::dict& given) {
  const PiecewiseLinearComplex plc = make_plc(arguments);
  const TetrahedralizeOptions options = options_of(given);
  Job job(request_of(given));
  ConstrainedTetrahedralization mesh =
      job.run([&](const RunContext& context) { return tetrahedralize(plc, options, context); });
  py::dict statistics = statistics_of(mesh);
  return {std::move(mesh), {}, std::move(statistics)};
}

RefineOptions refine_options_of(const py::dict& given, Job& job) {
  RefineOptions options;
  const py::object size = given["size"];
  if (py::isinstance<py::function>(size) || PyCallable_Check(size.ptr()))
    options.size.background = job.size_function(size);
  else if (!size.is_none())
    options.size.global = size.cast<double>();
  options.size.gradation = given["gradation"].cast<double>();
  options.size.curvature_angle = given["curvature_angle"].cast<double>();
  options.tolerance = given["tolerance"].cast<double>();
  if (options.tolerance > 0) options.honour = Honour::tolerance;
  const auto quality = given["quality"].cast<std::string>();
  options.quality = quality == "fast"   ? QualityLevel::fast
                    : quality == "best" ? QualityLevel::best
                                        : QualityLevel::standard;
  options.max_elements = given["max_elements"].cast<std::size_t>();
  return options;
}

MeshResult refine_plc(const PlcArguments& arguments, const py::dict& given) {
  const PiecewiseLinearComplex plc = make_plc(arguments);
  const TetrahedralizeOptions meshing = options_of(given);
  Job job(request_of(given));
  const RefineOptions options = refine_options_of(given, job);
  RefineResult result = job.run([&](const RunContext& context) {
    return refine_and_improve(plc, tetrahedralize(plc, meshing, context), options, context);
  });
  py::dict statistics = statistics_of(result);
  return {std::move(result.mesh), std::move(result.warnings), std::move(statistics)};
}

}  // namespace
}  // namespace geomesh::python

PYBIND11_MODULE(_core, module) {
  using namespace geomesh::python;
  module.doc() = "The engine of geomesh for plain arrays; use it through geomesh.core.";
  module.attr("__version__") = GEOMESH_VERSION;
  register_errors();
  define_results(module);
  py::class_<PlcArguments>(module, "PlcArguments")
      .def(py::init([](PointArray points, const py::object& triangles, Polygons polygons, py::array segments,
                       PointArray regions, PointArray holes) {
        std::vector<geomesh::Triangle> rows;
        if (!triangles.is_none()) rows = as_triangles(triangles.cast<py::array>(), "facets");
        return PlcArguments{std::move(points),   std::move(rows),    std::move(polygons),
                            std::move(segments), std::move(regions), std::move(holes)};
      }));
  module.def("delaunay", &delaunay);
  module.def("tetrahedralize", &mesh_plc);
  module.def("refine", &refine_plc);
}
