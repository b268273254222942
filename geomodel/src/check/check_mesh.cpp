// SPDX-License-Identifier: GPL-3.0-or-later
// Runs all checks of a mesh, declared in geomesh/geomodel/check.hpp.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "check/arrays/check_arrays.hpp"
#include "check/beside/as_in_vtu.hpp"
#include "check/curves/check_curves.hpp"
#include "check/gaps/check_gaps.hpp"
#include "check/mesh/checked_mesh.hpp"
#include "check/names/check_names.hpp"
#include "check/pieces/throw_cover.hpp"
#include "check/splits/check_splits.hpp"
#include "check/within/within_tolerance.hpp"
#include "check/zones/check_zones.hpp"
#include "common/foreign_json.hpp"
#include "geomesh/geomodel/check.hpp"
#include "geomesh/geomodel/project.hpp"
#include "solver_verdict/judge_file.hpp"

namespace geomesh::geomodel {
namespace {

using namespace checking;

/// Returns the path NAME<suffix> for a mesh file NAME.ext, or an empty path if there is no such file.
std::filesystem::path beside(const std::filesystem::path& mesh, const std::string& suffix) {
  std::filesystem::path file = mesh.parent_path() / (mesh.stem().string() + suffix);
  return std::filesystem::exists(file) ? file : std::filesystem::path{};
}

/// Returns the JSON report beside the mesh file; nothing if it is missing or is not JSON.
std::optional<nlohmann::json> report_beside(const std::filesystem::path& mesh) {
  const std::filesystem::path file = beside(mesh, ".report.json");
  if (file.empty()) return std::nullopt;
  std::ifstream in(file);
  auto report = parse_foreign_json(in);
  if (report.is_discarded()) return std::nullopt;
  return report;
}

std::vector<ReportedGap> gaps_reported_beside(const std::filesystem::path& mesh) {
  std::vector<ReportedGap> told;
  const auto report = report_beside(mesh);
  if (!report || !report->is_object() || !report->contains("open_borders")) return told;
  const auto text_of = [](const nlohmann::json& entry, const char* key) {
    return entry.contains(key) && entry.at(key).is_string() ? entry.at(key).get<std::string>() : std::string();
  };
  for (const nlohmann::json& entry : report->at("open_borders"))
    if (entry.is_object())
      told.push_back(
          {text_of(entry, "horizon"), text_of(entry, "region"), entry.value("joins_units", nlohmann::json()) == true});
  return told;
}

/// Returns the distance between neighbouring floating-point numbers at the mesh's largest coordinate.
double unit_in_last_place(const MeshFile& mesh) {
  double largest = 0;
  for (const Vec3& p : mesh.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (mesh.single_precision)
    return double(std::nextafter(float(largest), std::numeric_limits<float>::infinity())) - double(float(largest));
  return std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
}

/// Returns the largest distance by which rounding may have moved a point: the requested value, else the distance within
/// which rounding of intersections may merge points plus twice the project's own `tolerance`.
double tolerance_of(const CheckRequest& request, const MeshFile& mesh, const Specification& specification) {
  constexpr double ulps_of_crossings = 1024, ulps_of_other_tools = 8;
  if (request.tolerance >= 0) return request.tolerance;
  const double ulps = mesh.single_precision ? ulps_of_other_tools : ulps_of_crossings;
  return ulps * unit_in_last_place(mesh) + 2 * specification.merging;
}

/// Returns the largest allowed distance between surfaces and their input, beyond rounding: the requested value, else
/// that of the project; 0 if surfaces must not move.
double surfaces_may_be_off(const CheckRequest& request, const Specification& specification) {
  return request.within >= 0 ? request.within : specification.within;
}

bool all_known(const std::vector<Triangle>& faces) {
  return std::all_of(faces.begin(), faces.end(),
                     [](const Triangle& t) { return std::find(t.begin(), t.end(), no_vertex) == t.end(); });
}

/// Checks that the mesh covers the specified surfaces exactly, or follows them within a tolerance.
void check_surfaces(const CheckRequest& request, const CheckedMesh& mesh, const Specification& specification,
                    const FacesFile* faces, const std::vector<Triangle>& set_faces, CheckResult& result) {
  const double rounding = tolerance_of(request, mesh.file, specification),
               within = surfaces_may_be_off(request, specification);
  if (!all_known(set_faces)) {
    result.checks_done.emplace_back("coverage was not checked, for the faults of the face set above");
    return;
  }
  const CheckedFaces checked(mesh, specification, faces, set_faces);
  if (faces && specification.named) check_throw_cover(checked, within + rounding, result);
  if (within == 0) return check_coverage(mesh, specification, faces, set_faces, rounding, result);
  const Allowed allowed{within, rounding};
  check_surfaces_within(checked, allowed, result);
  if (faces) check_midpoints_within(checked, allowed, result);
  if (!faces || !specification.named) return;
  check_sources_within(checked, allowed, result);
  check_surface_topology(checked, allowed, result);
  check_volumes_within(checked, allowed, report_beside(request.mesh), result);
}

/// The mesh, its face set and its curves, either as in the files or with fault zones closed (collapsed to surfaces).
struct CheckedFiles {
  const CheckedMesh& mesh;
  const FacesFile& faces;
  const std::vector<Triangle>& set_faces;
  const CurvesFile* curves;
};

bool can_check_contract(const CheckedFiles& files) {
  return !files.mesh.file.region.empty() && all_known(files.set_faces);
}

void check_files(const CheckRequest& request, const CheckedFiles& files, const Specification& specification,
                 CheckResult& result) {
  const CheckedFaces checked(files.mesh, specification, &files.faces, files.set_faces);
  check_patches(checked, result);
  check_mesh_points(files.mesh, files.faces.points, files.faces.mesh_point, "the face set", result);
  std::optional<CheckedCurves> curves;
  if (files.curves) {
    check_mesh_points(files.mesh, files.curves->points, files.curves->mesh_point, "the curves", result);
    curves.emplace(check_curve_cells(files.mesh, *files.curves, files.faces, result));
  } else if (specification.output.curves) {
    result.faults.push_back({"missing_curves", "1 file is missing: the curves that belong to the face set", 1, {}, {}});
  }
  if (const auto report = report_beside(request.mesh))
    check_report(checked, curves ? &*curves : nullptr, *report, tolerance_of(request, files.mesh.file, specification),
                 result);
}

/// Checks names, curves and arrays of the output files against the project and docs/output-files.md.
void check_contract(const CheckRequest& request, const CheckedFiles& files, const Specification& specification,
                    CheckResult& result) {
  const CheckedFaces checked(files.mesh, specification, &files.faces, files.set_faces);
  const double rounding = tolerance_of(request, files.mesh.file, specification),
               reach = rounding + specification.within;
  check_surface_lists(checked, rounding, result);
  std::optional<CheckedCurves> curves;
  if (files.curves) {
    CheckResult told_already;
    curves.emplace(check_curve_cells(files.mesh, *files.curves, files.faces, told_already));
    check_surface_curves(checked, *curves, result);
    check_wells_and_points(checked, *curves, reach, result);
  }
  check_point_values(checked, curves ? &*curves : nullptr, rounding, result);
  check_region_names(checked, {specification.within, rounding}, result);
  check_gaps(checked, gaps_reported_beside(request.mesh), result);
  check_unit_arrays(checked, result);
  const double ulp = unit_in_last_place(files.mesh.file);
  check_cell_arrays(checked, ulp, result);
  if (const auto report = report_beside(request.mesh)) check_report_quality(files.mesh, *report, ulp, result);
}

/// Returns a length for which tetrahedra without longer edges fill nine tenths of the model's volume. If sizes are
/// graded, few elements are as large as the target size, but they fill most of the model.
double long_edge_by_volume(const CheckedMesh& mesh) {
  std::vector<std::pair<double, double>> edge_and_volume;
  edge_and_volume.reserve(mesh.cells.size());
  double whole = 0;
  for (const Tetrahedron& t : mesh.cells) {
    double square = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = i + 1; k < 4; ++k) {
        const Vec3 d = mesh.point(t[i]) - mesh.point(t[k]);
        square = std::max(square, dot(d, d));
      }
    const Vec3& a = mesh.point(t[0]);
    const double volume = std::abs(dot(mesh.point(t[1]) - a, cross(mesh.point(t[2]) - a, mesh.point(t[3]) - a))) / 6;
    edge_and_volume.emplace_back(std::sqrt(square), volume);
    whole += volume;
  }
  std::sort(edge_and_volume.begin(), edge_and_volume.end());
  double below = 0;
  for (const auto& [edge, volume] : edge_and_volume)
    if ((below += volume) >= 0.9 * whole) return edge;
  return edge_and_volume.back().first;
}

/// Takes the tolerance of surfaces from the report if the project only gives a number of elements, because the
/// tolerance then follows the derived sizes. Rejects a value above a twentieth of the mesh's long edges.
void adopt_told_tolerance(const CheckRequest& request, const CheckedMesh& mesh, Specification& specification,
                          CheckResult& result) {
  const auto report = report_beside(request.mesh);
  const nlohmann::json::json_pointer told("/tolerance/requested");
  if (request.within >= 0 || mesh.cells.empty()) return;
  if (!report || !report->contains(told) || !report->at(told).is_number()) return;
  const double most = long_edge_by_volume(mesh) / 20, promised = report->at(told).get<double>();
  specification.within = std::min(promised, most);
  char text[240];
  std::snprintf(text, sizeof text,
                "the project leaves its sizes to a number of elements: surfaces are held to %.4g (the report promises "
                "%.4g; at most a twentieth of the mesh's long edges counts)",
                specification.within, promised);
  result.checks_done.emplace_back(text);
}

void check_closed(const CheckRequest& request, const ClosedFiles& closed, const Specification& specification,
                  CheckResult& result) {
  CheckedMesh mesh{closed.mesh, closed.mesh.tetrahedra, {}, true};
  if (!check_cells(mesh, result)) return;
  check_faces(mesh, result);
  check_boundary(mesh, result);
  check_regions(mesh, true, result);
  const std::vector<Triangle> set_faces = check_face_set(mesh, closed.faces, result);
  check_surfaces(request, mesh, specification, &closed.faces, set_faces, result);
  const CheckedFiles files{mesh, closed.faces, set_faces, closed.curves ? &*closed.curves : nullptr};
  if (request.contract == CheckRequest::Contract::checked && can_check_contract(files))
    check_contract(request, files, specification, result);
}

void check_with_zones(const CheckRequest& request, const CheckedFiles& files, const Specification& specification,
                      CheckResult& result) {
  const auto closed = close_zones(files.mesh, files.faces, files.curves, specification.output.fault_zones, result);
  if (!closed) return;
  check_zones(files.mesh, files.faces, specification.output.fault_zones, result);
  CheckResult rest;
  check_closed(request, *closed, specification, rest);
  for (CheckFault& fault : rest.faults) {
    fault.what += " (with the fault zones closed)";
    result.faults.push_back(std::move(fault));
  }
  for (const std::string& text : rest.checks_done) result.checks_done.push_back("with zones closed: " + text);
}

/// The contents of the files of a mesh. Surfaces and curves are in separate files beside it, or cells of its own grid.
struct GivenFiles {
  MeshFile mesh;
  std::optional<FacesFile> faces;
  std::optional<CurvesFile> curves;
  /// Returns the faces file; null if the mesh has none, or if one of its face arrays is missing.
  const FacesFile* complete_faces() const { return faces && faces->missing_arrays.empty() ? &*faces : nullptr; }
};

GivenFiles read_files(const std::filesystem::path& mesh) {
  GivenFiles given{read_mesh_file(mesh), std::nullopt, std::nullopt};
  if (mesh.extension() != ".vtu" && mesh.extension() != ".pvtu") return given;
  const std::filesystem::path faces = beside(mesh, ".faces.vtp"), curves = beside(mesh, ".curves.vtp");
  if (!faces.empty()) {
    given.faces = read_faces_file(faces);
    if (!curves.empty()) given.curves = read_curves_file(curves);
  } else if (mesh.extension() == ".vtu" && !given.mesh.triangles.empty()) {
    if (auto of_grid = read_surfaces_of_grid(mesh)) {
      given.faces = std::move(of_grid->faces);
      if (!of_grid->curves.edges.empty() || !of_grid->curves.vertices.empty())
        given.curves = std::move(of_grid->curves);
    }
  }
  return given;
}

void join_sides(const Specification& specification, GivenFiles& given, CheckResult& result) {
  const std::vector<Vec3>& points = given.mesh.points;
  if (specification.output.split.empty() || !std::all_of(points.begin(), points.end(), is_finite)) return;
  if (!given.faces) {
    result.checks_done.emplace_back(
        "the project splits surfaces: the files of a .vtu are needed to join them again, and the mesh is checked as it "
        "stands");
    return;
  }
  auto joined = join_splits(given.mesh, *given.faces, given.curves,
                            {specification.output.split, specification.output.cohesive}, result);
  if (joined) given = {std::move(joined->mesh), std::move(joined->faces), std::move(joined->curves)};
}

void check_specification(const CheckRequest& request, const CheckedMesh& mesh, const GivenFiles& given,
                         Specification& specification, const std::vector<Triangle>& set_faces, CheckResult& result) {
  const FacesFile* const faces = given.complete_faces();
  if (specification.within_by_count) adopt_told_tolerance(request, mesh, specification, result);
  if (specification.volume) check_volume(mesh, specification, result);
  if (specification.output.fault_zones.empty()) {
    check_surfaces(request, mesh, specification, faces, set_faces, result);
  } else if (!faces) {
    result.checks_done.emplace_back(
        "surfaces were not checked: the project has fault zones, which are closed for that by the files of a .vtu");
  }
  if (!faces) return;
  const CheckedFiles files{mesh, *faces, set_faces, given.curves ? &*given.curves : nullptr};
  if (request.contract == CheckRequest::Contract::checked && can_check_contract(files)) {
    check_files(request, files, specification, result);
    if (specification.output.fault_zones.empty()) check_contract(request, files, specification, result);
  }
  if (!specification.output.fault_zones.empty()) check_with_zones(request, files, specification, result);
}

Velocities velocities_of(const CheckRequest& request) {
  Velocities velocities;
  if (request.project.empty()) return velocities;
  for (const auto& [unit, attributes] : read_project(request.project).naming.attributes)
    if (const auto v = attributes.find(velocity_attribute); v != attributes.end()) velocities[unit] = v->second;
  return velocities;
}

/// Checks the files of a mesh against each other, and against the specification if there is one.
void check_as_given(const CheckRequest& request, GivenFiles given, std::optional<Specification> specification,
                    CheckResult& result) {
  if (specification) join_sides(*specification, given, result);
  CheckedMesh mesh{given.mesh, given.mesh.tetrahedra, {}, true};
  if (!check_cells(mesh, result)) return;
  check_faces(mesh, result);
  check_boundary(mesh, result);
  check_second_order(mesh, result);

  check_regions(mesh, given.faces || given.mesh.region_array == "region", result);
  if (given.faces) check_point_arrays(mesh, result);
  std::vector<Triangle> set_faces;
  if (given.faces) set_faces = check_face_set(mesh, *given.faces, result);
  if (!given.complete_faces()) set_faces.clear();
  if (specification) check_specification(request, mesh, given, *specification, set_faces, result);
  if (!request.surfaces.empty())
    check_surfaces(request, mesh, specification_of_surfaces(request.surfaces), given.complete_faces(), set_faces,
                   result);
  if (request.solver) check_for_solvers(given.mesh, velocities_of(request), result);
  if (request.delaunay) check_delaunay(mesh, given.faces ? &*given.faces : nullptr, result);
}

/// Checks cells, second-order elements and regions of a solver's file, and all else in the equal .vtu beside it.
void check_by_vtu(const CheckRequest& request, const MeshFile& file, Specification specification, CheckResult& result) {
  CheckResult own;
  CheckedMesh mesh{file, file.tetrahedra, {}, true};
  const bool is_understood = check_cells(mesh, own);
  std::erase_if(own.faults, [](const CheckFault& fault) { return fault.id == "equal_points"; });  // of split surfaces
  if (is_understood) {
    check_second_order(mesh, own);
    check_regions(mesh, false, own);
  }
  CheckRequest of_vtu = request;
  of_vtu.mesh = beside(request.mesh, ".vtu");
  of_vtu.solver = false;
  CheckResult rest;
  check_as_given(of_vtu, read_files(of_vtu.mesh), std::move(specification), rest);
  const std::string name = of_vtu.mesh.filename().string();
  for (CheckFault& fault : rest.faults) {
    fault.what += " (in " + name + ")";
    own.faults.push_back(std::move(fault));
  }
  for (const std::string& text : rest.checks_done) own.checks_done.push_back("by " + name + ": " + text);
  own.checks_done.insert(own.checks_done.begin(), result.checks_done.begin(), result.checks_done.end());
  result = std::move(own);
  if (request.solver) check_for_solvers(file, velocities_of(request), result);
}

}  // namespace

CheckResult check_mesh(const CheckRequest& request) {
  CheckResult result;
  GivenFiles given = read_files(request.mesh);
  result.checks_done.push_back("read as " + given.mesh.format +
                               (given.mesh.single_precision ? " (coordinates in single precision)" : ""));
  std::optional<Specification> specification;
  if (!request.project.empty()) specification = specification_of_project(request.project);
  const bool is_contract_checked = specification && request.contract == CheckRequest::Contract::checked;
  if (is_contract_checked && check_as_in_vtu(request.mesh, specification->output, result))
    check_by_vtu(request, given.mesh, *std::move(specification), result);
  else
    check_as_given(request, std::move(given), std::move(specification), result);
  return result;
}

}  // namespace geomesh::geomodel
