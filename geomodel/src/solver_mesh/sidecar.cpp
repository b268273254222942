// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_mesh/sidecar.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "geomesh/geomodel/writers.hpp"

namespace geomesh::geomodel {

namespace {

using nlohmann::ordered_json;

using NamesById = std::unordered_map<std::int32_t, ordered_json>;

/// Returns for each id of a region, surface, curve or point the names of the groups that contain it.
NamesById names_by_member(const std::vector<SidecarGroup>& groups) {
  NamesById names;
  for (const SidecarGroup& g : groups) {
    std::vector<std::int32_t> members(g.members.begin(), g.members.end());
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    for (const std::int32_t id : members) names[id].push_back(g.name);
  }
  return names;
}

ordered_json entry(std::int32_t id, const std::string& name, const NamesById& groups) {
  const auto found = groups.find(id);
  return {{"id", id}, {"name", name}, {"groups", found == groups.end() ? ordered_json::array() : found->second}};
}

ordered_json field(const std::string& name, const char* place, const std::string& unit) {
  ordered_json result{{"name", name}, {"on", place}};
  if (!unit.empty()) result["unit"] = unit;
  return result;
}

}  // namespace

std::filesystem::path write_sidecar(const ModelMesh& mesh, const std::vector<SidecarGroup>& groups,
                                    const std::filesystem::path& mesh_file,
                                    const std::map<std::string, std::size_t>& counts) {
  const NamesById names = names_by_member(groups);
  ordered_json root;
  root["mesh"] = mesh_file.filename().string();
  root["unit"] = mesh.unit;
  for (const auto& [name, count] : counts) root[name] = count;
  if (!(mesh.origin == Vec3{0, 0, 0})) root["origin"] = {mesh.origin.x, mesh.origin.y, mesh.origin.z};
  for (const CellArray& a : mesh.cell_arrays) root["fields"].push_back(field(a.name, "cells", a.unit));
  for (const PointArray& a : mesh.point_arrays) root["fields"].push_back(field(a.name, "points", a.unit));
  root["groups"] = ordered_json::array();
  for (const SidecarGroup& g : groups) {
    ordered_json group{{"type", g.type}, {"dimension", g.dimension}};
    if (g.id != 0) group["id"] = g.id;
    group["name"] = g.name;
    group["full_name"] = g.full_name;
    root["groups"].push_back(std::move(group));
  }
  for (const RegionGroup& g : mesh.groups) root["region_groups"].push_back({{"name", g.name}, {"regions", g.regions}});
  root["regions"] = root["surfaces"] = root["curves"] = root["points"] = ordered_json::array();
  for (const Region& r : mesh.regions) {
    ordered_json region = entry(r.id, r.name, names);
    for (const RegionAttribute& a : mesh.attributes)
      if (const double value = a.by_region[static_cast<std::size_t>(r.id - 1)]; !std::isnan(value))
        region["attributes"][a.name] = value;
    root["regions"].push_back(std::move(region));
  }
  for (const NamedSurface& s : mesh.surfaces) {
    ordered_json surface = entry(s.id, s.name, names);
    surface["kind"] = to_string(s.kind);
    root["surfaces"].push_back(std::move(surface));
  }
  for (const NamedCurve& c : mesh.curves) {
    ordered_json curve = entry(c.id, c.name, names);
    curve["kind"] = c.kind;
    root["curves"].push_back(std::move(curve));
  }
  for (const auto& p : mesh.marked_points) root["points"].push_back(entry(p.id, p.name, names));
  for (const CohesiveLayer& l : mesh.cohesive_layers) root["cohesive_layers"].push_back(entry(l.id, l.name, names));
  for (const NodeSet& n : mesh.node_sets) root["node_sets"].push_back(entry(n.id, n.name, names));
  const std::filesystem::path file = mesh_file.string() + ".json";
  try {
    write_text_file(file, root.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(mesh_file, ignored);
    throw;
  }
  return file;
}

}  // namespace geomesh::geomodel
