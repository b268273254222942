// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "check/judged/judged_mesh.hpp"
#include "check/within/within_tolerance.hpp"
#include "coordinates/project_inputs.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/check.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "geomesh/geomodel/project.hpp"
#include "geomesh/geomodel/readers.hpp"

namespace geomesh::geomodel {
namespace {

using namespace checking;

/// NAME.ext -> NAME<suffix>, empty where there is no such file.
std::filesystem::path beside(const std::filesystem::path& mesh, const std::string& suffix) {
  std::filesystem::path file = mesh.parent_path() / (mesh.stem().string() + suffix);
  return std::filesystem::exists(file) ? file : std::filesystem::path{};
}

/// The report beside the mesh; nothing where there is none or it is no JSON.
std::optional<nlohmann::json> report_beside(const std::filesystem::path& mesh) {
  const std::filesystem::path file = beside(mesh, ".report.json");
  if (file.empty()) return std::nullopt;
  std::ifstream in(file);
  auto report = nlohmann::json::parse(in, nullptr, false);
  if (report.is_discarded()) return std::nullopt;
  return report;
}

/// Area clipped of each surface, as the report tells it.
std::map<std::string, double> reported_clipping(const std::filesystem::path& mesh) {
  std::map<std::string, double> areas;
  const auto report = report_beside(mesh);
  const nlohmann::json::json_pointer at("/displacement/clipping/surfaces");
  if (!report || !report->contains(at)) return areas;
  for (const auto& entry : report->at(at))
    areas[entry.value("surface", "")] =
        entry.value("area_by_box", 0.0) + entry.value("area_by_bodies", 0.0) + entry.value("area_by_rules", 0.0);
  return areas;
}

/// Whether rules of the model may take parts of the surface away.
bool may_be_trimmed(const Project& project, std::size_t row) {
  const SurfaceSpec& spec = project.surfaces[row];
  if (!spec.rules.stop_at.empty() || !spec.rules.cut_units.empty() || !spec.rules.throw_at.empty()) return true;
  for (const std::string* end : {&project.rules.topography, &project.rules.floor})
    if (!end->empty() && *end != spec.name) return true;
  if (spec.kind == SurfaceKind::body) return false;
  if (project.rules.trim_overshoot > 0) return true;
  const bool orders = project.rules.on_crossing != OnCrossing::leave ||
                      std::any_of(project.surfaces.begin(), project.surfaces.end(),
                                  [](const SurfaceSpec& s) { return s.rules.base != BaseRule::conformable; });
  return orders && std::find(project.column.begin(), project.column.end(), spec.name) != project.column.end();
}

/// What rules may trim, and what a volume that is no box cuts, is judged by its area: what is not covered is what the
/// report tells.
void claim_clipped_areas(const Project& project, const std::filesystem::path& mesh, Claim& claim) {
  const std::map<std::string, double> told = reported_clipping(mesh);
  for (Index s = 0; s < claim.surfaces.size(); ++s) {
    if (!may_be_trimmed(project, s) && !(claim.volume && !claim.volume->box)) continue;
    const auto area = told.find(claim.surfaces[s].name);
    claim.clipped_area[s] = area == told.end() ? 0 : area->second;
  }
}

Claim claim_of_project(const std::filesystem::path& file, const std::filesystem::path& mesh) {
  const Project project = read_project(file);
  ProjectInputs inputs = read_project_inputs(project, {});
  Claim claim;
  claim.named = true;
  claim.surfaces = std::move(inputs.surfaces);
  if (inputs.volume) claim.volume = make_volume(*inputs.volume, claim.surfaces, Vec3{});
  claim.ends_inside = !project.rules.topography.empty() || !project.rules.floor.empty();
  ModelRules rules = project.rules;
  if (claim.volume) rules.box = claim.volume->bounds;
  claim.surfaces = build_surfaces(claim.surfaces, rules).model_surfaces();
  claim_clipped_areas(project, mesh, claim);
  const RefinementSettings& refinement = project.mesh.refinement;
  if (refinement.refine && refinement.honour == Honour::tolerance)
    claim.within = refinement.tolerance;  // not together with crs.z_scale
  return claim;
}

Claim claim_of_surfaces(const std::vector<std::filesystem::path>& files) {
  Claim claim;
  for (const auto& file : files) {
    FileContents contents = read_surface_file(file);
    if (contents.surfaces.empty())
      throw Error(ErrorKind::invalid_input, file.string() + ": holds no triangulated surface");
    for (TriangulatedSurface& s : contents.surfaces) claim.surfaces.push_back(std::move(s));
  }
  return claim;
}

/// Largest displacement by rounding that the report beside the mesh states; 0 where it states none.
double reported_displacement(const std::filesystem::path& mesh) {
  const auto report = report_beside(mesh);
  const nlohmann::json::json_pointer at("/displacement/rounding/largest");
  if (!report || !report->contains(at) || !report->at(at).is_number()) return 0;
  return report->at(at).get<double>();
}

double tolerance_of(const CheckRequest& request, const MeshFile& mesh) {
  if (request.tolerance >= 0) return request.tolerance;
  double largest = 0;
  for (const Vec3& p : mesh.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const double ulp =
      mesh.single_precision
          ? double(std::nextafter(float(largest), std::numeric_limits<float>::infinity())) - double(float(largest))
          : std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
  constexpr double ulps = 8;
  return std::max(ulps * ulp, 2 * reported_displacement(request.mesh));
}

/// What surfaces may be off their input beyond rounding: as asked, else as the project says of its meshing; 0: nothing.
double surfaces_may_be_off(const CheckRequest& request, const Claim& claim) {
  return request.within >= 0 ? request.within : claim.within;
}

/// The surfaces of the claim: covered, or followed within a tolerance.
void judge_surfaces(const CheckRequest& request, const JudgedMesh& mesh, const Claim& claim, const FacesFile* faces,
                    const std::vector<Triangle>& set_faces, CheckResult& result) {
  const double rounding = tolerance_of(request, mesh.file), within = surfaces_may_be_off(request, claim);
  if (std::any_of(set_faces.begin(), set_faces.end(),
                  [](const Triangle& t) { return std::find(t.begin(), t.end(), no_vertex) != t.end(); })) {
    result.checks_done.emplace_back("coverage was not judged, for the faults of the face set above");
    return;
  }
  if (within == 0) return check_coverage(mesh, claim, faces, set_faces, rounding, result);
  const ClaimedFaces claimed(mesh, claim, faces, set_faces);
  const Allowed allowed{within, rounding};
  check_surfaces_within(claimed, allowed, result);
  if (!faces || !claim.named) return;
  check_surface_topology(claimed, allowed, result);
  check_volumes_within(claimed, allowed, report_beside(request.mesh), result);
}

void judge_claim(const CheckRequest& request, const JudgedMesh& mesh, const FacesFile* faces,
                 const std::vector<Triangle>& set_faces, CheckResult& result) {
  if (!request.project.empty()) {
    const Claim claim = claim_of_project(request.project, request.mesh);
    if (claim.volume) check_volume(mesh, claim, result);
    judge_surfaces(request, mesh, claim, faces, set_faces, result);
  }
  if (!request.surfaces.empty())
    judge_surfaces(request, mesh, claim_of_surfaces(request.surfaces), faces, set_faces, result);
}

}  // namespace

CheckResult check_mesh(const CheckRequest& request) {
  CheckResult result;
  const MeshFile file = read_mesh_file(request.mesh);
  JudgedMesh mesh{file, file.tetrahedra, {}, true};
  result.checks_done.push_back("read as " + file.format +
                               (file.single_precision ? " (coordinates in single precision)" : ""));
  if (!check_cells(mesh, result)) return result;
  check_faces(mesh, result);
  check_boundary(mesh, result);

  const std::filesystem::path faces_path = request.mesh.extension() == ".vtu" ? beside(request.mesh, ".faces.vtp") : "";
  const bool contract = !faces_path.empty() || file.region_array == "region";
  check_regions(mesh, contract, result);
  if (!faces_path.empty()) check_point_arrays(mesh, result);
  FacesFile faces;
  std::vector<Triangle> set_faces;
  const FacesFile* set = nullptr;
  if (!faces_path.empty()) {
    faces = read_faces_file(faces_path);
    set_faces = check_face_set(mesh, faces, result);
    if (faces.missing_arrays.empty()) set = &faces;
  }
  judge_claim(request, mesh, set, set ? set_faces : std::vector<Triangle>{}, result);
  if (request.delaunay) check_delaunay(mesh, faces_path.empty() ? nullptr : &faces, result);
  return result;
}

}  // namespace geomesh::geomodel
