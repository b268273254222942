// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "check/judged_mesh.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/check.hpp"
#include "geomesh/geomodel/project.hpp"
#include "geomesh/geomodel/readers.hpp"

namespace geomesh::geomodel {
namespace {

using namespace checking;

/// The object that a project's entry means: the file's only surface, or the one of the entry's name.
TriangulatedSurface surface_of_entry(const SurfaceSpec& spec, const Vec3& origin) {
  FileContents contents = read_surface_file(spec.file);
  auto it = contents.surfaces.begin();
  if (contents.surfaces.size() != 1)
    it = std::find_if(contents.surfaces.begin(), contents.surfaces.end(),
                      [&](const TriangulatedSurface& s) { return s.name == spec.name; });
  if (it == contents.surfaces.end())
    throw Error(ErrorKind::invalid_input, spec.file.string() + ": holds no surface for the project's entry " + spec.name);
  TriangulatedSurface surface = std::move(*it);
  surface.name = spec.name;
  surface.kind = spec.kind;
  surface.cuts_all = spec.cuts_all;
  for (Vec3& p : surface.points) p = p - origin;
  return surface;
}

Claim claim_of_project(const std::filesystem::path& file) {
  const Project project = read_project(file);
  Claim claim;
  claim.named = true;
  for (const SurfaceSpec& spec : project.surfaces) claim.surfaces.push_back(surface_of_entry(spec, project.output.origin));
  if (project.box) claim.box = Box3{project.box->min - project.output.origin, project.box->max - project.output.origin};
  return claim;
}

Claim claim_of_surfaces(const std::vector<std::filesystem::path>& files) {
  Claim claim;
  for (const auto& file : files) {
    FileContents contents = read_surface_file(file);
    if (contents.surfaces.empty()) throw Error(ErrorKind::invalid_input, file.string() + ": holds no triangulated surface");
    for (TriangulatedSurface& s : contents.surfaces) claim.surfaces.push_back(std::move(s));
  }
  return claim;
}

/// NAME.ext -> NAME<suffix>, empty where there is no such file.
std::filesystem::path beside(const std::filesystem::path& mesh, const std::string& suffix) {
  std::filesystem::path file = mesh.parent_path() / (mesh.stem().string() + suffix);
  return std::filesystem::exists(file) ? file : std::filesystem::path{};
}

/// Largest displacement by rounding that the report beside the mesh states; 0 where it states none.
double reported_displacement(const std::filesystem::path& mesh) {
  const std::filesystem::path file = beside(mesh, ".report.json");
  if (file.empty()) return 0;
  std::ifstream in(file);
  const auto report = nlohmann::json::parse(in, nullptr, false);
  const auto at = nlohmann::json::json_pointer("/displacement/rounding/largest");
  if (report.is_discarded() || !report.contains(at) || !report.at(at).is_number()) return 0;
  return report.at(at).get<double>();
}

double tolerance_of(const CheckRequest& request, const MeshFile& mesh) {
  if (request.tolerance >= 0) return request.tolerance;
  double largest = 0;
  for (const Vec3& p : mesh.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const double ulp = mesh.single_precision
                         ? double(std::nextafter(float(largest), std::numeric_limits<float>::infinity())) - double(float(largest))
                         : std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
  constexpr double ulps = 8;
  return std::max(ulps * ulp, 2 * reported_displacement(request.mesh));
}

void judge_claim(const CheckRequest& request, const JudgedMesh& mesh, const FacesFile* faces,
                 const std::vector<Triangle>& set_faces, CheckResult& result) {
  if (!request.project.empty()) {
    const Claim claim = claim_of_project(request.project);
    if (claim.box) check_box(mesh, *claim.box, result);
    check_coverage(mesh, claim, faces, set_faces, tolerance_of(request, mesh.file), result);
  }
  if (!request.surfaces.empty()) {
    const Claim claim = claim_of_surfaces(request.surfaces);
    check_coverage(mesh, claim, faces, set_faces, tolerance_of(request, mesh.file), result);
  }
}

}  // namespace

CheckResult check_mesh(const CheckRequest& request) {
  CheckResult result;
  const MeshFile file = read_mesh_file(request.mesh);
  JudgedMesh mesh{file, file.tetrahedra, {}, true};
  result.checks_done.push_back("read as " + file.format + (file.single_precision ? " (coordinates in single precision)" : ""));
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
