// SPDX-License-Identifier: GPL-3.0-or-later
#include "starters/starter_model.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {

namespace {

/// Typical parameters of a sandstone in SI units.
constexpr double usual_conductivity = 2.5, usual_density = 2400, usual_vp = 3500, usual_vs = 2000;

std::optional<double> attribute(const ModelMesh& mesh, std::int32_t region, std::initializer_list<const char*> names) {
  for (const char* name : names)
    for (const RegionAttribute& a : mesh.attributes)
      if (a.name == name) {
        const double value = a.by_region[static_cast<std::size_t>(region - 1)];
        if (!std::isnan(value)) return value;
      }
  return {};
}

MaterialValue or_usual(std::optional<double> given, double usual) { return {given.value_or(usual), given.has_value()}; }

/// Returns the material of a region. Velocities of an elastic rock are computed from Young's modulus and Poisson's
/// ratio, if those are given and velocities are not.
StarterMaterial material_of(const ModelMesh& mesh, std::int32_t region) {
  StarterMaterial material{
      or_usual(attribute(mesh, region, {"conductivity", "thermal_conductivity"}), usual_conductivity),
      or_usual(attribute(mesh, region, {"density"}), usual_density),
      or_usual(attribute(mesh, region, {"vp"}), usual_vp), or_usual(attribute(mesh, region, {"vs"}), usual_vs)};
  const auto young = attribute(mesh, region, {"young", "youngs_modulus"});
  const auto poisson = attribute(mesh, region, {"poisson", "poissons_ratio"});
  if (!young || !poisson || *poisson <= -1 || *poisson >= 0.5 || *young <= 0) return material;
  const double shear = *young / (2 * (1 + *poisson)), bulk = *young / (3 * (1 - 2 * *poisson));
  if (!material.vp.is_given) material.vp = {std::sqrt((bulk + shear * 4 / 3) / material.density.value), true};
  if (!material.vs.is_given) material.vs = {std::sqrt(shear / material.density.value), true};
  return material;
}

/// Finds the lowest and highest outer surface by the area-weighted mean height of their faces.
void find_outer_surfaces(const ModelMesh& mesh, StarterModel& model) {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (const NamedSurface& surface : mesh.surfaces) {
    double area = 0, moment = 0;
    for (const ModelMesh::Face& face : mesh.faces) {
      if (face.region_plus != 0) continue;
      const auto& set = mesh.surface_sets[static_cast<std::size_t>(face.surface_set)];
      if (std::find(set.begin(), set.end(), surface.id) == set.end()) continue;
      const Vec3 &a = mesh.points[face.vertices[0]], &b = mesh.points[face.vertices[1]],
                 &c = mesh.points[face.vertices[2]];
      const Vec3 n = cross(b - a, c - a);
      const double own = std::sqrt(dot(n, n));
      area += own;
      moment += own * (a.z + b.z + c.z) / 3;
    }
    if (area == 0) continue;
    if (moment / area < least) {
      least = moment / area;
      model.lowest = surface.name;
    }
    if (moment / area > greatest) {
      greatest = moment / area;
      model.highest = surface.name;
    }
  }
  if (model.lowest.empty()) throw Error(ErrorKind::usage, "starter: no named surface bounds the mesh");
}

void read_groups(const std::filesystem::path& mesh_file, StarterModel& model) {
  std::ifstream in(mesh_file.string() + ".json");
  const nlohmann::json root = nlohmann::json::parse(in);
  std::map<std::string, std::vector<std::string>> wholes;  // names of the surfaces that belong to each group
  for (const auto& surface : root.at("surfaces"))
    for (const auto& name : surface.at("groups")) wholes[name].push_back(surface.at("name"));
  for (const auto& group : root.at("groups")) {
    StarterModel::Listed listed{
        group.at("type"), group.at("dimension"), {group.at("name"), group.at("full_name"), group.value("id", 0)}, {}};
    if (listed.dimension == 2) listed.wholes = wholes[listed.group.name];
    model.groups.push_back(std::move(listed));
  }
}

}  // namespace

std::vector<StarterGroup> StarterModel::groups_of(const std::string& full_name, const std::string& type) const {
  std::vector<StarterGroup> found;
  for (const Listed& listed : groups)
    if (listed.type == type && listed.dimension == 2 &&
        std::find(listed.wholes.begin(), listed.wholes.end(), full_name) != listed.wholes.end())
      found.push_back(listed.group);
  return found;
}

StarterModel starter_model(const ModelMesh& mesh, const std::filesystem::path& mesh_file, const std::string& type) {
  StarterModel model;
  find_outer_surfaces(mesh, model);
  read_groups(mesh_file, model);
  for (const Region& region : mesh.regions)
    for (const StarterModel::Listed& listed : model.groups)
      if (listed.dimension == 3 && listed.type == type && listed.group.full_name == region.name) {
        model.regions.push_back({listed.group, material_of(mesh, region.id)});
        break;
      }
  return model;
}

const char* origin_of(const MaterialValue& value) {
  return value.is_given ? "from the project" : "not given in the project: a usual value of rock";
}

}  // namespace geomesh::geomodel
